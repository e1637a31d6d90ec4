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

impl<V: Vector> Progress<V> {
    /// That of an iteration which has not begun.
    #[inline(always)]
    pub(crate) fn unknown() -> Self {
        Self { change: BlockSizes::infinite(), size: BlockSizes::zero() }
    }

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
        Self { start: BlockSizes::of(core::slice::from_ref(z)), length: step.abs() }
    }

    /// Where the unknowns are not the derivatives of the state: each block is held against itself.
    #[inline(always)]
    pub(crate) fn of_unknowns(step: f64) -> Self {
        Self { start: BlockSizes::zero(), length: step.abs() }
    }

    /// A change, and the size that it is to be compared with.
    #[inline(always)]
    pub(crate) fn compare(&self, progress: &Progress<V>) -> (V::Scalar, V::Scalar) {
        let Progress { change, size } = progress;
        if V::BLOCKS == 1 {
            return (change.largest(), size.largest());
        }
        let rate = size.largest_of(|b| self.rate(b, size.at(b)));
        let change = change.largest_of(|b| {
            let scale = size.at(b).larger(rate * self.start.at(b));
            quotient(change.at(b), scale)
        });
        (change, V::Scalar::from_f64(1.0))
    }

    /// |k_b|/|z_b| where the block starts from a number that a step does not outgrow, else 0.
    #[inline(always)]
    fn rate(&self, block: usize, size: V::Scalar) -> V::Scalar {
        let (zero, start) = (V::Scalar::from_f64(0.0), self.start.at(block));
        let known = start.at_most(zero).not().and((size * self.length).at_most(start));
        Real::select(known, size / start, zero)
    }

    /// Where h |δk_b| is at most a tolerance times the larger of |z_b| and h |k_b|.
    #[inline]
    pub(crate) fn accepts(&self, progress: &Progress<V>, tolerance: f64) -> MaskOf<V> {
        progress.change.at_most(|b| self.bound(progress, b) * (tolerance / self.length))
    }

    /// max_b h |x_b| / max(|z_b|, h |k_b|) of sizes x, over all lanes but those that are `done`.
    pub(crate) fn displacement(
        &self,
        progress: &Progress<V>,
        x: &BlockSizes<V>,
        done: MaskOf<V>,
    ) -> f64 {
        let part = |b| quotient(x.at(b) * self.length, self.bound(progress, b));
        Real::select(done, V::Scalar::from_f64(0.0), x.largest_of(part)).max_abs()
    }

    /// The larger of |z_b| and h |k_b|.
    #[inline]
    fn bound(&self, progress: &Progress<V>, block: usize) -> V::Scalar {
        self.start.at(block).larger(progress.size.at(block) * self.length)
    }
}

/// change/scale, at most 1 where that is not small; 0/0 = 0, and NaN where either is not finite.
#[inline(always)]
fn quotient<T: Real>(change: T, scale: T) -> T {
    let (zero, all) = (T::from_f64(0.0), scale.larger(change));
    T::select(all.at_most(zero), zero, change / all)
}
