//! Fixed-point iteration for the stage equations, to the round-off floor.

use crate::{StepError, Tableau, VectorField};
use lie_poisson::{Real, Vector, larger};

/// A change that grows again is at the floor at once below this multiple of the size of the stage
/// derivatives: a few roundings.
const FEW_ROUNDINGS: f64 = 8.0 * f64::EPSILON;

/// An iteration that no longer gets better is accepted below this multiple of the size of the
/// stage derivatives: the round-off of evaluating a vector field, with room for cancellation in
/// it.
const ROUND_OFF: f64 = 1024.0 * f64::EPSILON;

/// Sweeps without a new least change after which an iteration no longer gets better. Changes of a
/// converging iteration go up and down where q feeds p and p feeds q with different strengths, so
/// that one larger change alone says nothing.
const PATIENCE: usize = 4;

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
        let (mut previous, mut least, mut stalled) = (f64::INFINITY, f64::INFINITY, 0);
        for iteration in 1..=self.max_iterations {
            let (change, size) = sweep(field, z, step, tableau, k);
            let floor = ROUND_OFF * size;
            stalled = if change < least { 0 } else { stalled + 1 };
            least = least.min(change);
            let settled = change == 0.0
                || (change >= previous && change <= FEW_ROUNDINGS * size)
                || (stalled >= PATIENCE && change <= floor);
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

#[cfg(test)]
mod tests {
    use crate::{RungeKutta, Scheme, from_fn};
    use nalgebra::Vector2;

    /// ẋ = 16 y, ẏ = −x/2 with h = ½: one sweep multiplies the change by 4 and the next by ⅛, in one
    /// or the other order. The midpoint rule is x₁ = (x/2 + 8y)/c, y₁ = (y/2 − x/4)/c, c = 3/2.
    #[test]
    fn an_iteration_that_converges_up_and_down_is_followed_to_the_floor() {
        let field = from_fn(|z: &Vector2<f64>| Vector2::new(16.0 * z.y, -0.5 * z.x));
        let midpoint = RungeKutta::implicit_midpoint();
        for z in [Vector2::new(1.0, 0.3), Vector2::new(-0.2, 0.9), Vector2::new(0.5, -2.0)] {
            let step = midpoint.step(&field, &z, 0.5, &mut midpoint.workspace()).map(|s| s.point);
            let exact = Vector2::new(0.5 * z.x + 8.0 * z.y, 0.5 * z.y - 0.25 * z.x) / 1.5;
            // the round-off of ẋ, up to 32 ε here, a few times over
            assert!(step.is_ok_and(|step| (step - exact).amax() < 128.0 * f64::EPSILON));
        }
    }
}
