//! The size of a conserved quantity along a motion: [`InvariantSize`].

use core::ops::Range;
use lie_poisson::larger;

/// The size of a quantity f along a motion, in the units of f, to which its deviations are relative:
///
/// ```text
/// Σ_b max |∂f/∂μ_b| · max |μ_b|
/// ```
///
/// The sum is over blocks b of coordinates that have one unit, such as Π and Γ, and the maxima are over the motion. It is
/// the largest change of f, to first order, when each block changes by its own size. In contrast to |f| it does not vanish
/// where the terms of f cancel, and a constant added to f does not change it. A deviation divided by this size is a number
/// that does not depend on units: it is of the size of the relative errors of the blocks that cause it.
///
/// # Example
/// Of f = Π·Γ the size is 2 |Π||Γ|, also where Π and Γ are at right angles:
/// ```
/// use collective_integrators::diagnostics::InvariantSize;
/// for unit in [1e-30, 1.0, 1e30] {
///     let mu = [3.0 * unit, 0.0, 4.0 * unit, 0.0, 1.0, 0.0];
///     let differential = [0.0, 1.0, 0.0, 3.0 * unit, 0.0, 4.0 * unit];
///     let mut size = InvariantSize::new([0..3, 3..6]);
///     size.include(&mu, &differential);
///     assert!((size.relative(1e-9 * unit) / 1e-10 - 1.0).abs() < 1e-15);
/// }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct InvariantSize {
    /// The coordinates of each block, max |μ_b| and max |∂f/∂μ_b|.
    blocks: Vec<(Range<usize>, f64, f64)>,
}

impl InvariantSize {
    /// Creates the size of a quantity before a motion, for these ranges of the coordinates of μ.
    #[must_use]
    pub fn new(blocks: impl IntoIterator<Item = Range<usize>>) -> Self {
        Self { blocks: blocks.into_iter().map(|block| (block, 0.0, 0.0)).collect() }
    }

    /// Takes notice of a momentum of the motion and of the differential of the quantity there. A NaN stays.
    pub fn include(&mut self, mu: &[f64], differential: &[f64]) {
        for (block, size, slope) in &mut self.blocks {
            *size = larger(*size, norm(mu, block));
            *slope = larger(*slope, norm(differential, block));
        }
    }

    /// Returns the size of the quantity.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.blocks.iter().fold(0.0, |sum, (_, size, slope)| sum + size * slope)
    }

    /// Returns a deviation of the quantity relative to its size. It is 0 for no deviation, also where the size is 0.
    #[must_use]
    pub fn relative(&self, deviation: f64) -> f64 {
        if deviation == 0.0 { 0.0 } else { deviation / self.size() }
    }
}

/// Returns the Euclidean norm of the coordinates of a block.
fn norm(coordinates: &[f64], block: &Range<usize>) -> f64 {
    let inside = coordinates.get(block.clone()).unwrap_or_default();
    inside.iter().copied().fold(0.0, f64::hypot)
}

#[cfg(test)]
mod tests {
    use super::InvariantSize;

    #[test]
    fn a_size_is_that_of_the_whole_motion() {
        let mut size = InvariantSize::new([0..1, 1..2]);
        // f = xy, with x = 0 at the start.
        size.include(&[0.0, 5.0], &[5.0, 0.0]);
        assert_eq!((size.size(), size.relative(0.0)), (0.0, 0.0));
        size.include(&[-2.0, 1.0], &[1.0, -2.0]);
        assert_eq!((size.size(), size.relative(1.0)), (20.0, 0.05));
        size.include(&[f64::NAN, 1.0], &[1.0, -2.0]);
        assert!(size.size().is_nan());
    }

    #[test]
    fn what_has_no_size_has_no_relative_deviation() {
        assert_eq!(InvariantSize::new([]).relative(1.0), f64::INFINITY);
    }
}
