//! The methods and the integrators of an open system.

use super::elements::open_reduced::reduced;
use super::open_field::{Motions, OpenField, Scratch};
use super::open_integrator::OpenIntegrator;
use super::open_system::OpenSystem;
use super::open_terms::NoiseFields;
use super::spin_terms::thermal_strength;
use crate::algebras::family::Family;
use crate::error::FormulaSystemError;
use crate::realisations::quadratic_momenta::QuadraticMomenta;
use collective_integrators::{
    AnyIntegrator, AnyState, AnyTangents, NoisePart, VectorField, Window,
};
use core::cell::RefCell;
use heavytop::methods::{Formulation, Method, SchemeName};
use lie_poisson::{Pair, Quaternion, State, larger};
use nalgebra::Vector2;
use std::sync::Arc;

impl OpenSystem {
    /// Returns the rate dμ/dt at a time, without the noise; with noise it is the drift in Stratonovich's sense.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::StateLength`] if the length of the state is not the dimension.
    pub fn rate(&self, state: &[f64], time: f64) -> Result<Vec<f64>, FormulaSystemError> {
        self.base().require_length(state)?;
        let scratch = Scratch::new(state.len());
        Ok(self.rate_and_element(state, time, &scratch))
    }

    /// Returns the element of the algebra along which the momentum moves at a time, without the noise; NaN for a state of another
    /// dimension.
    pub(super) fn element(&self, state: &[f64], time: f64) -> Vec<f64> {
        let dimension = self.base().algebra().dimension();
        if state.len() != dimension {
            return vec![f64::NAN; dimension];
        }
        let scratch = Scratch::new(dimension);
        self.rate_and_element(state, time, &scratch);
        scratch.into_inner().xi
    }

    /// Returns the rate, and leaves the element in the scratch.
    fn rate_and_element(
        &self,
        state: &[f64],
        time: f64,
        scratch: &RefCell<Scratch<f64>>,
    ) -> Vec<f64> {
        let part = NoisePart { drift: 1.0, weights: &[], step: 0.0 };
        let (momenta, motions, window) = (None, Motions::All, Window::ALL);
        let field = OpenField { system: self, momenta, part, motions, window, scratch };
        let clock = Vector2::new(0.0, time / self.interval());
        let at = Pair(AnyState::from_slice(state), Pair(clock, AnyState::from_slice(&[])));
        field.at(&at).0.as_slice().to_vec()
    }

    /// Moves a state of an integrator without attitude so many paths on from the path of the noise.
    pub fn move_path(&self, state: &mut [f64], on: u64) {
        let path = self.terms().noise.as_ref().map_or(0, |noise| noise.path);
        if let Some([number, _]) = state.last_chunk_mut() {
            *number = path.saturating_add(on) as f64;
        }
    }

    /// Returns the angle by which noise turns a state in a step h, rad: the largest σ√(h ♯_ii) of the coordinates i that are rotations
    /// for isotropic noise, or σ√h of all spins, and √(h Σ_k (σ_k)_i²) for constant fields, as they are at the time 0. There is
    /// none of fields that depend on coordinates or have no value, and of algebras whose coordinates are not known to be rotations.
    /// Steps are safe up to a third.
    #[must_use]
    pub fn noise_angle(&self, state: &[f64], step: f64) -> Option<f64> {
        let noise = &self.terms().noise.as_ref()?.fields;
        let strength = match noise {
            NoiseFields::Isotropic(noise) => {
                let dimension = self.base().algebra().dimension();
                let (mut covector, mut sharp) = (vec![0.0; dimension], vec![0.0; dimension]);
                let largest = (0..self.rotations()?).fold(0.0_f64, |most, i| {
                    covector.fill(0.0);
                    covector[i] = 1.0;
                    noise.inner_product.write_sharp(&covector, &mut sharp);
                    most.max(sharp[i])
                });
                noise.strength * largest.sqrt()
            }
            NoiseFields::OfSpins { damping, temperature } => {
                let spins = state.as_chunks::<3>().0.iter();
                let strengths = spins.map(|spin| thermal_strength(*damping, *temperature, *spin));
                strengths.fold(0.0, larger)
            }
            NoiseFields::Formulas(fields) => {
                let dimension = self.base().algebra().dimension();
                let mut x =
                    state.get(..dimension).filter(|_| noise.are_constant(dimension))?.to_vec();
                self.terms().inputs.append(0.0, &mut x);
                let values = |i: usize| fields.iter().filter_map(move |field| field.get(i));
                let about =
                    |i| values(i).fold(0.0, |sum: f64, field| sum.hypot(field.value_at(&x)));
                let largest = (0..self.rotations()?).map(about).fold(0.0, larger);
                Some(largest).filter(|strength| strength.is_finite())?
            }
        };
        Some(strength * step.abs().sqrt())
    }

    /// Returns the number of coordinates that are rotations, which come first.
    fn rotations(&self) -> Option<usize> {
        let algebra = self.base().algebra();
        match algebra.family {
            Family::Rotations | Family::ManyRotations => Some(algebra.dimension()),
            Family::Motions => Some(3),
            Family::Other => None,
        }
    }

    /// Returns the formulation that suits the system best: direct with a torque or where steps do not descend to 𝔤∗, and
    /// otherwise collective.
    #[must_use]
    pub fn default_formulation(&self) -> Formulation {
        let all = self.terms().formulations(self.base().algebra());
        all.first().copied().unwrap_or_default()
    }

    /// Returns the method of a formulation and a scheme.
    ///
    /// With noise, `reduced` is the collective midpoint rule without a lift. Each step moves the momentum along its coadjoint orbit by an
    /// element of the group, exactly, so that the Casimirs of each path are kept to round-off for any tolerance of its stages: 1e-6, far
    /// below the error of sampling, halves the time of a step. By `collective` a tolerance is an error of the Casimirs, too.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::NoMethod`] if the system does not have the formulation with the scheme: only the direct one
    /// with a torque, and the reduced one with noise and the implicit midpoint rule alone, on so(3), su(2) and se(3). Those of
    /// [`SystemAlgebra::method`](crate::SystemAlgebra::method) otherwise.
    pub fn method(
        &self,
        formulation: Formulation,
        scheme: SchemeName,
        tolerance: f64,
    ) -> Result<Method, FormulaSystemError> {
        let algebra = self.base().algebra();
        let refused = |has: &str| FormulaSystemError::NoMethod {
            algebra: format!("{} with forces", algebra.name()),
            formulation,
            scheme,
            has: has.into(),
        };
        if self.terms().torque.is_some() && formulation != Formulation::Direct {
            return Err(refused(
                "with a torque, which takes it off its coadjoint orbit, it has direct",
            ));
        }
        let is_midpoint = scheme == SchemeName::ImplicitMidpoint;
        match formulation {
            Formulation::Reduced if !self.terms().formulations(algebra).contains(&formulation) => {
                Err(refused(
                    "it has collective and direct, and with noise on so(3), su(2) and se(3) reduced",
                ))
            }
            Formulation::Reduced if !is_midpoint => Err(refused(
                "with noise it has reduced with implicit-midpoint alone; collective and direct have others",
            )),
            _ => algebra.method(formulation, scheme, tolerance),
        }
    }

    /// Returns the integrator of a method for runs from a state at the time 0. It has tangent maps, of one path if there is noise.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError`] if there is no such method, the state has another dimension, or has no lift.
    pub fn tangent_integrator(
        &self,
        method: &Method,
        start: &[f64],
    ) -> Result<AnyIntegrator<dyn AnyTangents>, FormulaSystemError> {
        if method.formulation() == Formulation::Reduced {
            self.method(method.formulation(), method.scheme(), method.tolerance())?;
            self.base().require_length(start)?;
            let made = reduced(self, method.tolerance());
            return made.ok_or_else(|| self.refused(method, "it has collective and direct"));
        }
        Ok(self.integrator(method, start, None)?.erased(start))
    }

    /// Returns the integrator of a method that carries the attitude of a body along, from an attitude on. Its unit quaternion is in
    /// the last four coordinates of the states.
    ///
    /// # Errors
    /// As [`tangent_integrator`](Self::tangent_integrator), and for `reduced`.
    pub fn integrator_with_attitude(
        &self,
        method: &Method,
        start: &[f64],
        attitude: Quaternion,
    ) -> Result<AnyIntegrator, FormulaSystemError> {
        Ok(self.integrator(method, start, Some(attitude))?.erased(start).without_tangents())
    }

    /// Returns whether the system is a body with an attitude: whether its algebra is that of rotations or of rigid motions, with the
    /// minus bracket.
    #[must_use]
    pub fn has_attitude(&self) -> bool {
        let family = self.base().algebra().family;
        matches!(family, Family::Rotations | Family::Motions) && !self.base().has_plus_bracket()
    }

    fn integrator(
        &self,
        method: &Method,
        start: &[f64],
        attitude: Option<Quaternion>,
    ) -> Result<OpenIntegrator, FormulaSystemError> {
        self.method(method.formulation(), method.scheme(), method.tolerance())?;
        self.base().require_length(start)?;
        let no_method = |has: &str| self.refused(method, has);
        let scheme = method.scheme().runge_kutta(method.tolerance())?;
        let scheme = scheme
            .ok_or_else(|| no_method("it has Runge–Kutta methods and compositions of them"))?;
        let momenta = match method.formulation() {
            Formulation::Collective => {
                Some(self.momenta().ok_or_else(|| no_method("it has direct"))?)
            }
            Formulation::Reduced => {
                return Err(no_method("the attitude is followed by collective and direct"));
            }
            _ => None,
        };
        let attitude = attitude.map(|q| core::array::from_fn(|i| q.coordinate(i)));
        let system = self.clone();
        OpenIntegrator::new(scheme, system, momenta, attitude).checked(start)
    }

    /// Returns the error for a method that there is not, with those that there are.
    fn refused(&self, method: &Method, has: &str) -> FormulaSystemError {
        let algebra = self.base().algebra().name().into();
        let (formulation, scheme) = (method.formulation(), method.scheme());
        FormulaSystemError::NoMethod { algebra, formulation, scheme, has: has.into() }
    }

    /// Returns the momenta along which the collective formulation goes, and whether they are a Poisson map to the plus bracket.
    fn momenta(&self) -> Option<(Arc<QuadraticMomenta>, bool)> {
        let algebra = self.base().algebra();
        let spinors = || Some((Arc::new(algebra.spinors()?), true));
        algebra.momenta().or_else(spinors)
    }

    /// Returns whether the steps of a method descend to 𝔤∗.
    ///
    /// # Errors
    /// As [`FormulaSystem::descends`](crate::FormulaSystem::descends).
    pub fn descends(&self, method: &Method) -> Result<bool, FormulaSystemError> {
        Ok(self.base().algebra().descends(method.formulation()))
    }
}
