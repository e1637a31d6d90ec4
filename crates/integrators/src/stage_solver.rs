//! Fixed-point iteration for the stage equations, to the round-off floor.

use crate::{StepError, Tableau, VectorField};
use lie_poisson::{Real, Vector, larger};

/// An iteration that no longer gets better is accepted below this multiple of the size of the
/// stage derivatives: the round-off of evaluating a vector field, with room for cancellation in
/// it.
const ROUND_OFF: f64 = 1024.0 * f64::EPSILON;

/// How to solve the stage equations k_i = X(z + h Σ_j a_ij k_j).
///
/// The iteration is of Gauss–Seidel kind and starts from k_i = X(z), so that a step depends on
/// its starting point alone.
///
/// Source of the stopping rule: Hairer, McLachlan & Razakarivony, *Achieving Brouwer's law with
/// implicit Runge–Kutta methods*, BIT 48 (2008), §2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StageSolver {
    /// Accept when h max |Δk| is at most this. 0 iterates to the round-off floor: until nothing
    /// changes, or the changes stop shrinking at the size of round-off.
    pub tolerance: f64,
    /// Give up after this many iterations.
    pub max_iterations: usize,
}

impl Default for StageSolver {
    /// To the round-off floor, within 200 iterations.
    fn default() -> Self {
        Self { tolerance: 0.0, max_iterations: 200 }
    }
}

impl StageSolver {
    /// Solves for the stages `k`, of which there must be as many as rows; returns the number of
    /// iterations.
    ///
    /// # Errors
    /// [`StepError::NotConverged`] if the iteration blows up or does not settle.
    pub(crate) fn solve<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &F::Point,
        step: f64,
        tableau: &Tableau,
        k: &mut [F::Point],
    ) -> Result<usize, StepError> {
        k.fill(field.at(z));
        let mut previous = f64::INFINITY;
        for iteration in 1..=self.max_iterations {
            let (change, size) = sweep(field, z, step, tableau, k);
            let floor = ROUND_OFF * size;
            let settled = change == 0.0 || (change >= previous && change <= floor);
            if settled || change * step.abs() <= self.tolerance {
                return Ok(iteration);
            }
            if !change.is_finite() || iteration == self.max_iterations {
                return Err(StepError::NotConverged {
                    residual: change * step.abs(),
                    required: self.tolerance.max(floor * step.abs()),
                    iterations: iteration,
                });
            }
            previous = change;
        }
        Err(StepError::NotConverged {
            residual: f64::INFINITY,
            required: self.tolerance,
            iterations: 0,
        })
    }
}

/// One sweep over all stages; returns the largest change and the largest stage derivative.
#[inline]
fn sweep<T: Real, F: VectorField<T>>(
    field: &F,
    z: &F::Point,
    step: f64,
    tableau: &Tableau,
    k: &mut [F::Point],
) -> (f64, f64) {
    let (mut change, mut size) = (0.0, 0.0);
    for (i, row) in tableau.rows().enumerate() {
        let derivative = field.at(&stage_point(z, step, row, k));
        change = larger(change, (derivative - k[i]).max_abs());
        size = larger(size, derivative.max_abs());
        k[i] = derivative;
    }
    (change, size)
}

/// z + h Σ_j a_j k_j, the small sum first.
#[inline]
pub(crate) fn stage_point<V: Vector>(z: &V, step: f64, row: &[f64], k: &[V]) -> V {
    let mut sum = V::zero();
    for (&a, k) in row.iter().zip(k) {
        sum.add_scaled(V::Scalar::from_f64(a), k);
    }
    *z + sum.scaled(V::Scalar::from_f64(step))
}
