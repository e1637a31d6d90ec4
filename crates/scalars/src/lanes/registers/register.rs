//! Registers of several `f64` as the processor offers them, and pairs of registers.

use crate::numbers::mask::Mask;

/// A register of `COUNT` numbers with the operations of the processor, which round in each lane as `f64`
/// does.
///
/// Implementations put `#[inline(always)]` on every function. A function that is not inlined into the one compiled
/// for the processor's features passes its registers through memory, and calls each instruction as a function.
pub trait Register: Copy + Send + Sync + 'static {
    /// The number of lanes.
    const COUNT: usize;
    /// Whether a product and a sum are rounded once, together.
    const FUSED: bool;
    /// The value of [`Real::HAS_SLOW_PATHS`](crate::Real::HAS_SLOW_PATHS) for lanes in this register.
    const HAS_SLOW_PATHS: bool = true;
    /// The type of one truth value for each lane.
    type Mask: Mask;

    /// Returns x in every lane.
    fn splat(x: f64) -> Self;
    /// Returns f(0), f(1), … in the lanes.
    fn from_lanes(f: &mut impl FnMut(usize) -> f64) -> Self;
    /// Loads the first `COUNT` values; returns `None` if there are fewer.
    fn load(values: &[f64]) -> Option<Self>;
    /// Writes to the first `COUNT` values; writes nothing and returns `None` if there are fewer.
    fn store(a: Self, values: &mut [f64]) -> Option<()>;
    /// Returns the number in lane `i`, or NaN for i ≥ `COUNT`.
    fn lane(a: Self, i: usize) -> f64;

    /// Returns the sum a + b.
    fn add(a: Self, b: Self) -> Self;
    /// Returns the difference a − b.
    fn subtract(a: Self, b: Self) -> Self;
    /// Returns the product a b.
    fn multiply(a: Self, b: Self) -> Self;
    /// Returns the quotient a / b.
    fn divide(a: Self, b: Self) -> Self;
    /// Returns the remainder of a / b, lane by lane, since no processor has an instruction for it.
    #[cfg_attr(optimised, inline(always))]
    fn remainder(a: Self, b: Self) -> Self {
        Self::from_lanes(&mut |i| Self::lane(a, i) % Self::lane(b, i))
    }
    /// Returns the negative −a.
    fn negate(a: Self) -> Self;
    /// Returns the square root √a.
    fn root(a: Self) -> Self;
    /// Returns the absolute value |a|.
    fn magnitude(a: Self) -> Self;
    /// Returns a where a > b, and b elsewhere.
    fn maximum(a: Self, b: Self) -> Self;
    /// Returns a b + c, rounded twice unless a `FUSED` type overrides it.
    #[cfg_attr(optimised, inline(always))]
    fn multiply_add(a: Self, b: Self, c: Self) -> Self {
        Self::add(Self::multiply(a, b), c)
    }
    /// Returns a b − c, rounded twice unless a `FUSED` type overrides it.
    #[cfg_attr(optimised, inline(always))]
    fn multiply_subtract(a: Self, b: Self, c: Self) -> Self {
        Self::subtract(Self::multiply(a, b), c)
    }
    /// Returns c − a b, rounded twice unless a `FUSED` type overrides it.
    #[cfg_attr(optimised, inline(always))]
    fn negative_multiply_add(a: Self, b: Self, c: Self) -> Self {
        Self::subtract(c, Self::multiply(a, b))
    }

    /// Returns sin a, in code that is not repeated where it is called, since it is long.
    fn sine(a: Self) -> Self;
    /// Returns cos a, as [`sine`](Self::sine) does.
    fn cosine(a: Self) -> Self;

    /// Returns the mask of the lanes in which a ≤ b.
    fn at_most(a: Self, b: Self) -> Self::Mask;
    /// Returns `yes` where the mask is true, and `no` elsewhere.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
}

/// Two registers, or two masks of registers, used alternately: while one waits for its result, the other
/// computes.
#[derive(Clone, Copy, Debug)]
pub struct Two<R>(R, R);

/// Defines functions that apply an operation to both registers.
macro_rules! both {
    ($($name:ident($($argument:ident),*);)*) => {$(
        #[cfg_attr(optimised, inline(always))]
        fn $name($($argument: Self),*) -> Self {
            Self(R::$name($($argument.0),*), R::$name($($argument.1),*))
        }
    )*};
}

impl<R: Register> Register for Two<R> {
    const COUNT: usize = 2 * R::COUNT;
    const FUSED: bool = R::FUSED;
    type Mask = Two<R::Mask>;

    both! {
        add(a, b);
        subtract(a, b);
        multiply(a, b);
        divide(a, b);
        negate(a);
        root(a);
        magnitude(a);
        maximum(a, b);
        sine(a);
        cosine(a);
        multiply_add(a, b, c);
        multiply_subtract(a, b, c);
        negative_multiply_add(a, b, c);
    }

    #[cfg_attr(optimised, inline(always))]
    fn splat(x: f64) -> Self {
        Self(R::splat(x), R::splat(x))
    }

    #[cfg_attr(optimised, inline(always))]
    fn from_lanes(f: &mut impl FnMut(usize) -> f64) -> Self {
        let first = R::from_lanes(f);
        Self(first, R::from_lanes(&mut |i| f(R::COUNT + i)))
    }

    #[cfg_attr(optimised, inline(always))]
    fn load(values: &[f64]) -> Option<Self> {
        let (first, second) = values.split_at_checked(R::COUNT)?;
        Some(Self(R::load(first)?, R::load(second)?))
    }

    #[cfg_attr(optimised, inline(always))]
    fn store(a: Self, values: &mut [f64]) -> Option<()> {
        if values.len() < Self::COUNT {
            return None;
        }
        let (first, second) = values.split_at_mut_checked(R::COUNT)?;
        R::store(a.0, first).and(R::store(a.1, second))
    }

    #[cfg_attr(optimised, inline(always))]
    fn lane(a: Self, i: usize) -> f64 {
        if i < R::COUNT { R::lane(a.0, i) } else { R::lane(a.1, i - R::COUNT) }
    }

    #[cfg_attr(optimised, inline(always))]
    fn at_most(a: Self, b: Self) -> Self::Mask {
        Two(R::at_most(a.0, b.0), R::at_most(a.1, b.1))
    }

    #[cfg_attr(optimised, inline(always))]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        Self(R::select(mask.0, yes.0, no.0), R::select(mask.1, yes.1, no.1))
    }
}

impl<M: Mask> Mask for Two<M> {
    const COUNT: usize = 2 * M::COUNT;

    #[cfg_attr(optimised, inline(always))]
    fn from_bool(truth: bool) -> Self {
        Self(M::from_bool(truth), M::from_bool(truth))
    }

    #[cfg_attr(optimised, inline(always))]
    fn and(self, other: Self) -> Self {
        Self(self.0.and(other.0), self.1.and(other.1))
    }

    #[cfg_attr(optimised, inline(always))]
    fn or(self, other: Self) -> Self {
        Self(self.0.or(other.0), self.1.or(other.1))
    }

    #[cfg_attr(optimised, inline(always))]
    fn not(self) -> Self {
        Self(self.0.not(), self.1.not())
    }

    #[cfg_attr(optimised, inline(always))]
    fn all(self) -> bool {
        self.0.and(self.1).all()
    }

    #[cfg_attr(optimised, inline(always))]
    fn lane(self, i: usize) -> bool {
        if i < M::COUNT { self.0.lane(i) } else { self.1.lane(i - M::COUNT) }
    }
}
