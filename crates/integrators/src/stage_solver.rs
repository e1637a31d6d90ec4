//! Iterations for the stage equations, to the round-off floor.

use crate::StepError;
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
/// First a fixed-point iteration of Gauss–Seidel kind. In a step that goes on from steps of the same
/// size it begins with the polynomial through their stage derivatives, else with k_i = X(z): where
/// it begins shows in the last bits of a result, which [`Scheme::forget`](crate::Scheme::forget)
/// makes independent of the steps before. Where it is slow or diverges, for large steps, Newton's
/// iteration takes over, with the exact derivative of the field if it is known
/// ([`VectorField::derivative`](crate::VectorField::derivative)).
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
        // An infinite change is not above an infinite floor, and not at it either.
        let settled = change == 0.0
            || (change >= self.previous && change <= FEW_ROUNDINGS * size)
            || (self.stalled >= PATIENCE && change <= ROUND_OFF * size);
        let settled = settled && change.is_finite() && size.is_finite();
        self.previous = change;
        settled
    }
}

impl StageSolver {
    /// Solves k_i = `derivative`(i, k) for the stages `k`, all of which start from `start`, by
    /// fixed-point iteration; returns the number of iterations. `derivative` computes X at the
    /// i-th stage; `step` only turns changes into the residuals h |Δk| of messages and tolerance.
    ///
    /// # Errors
    /// [`StepError::NotConverged`] if the iteration blows up or does not settle.
    #[inline]
    pub fn solve<V: Vector>(
        &self,
        start: V,
        step: f64,
        k: &mut [V],
        derivative: impl Fn(usize, &[V]) -> V,
    ) -> Result<usize, StepError> {
        k.fill(start);
        self.solve_from(step, k, derivative)
    }

    /// The same from the guess that `k` holds.
    #[inline]
    pub(crate) fn solve_from<V: Vector>(
        &self,
        step: f64,
        k: &mut [V],
        derivative: impl Fn(usize, &[V]) -> V,
    ) -> Result<usize, StepError> {
        self.iterate(self.max_iterations, step, || Some(sweep(k, &derivative)))
    }

    /// Newton's iteration from k_i = `start`; `advance` makes one iteration and returns its change and
    /// the size of the stages. Returns the number of iterations.
    ///
    /// # Errors
    /// [`StepError::NotConverged`] if it does not settle.
    #[inline]
    pub(crate) fn newton<V: Vector>(
        &self,
        start: V,
        step: f64,
        k: &mut [V],
        mut advance: impl FnMut(&mut [V]) -> Option<(f64, f64)>,
    ) -> Result<usize, StepError> {
        k.fill(start);
        self.iterate(NEWTON_ITERATIONS, step, || advance(k))
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
            let required = larger(self.tolerance, ROUND_OFF * size * step.abs());
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
fn sweep<V: Vector>(k: &mut [V], derivative: &impl Fn(usize, &[V]) -> V) -> (f64, f64) {
    let (mut change, mut size) = (0.0, 0.0);
    for i in 0..k.len() {
        let value = derivative(i, k);
        change = larger(change, (value - k[i]).max_abs());
        size = larger(size, value.max_abs());
        k[i] = value;
    }
    (change, size)
}

/// z + h Σ_j (a_j + low_j) k_j, the small sums first; `low` may be empty.
#[inline]
pub(crate) fn stage_point<V: Vector>(z: &V, step: f64, row: &[f64], low: &[f64], k: &[V]) -> V {
    *z + stage_sum(step, row, low, k)
}

/// h Σ_j (a_j + low_j) k_j
#[inline]
pub(crate) fn stage_sum<V: Vector>(step: f64, row: &[f64], low: &[f64], k: &[V]) -> V {
    let mut sum = V::zero();
    for (&a, k) in row.iter().zip(k) {
        sum.add_scaled(V::Scalar::from_f64(a), k);
    }
    if !low.is_empty() {
        let mut small = V::zero();
        for (&a, k) in low.iter().zip(k) {
            small.add_scaled(V::Scalar::from_f64(a), k);
        }
        sum += small;
    }
    sum.scaled(V::Scalar::from_f64(step))
}

#[cfg(test)]
mod tests {
    use crate::{RungeKutta, Scheme, StepError, from_fn};
    use nalgebra::{Vector1, Vector2};

    #[test]
    fn an_iteration_that_blows_up_is_refused() {
        let field = from_fn(|z: &Vector1<f64>| z.map(|x| x * x * 1e6));
        let midpoint = RungeKutta::implicit_midpoint();
        let step = midpoint.step(&field, &Vector1::new(1.0), 1.0, &mut midpoint.workspace());
        assert!(matches!(step, Err(StepError::NotConverged { .. })));
    }

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
