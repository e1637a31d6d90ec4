//! Steps that are refused if they lose an invariant: [`InvariantGuard`].

use crate::FormulaSystemError;
use collective_integrators::{Integrator, Start, Step, StepError};
use lie_poisson::{
    Covector, Hamiltonian, LieAlgebra, LiePoisson, Momentum, Real, StructureConstants, Vector,
    larger,
};
use lie_poisson_formulas::{Formula, FormulaHamiltonian};
use momentum_map::LiftError;
use nalgebra::SVector;

/// An integrator on 𝔤∗ whose steps fail if h or a Casimir changes by more than the order of the method allows.
///
/// A step of a method of order p changes an invariant f by an error of the size (h r)ᵖ⁺¹ S, with the rate r of the motion
/// and the size S of the terms of f. In the time t since the last checkpoint, the change may be
///
/// ```text
/// |Δf| ≤ S ((h r)ᵖ (1 + r t) + ROUND_OFF),    S = max Σ_i |μ_i ∂_i f|,    r = max_j Σ_ik |c_ijk ∂_i h|
/// ```
///
/// with the largest S and r of the states before the step. A state that has left its orbit, or its level of the energy, by
/// more is wrong, even if it solves the equations of the step. For steps that resolve the motion the inequality holds with
/// room, since r is a bound and the constants of the methods are small.
pub(super) struct InvariantGuard<I, const N: usize> {
    integrator: I,
    order: i32,
    algebra: StructureConstants<N>,
    /// The Hamiltonian, then the Casimirs.
    invariants: Vec<FormulaHamiltonian<StructureConstants<N>>>,
}

/// The relative change of an invariant that round-off may cause between two checkpoints.
const ROUND_OFF: f64 = 1e-9;

/// The storage of guarded steps: that of the integrator, and what changes are compared with.
pub(super) struct GuardedSpace<W, V> {
    inner: W,
    /// The end of the last step.
    end: Option<V>,
    since: Record,
}

/// The invariants of a state, with the sizes and rates of the states since.
#[derive(Default)]
struct Record {
    values: Vec<f64>,
    terms: Vec<f64>,
    rate: f64,
    time: f64,
}

impl<I, const N: usize> InvariantGuard<I, N> {
    /// Guards an integrator of this order.
    pub(super) fn new<'a>(
        integrator: I,
        order: usize,
        algebra: StructureConstants<N>,
        invariants: impl Iterator<Item = &'a Formula>,
    ) -> Result<Self, FormulaSystemError> {
        let invariants = invariants.map(FormulaHamiltonian::of).collect::<Result<_, _>>();
        let invariants = invariants.map_err(FormulaSystemError::Hamiltonian)?;
        Ok(Self {
            integrator,
            order: i32::try_from(order).unwrap_or(i32::MAX),
            algebra,
            invariants,
        })
    }

    /// Returns the largest rate at which elements of 𝔤∗ move under ξ.
    fn rate(&self, xi: &SVector<f64, N>) -> f64 {
        let row = |j: usize| {
            let moved =
                |k: usize| (0..N).map(|i| self.algebra.constant(i, j, k) * xi[i]).sum::<f64>();
            (0..N).map(|k| moved(k).abs()).sum::<f64>()
        };
        (0..N).map(row).fold(0.0, larger)
    }

    /// Begins a record at μ.
    fn begin(&self, mu: &Momentum<StructureConstants<N>>, since: &mut Record) {
        since.values.clear();
        since.values.extend(self.invariants.iter().map(|f| value(f, mu)));
        since.terms.clear();
        since.terms.resize(self.invariants.len(), 0.0);
        (since.rate, since.time) = (0.0, 0.0);
        self.note(mu, since);
    }

    /// Enlarges the sizes and the rate of a record to those at μ.
    fn note(&self, mu: &Momentum<StructureConstants<N>>, since: &mut Record) {
        for (index, (f, terms)) in self.invariants.iter().zip(&mut since.terms).enumerate() {
            let slopes = differential(f, mu);
            let sum = (0..N).map(|i| (slopes[i] * mu.0[i]).abs()).sum();
            *terms = larger(*terms, sum);
            if index == 0 {
                since.rate = larger(since.rate, self.rate(&slopes));
            }
        }
    }

    /// Checks the invariants at μ after a step, and records μ.
    fn check(
        &self,
        mu: &Momentum<StructureConstants<N>>,
        step: f64,
        since: &mut Record,
    ) -> Result<(), StepError> {
        since.time += step.abs();
        let order = (step * since.rate).abs().powi(self.order);
        let relative = order * (1.0 + since.rate * since.time) + ROUND_OFF;
        let before = since.values.iter().zip(&since.terms);
        for (index, (f, (before, terms))) in self.invariants.iter().zip(before).enumerate() {
            let (change, allowed) = ((value(f, mu) - before).abs(), relative * terms);
            // A NaN is left to the error that says so.
            if change > allowed {
                return Err(StepError::InvariantLost { index, change, allowed });
            }
        }
        self.note(mu, since);
        Ok(())
    }
}

fn value<A: LieAlgebra>(f: &FormulaHamiltonian<A>, mu: &Momentum<A>) -> f64 {
    Hamiltonian::<LiePoisson<A>>::value(f, mu)
}

fn differential<A: LieAlgebra>(f: &FormulaHamiltonian<A>, mu: &Momentum<A>) -> A::Element<f64> {
    Hamiltonian::<LiePoisson<A>>::differential(f, mu)
}

/// Returns a momentum as numbers, or `None` over another scalar, whose steps are those of numbers.
fn numbers<T: Real, const N: usize>(
    mu: &Covector<SVector<T, N>>,
) -> Option<Momentum<StructureConstants<N>>> {
    mu.coordinate(0).as_f64()?;
    Some(Covector(SVector::from_fn(|i, _| mu.0[i].as_f64().unwrap_or(f64::NAN))))
}

impl<T, I, const N: usize> Integrator<T> for InvariantGuard<I, N>
where
    T: Real,
    I: Integrator<T, Momentum = Covector<SVector<T, N>>>,
{
    type State = I::State;
    type Momentum = I::Momentum;
    type Workspace = GuardedSpace<I::Workspace, I::State>;

    fn workspace(&self) -> Self::Workspace {
        GuardedSpace { inner: self.integrator.workspace(), end: None, since: Record::default() }
    }

    fn step(
        &self,
        state: &I::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<I::State>, StepError> {
        let made = self.integrator.step(state, step, &mut workspace.inner)?;
        let Some(mu) = numbers(&self.integrator.momentum(&made.point)) else { return Ok(made) };
        let GuardedSpace { end, since, .. } = workspace;
        if end.as_ref() != Some(state)
            && let Some(start) = numbers(&self.integrator.momentum(state))
        {
            self.begin(&start, since);
        }
        let kept = self.check(&mu, step, since);
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

impl<T, I, const N: usize> Start<T> for InvariantGuard<I, N>
where
    T: Real,
    I: Start<T, Momentum = Covector<SVector<T, N>>>,
{
    fn start(&self, mu: &I::Momentum) -> Result<I::State, LiftError> {
        self.integrator.start(mu)
    }
}
