//! Registers whose products and sums are rounded separately: [`Unfused`].

use super::register::Register;

/// A register without fused multiply-add, bit-identical to `f64` in each lane.
///
/// It is for formulas that also run on `f64`, if their results must not depend on the register.
#[derive(Clone, Copy)]
pub struct Unfused<R>(R);

/// Defines functions that call those of the register.
macro_rules! inherited {
    ($($name:ident($($argument:ident),*);)*) => {$(
        #[cfg_attr(optimised, inline(always))]
        fn $name($($argument: Self),*) -> Self {
            Self(R::$name($($argument.0),*))
        }
    )*};
}

/// The three functions with a product and a sum have their default implementations, which round twice.
impl<R: Register> Register for Unfused<R> {
    const COUNT: usize = R::COUNT;
    const FUSED: bool = false;
    const HAS_SLOW_PATHS: bool = false;
    type Mask = R::Mask;

    inherited! {
        add(a, b);
        subtract(a, b);
        multiply(a, b);
        divide(a, b);
        negate(a);
        root(a);
        magnitude(a);
        maximum(a, b);
        // These have no product with a sum.
        sine(a);
        cosine(a);
    }

    #[cfg_attr(optimised, inline(always))]
    fn splat(x: f64) -> Self {
        Self(R::splat(x))
    }

    #[cfg_attr(optimised, inline(always))]
    fn from_lanes(f: &mut impl FnMut(usize) -> f64) -> Self {
        Self(R::from_lanes(f))
    }

    #[cfg_attr(optimised, inline(always))]
    fn load(values: &[f64]) -> Option<Self> {
        R::load(values).map(Self)
    }

    #[cfg_attr(optimised, inline(always))]
    fn store(a: Self, values: &mut [f64]) -> Option<()> {
        R::store(a.0, values)
    }

    #[cfg_attr(optimised, inline(always))]
    fn lane(a: Self, i: usize) -> f64 {
        R::lane(a.0, i)
    }

    #[cfg_attr(optimised, inline(always))]
    fn at_most(a: Self, b: Self) -> R::Mask {
        R::at_most(a.0, b.0)
    }

    #[cfg_attr(optimised, inline(always))]
    fn select(mask: R::Mask, yes: Self, no: Self) -> Self {
        Self(R::select(mask, yes.0, no.0))
    }
}
