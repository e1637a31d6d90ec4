//! What the processor offers: registers of several `f64`, and pairs of them.

use crate::Mask;

/// A register of `COUNT` numbers with the operations of the processor, each lane by lane with the
/// rounding of `f64`.
///
/// Implementations put `#[inline(always)]` on everything: a function that the compiler leaves
/// outside of the one that has the processor's features passes its registers through memory, and
/// calls each instruction as a function.
pub trait Register: Copy + Send + Sync + 'static {
    /// How many lanes there are.
    const COUNT: usize;
    /// Whether products and sums are rounded once, together.
    const FUSED: bool;
    /// Truth in each lane.
    type Mask: Mask;

    /// x in every lane.
    fn splat(x: f64) -> Self;
    /// f(0), f(1), …
    fn from_lanes(f: &mut impl FnMut(usize) -> f64) -> Self;
    /// The first `COUNT` values; none where there are fewer.
    fn load(values: &[f64]) -> Option<Self>;
    /// Writes to the first `COUNT` values; to none where there are fewer.
    fn store(a: Self, values: &mut [f64]) -> Option<()>;
    /// The number in lane `i`, NaN for i ≥ `COUNT`.
    fn lane(a: Self, i: usize) -> f64;

    /// a + b
    fn add(a: Self, b: Self) -> Self;
    /// a − b
    fn subtract(a: Self, b: Self) -> Self;
    /// a b
    fn multiply(a: Self, b: Self) -> Self;
    /// a / b
    fn divide(a: Self, b: Self) -> Self;
    /// The remainder of a / b, which no processor has for registers.
    #[inline(always)]
    fn remainder(a: Self, b: Self) -> Self {
        Self::from_lanes(&mut |i| Self::lane(a, i) % Self::lane(b, i))
    }
    /// −a
    fn negate(a: Self) -> Self;
    /// √a
    fn root(a: Self) -> Self;
    /// |a|
    fn magnitude(a: Self) -> Self;
    /// a where a > b, else b
    fn maximum(a: Self, b: Self) -> Self;
    /// a b + c; rounded twice, unless the type is `FUSED` and says how.
    #[inline(always)]
    fn multiply_add(a: Self, b: Self, c: Self) -> Self {
        Self::add(Self::multiply(a, b), c)
    }
    /// a b − c, likewise.
    #[inline(always)]
    fn multiply_subtract(a: Self, b: Self, c: Self) -> Self {
        Self::subtract(Self::multiply(a, b), c)
    }
    /// c − a b, likewise.
    #[inline(always)]
    fn negative_multiply_add(a: Self, b: Self, c: Self) -> Self {
        Self::subtract(c, Self::multiply(a, b))
    }

    /// a ≤ b
    fn at_most(a: Self, b: Self) -> Self::Mask;
    /// `yes` where the mask is true.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
}

/// Two registers, or two masks of registers, worked on by turns: while the first waits for its
/// result, the second computes.
#[derive(Clone, Copy, Debug)]
pub struct Two<R>(R, R);

/// Functions on both registers.
macro_rules! both {
    ($($name:ident($($argument:ident),*);)*) => {$(
        #[inline(always)]
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
        multiply_add(a, b, c);
        multiply_subtract(a, b, c);
        negative_multiply_add(a, b, c);
    }

    #[inline(always)]
    fn splat(x: f64) -> Self {
        Self(R::splat(x), R::splat(x))
    }

    #[inline(always)]
    fn from_lanes(f: &mut impl FnMut(usize) -> f64) -> Self {
        let first = R::from_lanes(f);
        Self(first, R::from_lanes(&mut |i| f(R::COUNT + i)))
    }

    #[inline(always)]
    fn load(values: &[f64]) -> Option<Self> {
        let (first, second) = values.split_at_checked(R::COUNT)?;
        Some(Self(R::load(first)?, R::load(second)?))
    }

    #[inline(always)]
    fn store(a: Self, values: &mut [f64]) -> Option<()> {
        if values.len() < Self::COUNT {
            return None;
        }
        let (first, second) = values.split_at_mut_checked(R::COUNT)?;
        R::store(a.0, first).and(R::store(a.1, second))
    }

    #[inline(always)]
    fn lane(a: Self, i: usize) -> f64 {
        if i < R::COUNT { R::lane(a.0, i) } else { R::lane(a.1, i - R::COUNT) }
    }

    #[inline(always)]
    fn at_most(a: Self, b: Self) -> Self::Mask {
        Two(R::at_most(a.0, b.0), R::at_most(a.1, b.1))
    }

    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        Self(R::select(mask.0, yes.0, no.0), R::select(mask.1, yes.1, no.1))
    }
}

impl<M: Mask> Mask for Two<M> {
    const COUNT: usize = 2 * M::COUNT;

    #[inline(always)]
    fn from_bool(truth: bool) -> Self {
        Self(M::from_bool(truth), M::from_bool(truth))
    }

    #[inline(always)]
    fn and(self, other: Self) -> Self {
        Self(self.0.and(other.0), self.1.and(other.1))
    }

    #[inline(always)]
    fn or(self, other: Self) -> Self {
        Self(self.0.or(other.0), self.1.or(other.1))
    }

    #[inline(always)]
    fn not(self) -> Self {
        Self(self.0.not(), self.1.not())
    }

    #[inline(always)]
    fn all(self) -> bool {
        self.0.and(self.1).all()
    }

    #[inline(always)]
    fn lane(self, i: usize) -> bool {
        if i < M::COUNT { self.0.lane(i) } else { self.1.lane(i - M::COUNT) }
    }
}
