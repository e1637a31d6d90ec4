//! Iterations for the stage equations, to the round-off floor.

use crate::newton::{NewtonSpace, newton_step};
use crate::{StepError, Tableau, VectorField};
use lie_poisson::{Real, Vector, larger};

/// A change that grows again is at the floor at once below this multiple of the size of the stage
/// derivatives: a few roundings.
const FEW_ROUNDINGS: f64 = 8.0 * f64::EPSILON;

/// An iteration that no longer gets better is accepted below this multiple of the size of the
/// stage derivatives: the round-off of evaluating a vector field, with room for cancellation in
/// it.
pub(crate) const ROUND_OFF: f64 = 1024.0 * f64::EPSILON;

/// Sweeps without a new least change after which an iteration no longer gets better. Changes of a
/// converging iteration go up and down where q feeds p and p feeds q with different strengths, so
/// that one larger change alone says nothing.
const PATIENCE: usize = 4;

/// Sweeps after which a fixed-point iteration that has not settled gives way to Newton's.
const SLOW: usize = 60;

/// Newton iterations after which the stage equations count as not solved.
const NEWTON_ITERATIONS: usize = 50;

/// How to solve the stage equations k_i = X(z + h Σ_j a_ij k_j).
///
/// First a fixed-point iteration of Gauss–Seidel kind from k_i = X(z), so that a step depends on
/// its starting point alone. Where it is slow or diverges, for large steps, Newton's iteration
/// takes over, with the exact derivative of the field if it is known
/// ([`VectorField::derivative`]).
///
/// Source of the stopping rule: Hairer, McLachlan & Razakarivony, *Achieving Brouwer's law with
/// implicit Runge–Kutta methods*, BIT 48 (2008), §2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StageSolver {
    /// Accept when h max |Δk| is at most this. 0 iterates to the round-off floor: until nothing
    /// changes, or the changes stop shrinking at the size of round-off.
    pub tolerance: f64,
    /// Give up the fixed-point iteration after this many sweeps.
    pub max_iterations: usize,
    /// Whether Newton's iteration may follow.
    pub newton: bool,
}

impl Default for StageSolver {
    /// To the round-off floor, within 60 sweeps, then by Newton's iteration.
    fn default() -> Self {
        Self { tolerance: 0.0, max_iterations: SLOW, newton: true }
    }
}

/// The changes of an iteration, watched for the moment at which they are round-off.
struct Watch {
    previous: f64,
    least: f64,
    stalled: usize,
}

impl Watch {
    fn new() -> Self {
        Self { previous: f64::INFINITY, least: f64::INFINITY, stalled: 0 }
    }

    /// Whether a change is the last that means anything, for stages of the given size.
    fn settled(&mut self, change: f64, size: f64) -> bool {
        self.stalled = if change < self.least { 0 } else { self.stalled + 1 };
        self.least = self.least.min(change);
        // ∞ ≤ ∞ would pass for round-off.
        let settled = change == 0.0
            || (change >= self.previous && change <= FEW_ROUNDINGS * size)
            || (self.stalled >= PATIENCE && change <= ROUND_OFF * size);
        let settled = settled && change.is_finite() && size.is_finite();
        self.previous = change;
        settled
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
        space: &mut NewtonSpace<T>,
    ) -> Result<usize, StepError> {
        let start = field.at(z);
        k.fill(start);
        let sweeps =
            self.iterate(self.max_iterations, step, || Some(sweep(field, z, step, tableau, k)));
        match sweeps {
            Err(StepError::NotConverged { iterations, .. }) if self.newton => {
                k.fill(start);
                let newton = self.iterate(NEWTON_ITERATIONS, step, || {
                    newton_step(field, z, step, tableau, k, space)
                });
                newton.map(|more| iterations + more)
            }
            outcome => outcome,
        }
    }

    /// Iterates until the change settles; `advance` returns it with the size of the stages.
    fn iterate(
        &self,
        most: usize,
        step: f64,
        mut advance: impl FnMut() -> Option<(f64, f64)>,
    ) -> Result<usize, StepError> {
        let mut watch = Watch::new();
        let mut failure = StepError::NotConverged {
            residual: f64::INFINITY,
            required: self.tolerance,
            iterations: 0,
        };
        for iterations in 1..=most {
            let (change, size) = advance().unwrap_or((f64::INFINITY, f64::INFINITY));
            if watch.settled(change, size) || change * step.abs() <= self.tolerance {
                return Ok(iterations);
            }
            let required = self.tolerance.max(ROUND_OFF * size * step.abs());
            failure =
                StepError::NotConverged { residual: change * step.abs(), required, iterations };
            if !change.is_finite() {
                break;
            }
        }
        Err(failure)
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
