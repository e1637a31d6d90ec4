//! The functions of [`Real`] on dual numbers, by the chain rule.

use super::number::DualNumber;
use crate::numbers::real::Real;

impl<T: Real> Real for DualNumber<T> {
    const HAS_SLOW_PATHS: bool = T::HAS_SLOW_PATHS;
    type Mask = T::Mask;

    #[cfg_attr(optimised, inline(always))]
    fn from_f64(x: f64) -> Self {
        Self::constant(T::from_f64(x))
    }

    #[cfg_attr(optimised, inline(always))]
    fn without_derivative(self) -> Option<Self> {
        Some(Self::constant(self.value.without_derivative().unwrap_or(self.value)))
    }

    #[inline]
    fn lane_by_lane(self, other: Self, f: impl FnMut(f64, f64) -> f64) -> Self {
        Self::constant(self.value.lane_by_lane(other.value, f))
    }

    #[cfg_attr(optimised, inline(always))]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, reciprocal(root + root))
    }

    fn ln(self) -> Self {
        self.chain(self.value.ln(), reciprocal(self.value))
    }

    fn atan2(self, x: Self) -> Self {
        let turned = x.value * self.derivative - self.value * x.derivative;
        Self {
            value: self.value.atan2(x.value),
            derivative: turned / (x.value * x.value + self.value * self.value),
        }
    }

    fn exp(self) -> Self {
        let value = self.value.exp();
        self.chain(value, value)
    }

    fn sin(self) -> Self {
        self.chain(self.value.sin(), self.value.cos())
    }

    fn cos(self) -> Self {
        self.chain(self.value.cos(), -self.value.sin())
    }

    /// Returns tanh x with the slope 4e/(1 + e)², where e = exp(−2|x|). The formula 1 − tanh² x loses this slope for
    /// large |x|.
    fn tanh(self) -> Self {
        let e = (self.value.select_nonnegative(-self.value, self.value) * 2.0).exp();
        let sum = e + 1.0;
        self.chain(self.value.tanh(), e / sum * 4.0 / sum)
    }

    /// Returns xⁿ with the slope n xⁿ⁻¹, which is 0 for n = 0 even at x = 0.
    fn powi(self, n: i32) -> Self {
        let value = self.value.powi(n);
        if n == 0 {
            return Self::constant(value);
        }
        self.chain(value, self.value.powi(n.saturating_sub(1)) * f64::from(n))
    }

    fn stumpff(self, order: u32) -> Self {
        let x = self.value;
        let (next, second) =
            (x.stumpff(order.saturating_add(1)), x.stumpff(order.saturating_add(2)));
        let slope = (second * f64::from(order) - next) * 0.5;
        self.chain(x.stumpff(order), slope)
    }

    #[cfg_attr(optimised, inline(always))]
    fn at_most(self, bound: Self) -> T::Mask {
        self.value.at_most(bound.value)
    }

    #[cfg_attr(optimised, inline(always))]
    fn select(mask: T::Mask, yes: Self, no: Self) -> Self {
        Self {
            value: T::select(mask, yes.value, no.value),
            derivative: T::select(mask, yes.derivative, no.derivative),
        }
    }

    #[cfg_attr(optimised, inline(always))]
    fn magnitude(self) -> Self {
        Self::constant(self.value.magnitude().larger(self.derivative.magnitude()))
    }

    fn max_abs(self) -> f64 {
        crate::larger(self.value.max_abs(), self.derivative.max_abs())
    }
}

/// Returns 1/x; `num_traits` offers it only on `Float`.
fn reciprocal<T: Real>(x: T) -> T {
    T::one() / x
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares the derivative of `f` at `x` with the symmetric difference quotient.
    fn check(f: impl Fn(DualNumber) -> DualNumber, x: f64) {
        let step = 1e-5;
        let at = |x: f64| f(DualNumber::constant(x)).value;
        let quotient = (at(x + step) - at(x - step)) / (2.0 * step);
        let exact = f(DualNumber::variable(x)).derivative;
        // Truncation step²·f‴/6 and round-off 1e-16/step are both near 1e-10.
        assert!((quotient - exact).abs() < 1e-9 * (1.0 + exact.abs()), "{x}: {quotient} {exact}");
    }

    #[test]
    fn every_operation_has_the_right_derivative() {
        for x in [0.3, 1.7] {
            check(|x| x * x + x * 3.0 - x / (x + 1.0) + (-x) * 0.5 - 2.0, x);
            check(Real::sqrt, x);
            check(Real::ln, x);
            check(|x| (x + 1.0).atan2(x * x - 2.0), x);
            check(|x| (x * 5.0) % DualNumber::from_f64(0.7), x);
            for x in [x, -x] {
                check(Real::exp, x);
                check(Real::sin, x);
                check(Real::cos, x);
                check(Real::tanh, x);
                for n in -3..5 {
                    check(|x| (x + 3.0).powi(n), x);
                }
                for order in 0..5 {
                    check(|x| x.stumpff(order), x);
                }
            }
        }
    }

    /// Returns x as a variable of two nested dual numbers.
    fn twice(x: f64) -> DualNumber<DualNumber> {
        DualNumber::new(DualNumber::variable(x), DualNumber::from_f64(1.0))
    }

    #[test]
    fn nested_dual_numbers_give_second_derivatives() {
        let x = twice(2.0);
        assert_eq!((x * x * x).derivative.derivative, 12.0);
    }

    /// f″ is −f for sin and cos, f for exp, −2ff′ for tanh, and n(n−1)xⁿ⁻² for powers.
    #[test]
    fn second_derivatives_of_functions() {
        let near = |a: f64, b: f64| (a - b).abs() <= 8.0 * f64::EPSILON * b.abs();
        for x in [-2.5, -0.3, 0.4, 1.9, 12.0_f64] {
            let second = |f: DualNumber<DualNumber>| f.derivative.derivative;
            assert_eq!(second(twice(x).exp()), x.exp());
            assert_eq!(second(twice(x).sin()), -Real::sin(x));
            assert_eq!(second(twice(x).cos()), -Real::cos(x));
            let (tanh, slope) = (x.tanh(), 1.0 / (x.cosh() * x.cosh()));
            assert!(near(second(twice(x).tanh()), -2.0 * tanh * slope), "{x}");
            for n in [-3, -1, 2, 3, 7] {
                let exact = f64::from(n * (n - 1)) * f64::powi(x, n - 2);
                assert!(near(second(twice(x).powi(n)), exact), "{x} {n}");
            }
        }
    }

    /// cos² + sin² = 1 and exp(x) exp(−x) = 1 have no derivative; far from 0, where 1 − tanh² would be 0, the slope
    /// of tanh is 4 exp(−2|x|).
    #[test]
    fn identities_of_functions() {
        for x in [-700.0, -40.0, -1e-9, 0.0, 0.7, 25.0, 300.0] {
            let x = DualNumber::variable(x);
            let circle = x.cos() * x.cos() + x.sin() * x.sin();
            assert!((circle.value - 1.0).abs() < 1e-15 && circle.derivative.abs() < 1e-15);
            let one = x.exp() * (-x).exp();
            assert!((one.value - 1.0).abs() < 1e-15 && one.derivative.abs() < 1e-15, "{x:?}");
            if x.value.abs() > 20.0 {
                let slope = 4.0 * (-2.0 * x.value.abs()).exp();
                assert!((x.tanh().derivative - slope).abs() <= 1e-15 * slope);
            }
        }
        let zero = DualNumber::variable(0.0);
        let powers = [0, 1, 2].map(|n| zero.powi(n));
        assert_eq!(powers.map(|x| (x.value, x.derivative)), [(1.0, 0.0), (0.0, 1.0), (0.0, 0.0)]);
    }

    #[test]
    fn a_nan_stays_a_nan() {
        let x = DualNumber::variable(f64::NAN);
        for f in [x.exp(), x.sin(), x.cos(), x.tanh(), x.powi(3), x.powi(-2)] {
            assert!(f.value.is_nan() && f.derivative.is_nan(), "{f:?}");
        }
    }

    #[test]
    fn a_nan_derivative_is_seen() {
        let x = DualNumber { value: 0.0, derivative: f64::NAN };
        assert!(!x.all_below(1.0) && x.max_abs().is_nan());
        assert!(x.magnitude().value.is_nan() && x.at_most(DualNumber::constant(0.0)));
    }
}
