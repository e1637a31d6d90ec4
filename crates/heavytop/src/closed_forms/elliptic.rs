//! Jacobi's elliptic functions.

use crate::error::TopError;
use core::f64::consts::{FRAC_PI_2, TAU};
use twofloat::TwoFloat;

/// The number of stored steps of the arithmetic–geometric mean, enough for 1 and the smallest k′ > 0.
const STEPS: usize = 16;

/// Jacobi's elliptic functions of one parameter m = k², 0 ≤ m ≤ 1, for real arguments.
///
/// The quarter period is K(m). Near m = 1 it is ln(4/k′), with the complementary modulus k′ = √(1−m). A number m near 1
/// holds few digits of 1 − m, or none: [`with_complement`](Self::with_complement) accepts 1 − m instead.
///
/// The argument is reduced modulo K with twice the digits of an `f64`. For |u| ≤ 2⁵³K the errors of sn u, cn u and dn u
/// are therefore those of an exact formula whose argument is wrong by a few units of round-off of K, rather than of u:
/// |error of f(u)| ≤ 16ε(|f(u)| + K|f′(u)|), ε = 2⁻⁵³. For m = 1, where K is infinite, |u| replaces K.
///
/// Method: the descending Landen transformation along the arithmetic–geometric mean a₀ = 1, b₀ = k′,
/// aₙ₊₁ = ½(aₙ+bₙ), bₙ₊₁ = √(aₙbₙ). With X = a cs(au), Y = a ds(au), Z = a ns(au) for the
/// complementary modulus b/a it reads
///
/// ```text
/// Xₙ = Xₙ₊₁Yₙ₊₁/Zₙ₊₁,  Yₙ = (Xₙ₊₁² + aₙ₊₁bₙ)/Zₙ₊₁,  Zₙ = (Xₙ₊₁² + aₙ₊₁aₙ)/Zₙ₊₁,
/// ```
///
/// in which nothing cancels.
///
/// Source: NIST Digital Library of Mathematical Functions, §22.7(i) and §22.20(ii).
///
/// # Example
/// ```
/// use heavytop::JacobiElliptic;
/// let jacobi = JacobiElliptic::with_complement(1e-40)?;
/// let quarter = jacobi.quarter_period();
/// assert!((quarter - 4e20_f64.ln()).abs() < 1e-14 * quarter);
/// // dn K = k′
/// let [_, _, dn, _] = jacobi.at(quarter);
/// assert!((dn - 1e-20).abs() < 1e-33);
/// # Ok::<(), heavytop::TopError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JacobiElliptic {
    /// The quarter period K as an unevaluated sum; infinite for m = 1.
    quarter_period: [f64; 2],
    /// The common limit of aₙ and bₙ.
    mean: f64,
    /// The products (aₙ₊₁aₙ, aₙ₊₁bₙ) of each step.
    products: [[f64; 2]; STEPS],
    steps: usize,
}

impl JacobiElliptic {
    /// Creates the functions of the parameter m.
    ///
    /// # Errors
    /// Returns [`TopError::OutOfRange`] unless 0 ≤ m ≤ 1.
    pub fn new(parameter: f64) -> Result<Self, TopError> {
        let parameter = between_zero_and_one("parameter", parameter)?;
        Ok(Self::of_modulus(root(TwoFloat::new_sub(1.0, parameter))))
    }

    /// Creates the functions of the parameter m from its complement 1 − m.
    ///
    /// # Errors
    /// Returns [`TopError::OutOfRange`] unless 0 ≤ 1 − m ≤ 1.
    pub fn with_complement(complement: f64) -> Result<Self, TopError> {
        let complement = between_zero_and_one("complement", complement)?;
        // Powers of two, so that no low part underflows.
        Ok(Self::of_modulus(root((complement * 2.0_f64.powi(220)).into()) * 2.0_f64.powi(-110)))
    }

    /// Creates the functions of the complementary modulus k′ ≥ 0; a number above 1, by rounding, counts as 1.
    pub(crate) fn with_complementary_modulus(modulus: f64) -> Self {
        Self::of_modulus(modulus.min(1.0).into())
    }

    fn of_modulus(modulus: TwoFloat) -> Self {
        let (mut a, mut b) = (TwoFloat::from(1.0), modulus);
        let (mut products, mut steps) = ([[0.0; 2]; STEPS], 0);
        if b.hi() == 0.0 {
            return Self { quarter_period: [f64::INFINITY, 0.0], mean: 0.0, products, steps };
        }
        // ½(a + b) then differs from the limit by the square of this bound.
        while f64::from(a - b) > 1e-17 * a.hi() && steps < STEPS {
            let (next, product) = ((a + b) * 0.5, a * b);
            products[steps] = [f64::from(next * a), f64::from(next * b)];
            steps += 1;
            (a, b) = (next, root(product));
        }
        // K is π/2 over the mean, the low part from the remainder of the division.
        let mean = (a + b) * 0.5;
        let high = FRAC_PI_2 / mean.hi();
        let low = f64::from(twofloat::consts::FRAC_PI_2 - mean * high) / mean.hi();
        Self { quarter_period: [high, low], mean: mean.hi(), products, steps }
    }

    /// Returns the quarter period K of sn and cn, which is half the period of dn; infinite for m = 1.
    #[must_use]
    pub fn quarter_period(&self) -> f64 {
        self.quarter_period[0]
    }

    /// Returns sn u, cn u, dn u and the amplitude am u, in radians.
    ///
    /// The values are NaN for u = ±∞, except for m = 1, where the limits exist.
    #[must_use]
    pub fn at(&self, u: f64) -> [f64; 4] {
        let [high, low] = self.quarter_period;
        if high == f64::INFINITY {
            let sech = 1.0 / u.cosh();
            return [u.tanh(), sech, sech, 2.0 * (0.5 * u).tanh().atan()];
        }
        // u = nK + rest; the first difference is exact.
        let quarters = (u / high).round_ties_even();
        let rest = (-quarters).mul_add(low, (-quarters).mul_add(high, u));
        let [sn, cn, dn] = self.in_quarter(quarters.rem_euclid(4.0), rest);
        // am and the angle of (cn, sn) differ by whole turns.
        let angle = sn.atan2(cn);
        let turns = ((quarters * FRAC_PI_2 - angle) / TAU).round_ties_even();
        [sn, cn, dn, if turns == 0.0 { angle } else { turns.mul_add(TAU, angle) }]
    }

    /// Returns sn, cn and dn at `quarter`·K + `rest`.
    fn in_quarter(&self, quarter: f64, rest: f64) -> [f64; 3] {
        let half = if quarter >= 2.0 { -1.0 } else { 1.0 };
        if quarter.rem_euclid(2.0) == 0.0 && rest.abs() < 1e-9 {
            // The terms that follow are of the relative order u².
            return [half * rest, half, 1.0];
        }
        let (sin, cos) = (self.mean * rest).sin_cos();
        let (sin, cos) = if quarter.rem_euclid(2.0) == 0.0 { (sin, cos) } else { (cos, -sin) };
        let mut z = self.mean / sin.abs();
        let (mut x, mut y) = (z * cos, z);
        for [aa, ab] in self.products[..self.steps].iter().rev() {
            let square = x * x;
            (x, y, z) = (x * y / z, (square + ab) / z, (square + aa) / z);
        }
        [1.0_f64.copysign(half * sin) / z, half * x / z, y / z]
    }
}

/// Returns sn u, cn u, dn u and the amplitude am u for the parameter m = k², 0 ≤ m ≤ 1, and real u.
///
/// For many values with one m, and for parameters near 1, use [`JacobiElliptic`], which also states the
/// accuracy. The values are NaN for m outside [0, 1], and for u = ±∞ unless m = 1.
///
/// Source: Abramowitz & Stegun, *Handbook of Mathematical Functions*, chapter 16.
///
/// # Example
/// ```
/// let [sn, cn, dn, _] = heavytop::jacobi_elliptic(0.7, 0.36);
/// assert!((sn * sn + cn * cn - 1.0).abs() < 1e-15);
/// assert!((dn * dn + 0.36 * sn * sn - 1.0).abs() < 1e-15);
/// ```
#[must_use]
pub fn jacobi_elliptic(u: f64, m: f64) -> [f64; 4] {
    JacobiElliptic::new(m).map_or([f64::NAN; 4], |jacobi| jacobi.at(u))
}

/// Returns the argument u in [−K, K] with the given sn u, cn u ≥ 0 and dn u ≥ 0, not both zero.
///
/// It is
///
/// ```text
/// u = F(φ | m) = ∫₀^φ dθ/√(1 − m sin²θ) = sn u R_F(cn² u, dn² u, 1),   φ = am u
/// ```
///
/// The method is Carlson's duplication theorem for R_F. Source: NIST Digital Library of Mathematical
/// Functions, (19.25.5) and §19.36(i).
pub(crate) fn elliptic_argument(sn: f64, cn: f64, dn: f64) -> f64 {
    // The first duplication takes the square roots as they are, so that no square underflows.
    let (mut roots, mut values) = ([cn, dn, 1.0], [cn * cn, dn * dn, 1.0]);
    // Each duplication divides the differences by four, once the values are of one size.
    for _ in 0..64 {
        let [a, b, c] = roots;
        let lambda = a * b + b * c + c * a;
        values = values.map(|value| 0.25 * (value + lambda));
        roots = values.map(f64::sqrt);
        let [x, y, z] = values;
        if (x - z).abs() + (y - z).abs() < 1e-3 * z {
            break;
        }
    }
    let mean = (values[0] + values[1] + values[2]) / 3.0;
    let [x, y, z] = values.map(|value| 1.0 - value / mean);
    let (e2, e3) = (x * y + y * z + z * x, x * y * z);
    let series = 1.0 - e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0 - 3.0 * e2 * e3 / 44.0;
    sn * series / mean.sqrt()
}

/// Returns the square root. The one of the crate `twofloat` is not exact for squares of whole numbers.
pub(crate) fn root(x: TwoFloat) -> TwoFloat {
    let estimate = x.hi().sqrt();
    if estimate == 0.0 {
        return estimate.into();
    }
    TwoFloat::new_add(estimate, (x - TwoFloat::new_mul(estimate, estimate)).hi() / (2.0 * estimate))
}

fn between_zero_and_one(name: &'static str, value: f64) -> Result<f64, TopError> {
    if (0.0..=1.0).contains(&value) {
        Ok(value)
    } else {
        Err(TopError::OutOfRange { name, value, least: 0.0, greatest: 1.0 })
    }
}

#[cfg(test)]
mod tests {
    use super::{JacobiElliptic, STEPS, elliptic_argument};

    /// u with sn u, cn u and dn u for 1 − m = 1, ½, 1e-6, 1e-16, 1e-40 and 1e-300, rounded from 60-digit
    /// arithmetic (mpmath 1.3).
    #[rustfmt::skip]
    const REFERENCE: [[f64; 4]; 11] = [
        [1.5, 0.997_494_986_604_054_4, 0.070_737_201_667_702_9, 1.0],
        [1e-9, 1e-9, 1.0, 1.0],
        [1.8, 0.999_268_715_242_506_7, 0.038_236_562_837_027_484, 0.707_623_499_729_054_4],
        [3.0, 0.995_054_995_047_900_6, 0.099_325_509_463_695, 0.099_330_493_629_427_5],
        [8.0, 0.999_999_955_506_346_1, 0.000_298_307_401_570_050_5, 0.001_043_545_503_006_059_4],
        [15.0, 0.999_999_999_999_812_9, 6.117_637_782_864_387e-7, 6.118_455_037_207_504e-7],
        [19.8, 1.0, 6.975_161_631_300_964e-11, 1.000_024_326_144_010_7e-8],
        [40.0, 1.0, 8.496_705_568_267_343e-18, 8.496_711_452_899_014e-18],
        [47.0, 1.0, 4.521_354_149_636_79e-21, 1.097_463_636_511_195_8e-20],
        [300.0, 1.0, 1.029_640_044_482_402_7e-130, 1.029_640_044_482_402_7e-130],
        [346.7, 1.0, 7.412_602_590_644_129e-152, 1.002_743_570_269_429_5e-150],
    ];

    #[test]
    fn the_mean_converges_for_every_modulus() {
        for modulus in [5e-324, 1e-300, 1e-20, 0.5, 1.0 - f64::EPSILON, 1.0] {
            assert!(JacobiElliptic::with_complementary_modulus(modulus).steps < STEPS);
        }
    }

    #[test]
    fn the_argument_has_the_digits_of_its_functions() {
        for [u, sn, cn, dn] in REFERENCE {
            for sign in [1.0, -1.0] {
                // The relative condition numbers of R_F add to ½, that of sn is 1.
                let error = (elliptic_argument(sign * sn, cn, dn) - sign * u).abs() / u;
                assert!(error < 2.0 * f64::EPSILON, "{u}: {error:e}");
            }
        }
        // cn = 0 is the quarter period, here ln(4/k′).
        assert!((elliptic_argument(1.0, 0.0, 1e-300) / 4e300_f64.ln() - 1.0).abs() < 4e-16);
        assert_eq!(elliptic_argument(0.0, 1.0, 1.0), 0.0);
    }
}
