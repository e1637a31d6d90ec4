//! Sums without loss by rounding.

use lie_poisson::{Pair, State, Vector};

/// Writes a + b as its rounded value `sum` and the rounding `error`, whichever of a and b is the larger. The vector
/// `spare` is overwritten.
///
/// ```text
/// s = a + b,    d = s − a,    error = (a − (s − d)) + (b − d)
/// ```
///
/// Source: D. E. Knuth, *The Art of Computer Programming*, vol. 2, §4.2.2, Thm. B.
#[inline]
pub(crate) fn two_sum<V: State>(a: &V, b: &V, sum: &mut V, error: &mut V, spare: &mut V) {
    sum.assign(a);
    sum.add_in_place(b);
    spare.assign(sum);
    spare.subtract_in_place(a);
    error.assign(sum);
    error.subtract_in_place(spare);
    error.subtract_from(a);
    spare.subtract_from(b);
    error.add_in_place(spare);
}

/// Returns a + b as its rounded value and the rounding error.
#[inline]
pub(crate) fn exact_sum<V: Vector>(a: &V, b: &V) -> Pair<V, V> {
    let [mut sum, mut error, mut spare] = [V::zero(); 3];
    two_sum(a, b, &mut sum, &mut error, &mut spare);
    Pair(sum, error)
}
