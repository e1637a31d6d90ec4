//! The solution of the stage equations to the round-off floor, by iteration: [`StageSolver`].

use crate::error::StepError;
use crate::iteration::block_sizes::{BlockSizes, MaskOf};
use crate::iteration::convergence::{ConvergenceTest, FLOOR, Ratios, is_finite, unknown};
use crate::iteration::prediction::Prediction;
use crate::iteration::stage_scale::{OwnScale, Scale, SweepChange};
use lie_poisson::{Mask, Real, State, larger};
use nalgebra::Vector1;

/// The number of sweeps after which a fixed-point iteration that has not converged is replaced by Newton's.
const SLOW: usize = 60;

/// The multiple √ε of the size of the stage derivatives below which a change does not alter the contribution of the low
/// parts of the coefficients, to an accuracy of ε.
///
/// The contribution then has to be computed only once.
const CLOSE: f64 = 1.0 / (1 << 26) as f64;

/// The number of Newton iterations after which the stage equations count as not solved.
pub(crate) const NEWTON_ITERATIONS: usize = 50;

/// The solver of the stage equations k_i = X(z + h Σ_j a_ij k_j), with its settings.
///
/// The first method is a fixed-point iteration of Gauss–Seidel kind. In a step that continues from steps of the same
/// size it begins with the polynomial through their stage derivatives, otherwise with k_i = X(z). The starting point
/// affects the last bits of a result; [`Scheme::forget`](crate::Scheme::forget) makes them independent of the earlier
/// steps. If the iteration is slow or diverges, as for large steps, Newton's iteration continues, with the exact
/// derivative of the field if it is known ([`VectorField::derivative`](crate::VectorField::derivative)). It solves
/// dense linear equations, and is used for at most 1024 unknowns: stages times dimension.
///
/// The iteration stops at the round-off floor in one of three cases: nothing changes; the next change is expected to be
/// below a thirty-second of a rounding error, judged by the ratios of earlier changes, including those of the previous
/// step; or the changes are of the size of round-off and no longer decrease. The low parts of coefficients are included
/// once k is within √ε of the solution.
///
/// Stage equations that are not linear may have several solutions. One to which the iteration goes with changes that grow,
/// over a distance comparable with the stage derivatives themselves, is not accepted. If that of Newton's iteration from
/// X(z) is far, it is compared with the solution that is followed from short steps to the whole one.
///
/// Sizes are compared block by block, in units of the state ([`State::BLOCKS`]). For (q, p) with q of size 1e-20 and p
/// of size 1, both are found to the same number of digits.
///
/// Source of the last rule: Hairer, McLachlan & Razakarivony, *Achieving Brouwer's law with
/// implicit Runge–Kutta methods*, BIT 48 (2008), §2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StageSolver {
    /// The largest accepted h |Δk|, as a multiple of the larger of |z| and h |k|, in each block of coordinates. If the
    /// unknowns are not derivatives of the state ([`solve`](Self::solve), [`solve_by_sweeps`](Self::solve_by_sweeps),
    /// [`StageMemory`](crate::StageMemory)), it is the largest accepted |Δk| as a multiple of |k| in each block. It has
    /// no unit; 0 iterates to the round-off floor.
    pub tolerance: f64,
    /// The number of sweeps after which the fixed-point iteration is abandoned.
    pub max_iterations: usize,
    /// Whether Newton's iteration may follow the fixed-point iteration.
    pub newton: bool,
}

impl Default for StageSolver {
    /// Creates a solver to the round-off floor, with at most 60 sweeps, followed by Newton's iteration.
    fn default() -> Self {
        Self { tolerance: 0.0, max_iterations: SLOW, newton: true }
    }
}

/// The error of an iteration that has not converged in every SIMD lane (one of several trajectories in one register).
#[derive(Clone, Copy, Debug)]
pub struct Unconverged<M> {
    /// The lanes in which the iteration has converged.
    pub converged: M,
    /// The lanes in which it has converged to a solution far from the guess, which may not be that of the step.
    pub astray: M,
    /// The number of iterations made.
    pub iterations: usize,
    /// The error of the other lanes.
    pub error: StepError,
}

impl<M: Mask> Unconverged<M> {
    /// Returns the error of an iteration that has not been made.
    pub(crate) fn before() -> Self {
        let none = M::from_bool(false);
        let error = StepError::NotConverged { residual: f64::NAN, required: FLOOR, iterations: 0 };
        Self { converged: none, astray: none, iterations: 0, error }
    }

    /// Returns the outcome of an iteration whose results in some lanes do not count.
    pub(crate) fn unless(outcome: Result<usize, Self>, lanes: M) -> Result<usize, Self> {
        let (made, others) = (Self::before(), lanes.not());
        Err(match outcome {
            Ok(iterations) => Self { converged: others, iterations, ..made },
            Err(failed) => Self {
                converged: failed.converged.and(others),
                astray: failed.astray.and(others),
                ..failed
            },
        })
    }
}

/// Converts the error as if no lane had converged.
impl<M> From<Unconverged<M>> for StepError {
    fn from(unconverged: Unconverged<M>) -> Self {
        unconverged.error
    }
}

/// The right-hand sides of stage equations k_i = f_i(k). A closure implements it for exact coefficients.
pub(crate) trait StageEquations<V: State> {
    /// Returns whether the coefficients have low parts, which enter once k is [close](CLOSE) to the solution.
    fn has_low_parts(&self) -> bool;

    /// Writes f_i(k) to the value. In the lanes `near`, k has just come close to the solution.
    fn evaluate(&mut self, i: usize, k: &[V], near: MaskOf<V>, value: &mut V);

    /// Solves the equations from what is predicted, or from the guess in `k`, with one stage in each SIMD lane, if they
    /// support that and what is predicted is modest.
    ///
    /// The ratios are those of the changes in the previous iteration, and the number is that of its sweeps from as good a
    /// guess, or 0.
    #[cfg_attr(optimised, inline(always))]
    fn solve_in_lanes(
        &mut self,
        _solver: &StageSolver,
        _k: &mut [V],
        _prediction: Option<Prediction<'_, V>>,
        _pace: (&mut Ratios<V::Scalar>, usize),
    ) -> Option<Result<usize, Unconverged<MaskOf<V>>>> {
        None
    }
}

impl<V: State, F: FnMut(usize, &[V], &mut V)> StageEquations<V> for F {
    #[cfg_attr(optimised, inline(always))]
    fn has_low_parts(&self) -> bool {
        false
    }

    #[cfg_attr(optimised, inline(always))]
    fn evaluate(&mut self, i: usize, k: &[V], _near: MaskOf<V>, value: &mut V) {
        self(i, k, value);
    }
}

/// Stage equations given by a function that returns f_i(k).
pub(crate) struct ByValue<F>(pub F);

impl<V: State, F: Fn(usize, &[V]) -> V> StageEquations<V> for ByValue<F> {
    #[cfg_attr(optimised, inline(always))]
    fn has_low_parts(&self) -> bool {
        false
    }

    #[cfg_attr(optimised, inline(always))]
    fn evaluate(&mut self, i: usize, k: &[V], _near: MaskOf<V>, value: &mut V) {
        *value = (self.0)(i, k);
    }
}

impl StageSolver {
    /// Solves k_i = `derivative`(i, k) for the stages `k` by fixed-point iteration, and returns the number of
    /// iterations.
    ///
    /// All stages start from `start`. The closure `derivative` computes X at the i-th stage. The changes of each block
    /// of coordinates are compared with that block.
    ///
    /// Over SIMD lanes (several trajectories in one register) the iteration stops in each lane by itself, with the
    /// stages that the lane would have alone.
    ///
    /// # Errors
    /// Returns [`StepError::NotConverged`] if the iteration diverges or does not converge in some lane.
    #[cfg_attr(optimised, inline(always))]
    pub fn solve<V: State>(
        &self,
        mut start: V,
        k: &mut [V],
        derivative: impl Fn(usize, &[V]) -> V,
    ) -> Result<usize, StepError> {
        k.iter_mut().for_each(|k| k.assign(&start));
        let none = MaskOf::<V>::from_bool(false);
        self.solve_from(none, &OwnScale, k, &mut start, &mut unknown(), &mut ByValue(derivative))
            .map_err(|unconverged| unconverged.error)
    }

    /// Repeats the caller's own sweeps over the unknowns until they have converged by the test of
    /// [`solve`](Self::solve). Returns the number of sweeps.
    ///
    /// The closure makes one sweep and returns the largest |Δk| and the largest |k| of a coordinate, or NaN. This
    /// serves kernels that compute both along with the sweep. All unknowns count as one block. Newton's iteration is
    /// not used.
    ///
    /// # Errors
    /// Returns [`StepError::NotConverged`] if the iteration diverges or does not converge.
    ///
    /// # Example
    /// The equation k = cos k:
    /// ```
    /// use collective_integrators::StageSolver;
    /// let mut k = 0.7_f64;
    /// let solver = StageSolver { max_iterations: 100, ..Default::default() };
    /// solver.solve_by_sweeps(|| {
    ///     let before = k;
    ///     k = k.cos();
    ///     [(k - before).abs(), k.abs()]
    /// })?;
    /// assert!((k - k.cos()).abs() < 1e-15);
    /// # Ok::<(), collective_integrators::StepError>(())
    /// ```
    #[cfg_attr(optimised, inline(always))]
    pub fn solve_by_sweeps(&self, mut sweep: impl FnMut() -> [f64; 2]) -> Result<usize, StepError> {
        let advance = |_, _| {
            let [change, size] = sweep().map(|x| BlockSizes::of(&[Vector1::new(x)]));
            SweepChange { change, size }
        };
        self.iterate(self.max_iterations, (false, true), &OwnScale, &mut unknown(), advance)
            .map_err(|unconverged| unconverged.error)
    }

    /// Solves as [`solve`](Self::solve) does, from the guess in `k` and with the ratios of changes of the previous
    /// iteration.
    ///
    /// Lanes that are `done` stay as they are. The vector `spare` is overwritten.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn solve_from<V: State>(
        &self,
        done: MaskOf<V>,
        scale: &impl Scale<V>,
        k: &mut [V],
        spare: &mut V,
        pace: &mut Ratios<V::Scalar>,
        equations: &mut impl StageEquations<V>,
    ) -> Result<usize, Unconverged<MaskOf<V>>> {
        let whole = MaskOf::<V>::from_bool(!equations.has_low_parts());
        self.iterate(
            self.max_iterations,
            (done, whole),
            scale,
            pace,
            #[cfg_attr(optimised, inline(always))]
            |done, near| {
                sweep(
                    done,
                    k,
                    spare,
                    #[cfg_attr(optimised, inline(always))]
                    |i, k, value| equations.evaluate(i, k, near, value),
                )
            },
        )
    }

    /// Makes at most so many iterations of Newton's from the guess in `k`, in the lanes that are not `done`. Returns their
    /// number.
    ///
    /// The closure `advance` makes one iteration in those lanes, and returns its change and the size of the stages.
    ///
    /// # Errors
    /// Returns [`Unconverged`] if the iteration does not converge in some lane, or to a solution far from the guess.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn newton<V: State>(
        &self,
        most: usize,
        done: MaskOf<V>,
        scale: &impl Scale<V>,
        k: &mut [V],
        mut advance: impl FnMut(MaskOf<V>, &mut [V]) -> SweepChange<V>,
    ) -> Result<usize, Unconverged<MaskOf<V>>> {
        let lanes = (done, MaskOf::<V>::from_bool(false));
        self.iterate(most, lanes, scale, &mut unknown(), |done, _| advance(done, k))
    }

    /// Iterates until the change has converged, or has become infinite, in every lane that is not `done`. In the lanes
    /// `close` the coefficients are whole from the beginning.
    ///
    /// The closure `advance` receives the lanes that are to stay as they are and those that have just come close. It
    /// returns the changes and the sizes of the stages.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn iterate<V: State>(
        &self,
        most: usize,
        (done, mut close): (MaskOf<V>, MaskOf<V>),
        scale: &impl Scale<V>,
        pace: &mut Ratios<V::Scalar>,
        mut advance: impl FnMut(MaskOf<V>, MaskOf<V>) -> SweepChange<V>,
    ) -> Result<usize, Unconverged<MaskOf<V>>> {
        let mut watch = ConvergenceTest::new(*pace);
        let none = MaskOf::<V>::from_bool(false);
        let (mut converged, mut lost, mut near, mut astray) = (done, none, none, none);
        let mut progress = SweepChange { change: BlockSizes::zero(), size: BlockSizes::zero() };
        let mut iterations = 0;
        while iterations < most && !converged.or(lost).all() {
            iterations += 1;
            let ended = converged.or(lost);
            progress = advance(ended, near);
            let (change, size) = scale.compare(&progress);
            // Otherwise the low parts of the coefficients are missing. They do not matter for a k that does not
            // change.
            let whole = close.or(change.at_most(V::Scalar::from_f64(0.0)));
            let mut now = watch.converged(change, size).and(whole);
            if self.tolerance > 0.0 {
                now = now.or(scale.accepts(&progress, self.tolerance));
            }
            if now.any() {
                *pace = keep(ended.or(now.not()), *pace, watch.ratios());
                let far = watch.is_astray(size);
                if far.any() {
                    let far = far.and(now).and(ended.not());
                    astray = astray.or(far);
                    lost = lost.or(far);
                }
            }
            converged = converged.or(now.and(lost.not()));
            if converged.all() {
                return Ok(iterations);
            }
            lost = lost.or(is_finite(change).or(converged).not());
            // A lane that has ended does not change any more, whatever the others do.
            near = change.at_most(size * CLOSE).and(close.or(converged).or(lost).not());
            close = close.or(near);
        }
        // An iteration that failed says nothing about the next one.
        *pace = keep(converged, *pace, unknown());
        let (change, size) = scale.compare(&progress);
        let relative = V::Scalar::select(converged, V::Scalar::from_f64(0.0), change / size);
        let (residual, required) = (relative.max_abs(), larger(self.tolerance, FLOOR));
        let error = if astray.any() {
            StepError::OtherSolution { distance: (watch.path() / size).max_abs() }
        } else {
            StepError::NotConverged { residual, required, iterations }
        };
        Err(Unconverged { converged, astray, iterations, error })
    }
}

/// Returns the ratios that a lane had when it ended.
#[cfg_attr(optimised, inline(always))]
fn keep<T: Real>(ended: T::Mask, [a, b]: Ratios<T>, [c, d]: Ratios<T>) -> Ratios<T> {
    [T::select(ended, a, c), T::select(ended, b, d)]
}

/// Makes one sweep over all stages, in the lanes that are not `done`. The vector `spare` is overwritten.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn sweep<V: State>(
    done: MaskOf<V>,
    k: &mut [V],
    spare: &mut V,
    mut derivative: impl FnMut(usize, &[V], &mut V),
) -> SweepChange<V> {
    let mut progress = SweepChange { change: BlockSizes::zero(), size: BlockSizes::zero() };
    for i in 0..k.len() {
        // A local variable of a small type stays in registers.
        let mut local;
        let value = if size_of::<V::Pool>() == 0 {
            local = V::take(&mut V::Pool::default(), spare);
            &mut local
        } else {
            &mut *spare
        };
        derivative(i, k, value);
        progress.change.include_difference(value, &k[i]);
        progress.size.include(value);
        if done.any() {
            value.replace_where(done, &k[i]);
        }
        k[i].move_from(value);
    }
    progress
}

/// Sets k_i = `value` in the lanes that are not `done`.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn fill_unless<V: State>(done: MaskOf<V>, k: &mut [V], value: &V) {
    for k in k {
        k.replace_where(done.not(), value);
    }
}

/// Makes the storage hold `count` vectors of the space of `like`.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn fit<V: State>(storage: &mut Vec<V>, count: usize, like: &V) {
    if storage.len() != count || storage.first().is_some_and(|first| !first.same_shape(like)) {
        storage.clear();
        storage.resize(count, like.zeros_like());
    }
}

/// Writes Σ_j a_j k_j to the sum.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn set_combination<V: State>(sum: &mut V, row: &[f64], k: &[V]) {
    sum.set_zero();
    sum.add_combination(row, k);
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use crate::error::StepError;
    use crate::schemes::runge_kutta::RungeKutta;
    use crate::schemes::scheme::Scheme;
    use crate::vector_field::from_fn;
    use lie_poisson::Pair;
    use nalgebra::{Vector1, Vector2};

    #[test]
    fn an_iteration_that_blows_up_is_refused() {
        let field = from_fn(|z: &Vector1<f64>| z.map(|x| x * x * 1e6));
        let midpoint = RungeKutta::implicit_midpoint();
        let step = midpoint.step(&field, &Vector1::new(1.0), 1.0, &mut midpoint.workspace());
        assert!(matches!(step, Err(StepError::NotConverged { .. })));
    }

    /// The field is ẋ = 16 y, ẏ = −x/2, with h = ½. One sweep multiplies the change by 4 and the next by ⅛, in one or
    /// the other order. The midpoint rule is x₁ = (x/2 + 8y)/c, y₁ = (y/2 − x/4)/c, c = 3/2.
    #[test]
    fn an_iteration_that_converges_up_and_down_is_followed_to_the_floor() {
        let field = from_fn(|z: &Vector2<f64>| Vector2::new(16.0 * z.y, -0.5 * z.x));
        let midpoint = RungeKutta::implicit_midpoint();
        for z in [Vector2::new(1.0, 0.3), Vector2::new(-0.2, 0.9), Vector2::new(0.5, -2.0)] {
            let step = midpoint.step(&field, &z, 0.5, &mut midpoint.workspace()).map(|s| s.point);
            let exact = Vector2::new(0.5 * z.x + 8.0 * z.y, 0.5 * z.y - 0.25 * z.x) / 1.5;
            // a few times the round-off of ẋ, which is up to 32 ε here
            assert!(step.is_ok_and(|step| (step - exact).amax() < 128.0 * f64::EPSILON));
        }
    }

    /// A block below the normal numbers, first or second, does not disturb the other block: by sweeps, and by Newton's
    /// iteration at a step for which sweeps diverge.
    #[test]
    fn a_subnormal_block_does_not_disturb_the_other() {
        type Two = Pair<Vector1<f64>, Vector1<f64>>;
        let rate = |x: f64| -x - x * x * x;
        let alone = from_fn(|x: &Vector1<f64>| Vector1::new(rate(x.x)));
        let second = from_fn(|z: &Two| Pair(z.0.map(rate), -z.1));
        let first = from_fn(|z: &Two| Pair(Vector1::new(0.0), z.1.map(rate)));
        let gauss = RungeKutta::gauss(2).unwrap();
        for (h, tiny) in [0.1, 8.0].into_iter().flat_map(|h| [5e-324, 1e-310].map(|y| (h, y))) {
            let (x, y) = (Vector1::new(0.7), Vector1::new(tiny));
            let expected = gauss.step(&alone, &x, h, &mut gauss.workspace()).unwrap().point;
            let end = gauss.step(&second, &Pair(x, y), h, &mut gauss.workspace()).unwrap().point.0;
            assert!((end - expected).amax() < 4.0 * f64::EPSILON, "{h} {tiny:e}: {end}");
            let end = gauss.step(&first, &Pair(y, x), h, &mut gauss.workspace()).unwrap().point;
            assert!((end.1 - expected).amax() < 4.0 * f64::EPSILON, "{h} {tiny:e}: {end:?}");
            assert_eq!(end.0, y);
        }
    }
}
