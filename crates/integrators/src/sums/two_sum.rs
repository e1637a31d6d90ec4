//! Sums that keep their rounding errors.

use lie_poisson::{Pair, State, Vector};

/// Writes a + b as its rounded value `sum` and the rounding `error`, whichever of a and b is the larger. The vector
/// `spare` is overwritten.
///
/// ```text
/// s = a + b,    d = s − a,    error = (a − (s − d)) + (b − d)
/// ```
///
/// Source: D. E. Knuth, *The Art of Computer Programming*, vol. 2, §4.2.2, Thm. B.
#[cfg_attr(optimised, inline(always))]
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

/// Replaces (z, e) by (z, e) + (δz, δe), where e and δe have the size of rounding errors.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn add_compensated<V: State>(
    (z, e): (&mut V, &mut V),
    (dz, de): (&V, &V),
    pool: &mut V::Pool,
) {
    let (mut change, mut lost) = (V::take(pool, z), V::take(pool, z));
    let (mut next, mut spare) = (V::take(pool, z), V::take(pool, z));
    two_sum(dz, e, &mut change, &mut lost, &mut spare);
    two_sum(z, &change, &mut next, e, &mut spare);
    lost.add_in_place(de);
    e.add_in_place(&lost);
    z.move_from(&mut next);
    for vector in [change, lost, next, spare] {
        vector.give(pool);
    }
}

/// Returns a + b as its rounded value and the rounding error.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn exact_sum<V: Vector>(a: &V, b: &V) -> Pair<V, V> {
    let [mut sum, mut error, mut spare] = [V::zero(); 3];
    two_sum(a, b, &mut sum, &mut error, &mut spare);
    Pair(sum, error)
}
