//! Linear combinations of vectors in twice the digits.

use crate::sums::halves::{halves, split};
use crate::sums::two_sum::two_sum;
use lie_poisson::{Real, State};

/// Returns h (w + low) as a number of 26 bits and the rest, which is accurate to 2⁻⁷⁸ of the product.
#[cfg_attr(optimised, inline(always))]
fn product_in_halves(h: f64, w: f64, low: f64) -> (f64, f64) {
    let ((h_upper, h_rest), (w_upper, w_rest)) = (halves(h), halves(w));
    let (upper, _) = halves(h * w);
    let rest = (h_upper * w_upper - upper) + (h_upper * w_rest + h_rest * w_upper);
    (upper, rest + (h_rest * w_rest + h * low))
}

/// Replaces z + e by z + e + h Σ_j (w_j + low_j) k_j, where e has the size of a rounding error of z, or is zero.
///
/// The sum has about twice the digits of z. Missing low parts are zero.
///
/// Each coefficient h w_j and each vector k_j is split into halves of 26 bits. The product of the upper halves is
/// exact, and its sum with z is split into the rounded value and the rounding error. The other terms, smaller by 2⁻²⁶,
/// are added to e. The largest numbers, above 1e300, become NaN.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn add_exactly<V: State>(
    (z, e): (&mut V, &mut V),
    (step, weights, low): (f64, &[f64], &[f64]),
    k: &[V],
    pool: &mut V::Pool,
) {
    let (mut upper, mut lower) = (V::take(pool, z), V::take(pool, z));
    let (mut next, mut spare) = (V::take(pool, z), V::take(pool, z));
    let number = V::Scalar::from_f64;
    for (j, (k, &w)) in k.iter().zip(weights).enumerate() {
        let (w, rest) = product_in_halves(step, w, low.get(j).copied().unwrap_or(0.0));
        split(k, &mut upper, &mut lower);
        e.add_multiple(number(rest), k);
        e.add_multiple(number(w), &lower);
        upper.scale_in_place(number(w));
        two_sum(z, &upper, &mut next, &mut lower, &mut spare);
        e.add_in_place(&lower);
        z.move_from(&mut next);
    }
    two_sum(z, e, &mut next, &mut lower, &mut spare);
    z.move_from(&mut next);
    e.move_from(&mut lower);
    for vector in [upper, lower, next, spare] {
        vector.give(pool);
    }
}
