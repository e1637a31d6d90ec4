//! Sums without loss by rounding.

use lie_poisson::{Pair, Vector};

/// Returns a + b as its rounded value and the rounding error, whichever of a and b is the larger.
///
/// Source: D. E. Knuth, *The Art of Computer Programming*, vol. 2, §4.2.2, Thm. B.
#[inline]
pub(crate) fn two_sum<V: Vector>(a: &V, b: &V) -> Pair<V, V> {
    let sum = *a + *b;
    let change = sum - *a;
    Pair(sum, (*a - (sum - change)) + (*b - change))
}
