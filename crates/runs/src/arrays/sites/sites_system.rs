//! Spins and vortices: points of (so(3)∗)ᴺ, and their integrators.

use super::open_lattice::OpenLattice;
use crate::arrays::renewed::{Renewed, resumable_after};
use crate::error::RunFailure;
use collective_integrators::{
    AnyIntegrator, AnyTangents, ByPointer, CollectiveSites, Direct, LiftFreeSites,
    SphericalMidpoint, StageSolver, VectorField,
};
use heavytop::methods::{Formulation, Method, MethodError, SchemeName};
use lie_poisson::{Covector, Real, Sites, SitesHamiltonian, State, larger};
use lie_poisson_systems::{LatticeMidpoint, ManyVortices};
use momentum_map::{HOPF, Quaternions};
use nalgebra::Vector3;

/// A point of (so(3)∗)ᴺ.
pub(in crate::arrays) type Momenta = Covector<Sites<Vector3<f64>>>;

/// A system on (so(3)∗)ᴺ, by the Hamiltonian that has its motion in the minus bracket. Spins have the plus bracket, so that
/// theirs is −h.
#[derive(Clone, Debug)]
pub(in crate::arrays) enum SitesSystem {
    Spins(OpenLattice),
    Vortices(ManyVortices),
}

impl<T: Real> SitesHamiltonian<Vector3<T>> for SitesSystem {
    fn value(&self, m: &Covector<Sites<Vector3<T>>>) -> T {
        match self {
            Self::Spins(spins) => -spins.value(m),
            Self::Vortices(vortices) => vortices.value(m),
        }
    }

    fn differential_into(&self, m: &Covector<Sites<Vector3<T>>>, dh: &mut Sites<Vector3<T>>) {
        match self {
            Self::Spins(spins) => {
                spins.differential_into(m, dh);
                dh.iter_mut().for_each(|dh| *dh = -*dh);
            }
            Self::Vortices(vortices) => vortices.differential_into(m, dh),
        }
    }
}

impl<T: Real> VectorField<T> for SitesSystem {
    type Point = Covector<Sites<Vector3<T>>>;

    fn at(&self, m: &Self::Point) -> Self::Point {
        let mut rate = m.zeros_like();
        self.at_into(m, &mut rate);
        rate
    }

    fn at_into(&self, m: &Self::Point, rate: &mut Self::Point) {
        match self {
            Self::Spins(spins) => spins.at_into(m, rate),
            Self::Vortices(vortices) => vortices.at_into(m, rate),
        }
    }
}

impl SitesSystem {
    /// The formulations of spins and vortices, the default one first.
    pub(in crate::arrays) const FORMULATIONS: &'static [Formulation] =
        &[Formulation::Collective, Formulation::Reduced, Formulation::Direct];

    /// Returns whether spins and vortices have a scheme in a formulation.
    pub(in crate::arrays) fn offers(formulation: Formulation, scheme: SchemeName) -> bool {
        match scheme {
            SchemeName::SphericalMidpoint => formulation == Formulation::Reduced,
            SchemeName::Partitioned(_) => false,
            _ => formulation.offers(scheme),
        }
    }

    /// Returns h.
    pub(in crate::arrays) fn energy(&self, m: &Momenta) -> f64 {
        let motion = SitesHamiltonian::<Vector3<f64>>::value(self, m);
        if matches!(self, Self::Spins(_)) { -motion } else { motion }
    }

    /// Returns the fastest rotation of a vector, |dh_i|.
    pub(in crate::arrays) fn fastest_rate(&self, m: &Momenta) -> f64 {
        self.velocities(m).iter().map(Vector3::norm).fold(0.0, larger)
    }

    /// Returns dh.
    pub(in crate::arrays) fn differential(&self, m: &Momenta) -> Vec<f64> {
        let sign = if matches!(self, Self::Spins(_)) { -1.0 } else { 1.0 };
        numbers(&self.velocities(m)).into_iter().map(|x| sign * x).collect()
    }

    fn velocities(&self, m: &Momenta) -> Sites<Vector3<f64>> {
        let mut dh = State::zeros_of(&m.0.len());
        self.differential_into(m, &mut dh);
        dh
    }

    /// Returns the fastest integrator of a method for so many vectors.
    ///
    /// # Errors
    /// If the coefficients of the scheme cannot be made.
    pub(in crate::arrays) fn integrator(
        &self,
        method: &Method,
        count: usize,
    ) -> Result<AnyIntegrator, RunFailure> {
        match (self, method.scheme()) {
            // The kernel in registers goes round the lattice.
            (Self::Spins(spins), SchemeName::SphericalMidpoint) if spins.is_periodic() => {
                let zero: Momenta = State::zeros_of(&count);
                let period = resumable_after(3 * count);
                let midpoint =
                    LatticeMidpoint::new(spins.periodic.clone()).with_solver(solver(method));
                Ok(AnyIntegrator::of_states(Renewed { integrator: midpoint, period }, &zero, &zero))
            }
            _ => Ok(self.tangent_integrator(method, count)?.without_tangents()),
        }
    }

    /// Returns the integrator of a method for so many vectors, with tangent maps.
    ///
    /// # Errors
    /// If the coefficients of the scheme cannot be made.
    pub(in crate::arrays) fn tangent_integrator(
        &self,
        method: &Method,
        count: usize,
    ) -> Result<AnyIntegrator<dyn AnyTangents>, RunFailure> {
        let (formulation, name) = (method.formulation(), method.scheme());
        let zero: Momenta = State::zeros_of(&count);
        let period = resumable_after(3 * count);
        if name == SchemeName::SphericalMidpoint {
            let midpoint = SphericalMidpoint::new(self.clone()).with_solver(solver(method));
            return Ok(AnyIntegrator::of_states_with_tangents(
                Renewed { integrator: midpoint, period },
                &zero,
                &zero,
            ));
        }
        let impossible = || MethodError::NoSuchPair { formulation, scheme: name };
        let scheme = name.runge_kutta(method.tolerance())?.ok_or_else(impossible)?;
        Ok(match formulation {
            Formulation::Collective => {
                let collective = CollectiveSites::new(scheme, HOPF, self.clone());
                let points = Sites::zeros_of(&count);
                AnyIntegrator::of_states_with_tangents(
                    Renewed { integrator: collective, period },
                    &points,
                    &zero,
                )
            }
            Formulation::Reduced => {
                let reduced = LiftFreeSites::new(scheme, Quaternions, self.clone());
                AnyIntegrator::of_states_with_tangents(
                    Renewed { integrator: reduced, period },
                    &zero,
                    &zero,
                )
            }
            Formulation::Direct => {
                let direct = Direct::new(ByPointer(scheme), self.clone());
                AnyIntegrator::of_states_with_tangents(
                    Renewed { integrator: direct, period },
                    &zero,
                    &zero,
                )
            }
            Formulation::Splitting => return Err(impossible().into()),
        })
    }
}

fn solver(method: &Method) -> StageSolver {
    StageSolver { tolerance: method.tolerance(), ..StageSolver::default() }
}

/// Returns the vectors of their components, one after the other.
pub(in crate::arrays) fn momenta(state: &[f64]) -> Momenta {
    Covector(state.as_chunks::<3>().0.iter().map(|x| Vector3::from(*x)).collect())
}

/// Returns the components of vectors, one after the other.
pub(in crate::arrays) fn numbers(vectors: &[Vector3<f64>]) -> Vec<f64> {
    vectors.iter().flat_map(|x| [x.x, x.y, x.z]).collect()
}

/// Returns the sum of vectors.
pub(in crate::arrays) fn total(vectors: &[Vector3<f64>]) -> Vector3<f64> {
    vectors.iter().sum()
}
