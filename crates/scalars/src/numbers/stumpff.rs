//! Stumpff functions of an `f64` number.

/// Returns the Stumpff function cₖ(x) of order k, see [`Real::stumpff`](crate::Real::stumpff).
///
/// The short series for small x are inlined, so that a constant order gives constant coefficients.
#[inline]
pub(crate) fn stumpff(x: f64, order: u32) -> f64 {
    // For k = 0 the first omitted term is below 2⁻⁶⁴ (five factors) and 2⁻⁶¹ (nine factors) of the first term. It is
    // smaller for k > 0.
    let short = match x.abs() {
        size if size <= 1.0 / 64.0 => five_factors(x, order),
        size if size <= 1.0 => nine_factors(x, order),
        _ => None,
    };
    match short {
        Some(sum) => over_factorial(sum, order),
        None => of_large_argument(x, order),
    }
}

/// Returns cₖ(x) where the short series do not suffice.
#[cold]
fn of_large_argument(x: f64, order: u32) -> f64 {
    let k = f64::from(order);
    // Within this radius the terms of the series decrease from the first one on.
    if x.abs() <= (k + 1.0) * (k + 2.0) { series(x, order) } else { recursion(x, order) }
}

/// Sums the series for |x| ≤ (k+1)(k+2), with all terms above 2⁻⁶⁰ of the first (22 terms for k = 12).
fn series(x: f64, order: u32) -> f64 {
    if order >= UNDERFLOW { x * 0.0 } else { over_factorial(long_series(x, order), order) }
}

#[inline]
fn over_factorial(sum: f64, order: u32) -> f64 {
    match order {
        0 | 1 => sum,
        2 => 0.5 * sum,
        _ => sum / factorial(order),
    }
}

/// Returns k! cₖ(x) by the first six terms of the series; `None` for orders beyond the table.
///
/// ```text
/// 1 − f₀x (1 − f₁x (1 − f₂x (1 − …))) = (1 − f₀x) + f₀f₁x² ((1 − f₂x) + f₂f₃x² ((1 − f₄x) + …)),
/// f_j = 1/((k+2j+1)(k+2j+2))
/// ```
///
/// In the second form each result depends on half as many earlier ones.
#[cfg_attr(optimised, inline(always))]
fn five_factors(x: f64, order: u32) -> Option<f64> {
    let factors = FACTORS.get(order as usize..)?.first_chunk::<9>()?;
    let tail = 1.0 - factors[8].0 * x;
    Some(pair(x, factors[0], pair(x, factors[4], tail)))
}

/// Returns k! cₖ(x) by the first ten terms of the series, as [`five_factors`] does.
#[cfg_attr(optimised, inline(always))]
fn nine_factors(x: f64, order: u32) -> Option<f64> {
    let factors = FACTORS.get(order as usize..)?.first_chunk::<17>()?;
    let tail = pair(x, factors[8], pair(x, factors[12], 1.0 - factors[16].0 * x));
    Some(pair(x, factors[0], pair(x, factors[4], tail)))
}

/// Adds two terms before a tail.
#[cfg_attr(optimised, inline(always))]
fn pair(x: f64, (factor, product): (f64, f64), tail: f64) -> f64 {
    (1.0 - factor * x) + (product * (x * x)) * tail
}

/// The numbers f = 1/((i+1)(i+2)) and f/((i+3)(i+4)), for i from 0.
const FACTORS: [(f64, f64); 32] = {
    let mut factors = [(0.0, 0.0); 32];
    let mut i = 0;
    while i < factors.len() {
        let factor = 1.0 / ((i + 1) * (i + 2)) as f64;
        factors[i] = (factor, factor / ((i + 3) * (i + 4)) as f64);
        i += 1;
    }
    factors
};

/// Returns k! cₖ(x) by as many terms as are needed.
fn long_series(x: f64, order: u32) -> f64 {
    let k = f64::from(order);
    let step = |j: u32| {
        let n = k + 2.0 * f64::from(j);
        (n - 1.0) * n
    };
    let (mut terms, mut size) = (0, 1.0);
    while size > 1e-18 {
        terms += 1;
        size *= x.abs() / step(terms);
    }
    (1..=terms).rev().fold(1.0, |tail, j| 1.0 - x * tail / step(j))
}

/// The lowest order k for which 1/k! is not a normal number.
const UNDERFLOW: u32 = 171;

/// Computes cₖ from c₀ or c₁ by the recursion cₖ₊₂ = (1/k! − cₖ)/x, for |x| > (k+1)(k+2).
fn recursion(x: f64, order: u32) -> f64 {
    let root = x.abs().sqrt();
    let mut value = match (order.is_multiple_of(2), x > 0.0) {
        (true, true) => root.cos(),
        (true, false) => root.cosh(),
        (false, true) => root.sin() / root,
        (false, false) => root.sinh() / root,
    };
    let mut k = order % 2;
    while k < order && (value != 0.0 || k < UNDERFLOW) {
        value = (1.0 / factorial(k) - value) / x;
        k += 2;
    }
    value
}

fn factorial(n: u32) -> f64 {
    (1..=n.min(UNDERFLOW)).map(f64::from).product()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numbers::real::Real;

    #[test]
    fn stumpff_functions_against_fifty_digit_values() {
        // (x, order, c_order(x)), from their series in 60-digit arithmetic.
        let table = [
            (1e-20, 3, 1.0 / 6.0),
            (0.5, 0, 0.760_244_597_075_630_2),
            (2.0, 2, 0.422_028_152_617_312_75),
            (-3.0, 1, 1.580_586_563_566_668),
            (30.0, 3, 0.037_724_215_189_836_375),
        ];
        for (x, order, expected) in table {
            let error = (stumpff(x, order) / expected - 1.0).abs();
            // The recursion has a few rounding errors.
            assert!(error < 4.0 * f64::EPSILON, "c_{order}({x}): {error:e}");
        }
    }

    /// Compares the short series with the long one at the ends of their ranges, where |x| is largest for the number
    /// of terms.
    #[test]
    fn short_series_have_enough_terms() {
        for order in 0..24 {
            for size in [0.0, 1e-300, 1e-9, 1.0 / 65.0, 1.0 / 64.0, 1.0 / 63.0, 0.5, 1.0] {
                for x in [size, -size] {
                    let long = long_series(x, order) / factorial(order);
                    let error = (stumpff(x, order) / long - 1.0).abs();
                    // On either side the first factor, the sum and the quotient by k! are rounded.
                    assert!(error < 3.0 * f64::EPSILON, "c_{order}({x}): {error:e}");
                }
            }
        }
        // The first omitted term at the ends of the ranges. With one term fewer it would exceed a tenth of a rounding
        // error.
        let term = |x: f64, terms: i32| x.powi(terms) / factorial(2 * terms as u32);
        for (x, terms) in [(1.0 / 64.0, 5), (1.0, 9)] {
            assert!(term(x, terms + 1) < 2.0_f64.powi(-60), "{x}");
            assert!(term(x, terms) > 2.0_f64.powi(-56), "{x}");
        }
        assert!(stumpff(f64::NAN, 1).is_nan());
    }

    #[test]
    fn stumpff_functions_of_large_order() {
        // As above.
        let table = [
            (0.5, 20, 4.105_873_253_862_420_6e-19),
            (462.0, 20, 1.954_867_587_507_402e-19),
            (-462.0, 20, 1.699_691_573_580_728_4e-18),
            (2000.0, 20, 6.745_893_980_687_095e-20),
            (-2000.0, 20, 1.290_941_734_738_425_7e-14),
            (0.5, 40, 1.225_261_662_815_181_9e-48),
            (200.0, 40, 1.096_981_931_302_853_1e-48),
            (1722.0, 40, 5.976_756_654_147_745e-49),
            (-1722.0, 40, 6.432_829_663_662_85e-48),
            (2000.0, 40, 5.508_387_799_351_775e-49),
            (-2000.0, 40, 1.012_102_996_389_708e-47),
            // The terms of the series would increase to a thousand times the sum.
            (27_360.0, 120, 5.165_532_808_167_744_6e-200),
        ];
        for (x, order, expected) in table {
            let error = (stumpff(x, order) / expected - 1.0).abs();
            // The error comes from the roundings of k! and of k/2 steps of the recursion.
            assert!(error < f64::from(order) * f64::EPSILON, "c_{order}({x}): {error:e}");
        }
        for x in [0.0, 1.0, -1e5, 1e300] {
            for order in [1000, u32::MAX] {
                assert_eq!(crate::DualNumber::variable(x).stumpff(order).derivative(), 0.0);
            }
        }
        assert!(stumpff(f64::NAN, 1000).is_nan());
    }

    /// For x = (2πn)² the recursion starts from c₁ or c₂, which are zero up to the rounding of √x.
    #[test]
    fn functions_at_whole_turns() {
        for turns in 1..6 {
            let x = (core::f64::consts::TAU * f64::from(turns)).powi(2);
            assert_eq!(stumpff(x, 0), 1.0);
            assert_eq!(stumpff(x, 2), 0.0);
            for (order, expected) in [(3, 1.0 / x), (4, 0.5 / x)] {
                let error = (stumpff(x, order) / expected - 1.0).abs();
                // The error comes from the rounding of the angle, at most 31 rad, and from the roundings of the
                // recursion.
                assert!(error < 32.0 * f64::EPSILON, "c_{order}({x}): {error:e}");
            }
        }
    }

    #[test]
    fn both_branches_agree_at_their_seam() {
        for order in 0..6_u32 {
            let seam = f64::from((order + 1) * (order + 2));
            for x in [seam, -seam] {
                let difference = series(x, order) / recursion(x, order) - 1.0;
                // c₀(2) = cos √2 is small against its terms: a few units are lost.
                assert!(difference.abs() < 64.0 * f64::EPSILON, "{order} {x} {difference:e}");
            }
        }
    }
}
