//! The operators of [`DualNumber`].

use super::number::DualNumber;
use crate::numbers::real::Real;
use core::ops::{
    Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign,
};
use num_traits::{Num, One, Zero};

impl<T: Real> Add for DualNumber<T> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
    fn add(self, rhs: Self) -> Self {
        Self { value: self.value + rhs.value, derivative: self.derivative + rhs.derivative }
    }
}

impl<T: Real> Sub for DualNumber<T> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
    fn sub(self, rhs: Self) -> Self {
        Self { value: self.value - rhs.value, derivative: self.derivative - rhs.derivative }
    }
}

impl<T: Real> Mul for DualNumber<T> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
    fn mul(self, rhs: Self) -> Self {
        Self {
            value: self.value * rhs.value,
            derivative: self.derivative * rhs.value + self.value * rhs.derivative,
        }
    }
}

impl<T: Real> Div for DualNumber<T> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
    fn div(self, rhs: Self) -> Self {
        let value = self.value / rhs.value;
        Self { value, derivative: (self.derivative - value * rhs.derivative) / rhs.value }
    }
}

/// The remainder of the values; its derivative treats the truncated quotient as a constant.
impl<T: Real> Rem for DualNumber<T> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
    fn rem(self, rhs: Self) -> Self {
        let value = self.value % rhs.value;
        let quotient = (self.value - value) / rhs.value;
        Self { value, derivative: self.derivative - quotient * rhs.derivative }
    }
}

impl<T: Real> Neg for DualNumber<T> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
    fn neg(self) -> Self {
        Self { value: -self.value, derivative: -self.derivative }
    }
}

impl<T: Real> Add<f64> for DualNumber<T> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
    fn add(self, rhs: f64) -> Self {
        Self { value: self.value + rhs, ..self }
    }
}

impl<T: Real> Sub<f64> for DualNumber<T> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
    fn sub(self, rhs: f64) -> Self {
        Self { value: self.value - rhs, ..self }
    }
}

impl<T: Real> Mul<f64> for DualNumber<T> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
    fn mul(self, rhs: f64) -> Self {
        Self { value: self.value * rhs, derivative: self.derivative * rhs }
    }
}

impl<T: Real> Div<f64> for DualNumber<T> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
    fn div(self, rhs: f64) -> Self {
        Self { value: self.value / rhs, derivative: self.derivative / rhs }
    }
}

macro_rules! assign {
    ($($trait:ident $method:ident $operator:tt),*) => {$(
        impl<T: Real> $trait for DualNumber<T> {
            #[cfg_attr(optimised, inline(always))]
            fn $method(&mut self, rhs: Self) {
                *self = *self $operator rhs;
            }
        }
    )*};
}
assign!(AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *,
        DivAssign div_assign /, RemAssign rem_assign %);

impl<T: Real> Zero for DualNumber<T> {
    #[cfg_attr(optimised, inline(always))]
    fn zero() -> Self {
        Self::constant(T::zero())
    }
    #[cfg_attr(optimised, inline(always))]
    fn is_zero(&self) -> bool {
        self.value.is_zero() && self.derivative.is_zero()
    }
}

impl<T: Real> One for DualNumber<T> {
    #[cfg_attr(optimised, inline(always))]
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
