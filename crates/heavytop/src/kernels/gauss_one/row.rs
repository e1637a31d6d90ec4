//! Rows of eight numbers: one for each stage, or for each coordinate of T∗C².

use lie_poisson::Lanes;

/// The largest number of stages, and the number of coordinates of T∗C².
pub(super) const WIDTH: usize = 8;

/// Eight numbers, aligned for the widest register.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub(super) struct Row(pub(super) [f64; WIDTH]);

/// The weighted stage derivatives ℓ, one row for each coordinate.
pub(super) type Stages = [Row; WIDTH];

impl Row {
    pub(super) const ZERO: Self = Self([0.0; WIDTH]);

    /// Loads the block-th register of the row.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn load<T: Lanes>(&self, block: usize) -> T {
        T::load(&self.0[block * T::COUNT..])
    }

    /// Stores the block-th register of the row.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn store<T: Lanes>(&mut self, x: T, block: usize) {
        x.store(&mut self.0[block * T::COUNT..]);
    }
}
