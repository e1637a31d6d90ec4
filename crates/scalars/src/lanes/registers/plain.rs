//! Two lanes in plain Rust, for processors whose registers are not known.

use super::register::Register;
use crate::numbers::mask::Mask;
use crate::numbers::real::Real;

/// Two numbers; products and sums are rounded separately, as for `f64`.
#[derive(Clone, Copy)]
pub struct Plain(f64, f64);

/// Two truth values, the mask of [`Plain`].
#[derive(Clone, Copy, Debug)]
pub struct PlainMask(bool, bool);

macro_rules! formulas {
    ($($name:ident($($argument:ident),*) = $formula:expr;)*) => {$(
        #[cfg_attr(optimised, inline(always))]
        fn $name($($argument: Self),*) -> Self {
            let one = |$($argument: f64),*| $formula;
            Self(one($($argument.0),*), one($($argument.1),*))
        }
    )*};
}

impl Register for Plain {
    const COUNT: usize = 2;
    const FUSED: bool = false;
    type Mask = PlainMask;

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
    }

    #[cfg_attr(optimised, inline(always))]
    fn splat(x: f64) -> Self {
        Self(x, x)
    }

    #[cfg_attr(optimised, inline(always))]
    fn from_lanes(f: &mut impl FnMut(usize) -> f64) -> Self {
        Self(f(0), f(1))
    }

    #[cfg_attr(optimised, inline(always))]
    fn load(values: &[f64]) -> Option<Self> {
        let [first, second] = *values.first_chunk()?;
        Some(Self(first, second))
    }

    #[cfg_attr(optimised, inline(always))]
    fn store(a: Self, values: &mut [f64]) -> Option<()> {
        *values.first_chunk_mut()? = [a.0, a.1];
        Some(())
    }

    #[cfg_attr(optimised, inline(always))]
    fn lane(a: Self, i: usize) -> f64 {
        match i {
            0 => a.0,
            1 => a.1,
            _ => f64::NAN,
        }
    }

    #[cfg_attr(optimised, inline(always))]
    fn at_most(a: Self, b: Self) -> PlainMask {
        PlainMask(a.0 <= b.0, a.1 <= b.1)
    }

    #[cfg_attr(optimised, inline(always))]
    fn select(mask: PlainMask, yes: Self, no: Self) -> Self {
        Self(if mask.0 { yes.0 } else { no.0 }, if mask.1 { yes.1 } else { no.1 })
    }
}

impl Mask for PlainMask {
    const COUNT: usize = 2;

    #[cfg_attr(optimised, inline(always))]
    fn from_bool(truth: bool) -> Self {
        Self(truth, truth)
    }

    #[cfg_attr(optimised, inline(always))]
    fn and(self, other: Self) -> Self {
        Self(self.0 & other.0, self.1 & other.1)
    }

    #[cfg_attr(optimised, inline(always))]
    fn or(self, other: Self) -> Self {
        Self(self.0 | other.0, self.1 | other.1)
    }

    #[cfg_attr(optimised, inline(always))]
    fn not(self) -> Self {
        Self(!self.0, !self.1)
    }

    #[cfg_attr(optimised, inline(always))]
    fn all(self) -> bool {
        self.0 & self.1
    }

    #[cfg_attr(optimised, inline(always))]
    fn lane(self, i: usize) -> bool {
        (i == 0 && self.0) || (i == 1 && self.1)
    }
}

#[cfg(test)]
mod tests {
    use super::Plain;
    use crate::lanes::packed::Packed;
    use crate::lanes::registers::register::Two;
    use crate::lanes::{DefaultLanes, Lanes};
    use crate::numbers::mask::Mask;
    use proptest::prelude::*;

    /// Runs every operation and returns the bits of the results.
    fn everything<T: Lanes>(x: &[f64; 4], y: &[f64; 4]) -> Vec<u64> {
        let (a, b) = (T::load(x), T::load(y));
        let below = a.at_most(b).and(b.at_most(T::one()).not()).or(b.at_most(-a));
        let fractions = [a / b, a % b, (a * a).sqrt(), a.multiply_add(b, a)];
        let others = [a.multiply_subtract(b, a), a.negative_multiply_add(b, a), a.magnitude()];
        let both = [T::select(below, a, b), T::select(T::Mask::from_bool(true), -a, a)];
        let mut bits = vec![u64::from(below.all()), u64::from(below.any()), a.max_abs().to_bits()];
        for result in fractions.into_iter().chain(others).chain(both) {
            let mut stored = [0.0; 4];
            result.store(&mut stored);
            assert_eq!(stored, [0, 1, 2, 3].map(|i| result.lane(i)));
            bits.extend(stored.map(f64::to_bits));
        }
        bits.extend((0..5).map(|i| u64::from(below.lane(i))));
        bits
    }

    proptest! {
        #[test]
        fn lanes_of_other_processors_compute_as_these_do(
            x in [-2.0..2.0, -2.0..2.0, -2.0..2.0, -2.0..2.0f64],
            y in [-2.0..2.0, -2.0..2.0, -2.0..2.0, -2.0..2.0f64],
        ) {
            let plain = everything::<Packed<Two<Plain>>>(&x, &y);
            prop_assert_eq!(&plain, &everything::<DefaultLanes>(&x, &y));
            prop_assert_ne!(plain, everything::<DefaultLanes>(&y, &x));
        }
    }
}
