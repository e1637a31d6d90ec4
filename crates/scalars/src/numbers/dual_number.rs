//! Dual numbers over any scalar, for exact first derivatives.

use crate::Real;
use core::ops::{
    Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign,
};
use num_traits::{Num, One, Zero};

/// A dual number x + ε x′ with ε² = 0, which carries a value and its exact first derivative.
///
/// Evaluating a function at `x + ε v` gives f(x) + ε Df(x)·v, exact to round-off. Dual numbers can be
/// nested, for second derivatives, and can be used over [`DefaultLanes`](crate::DefaultLanes), four SIMD
/// lanes.
///
/// Two dual numbers are equal if both their values and their derivatives are equal.
///
/// Source: W. K. Clifford, *Preliminary sketch of biquaternions*, Proc. London Math. Soc. 4 (1873).
///
/// # Example
/// ```
/// use generic_scalars::{DualNumber, Real};
/// let x = DualNumber::variable(4.0);
/// assert_eq!(Real::sqrt(x), DualNumber { value: 2.0, derivative: 0.25 });
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DualNumber<T = f64> {
    /// The value x of the number.
    pub value: T,
    /// The derivative x′, the coefficient of ε.
    pub derivative: T,
}

impl<T: Real> DualNumber<T> {
    /// Creates the constant x + 0 ε, whose derivative is zero.
    pub fn constant(value: T) -> Self {
        Self { value, derivative: T::zero() }
    }

    /// Creates x + 1 ε, the variable with respect to which a function is differentiated.
    pub fn variable(value: T) -> Self {
        Self { value, derivative: T::one() }
    }

    /// Applies the chain rule: returns f(x) + ε f′(x) x′ for the given value f(x) and slope f′(x).
    #[inline]
    fn chain(self, value: T, slope: T) -> Self {
        Self { value, derivative: slope * self.derivative }
    }
}

impl<T: Real> Add for DualNumber<T> {
    type Output = Self;
    fn add(self, rhs: Self) -> Self {
        Self { value: self.value + rhs.value, derivative: self.derivative + rhs.derivative }
    }
}

impl<T: Real> Sub for DualNumber<T> {
    type Output = Self;
    fn sub(self, rhs: Self) -> Self {
        Self { value: self.value - rhs.value, derivative: self.derivative - rhs.derivative }
    }
}

impl<T: Real> Mul for DualNumber<T> {
    type Output = Self;
    fn mul(self, rhs: Self) -> Self {
        Self {
            value: self.value * rhs.value,
            derivative: self.derivative * rhs.value + self.value * rhs.derivative,
        }
    }
}

impl<T: Real> Div for DualNumber<T> {
    type Output = Self;
    fn div(self, rhs: Self) -> Self {
        let value = self.value / rhs.value;
        Self { value, derivative: (self.derivative - value * rhs.derivative) / rhs.value }
    }
}

/// The remainder of the values; its derivative treats the truncated quotient as a constant.
impl<T: Real> Rem for DualNumber<T> {
    type Output = Self;
    fn rem(self, rhs: Self) -> Self {
        let value = self.value % rhs.value;
        let quotient = (self.value - value) / rhs.value;
        Self { value, derivative: self.derivative - quotient * rhs.derivative }
    }
}

impl<T: Real> Neg for DualNumber<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, derivative: -self.derivative }
    }
}

impl<T: Real> Add<f64> for DualNumber<T> {
    type Output = Self;
    fn add(self, rhs: f64) -> Self {
        Self { value: self.value + rhs, ..self }
    }
}

impl<T: Real> Sub<f64> for DualNumber<T> {
    type Output = Self;
    fn sub(self, rhs: f64) -> Self {
        Self { value: self.value - rhs, ..self }
    }
}

impl<T: Real> Mul<f64> for DualNumber<T> {
    type Output = Self;
    fn mul(self, rhs: f64) -> Self {
        Self { value: self.value * rhs, derivative: self.derivative * rhs }
    }
}

impl<T: Real> Div<f64> for DualNumber<T> {
    type Output = Self;
    fn div(self, rhs: f64) -> Self {
        Self { value: self.value / rhs, derivative: self.derivative / rhs }
    }
}

macro_rules! assign {
    ($($trait:ident $method:ident $operator:tt),*) => {$(
        impl<T: Real> $trait for DualNumber<T> {
            fn $method(&mut self, rhs: Self) {
                *self = *self $operator rhs;
            }
        }
    )*};
}
assign!(AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *,
        DivAssign div_assign /, RemAssign rem_assign %);

impl<T: Real> Zero for DualNumber<T> {
    fn zero() -> Self {
        Self::constant(T::zero())
    }
    fn is_zero(&self) -> bool {
        self.value.is_zero() && self.derivative.is_zero()
    }
}

impl<T: Real> One for DualNumber<T> {
    fn one() -> Self {
        Self::constant(T::one())
    }
}

impl<T: Real> Num for DualNumber<T> {
    type FromStrRadixErr = T::FromStrRadixErr;
    fn from_str_radix(text: &str, radix: u32) -> Result<Self, Self::FromStrRadixErr> {
        T::from_str_radix(text, radix).map(Self::constant)
    }
}

impl<T: Real> Real for DualNumber<T> {
    type Mask = T::Mask;

    fn from_f64(x: f64) -> Self {
        Self::constant(T::from_f64(x))
    }

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

    fn stumpff(self, order: u32) -> Self {
        let x = self.value;
        let (next, second) =
            (x.stumpff(order.saturating_add(1)), x.stumpff(order.saturating_add(2)));
        let slope = (second * f64::from(order) - next) * 0.5;
        self.chain(x.stumpff(order), slope)
    }

    fn at_most(self, bound: Self) -> T::Mask {
        self.value.at_most(bound.value)
    }

    fn select(mask: T::Mask, yes: Self, no: Self) -> Self {
        Self {
            value: T::select(mask, yes.value, no.value),
            derivative: T::select(mask, yes.derivative, no.derivative),
        }
    }

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
            for order in 0..5 {
                check(|x| x.stumpff(order), x);
                check(|x| x.stumpff(order), -x);
            }
        }
    }

    #[test]
    fn nested_dual_numbers_give_second_derivatives() {
        let x =
            DualNumber { value: DualNumber::variable(2.0), derivative: DualNumber::from_f64(1.0) };
        assert_eq!((x * x * x).derivative.derivative, 12.0);
    }

    #[test]
    fn a_nan_derivative_is_seen() {
        let x = DualNumber { value: 0.0, derivative: f64::NAN };
        assert!(!x.all_below(1.0) && x.max_abs().is_nan());
        assert!(x.magnitude().value.is_nan() && x.at_most(DualNumber::constant(0.0)));
    }
}
