//! A single lane with fused multiply-add.

use super::registers::register::Register;
use crate::numbers::real::Real;

/// One number with fused multiply-add, bit-identical to one lane of AVX2 and of AVX-512.
///
/// Every processor can run it; those without the instruction use a slow library function.
#[derive(Clone, Copy)]
pub struct FusedSingle(f64);

macro_rules! formulas {
    ($($name:ident($($argument:ident),*) = $formula:expr;)*) => {$(
        #[cfg_attr(optimised, inline(always))]
        fn $name($(Self($argument): Self),*) -> Self {
            Self($formula)
        }
    )*};
}

impl Register for FusedSingle {
    const COUNT: usize = 1;
    const FUSED: bool = true;
    type Mask = bool;

    formulas! {
        add(a, b) = a + b;
        subtract(a, b) = a - b;
        multiply(a, b) = a * b;
        divide(a, b) = a / b;
        negate(a) = -a;
        root(a) = a.sqrt();
        magnitude(a) = a.abs();
        maximum(a, b) = if a > b { a } else { b };
        sine(a) = Real::sin(a);
        cosine(a) = Real::cos(a);
        multiply_add(a, b, c) = a.mul_add(b, c);
        multiply_subtract(a, b, c) = a.mul_add(b, -c);
        negative_multiply_add(a, b, c) = (-a).mul_add(b, c);
    }

    #[cfg_attr(optimised, inline(always))]
    fn splat(x: f64) -> Self {
        Self(x)
    }

    #[cfg_attr(optimised, inline(always))]
    fn from_lanes(f: &mut impl FnMut(usize) -> f64) -> Self {
        Self(f(0))
    }

    #[cfg_attr(optimised, inline(always))]
    fn load(values: &[f64]) -> Option<Self> {
        values.first().map(|&x| Self(x))
    }

    #[cfg_attr(optimised, inline(always))]
    fn store(a: Self, values: &mut [f64]) -> Option<()> {
        *values.first_mut()? = a.0;
        Some(())
    }

    #[cfg_attr(optimised, inline(always))]
    fn lane(a: Self, i: usize) -> f64 {
        if i == 0 { a.0 } else { f64::NAN }
    }

    #[cfg_attr(optimised, inline(always))]
    fn at_most(a: Self, b: Self) -> bool {
        a.0 <= b.0
    }

    #[cfg_attr(optimised, inline(always))]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
}
