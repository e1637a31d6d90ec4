//! Plain numbers as a scalar.

use crate::numbers::real::Real;
use crate::numbers::sine::{cosine_of_number, sine_of_number};
use crate::numbers::stumpff::stumpff;

impl Real for f64 {
    type Mask = bool;

    #[inline]
    fn from_f64(x: f64) -> Self {
        x
    }

    #[cfg_attr(optimised, inline(always))]
    fn as_f64(self) -> Option<f64> {
        Some(self)
    }

    #[inline]
    fn sqrt(self) -> Self {
        self.sqrt()
    }

    fn ln(self) -> Self {
        self.ln()
    }

    fn atan2(self, x: Self) -> Self {
        self.atan2(x)
    }

    fn exp(self) -> Self {
        self.exp()
    }

    fn sin(self) -> Self {
        sine_of_number(self)
    }

    fn cos(self) -> Self {
        cosine_of_number(self)
    }

    fn tanh(self) -> Self {
        self.tanh()
    }

    #[inline]
    fn stumpff(self, order: u32) -> Self {
        stumpff(self, order)
    }

    #[inline]
    fn at_most(self, bound: Self) -> bool {
        self <= bound
    }

    #[inline]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }

    #[inline]
    fn magnitude(self) -> Self {
        self.abs()
    }

    #[inline]
    fn max_abs(self) -> f64 {
        self.abs()
    }

    #[cfg_attr(optimised, inline(always))]
    fn maximum(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
}
