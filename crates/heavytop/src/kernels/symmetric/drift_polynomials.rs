//! Sine, versine and half tangent of the angles of one flow as polynomials: [`DriftPolynomials`].

use crate::kernels::symmetric::stumpff_polynomials::{STUMPFF, StumpffPolynomials};
use lie_poisson::Lanes;
use twofloat::TwoFloat;

/// The largest number of coefficients of a versine. A sine has one more.
const MOST_TERMS: usize = 8;

/// The polynomials of a drift for the fraction c of a step: c c₁, c²c₂ and c tan(θ/2)/θ at θ² = c²x, in terms of x.
///
/// Their cosine 1 − x (c²c₂) and sine √x (c c₁) must be on the unit circle to 1e-18 for all x, since the stretching by
/// each flow adds up in a long run. With the coefficients s of the sine and v of the versine, cos² + sin² − 1 has
///
/// ```text
/// Σ s_i s_(n−i) − 2 v_n + Σ v_i v_(n−1−i)    as the coefficient of xⁿ⁺¹
/// ```
///
/// The v_n are chosen such that this coefficient is the [`defect`](StumpffPolynomials::defect), which balances the
/// higher terms. The rounding errors of v₀ and v₁ would make it as large as 1e-16 and 7e-18, so these two have twice
/// the digits.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct DriftPolynomials {
    /// The number of coefficients of `versine`; `sine` has one more.
    terms: usize,
    sine: [f64; MOST_TERMS + 1],
    versine: [f64; MOST_TERMS],
    /// The rounding errors of the first coefficients of the versine.
    versine_low: [f64; 2],
    half_tangent: [f64; 13],
}

/// The values of [`DriftPolynomials`] at one x.
pub(crate) struct DriftValues<T> {
    /// The sine c c₁.
    pub(crate) sine: T,
    /// The leading coefficient v₀ = c²/2 of the versine, rounded.
    pub(crate) half_square: T,
    /// The versine c²c₂ less v₀. Adding v₀ here would delay everything that depends on it.
    pub(crate) rest: T,
}

impl DriftPolynomials {
    /// Creates the shortest polynomials that suffice for x up to `limit`.
    pub(crate) fn new(c: f64, limit: f64) -> Self {
        let square = c * c;
        let will_do = |p: &&StumpffPolynomials| square * limit <= p.range;
        let [longest, ..] = &STUMPFF;
        let polynomials = STUMPFF.iter().rev().find(will_do).unwrap_or(longest);
        let scale = |mut power: f64, coefficients: &[f64], scaled: &mut [f64]| {
            for (scaled, coefficient) in scaled.iter_mut().zip(coefficients) {
                *scaled = power * coefficient;
                power *= square;
            }
        };
        let (mut sine, mut half_tangent, mut defect) =
            ([0.0; MOST_TERMS + 1], [0.0; 13], [0.0; MOST_TERMS]);
        scale(c, polynomials.first, &mut sine);
        scale(c, polynomials.half_tangent, &mut half_tangent);
        scale(square, polynomials.defect, &mut defect);
        let terms = polynomials.defect.len();
        let (versine, versine_low) = versine(&sine[..terms], &defect);
        Self { terms, sine, versine, versine_low, half_tangent }
    }

    /// Returns the sine and the versine at c²x, and (c c₁, c tan(θ/2)/θ) at θ² = c²y.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn at<T: Lanes>(&self, x: T, y: T) -> (DriftValues<T>, (T, T)) {
        match self.terms {
            4 => self.with_terms::<T, 4, 5>(x, y),
            5 => self.with_terms::<T, 5, 7>(x, y),
            6 => self.with_terms::<T, 6, 8>(x, y),
            7 => self.with_terms::<T, 7, 10>(x, y),
            _ => self.with_terms::<T, 8, 13>(x, y),
        }
    }

    #[cfg_attr(optimised, inline(always))]
    fn with_terms<T: Lanes, const TERMS: usize, const HALF: usize>(
        &self,
        x: T,
        y: T,
    ) -> (DriftValues<T>, (T, T)) {
        let sine = &self.sine[..=TERMS];
        let [low, low_slope] = self.versine_low.map(T::from_f64);
        let values = DriftValues {
            sine: polynomial(sine, x),
            half_square: T::from_f64(self.versine[0]),
            rest: polynomial(&self.versine[1..TERMS], x)
                .multiply_add(x, low_slope.multiply_add(x, low)),
        };
        (values, (polynomial(sine, y), polynomial(&self.half_tangent[..HALF], y)))
    }
}

/// Returns the coefficients v of the versine for those of the sine, rounded, and the rounding errors of the first two.
fn versine(sine: &[f64], defect: &[f64]) -> ([f64; MOST_TERMS], [f64; 2]) {
    let zero = TwoFloat::from(0.0);
    let mut exact = [zero; MOST_TERMS];
    for (n, defect) in (0..sine.len()).zip(defect) {
        let reversed = |i: usize| sine[n - i];
        let squares = (0..=n).map(|i| TwoFloat::new_mul(sine[i], reversed(i)));
        let products = (0..n).map(|i| exact[i] * exact[n - 1 - i]);
        let sum = squares.chain(products).fold(zero, |sum, term| sum + term);
        exact[n] = (sum - *defect) * 0.5;
    }
    (exact.map(|v| v.hi()), [exact[0].lo(), exact[1].lo()])
}

/// Evaluates a polynomial by Horner's rule.
#[cfg_attr(optimised, inline(always))]
fn polynomial<T: Lanes>(coefficients: &[f64], x: T) -> T {
    let [lower @ .., highest] = coefficients else { return T::from_f64(0.0) };
    let mut sum = T::from_f64(*highest);
    for &coefficient in lower.iter().rev() {
        sum = sum.multiply_add(x, T::from_f64(coefficient));
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use lie_poisson::Real;

    /// Returns sine, versine and half tangent.
    fn values(drift: &DriftPolynomials, x: f64) -> [f64; 3] {
        let (at_x, (sine, half_tangent)) = drift.at(x, x);
        assert_eq!(at_x.sine, sine);
        [sine, at_x.half_square + at_x.rest, half_tangent]
    }

    /// Returns the exact values.
    fn expected(c: f64, x: f64) -> [f64; 3] {
        let square = c * c * x;
        let angle = square.sqrt();
        let half_tangent = if x > 0.0 { c * (angle / 2.0).tan() / angle } else { c / 2.0 };
        [c * square.stumpff(1), c * c * square.stumpff(2), half_tangent]
    }

    /// Returns the largest of the three errors on [from, to], those of c c₁, c²c₂ and c tan(θ/2)/θ divided by |c|,
    /// c², |c|.
    fn worst(c: f64, drift: &DriftPolynomials, [from, to]: [f64; 2]) -> f64 {
        let sizes = [c.abs(), c * c, c.abs()];
        (0..=1000).fold(0.0, |worst: f64, n| {
            let x = from + (to - from) * f64::from(n) / 1000.0;
            let errors = values(drift, x).into_iter().zip(expected(c, x)).zip(sizes);
            errors.fold(worst, |worst, ((a, b), size)| worst.max((a - b).abs() / size))
        })
    }

    #[test]
    fn drifts_have_the_sine_the_versine_and_the_half_tangent() {
        for c in [1.0, 0.4, -0.2, 0.05, 0.01] {
            for StumpffPolynomials { range, .. } in STUMPFF {
                let limit = range / (c * c);
                let drift = DriftPolynomials::new(c, limit);
                // 1.5e-16 of the polynomials, and some roundings of sums up to 1 here and there.
                assert!(worst(c, &drift, [0.0, limit]) <= 2.0 * f64::EPSILON, "{c} {range}");
                // Beyond it they are not exact, so that the range is needed.
                assert!(
                    worst(c, &drift, [limit, 4.0 * limit]) > 16.0 * f64::EPSILON,
                    "{c} {range}"
                );
            }
        }
    }

    #[test]
    fn shorter_drifts_have_shorter_polynomials() {
        let terms =
            [0.4, 0.2, 0.09, 0.01].map(|c| DriftPolynomials::new(c, 2.0 / (0.4 * 0.4)).terms);
        assert_eq!(terms, [8, 7, 5, 4]);
    }

    /// Returns cos² + sin² − 1 at x in twice the digits, without the rounding errors of the evaluation.
    fn stretching(drift: &DriftPolynomials, x: f64) -> f64 {
        let value = |coefficients: &[f64]| {
            let terms = coefficients.iter().rev();
            terms.fold(TwoFloat::from(0.0), |sum, &c| sum * x + c)
        };
        let versine = value(&drift.versine) + value(&drift.versine_low);
        let (cosine, sine) = (TwoFloat::from(1.0) - versine * x, value(&drift.sine));
        f64::from(cosine * cosine - 1.0 + sine * sine * x)
    }

    #[test]
    fn cosine_and_sine_stay_on_the_unit_circle() {
        let mut rounded = 0.0_f64;
        for c in [1.0, 1.351_207_191_959_657_8, -0.175_603_595_979_828_86, 0.414, 0.017] {
            for StumpffPolynomials { range, .. } in STUMPFF {
                let mut drift = DriftPolynomials::new(c, range / (c * c));
                for n in 0..=128 {
                    let square = range * f64::from(n) / 128.0;
                    // 6e-19 of the longest polynomials, 6e-20 of the others, and rounding. Near θ² = π²/4, where the
                    // cosine vanishes, the versine does not balance the rounding errors of the sine.
                    let bound = if square > 1.4 {
                        4e-17
                    } else if range > 1.0 {
                        2e-18
                    } else {
                        2e-19
                    };
                    let stretching = stretching(&drift, square / (c * c));
                    assert!(stretching.abs() < bound, "{c} {range} {square}: {stretching:e}");
                }
                drift.versine_low = [0.0; 2];
                rounded = rounded.max(stretching(&drift, 0.75 * range / (c * c)).abs());
            }
        }
        // Negative control: with the first coefficients of the versine rounded they do not.
        assert!(rounded > 1e-17, "{rounded:e}");
    }

    /// At θ² = c²x the polynomials of a fraction c are those of a step at x.
    #[test]
    fn a_fraction_scales_the_polynomials() {
        let (whole, half) = (DriftPolynomials::new(1.0, 0.1), DriftPolynomials::new(0.5, 0.4));
        assert!(whole.terms == half.terms && whole.versine_low != [0.0; 2]);
        let scaled = |power: f64| move |(n, x): (i32, f64)| power * x * 0.25_f64.powi(n);
        for (one, other, power) in [
            (&whole.sine[..], &half.sine[..], 0.5),
            (&whole.versine, &half.versine, 0.25),
            (&whole.versine_low, &half.versine_low, 0.25),
            (&whole.half_tangent, &half.half_tangent, 0.5),
        ] {
            let expected = (0..).zip(one.iter().copied()).map(scaled(power));
            assert!(expected.eq(other.iter().copied()), "{one:?} {other:?}");
        }
    }
}
