//! Predictions for integrators with their own stage equations: [`StageMemory`].

use crate::iteration::block_sizes::MaskOf;
use crate::iteration::convergence::unknown;
use crate::iteration::stage_scale::OwnScale;
use crate::iteration::stage_solver::{ByValue, StageEquations, StageSolver, Unconverged};
use crate::stages::extrapolation::Predictor;
use crate::stages::history::StageHistory;
use crate::vector_field::from_fn;
use lie_poisson::{Mask, Real, State};

/// The memory of earlier steps for an integrator that has its own stage equations k_i = f_i(k).
///
/// The next step of equal size begins its iteration with the polynomial through the remembered k, as
/// [`RungeKutta`](crate::RungeKutta) methods do.
///
/// A prediction affects the last bits of a result. [`forget`](Self::forget) makes them independent of the earlier
/// steps.
///
/// # Example
/// The midpoint rule for a pendulum, with the velocity (dq/dt, dp/dt) = (p, −sin q) at the midpoint as unknown:
/// ```
/// use collective_integrators::{StageMemory, StageSolver};
/// use nalgebra::Vector2;
/// let rate = |z: Vector2<f64>| Vector2::new(z.y, -z.x.sin());
/// let (h, solver) = (0.05, StageSolver::default());
/// let (mut z, mut memory) = (Vector2::new(1.0, 0.0), StageMemory::new(&[0.5]));
/// let mut sweeps = Vec::new();
/// for _ in 0..1000 {
///     let mut k = [Vector2::zeros()];
///     let solve = |_, k: &[Vector2<f64>]| rate(z + k[0] * (h / 2.0));
///     sweeps.push(memory.solve(&solver, &z, h, &mut k, || rate(z), solve)?);
///     z += k[0] * h;
///     memory.end_at(&z);
/// }
/// assert!((z.y * z.y / 2.0 - z.x.cos() + 1.0_f64.cos()).abs() < 1e-3);
/// assert!(sweeps.iter().skip(8).all(|n| n < &sweeps[0]));
/// # Ok::<(), collective_integrators::StepError>(())
/// ```
#[derive(Clone, Debug)]
pub struct StageMemory<V: State> {
    predictor: Predictor,
    memory: StageHistory<V>,
    pool: V::Pool,
}

impl<V: State> StageMemory<V> {
    /// Creates an empty memory for stages at the times c, in steps. If two of them coincide, nothing is predicted.
    #[must_use]
    pub fn new(nodes: &[f64]) -> Self {
        let predictor = Predictor::new(nodes);
        Self { memory: StageHistory::new(&predictor), predictor, pool: V::Pool::default() }
    }

    /// Solves k_i = `stage`(i, k) as [`StageSolver::solve`] does, for a step of the given size from z. Returns the
    /// number of iterations.
    ///
    /// The iteration starts from a prediction if z is the end of the last step. Otherwise, or if that fails, it starts
    /// from k_i = `first`(). If the number of stages differs from that of the nodes, there is no prediction, and
    /// nothing is remembered.
    ///
    /// # Errors
    /// Returns [`Unconverged`] if the iteration diverges or does not converge in some SIMD lane (one of several
    /// trajectories in one register). The other lanes hold their k, and remember it. The operator `?` converts the
    /// error into a [`StepError`](crate::StepError).
    #[cfg_attr(optimised, inline(always))]
    pub fn solve(
        &mut self,
        solver: &StageSolver,
        z: &V,
        step: f64,
        k: &mut [V],
        first: impl Fn() -> V,
        stage: impl Fn(usize, &[V]) -> V,
    ) -> Result<usize, Unconverged<<V::Scalar as Real>::Mask>> {
        let mut spare = V::take(&mut self.pool, z);
        let mut stage = ByValue(stage);
        let solved = if k.len() == self.predictor.stages {
            let (field, from) = (from_fn(|_: &V| first()), (z, step, &OwnScale));
            self.memory.solve(&self.predictor, solver, &field, from, (k, &mut spare), stage)
        } else {
            self.memory.forget();
            without_guess(solver, &first(), (k, &mut spare), &mut stage)
        };
        spare.give(&mut self.pool);
        solved
    }

    /// Records the end of the step that was solved last.
    #[cfg_attr(optimised, inline(always))]
    pub fn end_at(&mut self, z: &V) {
        self.memory.end_at(z);
    }

    /// Forgets all earlier steps.
    #[cfg_attr(optimised, inline(always))]
    pub fn forget(&mut self) {
        self.memory.forget();
    }
}

/// Solves the stage equations from k_i = `start`.
#[cold]
#[inline(never)]
fn without_guess<V: State>(
    solver: &StageSolver,
    start: &V,
    (k, spare): (&mut [V], &mut V),
    equations: &mut impl StageEquations<V>,
) -> Result<usize, Unconverged<MaskOf<V>>> {
    k.iter_mut().for_each(|k| k.assign(start));
    let none = Mask::from_bool(false);
    solver.solve_from(none, &OwnScale, k, spare, &mut unknown(), equations)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use nalgebra::{Vector1, Vector2};

    /// The equation at every stage is k = (k + z)/2, and the last k is the solution.
    #[test]
    fn other_numbers_of_stages_are_solved_without_a_guess_and_forgotten() {
        let (mut memory, z) = (StageMemory::new(&[0.25, 0.75]), Vector1::new(1.0));
        let mut sweeps = |stages: usize| {
            let mut k = vec![Vector1::new(0.0); stages];
            let first = || Vector1::new(0.75);
            let stage = |i: usize, k: &[Vector1<f64>]| (k[i] + z) * 0.5;
            let solver = StageSolver::default();
            let made = memory.solve(&solver, &z, 0.1, &mut k, first, stage).unwrap();
            memory.end_at(&z);
            // the rounding errors that the ratio ½ leaves
            assert!(k.iter().all(|k| (k.x - 1.0).abs() < 4.0 * f64::EPSILON), "{stages} {k:?}");
            made
        };
        let cold = sweeps(2);
        assert!(sweeps(2) < cold);
        for stages in [0, 1, 3] {
            assert!(stages == 0 || sweeps(stages) > 2);
            assert_eq!(sweeps(stages), sweeps(stages));
            assert_eq!(sweeps(2), cold);
            assert!(sweeps(2) < cold);
        }
    }

    /// Makes a step of the midpoint rule of a pendulum, and returns its end with the number of sweeps.
    fn step(memory: &mut StageMemory<Vector2<f64>>, z: Vector2<f64>) -> (Vector2<f64>, usize) {
        let (h, rate) = (0.1, |z: Vector2<f64>| Vector2::new(z.y, -z.x.sin()));
        let mut k = [Vector2::zeros()];
        let solve = |_, k: &[Vector2<f64>]| rate(z + k[0] * (h / 2.0));
        let solver = StageSolver::default();
        let sweeps = memory.solve(&solver, &z, h, &mut k, || rate(z), solve).unwrap();
        let end = z + k[0] * h;
        memory.end_at(&end);
        (end, sweeps)
    }

    /// A memory that is forgotten, or belongs to another point, is that of no step.
    #[test]
    fn a_step_that_continues_nothing_is_the_first_one() {
        let (mut memory, start) = (StageMemory::new(&[0.5]), Vector2::new(1.0, 0.3));
        let first = step(&mut memory, start);
        let mut z = first.0;
        for _ in 0..20 {
            z = step(&mut memory, z).0;
        }
        let anew = step(&mut StageMemory::new(&[0.5]), z);
        // Control: the next step of the motion needs fewer sweeps.
        assert!(step(&mut memory.clone(), z).1 < anew.1);
        assert_eq!(step(&mut memory.clone(), start), first);
        memory.forget();
        assert_eq!(step(&mut memory, z), anew);
    }
}
