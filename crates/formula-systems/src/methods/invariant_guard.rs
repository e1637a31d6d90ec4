//! Steps that are refused if they lose an invariant: [`InvariantGuard`].

use crate::casimirs::casimir::{Casimir, ScalarFunction};
use crate::systems::formula_system::FormulaSystem;
use collective_integrators::{Integrator, Start, Step, StepError};
use lie_poisson::{Real, State, larger};
use lie_poisson_formulas::StructureEntry;
use momentum_map::LiftError;

/// An integrator on 𝔤∗ whose steps fail if h or a Casimir changes by more than the order of the method allows.
///
/// A step of a method of order p changes an invariant f by an error of the size (h r)ᵖ⁺¹ S, with the rate r of the motion
/// and the size S of the terms of f. In the time t since the last checkpoint, the change may be
///
/// ```text
/// |Δf| ≤ S ((h r)ᵖ (1 + r t) + ROUND_OFF) + MIXED m Σ_i |∂_i f(m, …, m)|
/// S = max Σ_i |μ_i ∂_i f|,    r = max_j Σ_ik |c_ijk ∂_i h|,    m = max_i |μ_i|
/// ```
///
/// with the largest S, r and m of the states before the step. The last term is for invariants whose terms vanish: points of
/// T∗V mix all coordinates, so that their rounding errors reach those that are zero. Where units make some coordinates a
/// million times smaller than others, it hides losses of what depends on these alone.
///
/// A state that has left its orbit, or its level of the energy, by more is wrong, even if it solves the equations of the step.
/// For steps that resolve the motion the inequality holds with room, since r is a bound and the constants of the methods are
/// small.
pub(super) struct InvariantGuard<I> {
    integrator: I,
    guarded: Guarded,
}

/// What is not to be lost, in the coordinates of the algebra.
struct Guarded {
    order: i32,
    dimension: usize,
    entries: Vec<StructureEntry>,
    /// The Hamiltonian, then the Casimirs.
    invariants: Vec<Casimir>,
}

/// The relative change of an invariant that round-off may cause between two checkpoints.
const ROUND_OFF: f64 = 1e-9;

/// The rounding error of a coordinate between two checkpoints, relative to the largest coordinate.
const MIXED: f64 = 1e-12;

/// The storage of guarded steps: that of the integrator, and what changes are compared with.
pub(super) struct GuardedWorkspace<W, V> {
    inner: W,
    /// The end of the last step.
    end: Option<V>,
    since: Record,
}

/// The invariants of a state, with the sizes and rates of the states since.
struct Record {
    values: Vec<f64>,
    terms: Vec<f64>,
    /// The changes of the invariants that rounding errors of the largest coordinate may cause.
    mixed: Vec<f64>,
    /// The largest coordinate with which these were computed.
    largest: f64,
    rate: f64,
    time: f64,
    /// The last momentum.
    mu: Vec<f64>,
    /// Space for a differential ξ, and for the matrix Σ_i c_ijk ξ_i.
    slopes: Vec<f64>,
    moved: Vec<f64>,
}

impl<I> InvariantGuard<I> {
    /// Guards an integrator of this order for a system. Its momenta begin with those of the system.
    pub(super) fn new(integrator: I, order: usize, system: &FormulaSystem) -> Self {
        let hamiltonian = Casimir::from(system.hamiltonian().clone());
        let invariants = core::iter::once(hamiltonian).chain(system.casimirs().iter().cloned());
        let guarded = Guarded {
            order: i32::try_from(order).unwrap_or(i32::MAX),
            dimension: system.algebra().dimension(),
            entries: system.algebra().entries().to_vec(),
            invariants: invariants.collect(),
        };
        Self { integrator, guarded }
    }
}

impl Guarded {
    fn record(&self) -> Record {
        let (n, count) = (self.dimension, self.invariants.len());
        let zeros = |length: usize| vec![0.0; length];
        Record {
            values: zeros(count),
            terms: zeros(count),
            mixed: zeros(count),
            largest: 0.0,
            rate: 0.0,
            time: 0.0,
            mu: zeros(n),
            slopes: zeros(n),
            moved: zeros(n * n),
        }
    }

    /// Writes a momentum into the record.
    fn take<V: State>(mu: &V, since: &mut Record) {
        let number = |i: usize| mu.coordinate(i).as_f64().unwrap_or(f64::NAN);
        since.mu.iter_mut().enumerate().for_each(|(i, x)| *x = number(i));
    }

    /// Begins at the momentum of the record.
    fn begin(&self, since: &mut Record) {
        for (f, value) in self.invariants.iter().zip(&mut since.values) {
            *value = f.value_at(&since.mu);
        }
        since.terms.fill(0.0);
        since.mixed.fill(0.0);
        since.largest = 0.0;
        (since.rate, since.time) = (0.0, 0.0);
        self.note(since);
    }

    /// Includes the sizes and the rate at the momentum of the record.
    fn note(&self, since: &mut Record) {
        for (index, f) in self.invariants.iter().enumerate() {
            f.write_differential(&since.mu, &mut since.slopes);
            let terms = since.slopes.iter().zip(&since.mu).map(|(slope, x)| (slope * x).abs());
            since.terms[index] = larger(since.terms[index], terms.sum());
            if index == 0 {
                since.rate = larger(since.rate, self.rate(&since.slopes, &mut since.moved));
            }
        }
        let largest = since.mu.iter().fold(0.0_f64, |most, x| larger(most, x.abs()));
        if largest <= since.largest {
            return;
        }
        since.largest = largest;
        since.moved.iter_mut().take(self.dimension).for_each(|x| *x = largest);
        for (f, mixed) in self.invariants.iter().zip(&mut since.mixed) {
            f.write_differential(
                since.moved.get(..self.dimension).unwrap_or_default(),
                &mut since.slopes,
            );
            let slopes: f64 = since.slopes.iter().map(|slope| slope.abs()).sum();
            // Where the invariant has no slopes with equal coordinates, there is no bound.
            let error = MIXED * largest * slopes;
            *mixed = if error.is_finite() { larger(*mixed, error) } else { *mixed };
        }
    }

    /// Returns a bound of the rate at which ad∗_ξ moves μ: the largest sum Σ_k |Σ_i c_ijk ξ_i|.
    fn rate(&self, xi: &[f64], moved: &mut [f64]) -> f64 {
        moved.fill(0.0);
        for &StructureEntry { i, j, k, value } in &self.entries {
            moved[j * self.dimension + k] += value * xi[i];
            moved[i * self.dimension + k] -= value * xi[j];
        }
        let rows = moved.chunks_exact(self.dimension.max(1));
        rows.map(|row| row.iter().map(|x| x.abs()).sum()).fold(0.0, larger)
    }

    /// Checks the momentum of the record, to which a step has led.
    fn check(&self, step: f64, since: &mut Record) -> Result<(), StepError> {
        since.time += step.abs();
        let order = (step * since.rate).abs().powi(self.order);
        let relative = order * (1.0 + since.rate * since.time) + ROUND_OFF;
        let before = since.values.iter().zip(&since.terms);
        for (index, (f, (before, terms))) in self.invariants.iter().zip(before).enumerate() {
            let change = (f.value_at(&since.mu) - before).abs();
            let allowed = relative * terms + since.mixed.get(index).copied().unwrap_or(0.0);
            // A NaN is left to the error that says so.
            if change > allowed {
                return Err(StepError::InvariantLost { index, change, allowed });
            }
        }
        self.note(since);
        Ok(())
    }
}

impl<T: Real, I: Integrator<T, Momentum: State>> Integrator<T> for InvariantGuard<I> {
    type State = I::State;
    type Momentum = I::Momentum;
    type Workspace = GuardedWorkspace<I::Workspace, I::State>;

    fn workspace(&self) -> Self::Workspace {
        let since = self.guarded.record();
        GuardedWorkspace { inner: self.integrator.workspace(), end: None, since }
    }

    fn step(
        &self,
        state: &I::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<I::State>, StepError> {
        let made = self.integrator.step(state, step, &mut workspace.inner)?;
        // Steps over dual numbers are those of numbers, which are guarded.
        if T::zero().as_f64().is_none() {
            return Ok(made);
        }
        let GuardedWorkspace { end, since, .. } = workspace;
        if end.as_ref() != Some(state) {
            Guarded::take(&self.integrator.momentum(state), since);
            self.guarded.begin(since);
        }
        Guarded::take(&self.integrator.momentum(&made.point), since);
        let kept = self.guarded.check(step, since);
        *end = kept.is_ok().then(|| made.point.clone());
        kept.map(|()| made)
    }

    fn forget(&self, workspace: &mut Self::Workspace) {
        self.integrator.forget(&mut workspace.inner);
        workspace.end = None;
    }

    fn pin(&self, workspace: &mut Self::Workspace) {
        self.integrator.pin(&mut workspace.inner);
    }

    fn momentum(&self, state: &I::State) -> I::Momentum {
        self.integrator.momentum(state)
    }
}

impl<T: Real, I: Start<T, Momentum: State>> Start<T> for InvariantGuard<I> {
    fn start(&self, mu: &I::Momentum) -> Result<I::State, LiftError> {
        self.integrator.start(mu)
    }
}
