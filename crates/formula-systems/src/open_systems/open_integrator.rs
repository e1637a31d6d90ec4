//! The integrator of an open system: [`OpenIntegrator`].

use super::open_field::{Motions, OpenField, OpenState, Scratch};
use super::open_system::OpenSystem;
use crate::algebras::family::Family;
use crate::error::FormulaSystemError;
use crate::realisations::quadratic_momenta::QuadraticMomenta;
use collective_integrators::{
    AnyIntegrator, AnyState, AnyTangents, ByPointer, Composition, Integrator, NoisePart,
    RungeKutta, Scheme, Start, Step, StepError, StepParts, VectorField, affine_flow,
};
use core::cell::RefCell;
use lie_poisson::{Momentum, Pair, Real, Se3, State, Vector};
use momentum_map::LiftError;
use nalgebra::Vector2;
use std::sync::Arc;

/// Any scheme, whose type is one: a step is a composition of one substep.
type AnyScheme = Composition<RungeKutta>;

/// A point of a realisation is moved back along its fibre every so many intervals, if it has grown.
const MOVED: f64 = 1024.0;

/// A scheme applied to the field of an open system, on the momentum or upstairs.
pub(super) struct OpenIntegrator {
    /// A field of an open system costs much more than a call.
    scheme: ByPointer<AnyScheme>,
    system: OpenSystem,
    /// The momenta, and the sign of the generator that makes the bracket of the system.
    momenta: Option<(Arc<QuadraticMomenta>, f64)>,
    /// Whether the fields of the noise are constant, so that the flow of each is exact.
    has_flows: bool,
    /// The attitude of the start, if it is followed.
    attitude: Option<[f64; 4]>,
}

/// The storage of a step.
pub(super) struct OpenWorkspace<W, T> {
    scheme: W,
    scratch: RefCell<Scratch<T>>,
    /// Whether states stay where they are on their fibres, as those with tangent vectors do.
    is_pinned: bool,
}

impl OpenIntegrator {
    pub(super) fn new(
        scheme: AnyScheme,
        system: OpenSystem,
        momenta: Option<(Arc<QuadraticMomenta>, bool)>,
        attitude: Option<[f64; 4]>,
    ) -> Self {
        let has_plus = system.base().has_plus_bracket();
        let sign = |is_plus| if is_plus == has_plus { 1.0 } else { -1.0 };
        let momenta = momenta.map(|(momenta, is_plus)| (momenta, sign(is_plus)));
        let (noise, dimension) = (&system.terms().noise, system.base().algebra().dimension());
        let has_flows = noise.as_ref().is_some_and(|noise| noise.fields.are_constant(dimension));
        Self { scheme: ByPointer(scheme), system, momenta, has_flows, attitude }
    }

    /// Returns the integrator if it can start from a state.
    pub(super) fn checked(self, start: &[f64]) -> Result<Self, FormulaSystemError> {
        self.start(&AnyState::from_slice(start))?;
        Ok(self)
    }

    /// Hides the type of the integrator, whose momenta are as large as a state.
    pub(super) fn erased(self, start: &[f64]) -> AnyIntegrator<dyn AnyTangents> {
        let zeros = |size: usize| AnyState::from_slice(&vec![0.0; size]);
        let momentum = match self.system.base().algebra().family {
            // Π and Γ have units of their own, which the structure constants of an algebra do not tell.
            Family::Motions => AnyState::of(&<Momentum<Se3>>::from_coordinates(|_| 0.0)),
            _ => AnyState::from_slice(start),
        };
        let point = match &self.momenta {
            Some((momenta, _)) => zeros(momenta.size()),
            None => momentum.zeros_like(),
        };
        let attitude = zeros(if self.attitude.is_some() { 4 } else { 0 });
        let clock = 2 + attitude.dimension();
        let state = Pair(point, Pair(Vector2::zeros(), attitude));
        AnyIntegrator::of_clocked_states(self, (&state, clock), &momentum)
    }

    fn dimension(&self) -> usize {
        self.system.base().algebra().dimension()
    }

    /// Returns how a step is divided.
    fn parts(&self) -> StepParts<'_> {
        let noise = self.system.terms().noise.as_ref().zip(self.system.paths());
        let noise =
            noise.map(|(noise, paths)| (paths, noise.rule, noise.fields.count(self.dimension())));
        StepParts { interval: self.system.interval(), noise }
    }

    fn momentum_of<T: Real>(&self, z: &AnyState<T>) -> AnyState<T> {
        let Some((momenta, _)) = &self.momenta else { return z.clone() };
        let mut mu = vec![T::zero(); self.dimension()];
        momenta.values(z.as_slice(), &mut mu);
        AnyState::from_slice(&mu)
    }

    /// Moves a point back along its fibre, which changes its momentum by rounding. That it happens after a number of intervals keeps
    /// runs that are resumed to the bit.
    fn move_back<T: Real>(&self, Pair(z, Pair(clock, _)): &mut OpenState<T>) {
        let Some((momenta, _)) = &self.momenta else { return };
        if clock.y.as_f64().is_none_or(|clock| clock == 0.0 || clock % MOVED != 0.0) {
            return;
        }
        let numbers: Vec<f64> = z.as_slice().iter().filter_map(|x| x.as_f64()).collect();
        if let Some(moved) = momenta.recentred(&numbers) {
            z.set_coordinates(|i| T::from_f64(moved.get(i).copied().unwrap_or(f64::NAN)));
        }
    }
}

impl<T: Real> Integrator<T> for OpenIntegrator {
    type State = OpenState<T>;
    type Momentum = AnyState<T>;
    type Workspace = OpenWorkspace<<ByPointer<AnyScheme> as Scheme>::Workspace<OpenState<T>>, T>;

    fn workspace(&self) -> Self::Workspace {
        let scratch = Scratch::new(self.dimension());
        OpenWorkspace { scheme: self.scheme.workspace(), scratch, is_pinned: false }
    }

    fn step(
        &self,
        state: &OpenState<T>,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<OpenState<T>>, StepError> {
        let mut point = state.clone();
        let OpenWorkspace { scheme, scratch, is_pinned } = workspace;
        if !*is_pinned {
            self.move_back(&mut point);
        }
        let clock = point.1.0;
        // Tangent vectors compare motions at the same time and on the same path, whatever the derivatives of the clock are.
        point.1.0 = clock.map(|x| x.lane_by_lane(x, |x, _| x));
        let inputs = &self.system.terms().inputs;
        let momenta = self.momenta.as_ref().map(|(momenta, sign)| (&**momenta, *sign));
        let iterations = self.parts().make(
            (point.1.0.x, point.1.0.y),
            step,
            |time, forward| inputs.next_break(time, forward),
            |window, part| {
                let system = &self.system;
                let mut make = |motions, part: NoisePart<'_, T>| {
                    let field = OpenField { system, momenta, part, motions, window, scratch };
                    if part.drift == 0.0 && self.has_flows {
                        field.place(&point);
                        let along = OpenField { motions: Motions::AlongElement, ..field };
                        return affine_flow(
                            |v, rate| along.at_into(v, rate),
                            part.step,
                            &mut point,
                        );
                    }
                    // The noise before says nothing about that of this part.
                    if system.paths().is_some() {
                        self.scheme.forget(scheme);
                    }
                    self.scheme.step_in_place(&field, &mut point, part.step, scheme)
                };
                if system.terms().torque.is_none() || part.weights.is_empty() || part.drift == 0.0 {
                    return make(Motions::All, part);
                }
                // The increments of a noise are too large for stages that a torque is to take off the orbit with the order of the
                // scheme: Strang's splitting.
                let half = NoisePart { weights: &[], step: 0.5 * part.step, ..part };
                let before = make(Motions::OfTorque, half)?;
                let on_orbit = make(Motions::OnOrbit, part)?;
                Ok(before + on_orbit + make(Motions::OfTorque, half)?)
            },
        )?;
        // The weights of a method add up to 1 but for rounding, which would make the time drift.
        let elapsed = T::from_f64(step / self.system.interval());
        point.1.0 = Vector2::new(clock.x, clock.y + elapsed);
        Ok(Step { point, iterations })
    }

    fn forget(&self, workspace: &mut Self::Workspace) {
        self.scheme.forget(&mut workspace.scheme);
    }

    fn pin(&self, workspace: &mut Self::Workspace) {
        workspace.is_pinned = true;
    }

    fn momentum(&self, Pair(z, _): &OpenState<T>) -> AnyState<T> {
        self.momentum_of(z)
    }
}

impl Start for OpenIntegrator {
    fn start(&self, mu: &AnyState) -> Result<OpenState<f64>, LiftError> {
        let z = match &self.momenta {
            Some((momenta, _)) => AnyState::from_slice(&momenta.short_lift(mu.as_slice())?),
            None => mu.clone(),
        };
        let path = self.system.terms().noise.as_ref().map_or(0, |noise| noise.path);
        let attitude = self.attitude.as_ref().map_or(&[][..], |attitude| attitude);
        Ok(Pair(z, Pair(Vector2::new(path as f64, 0.0), AnyState::from_slice(attitude))))
    }
}
