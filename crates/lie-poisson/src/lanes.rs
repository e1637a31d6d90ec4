//! Several `f64` at once: an ensemble by changing the scalar.

use crate::Real;
use core::array::from_fn;
use core::ops::{
    Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign,
};
use num_traits::{Num, One, Zero};

/// `N` independent real numbers, computed with side by side.
///
/// Each operation acts lane by lane and returns, in each lane, the bits that `f64` would.
///
/// # Example
/// ```
/// use lie_poisson::{Lanes, Real};
/// let x = Lanes([1.0, 4.0]);
/// assert_eq!(Real::sqrt(x * x + 0.0), Lanes([1.0, 4.0]));
/// assert!(!Lanes([0.0, f64::NAN]).all_below(1.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub struct Lanes<const N: usize>(pub [f64; N]);

impl<const N: usize> Lanes<N> {
    #[inline]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self(self.0.map(f))
    }

    #[inline]
    fn zip(self, rhs: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self(from_fn(|lane| f(self.0[lane], rhs.0[lane])))
    }
}

macro_rules! operator {
    ($($trait:ident $method:ident $assign:ident $assign_method:ident $operator:tt),*) => {$(
        impl<const N: usize> $trait for Lanes<N> {
            type Output = Self;
            #[inline]
            fn $method(self, rhs: Self) -> Self {
                self.zip(rhs, |a, b| a $operator b)
            }
        }
        impl<const N: usize> $trait<f64> for Lanes<N> {
            type Output = Self;
            #[inline]
            fn $method(self, rhs: f64) -> Self {
                self.map(|a| a $operator rhs)
            }
        }
        impl<const N: usize> $assign for Lanes<N> {
            #[inline]
            fn $assign_method(&mut self, rhs: Self) {
                *self = *self $operator rhs;
            }
        }
    )*};
}
operator!(Add add AddAssign add_assign +, Sub sub SubAssign sub_assign -,
          Mul mul MulAssign mul_assign *, Div div DivAssign div_assign /,
          Rem rem RemAssign rem_assign %);

impl<const N: usize> Neg for Lanes<N> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.map(|a| -a)
    }
}

impl<const N: usize> Zero for Lanes<N> {
    fn zero() -> Self {
        Self([0.0; N])
    }
    fn is_zero(&self) -> bool {
        self.0.iter().all(Zero::is_zero)
    }
}

impl<const N: usize> One for Lanes<N> {
    fn one() -> Self {
        Self([1.0; N])
    }
}

impl<const N: usize> Num for Lanes<N> {
    type FromStrRadixErr = <f64 as Num>::FromStrRadixErr;
    fn from_str_radix(text: &str, radix: u32) -> Result<Self, Self::FromStrRadixErr> {
        <f64 as Num>::from_str_radix(text, radix).map(Self::from_f64)
    }
}

impl<const N: usize> Real for Lanes<N> {
    #[inline]
    fn from_f64(x: f64) -> Self {
        Self([x; N])
    }

    #[inline]
    fn sqrt(self) -> Self {
        self.map(f64::sqrt)
    }

    fn ln(self) -> Self {
        self.map(f64::ln)
    }

    fn atan2(self, x: Self) -> Self {
        self.zip(x, f64::atan2)
    }

    fn stumpff(self, order: u32) -> Self {
        self.map(|x| x.stumpff(order))
    }

    #[inline]
    fn select_nonnegative(self, yes: Self, no: Self) -> Self {
        Self(from_fn(|lane| self.0[lane].select_nonnegative(yes.0[lane], no.0[lane])))
    }

    #[inline]
    fn all_below(self, bound: f64) -> bool {
        self.0.iter().all(|x| x.abs() <= bound)
    }

    #[inline]
    fn max_abs(self) -> f64 {
        self.0.iter().fold(0.0, |m, x| crate::larger(m, x.abs()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn formula<T: Real>(x: T, y: T) -> T {
        let sum = (x * y - x / (y + 3.0) + 0.5).stumpff(2) - y % T::from_f64(0.3);
        x.select_nonnegative((sum * sum).sqrt(), (x * x + 1.0).ln()) - (-y) * 2.0
    }

    proptest! {
        #[test]
        fn each_lane_has_the_bits_of_f64(x in [-9.0..9.0, -9.0..9.0, -9.0..9.0f64], y in 0.0..9.0f64) {
            let together = formula(Lanes(x), Lanes::from_f64(y));
            for (lane, x) in together.0.iter().zip(x) {
                prop_assert_eq!(lane.to_bits(), formula(x, y).to_bits());
            }
        }

        #[test]
        fn a_nan_in_any_lane_is_seen(lane in 0..4_usize) {
            let mut x = Lanes([1.0; 4]);
            x.0[lane] = f64::NAN;
            prop_assert!(!x.all_below(2.0) && x.max_abs().is_nan());
        }
    }
}
