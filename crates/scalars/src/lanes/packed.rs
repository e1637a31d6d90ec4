//! Lanes as a scalar type: [`Packed`].

use super::lane_scalar::Lanes;
use super::registers::register::Register;
use crate::numbers::mask::Mask;
use crate::numbers::real::{Real, larger};
use crate::numbers::sine::{cosine_of_moderate, is_moderate, sine_of_moderate};
use core::fmt;
use core::ops::{
    Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign,
};
use num_traits::{Num, One, Zero};

/// One or two registers with the operators of [`Real`] and the operations of [`Lanes`].
///
/// No conversion relates this type to a type that other crates can name. Otherwise type inference could lead them to
/// a register that the processor may lack: see [`dispatch`](super::dispatch()).
#[derive(Clone, Copy)]
pub struct Packed<R: Register>(pub(super) R);

macro_rules! operators {
    ($($trait:ident $method:ident $assign:ident $assign_method:ident $of_registers:ident;)*) => {$(
        impl<R: Register> $trait for Packed<R> {
            type Output = Self;
            #[cfg_attr(optimised, inline(always))]
            fn $method(self, rhs: Self) -> Self {
                Self(R::$of_registers(self.0, rhs.0))
            }
        }
        impl<R: Register> $trait<f64> for Packed<R> {
            type Output = Self;
            #[cfg_attr(optimised, inline(always))]
            fn $method(self, rhs: f64) -> Self {
                Self(R::$of_registers(self.0, R::splat(rhs)))
            }
        }
        impl<R: Register> $assign for Packed<R> {
            #[cfg_attr(optimised, inline(always))]
            fn $assign_method(&mut self, rhs: Self) {
                self.0 = R::$of_registers(self.0, rhs.0);
            }
        }
    )*};
}
operators! {
    Add add AddAssign add_assign add;
    Sub sub SubAssign sub_assign subtract;
    Mul mul MulAssign mul_assign multiply;
    Div div DivAssign div_assign divide;
    Rem rem RemAssign rem_assign remainder;
}

impl<R: Register> Neg for Packed<R> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
    fn neg(self) -> Self {
        Self(R::negate(self.0))
    }
}

/// Two values are equal if, in every lane, each is at most the other: NaN equals nothing, and −0 equals 0.
impl<R: Register> PartialEq for Packed<R> {
    #[cfg_attr(optimised, inline(always))]
    fn eq(&self, other: &Self) -> bool {
        R::at_most(self.0, other.0).and(R::at_most(other.0, self.0)).all()
    }
}

impl<R: Register> fmt::Debug for Packed<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries((0..R::COUNT).map(|i| self.lane(i))).finish()
    }
}

impl<R: Register> Zero for Packed<R> {
    #[cfg_attr(optimised, inline(always))]
    fn zero() -> Self {
        Self(R::splat(0.0))
    }
    #[cfg_attr(optimised, inline(always))]
    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }
}

impl<R: Register> One for Packed<R> {
    #[cfg_attr(optimised, inline(always))]
    fn one() -> Self {
        Self(R::splat(1.0))
    }
}

impl<R: Register> Num for Packed<R> {
    type FromStrRadixErr = <f64 as Num>::FromStrRadixErr;
    fn from_str_radix(text: &str, radix: u32) -> Result<Self, Self::FromStrRadixErr> {
        <f64 as Num>::from_str_radix(text, radix).map(Self::from_f64)
    }
}

impl<R: Register> Real for Packed<R> {
    const HAS_SLOW_PATHS: bool = R::HAS_SLOW_PATHS;
    type Mask = R::Mask;

    #[cfg_attr(optimised, inline(always))]
    fn from_f64(x: f64) -> Self {
        Self(R::splat(x))
    }

    #[inline]
    fn lane_by_lane(self, other: Self, mut f: impl FnMut(f64, f64) -> f64) -> Self {
        Self::from_lanes(|i| f(self.lane(i), other.lane(i)))
    }

    #[cfg_attr(optimised, inline(always))]
    fn sqrt(self) -> Self {
        Self(R::root(self.0))
    }

    fn ln(self) -> Self {
        Self::from_lanes(|i| self.lane(i).ln())
    }

    fn atan2(self, x: Self) -> Self {
        Self::from_lanes(|i| self.lane(i).atan2(x.lane(i)))
    }

    fn exp(self) -> Self {
        Self::from_lanes(|i| self.lane(i).exp())
    }

    #[cfg_attr(optimised, inline(always))]
    fn sin(self) -> Self {
        Self(R::sine(self.0))
    }

    #[cfg_attr(optimised, inline(always))]
    fn cos(self) -> Self {
        Self(R::cosine(self.0))
    }

    fn tanh(self) -> Self {
        Self::from_lanes(|i| self.lane(i).tanh())
    }

    fn stumpff(self, order: u32) -> Self {
        Self::from_lanes(|i| self.lane(i).stumpff(order))
    }

    #[cfg_attr(optimised, inline(always))]
    fn at_most(self, bound: Self) -> R::Mask {
        R::at_most(self.0, bound.0)
    }

    #[cfg_attr(optimised, inline(always))]
    fn select(mask: R::Mask, yes: Self, no: Self) -> Self {
        Self(R::select(mask, yes.0, no.0))
    }

    #[cfg_attr(optimised, inline(always))]
    fn magnitude(self) -> Self {
        Self(R::magnitude(self.0))
    }

    #[cfg_attr(optimised, inline(always))]
    fn maximum(self, other: Self) -> Self {
        Self(R::maximum(self.0, other.0))
    }

    #[cfg_attr(optimised, inline(always))]
    fn max_abs(self) -> f64 {
        let sizes = self.magnitude();
        let mut largest = 0.0;
        for i in 0..R::COUNT {
            largest = larger(largest, sizes.lane(i));
        }
        largest
    }
}

impl<R: Register> Lanes for Packed<R> {
    const COUNT: usize = R::COUNT;
    const FUSED: bool = R::FUSED;

    #[cfg_attr(optimised, inline(always))]
    fn from_lanes(mut f: impl FnMut(usize) -> f64) -> Self {
        Self(R::from_lanes(&mut f))
    }

    #[cfg_attr(optimised, inline(always))]
    fn lane(&self, i: usize) -> f64 {
        R::lane(self.0, i)
    }

    #[cfg_attr(optimised, inline(always))]
    fn load(values: &[f64]) -> Self {
        match R::load(values) {
            Some(register) => Self(register),
            None => load_some(values),
        }
    }

    #[cfg_attr(optimised, inline(always))]
    fn store(self, values: &mut [f64]) {
        if R::store(self.0, values).is_none() {
            store_some(&self, values);
        }
    }

    #[cfg_attr(optimised, inline(always))]
    fn multiply_add(self, a: Self, b: Self) -> Self {
        Self(R::multiply_add(self.0, a.0, b.0))
    }

    #[cfg_attr(optimised, inline(always))]
    fn multiply_subtract(self, a: Self, b: Self) -> Self {
        Self(R::multiply_subtract(self.0, a.0, b.0))
    }

    #[cfg_attr(optimised, inline(always))]
    fn negative_multiply_add(self, a: Self, b: Self) -> Self {
        Self(R::negative_multiply_add(self.0, a.0, b.0))
    }
}

/// Returns sin x.
#[cfg_attr(optimised, inline(always))]
pub(super) fn sine<R: Register>(x: Packed<R>) -> Packed<R> {
    if is_moderate(x) { sine_of_moderate(x) } else { lane_by_lane(x, Real::sin) }
}

/// Returns cos x.
#[cfg_attr(optimised, inline(always))]
pub(super) fn cosine<R: Register>(x: Packed<R>) -> Packed<R> {
    if is_moderate(x) { cosine_of_moderate(x) } else { lane_by_lane(x, Real::cos) }
}

/// Applies a function to each lane.
#[cold]
fn lane_by_lane<R: Register>(x: Packed<R>, f: fn(f64) -> f64) -> Packed<R> {
    Packed::from_lanes(|i| f(x.lane(i)))
}

/// Loads fewer values than there are lanes. It is a separate function so that the common case stays fast.
#[cold]
fn load_some<R: Register>(values: &[f64]) -> Packed<R> {
    let last = values.last().copied().unwrap_or(f64::NAN);
    Packed::from_lanes(|i| values.get(i).copied().unwrap_or(last))
}

#[cold]
fn store_some<R: Register>(lanes: &Packed<R>, values: &mut [f64]) {
    for (i, value) in values.iter_mut().enumerate() {
        *value = lanes.lane(i);
    }
}
