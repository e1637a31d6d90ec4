//! Scales with which changes of stage derivatives are compared.

use crate::iteration::block_sizes::{BlockSizes, MaskOf};
use crate::iteration::convergence::ROUND_OFF;
use lie_poisson::{Mask, Real, State};

/// The scales of a step: the sizes |z_b| of the blocks of its starting point, and its length h.
///
/// Changes δk of stage derivatives k are compared with numbers of the same unit:
///
/// ```text
/// max_b |δk_b| / s_b,    s_b = max( |k_b|, r |z_b| ),    r = max { 2⁻²⁰/h, |k_b|/|z_b| : h |k_b| ≤ |z_b| },
/// ```
///
/// The comparison is made block by block. The rate r is that at which the blocks move, and s_b is the derivative of
/// block b at that rate. If a block of z is multiplied by a constant, k_b and s_b are multiplied by the same constant,
/// so that units do not matter. If k_b is small by cancellation, no more digits are required than it has. A block that
/// starts at zero is compared with its own derivative alone. The least rate 2⁻²⁰/h is that of changes far below the
/// round-off of z. It matters where every other block moves by more than its own size, as along a fibre.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StageScale<V: State> {
    start: BlockSizes<V>,
    /// The reciprocals 1/|z_b|, or 0 for a block that starts at zero.
    inverse: BlockSizes<V>,
    length: f64,
    /// The least rate at which blocks count as moving.
    least_rate: f64,
}

/// The least rate at which blocks count as moving, in units of 1/h.
const LEAST_RATE: f64 = 1.0 / (1 << 20) as f64;

/// The changes of an iteration, and the sizes of its results.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SweepChange<V: State> {
    /// The sizes of the last changes.
    pub(crate) change: BlockSizes<V>,
    /// The sizes of the stage derivatives.
    pub(crate) size: BlockSizes<V>,
}

/// A scale with which the changes of an iteration for stage equations are compared.
pub(crate) trait Scale<V: State> {
    /// Returns a change, and the size with which it is to be compared.
    fn compare(&self, progress: &SweepChange<V>) -> (V::Scalar, V::Scalar);

    /// Returns the lanes in which h |δk_b| is at most a tolerance times the larger of |z_b| and h |k_b|.
    fn accepts(&self, progress: &SweepChange<V>, tolerance: f64) -> MaskOf<V>;
}

/// The scale of unknowns that are not derivatives of the state: each block is compared with itself.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OwnScale;

impl<V: State> Scale<V> for OwnScale {
    #[cfg_attr(optimised, inline(always))]
    fn compare(&self, progress: &SweepChange<V>) -> (V::Scalar, V::Scalar) {
        compare_by(
            progress,
            #[cfg_attr(optimised, inline(always))]
            |b| progress.size.at(b),
        )
    }

    #[cfg_attr(optimised, inline(always))]
    fn accepts(&self, progress: &SweepChange<V>, tolerance: f64) -> MaskOf<V> {
        progress.change.at_most(
            #[cfg_attr(optimised, inline(always))]
            |b| progress.size.at(b) * tolerance,
        )
    }
}

/// Returns the largest change of a block, in units of f of the size of the block, together with 1.
///
/// With a single block, returns its change and its size. A size is at least the smallest normal number, since a number
/// below it has fewer digits than the iteration is to find.
#[cfg_attr(optimised, inline(always))]
fn compare_by<V: State>(
    SweepChange { change, size }: &SweepChange<V>,
    scale: impl Fn(usize) -> V::Scalar,
) -> (V::Scalar, V::Scalar) {
    let least = V::Scalar::from_f64(f64::MIN_POSITIVE);
    if V::BLOCKS == 1 {
        return (change.largest(), least.maximum(size.largest()));
    }
    let change = change.largest_of(
        size,
        #[cfg_attr(optimised, inline(always))]
        |b| change.at(b) / scale(b).maximum((change.at(b) * BEYOND).maximum(least)),
    );
    (change, V::Scalar::from_f64(1.0))
}

/// The limit on a change as a multiple of a scale, so that a quotient does not overflow.
const BEYOND: f64 = 1.0 / (1_u64 << 60) as f64;

impl<V: State> SweepChange<V> {
    /// Counts residuals above the round-off of terms of the given sizes as changes, and the terms as stage derivatives.
    pub(crate) fn include_residual(&mut self, residual: &BlockSizes<V>, terms: &BlockSizes<V>) {
        self.change.include_above(residual, |b| terms.at(b) * ROUND_OFF);
        self.size.include_above(terms, |_| V::Scalar::from_f64(0.0));
    }
}

impl<V: State> StageScale<V> {
    /// Returns the scales of a step of the given size from z.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn new(z: &V, step: f64) -> Self {
        let start = BlockSizes::of(core::slice::from_ref(z));
        let (length, least_rate) = (step.abs(), (LEAST_RATE / step.abs()).min(f64::MAX));
        Self { inverse: start.inverse(), start, length, least_rate }
    }
}

impl<V: State> Scale<V> for StageScale<V> {
    #[cfg_attr(optimised, inline(always))]
    fn compare(&self, progress: &SweepChange<V>) -> (V::Scalar, V::Scalar) {
        let (zero, size) = (V::Scalar::from_f64(0.0), &progress.size);
        let rate = size.largest_unchecked(
            #[cfg_attr(optimised, inline(always))]
            |b| {
                let outgrown = (size.at(b) * self.length).at_most(self.start.at(b)).not();
                Real::select(outgrown, zero, size.at(b) * self.inverse.at(b))
            },
        );
        let rate = rate.maximum(V::Scalar::from_f64(self.least_rate));
        compare_by(
            progress,
            #[cfg_attr(optimised, inline(always))]
            |b| size.at(b).maximum(rate * self.start.at(b)),
        )
    }

    #[cfg_attr(optimised, inline(always))]
    fn accepts(&self, progress: &SweepChange<V>, tolerance: f64) -> MaskOf<V> {
        progress.change.at_most(
            #[cfg_attr(optimised, inline(always))]
            |b| {
                let moved = progress.size.at(b) * self.length;
                self.start.at(b).larger(moved) * (tolerance / self.length)
            },
        )
    }
}

/// The scale of a step whose derivatives are sums of terms of known sizes: changes are compared with the terms, too.
pub(crate) struct TermScale<'a, V: State> {
    pub(crate) scale: &'a StageScale<V>,
    pub(crate) terms: &'a BlockSizes<V>,
}

impl<V: State> TermScale<'_, V> {
    fn with_terms(&self, progress: &SweepChange<V>) -> SweepChange<V> {
        let mut progress = progress.clone();
        progress.size.include_above(self.terms, |_| V::Scalar::from_f64(0.0));
        progress
    }
}

impl<V: State> Scale<V> for TermScale<'_, V> {
    fn compare(&self, progress: &SweepChange<V>) -> (V::Scalar, V::Scalar) {
        self.scale.compare(&self.with_terms(progress))
    }

    fn accepts(&self, progress: &SweepChange<V>, tolerance: f64) -> MaskOf<V> {
        self.scale.accepts(&self.with_terms(progress), tolerance)
    }
}

#[cfg(test)]
mod tests {
    use super::{Scale, StageScale, SweepChange};
    use crate::iteration::block_sizes::BlockSizes;
    use lie_poisson::Pair;
    use nalgebra::Vector1;

    type Two = Pair<Vector1<f64>, Vector1<f64>>;

    fn two(x: f64, y: f64) -> Two {
        Pair(Vector1::new(x), Vector1::new(y))
    }

    /// Returns the relative change of k by `change`, in a step of 1/10 from z.
    fn relative(z: Two, k: Two, change: Two) -> f64 {
        let progress =
            SweepChange { change: BlockSizes::of(&[change]), size: BlockSizes::of(&[k]) };
        let (change, size) = StageScale::new(&z, 0.1).compare(&progress);
        change / size
    }

    /// Asserts that two numbers are equal, up to the rounding of a quotient, a product and an inverse.
    fn close(a: f64, b: f64) {
        assert!((a - b).abs() <= 4.0 * f64::EPSILON * b, "{a:e} {b:e}");
    }

    #[test]
    fn each_block_is_measured_by_its_own_scale() {
        // Both blocks move at the rate 1; a change of the small one counts as much as one of the large one.
        close(relative(two(1.0, 1e-30), two(1.0, 1e-30), two(0.0, 1e-32)), 0.01);
        close(relative(two(1.0, 1e-30), two(1.0, 1e-30), two(0.01, 0.0)), 0.01);
        // k is small by cancellation in the second block, so that the rate of the first counts.
        close(relative(two(1.0, 1.0), two(1.0, 1e-20), two(0.0, 1e-4)), 1e-4);
        // A block that starts at zero is measured by its own derivative, and sets no rate.
        close(relative(two(1.0, 0.0), two(1.0, 50.0), two(0.0, 0.5)), 0.01);
        close(relative(two(1.0, 0.0), two(1.0, 50.0), two(0.01, 0.0)), 0.01);
        close(relative(two(1.0, 0.0), two(1.0, 0.0), two(0.0, 0.0)), 0.0);
        // The reciprocal of a block below the normal numbers overflows; it sets no rate either.
        close(relative(two(1.0, 1e-310), two(1.0, -1e-310), two(0.1, 0.0)), 0.1);
        close(relative(two(1e-310, 1.0), two(0.0, 1.0), two(0.0, 0.01)), 0.01);
        // No block sets a rate: the change moves the first block, which is at rest, by less than a rounding error.
        close(relative(two(1.0, 1.0), two(1e-30, 50.0), two(1e-29, 0.0)), 1e-30 * (1 << 20) as f64);
        // A change may be many times the derivative, but the quotient does not overflow.
        close(relative(two(1.0, 1.0), two(1.0, 1.0), two(0.0, 1e6)), 1e6);
        close(relative(two(1.0, 1.0), two(1e-300, 1e-300), two(0.0, 1e300)), 2.0_f64.powi(60));
    }

    /// A single block below the normal numbers has fewer digits, and is not asked for more.
    #[test]
    fn a_size_is_at_least_the_smallest_normal_number() {
        let one = |x: f64| BlockSizes::of(&[Vector1::new(x)]);
        for (k, size) in [(1.0, 1.0), (1e-310, f64::MIN_POSITIVE), (0.0, f64::MIN_POSITIVE)] {
            let progress = SweepChange { change: one(5e-324), size: one(k) };
            let scale = StageScale::new(&Vector1::new(0.5), 0.1);
            assert_eq!(scale.compare(&progress), (5e-324, size));
        }
        let progress = SweepChange { change: one(0.0), size: one(f64::NAN) };
        assert!(StageScale::new(&Vector1::new(0.5), 0.1).compare(&progress).1.is_nan());
    }

    /// A change of k moves the end of a step of 1/10 by a tenth of it, and less than the tolerance of what moves.
    #[test]
    fn a_change_is_accepted_if_the_end_moves_by_less_than_the_tolerance() {
        let accepts = |z: Two, k: Two, change: Two| {
            let progress =
                SweepChange { change: BlockSizes::of(&[change]), size: BlockSizes::of(&[k]) };
            StageScale::new(&z, 0.1).accepts(&progress, 1e-3)
        };
        for (z, k, largest) in [(4.0, 1.0, 4e-2), (0.5, 20.0, 2e-2), (0.0, 1e-20, 1e-23)] {
            let (z, k) = (two(1.0, z), two(1.0, k));
            assert!(accepts(z, k, two(0.0, 0.999 * largest)), "{largest}");
            assert!(!accepts(z, k, two(0.0, 1.001 * largest)), "{largest}");
        }
    }

    #[test]
    fn what_is_no_number_is_no_small_change() {
        for bad in [f64::NAN, f64::INFINITY] {
            for (k, change) in [
                (two(bad, 1.0), two(0.0, 0.0)),
                (two(1.0, bad), two(0.0, 0.0)),
                (two(1.0, 1.0), two(bad, 0.0)),
                (two(1.0, 1.0), two(0.0, bad)),
            ] {
                assert!(!relative(two(1.0, 1.0), k, change).is_finite());
            }
        }
    }
}
