//! What changes of stage derivatives are measured by.

use crate::stages::block_sizes::{BlockSizes, MaskOf};
use crate::stages::convergence::ROUND_OFF;
use lie_poisson::{Mask, Real, Vector};

/// The scales of a step: the sizes |z_b| of the blocks of its starting point, and its length h.
///
/// Changes δk of stage derivatives k are compared with numbers of the same unit,
///
/// ```text
/// max_b |δk_b| / s_b,    s_b = max( |k_b|, r |z_b| ),    r = max { |k_b|/|z_b| : h |k_b| ≤ |z_b| },
/// ```
///
/// block by block: r is the rate at which the blocks move, and s_b the derivative of block b at that rate.
/// Multiplying a block of z by a constant multiplies k_b and s_b by the same, so that units do not matter; and
/// a k_b that is small by cancellation is not asked for digits that it does not have. A block that starts at
/// zero is held against its own derivative alone.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StageScale<V: Vector> {
    start: BlockSizes<V>,
    /// 1/|z_b|, or 0 for a block that starts at zero.
    inverse: BlockSizes<V>,
    length: f64,
}

/// The changes of an iteration and the sizes of what it leads to.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Progress<V: Vector> {
    /// Of the last changes.
    pub(crate) change: BlockSizes<V>,
    /// Of the stage derivatives.
    pub(crate) size: BlockSizes<V>,
}

/// A change from this multiple of a scale on is that multiple, lest a quotient overflow.
const BEYOND: f64 = 1.0 / (1_u64 << 60) as f64;

impl<V: Vector> Progress<V> {
    /// Counts residuals above the round-off of terms of the given sizes as changes, and the terms as stage
    /// derivatives.
    pub(crate) fn include_residual(&mut self, residual: &BlockSizes<V>, terms: &BlockSizes<V>) {
        self.change.include_above(residual, |b| terms.at(b) * ROUND_OFF);
        self.size.include_above(terms, |_| V::Scalar::from_f64(0.0));
    }
}

impl<V: Vector> StageScale<V> {
    /// The scales of a step of the given size from z.
    #[inline(always)]
    pub(crate) fn new(z: &V, step: f64) -> Self {
        let start = BlockSizes::of(core::slice::from_ref(z));
        Self { inverse: start.inverse(), start, length: step.abs() }
    }

    /// Where the unknowns are not the derivatives of the state: each block is held against itself.
    #[inline(always)]
    pub(crate) fn of_unknowns(step: f64) -> Self {
        Self { start: BlockSizes::zero(), inverse: BlockSizes::zero(), length: step.abs() }
    }

    /// A change, and the size that it is to be compared with.
    #[inline(always)]
    pub(crate) fn compare(&self, progress: &Progress<V>) -> (V::Scalar, V::Scalar) {
        let Progress { change, size } = progress;
        if V::BLOCKS == 1 {
            return (change.largest(), size.largest());
        }
        let (zero, least) = (V::Scalar::from_f64(0.0), V::Scalar::from_f64(f64::MIN_POSITIVE));
        let rate = size.largest_unchecked(|b| {
            let outgrown = (size.at(b) * self.length).at_most(self.start.at(b)).not();
            Real::select(outgrown, zero, size.at(b) * self.inverse.at(b))
        });
        let change = change.largest_of(size, |b| {
            let scale = size.at(b).maximum(rate * self.start.at(b));
            change.at(b) / scale.maximum((change.at(b) * BEYOND).maximum(least))
        });
        (change, V::Scalar::from_f64(1.0))
    }

    /// Where h |δk_b| is at most a tolerance times the larger of |z_b| and h |k_b|.
    #[inline]
    pub(crate) fn accepts(&self, progress: &Progress<V>, tolerance: f64) -> MaskOf<V> {
        progress.change.at_most(|b| {
            let moved = progress.size.at(b) * self.length;
            self.start.at(b).larger(moved) * (tolerance / self.length)
        })
    }
}
