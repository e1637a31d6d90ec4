//! Numbers in halves of 26 bits, whose products have no rounding errors.

use lie_poisson::{Real, State};

/// The mask of the sign, the exponent and the upper 26 of the 53 bits of a number.
const UPPER_HALF: u64 = !0 << 27;

/// The factor 2²⁷ + 1 of [`split`].
const SPLITTER: f64 = 134_217_729.0;

/// Splits a number into its upper 26 bits and the rest, without loss.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn halves(x: f64) -> (f64, f64) {
    let upper = f64::from_bits(x.to_bits() & UPPER_HALF);
    (upper, x - upper)
}

/// Writes a vector as the sum of two whose coordinates have 26 bits. Coordinates above 1e300 become NaN.
///
/// Source: T. J. Dekker, *A floating-point technique for extending the available precision*, Numer. Math. 18 (1971),
/// §5.8.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn split<V: State>(v: &V, upper: &mut V, lower: &mut V) {
    upper.assign(v);
    upper.scale_in_place(V::Scalar::from_f64(SPLITTER));
    lower.assign(upper);
    lower.subtract_in_place(v);
    upper.subtract_in_place(lower);
    lower.assign(v);
    lower.subtract_in_place(upper);
}

/// Writes h v to the product, with unbiased rounding errors.
///
/// If h is within a few roundings of a fraction of small denominator, such as 0.05 = 8/5 · 2⁻⁵, the products h x with
/// neighbouring x round alike. The products with the upper 26 bits of h do not, and the contribution of the lower bits
/// is small. An infinite h x becomes NaN.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn scale_evenly<V: State>(v: &V, step: f64, product: &mut V) {
    let (upper, rest) = halves(step);
    product.assign(v);
    product.scale_in_place(V::Scalar::from_f64(upper));
    product.add_multiple(V::Scalar::from_f64(rest), v);
}
