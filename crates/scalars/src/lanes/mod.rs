//! Several `f64` at once: an ensemble by changing the scalar.
//!
//! [`Lanes`] is what a computation asks of the type, [`DefaultLanes`] the type for code that knows
//! nothing of processors, [`dispatch`] the way to wider ones. [`FourLanes`] hold one vector of R³.

mod registers;
mod packed;
mod four;
#[cfg(target_arch = "x86_64")]
mod single;
mod dispatch;
mod dispatch_four;

pub use dispatch::{InstructionSet, LaneTask, MissingInstructions, Width, dispatch};
pub use dispatch_four::{FourLanesTask, dispatch_four};
pub use four::FourLanes;

use crate::Real;

#[cfg(not(all(target_arch = "x86_64", target_feature = "sse2")))]
use registers::plain::Plain as Baseline;
#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
use registers::sse2::Sse2 as Baseline;

/// Four lanes in two registers that need no detection: of SSE2 on x86-64, of whatever the compiler
/// makes of two pairs of `f64` elsewhere.
///
/// Each operation returns in each lane the bits that `f64` would. Code over [`Real`] from anywhere,
/// nalgebra's and num-complex's included, is compiled for these lanes as it is for `f64`.
///
/// # Example
/// ```
/// use generic_scalars::{DefaultLanes, Lanes, Real};
/// let x = DefaultLanes::load(&[1.0, 4.0, 9.0, 16.0]);
/// assert_eq!(Real::sqrt(x).lane(2), 3.0);
/// let hidden = DefaultLanes::load(&[0.0, f64::NAN, 0.0, 0.0]);
/// assert!(!hidden.all_below(1.0) && hidden.max_abs().is_nan());
/// ```
pub type DefaultLanes = packed::Packed<registers::register::Two<Baseline>>;

/// `COUNT` independent real numbers, computed with side by side.
///
/// Implemented by `f64` (one lane), by [`DefaultLanes`], and by the types that [`dispatch`] hands
/// to a [`LaneTask`]. The operators, √ and the comparisons return in each lane the bits that `f64`
/// would, whatever the type. [`multiply_add`](Self::multiply_add) and its two companions are
/// rounded once where the type is [`FUSED`](Self::FUSED), twice elsewhere. So one computation
/// returns
///
/// * the same bits on every type if it does without those three;
/// * otherwise the same bits on all types that fuse, and the same bits on all that do not; the
///   two differ by rounding.
///
/// # Example
/// A polynomial by Horner's rule, at as many points as there are lanes:
/// ```
/// use generic_scalars::{DefaultLanes, Lanes};
/// fn polynomial<T: Lanes>(x: T) -> T {
///     [2.0, -3.0, 1.0].iter().fold(T::from_f64(0.0), |sum, &c| sum.multiply_add(x, T::from_f64(c)))
/// }
/// let values = polynomial(DefaultLanes::load(&[0.0, 0.5, 1.0, 2.0]));
/// assert_eq!([0, 1, 2, 3].map(|i| values.lane(i)), [1.0, 0.0, 0.0, 3.0]);
/// assert_eq!(polynomial(2.0), 3.0);
/// ```
pub trait Lanes: Real {
    /// How many lanes there are.
    const COUNT: usize;

    /// Whether [`multiply_add`](Self::multiply_add) and its companions are rounded once.
    const FUSED: bool;

    /// Lane i is f(i); `f` is called once for each i = 0, …, `COUNT` − 1, in this order.
    fn from_lanes(f: impl FnMut(usize) -> f64) -> Self;

    /// The number in lane `i`; NaN for i ≥ `COUNT`.
    fn lane(&self, i: usize) -> f64;

    /// The first `COUNT` values. Where there are fewer, the lanes beyond repeat the last of them:
    /// at the ragged end of an ensemble they compute something harmless. NaN if there is none.
    fn load(values: &[f64]) -> Self;

    /// Writes lane i to `values[i]`, for as many as there are of both.
    fn store(self, values: &mut [f64]);

    /// `self` · a + b. (`f64` has a method `mul_add` of its own, which fuses; hence the name.)
    #[must_use]
    fn multiply_add(self, a: Self, b: Self) -> Self;

    /// `self` · a − b.
    #[must_use]
    fn multiply_subtract(self, a: Self, b: Self) -> Self;

    /// b − `self` · a.
    #[must_use]
    fn negative_multiply_add(self, a: Self, b: Self) -> Self;
}

impl Lanes for f64 {
    const COUNT: usize = 1;
    const FUSED: bool = false;

    #[inline(always)]
    fn from_lanes(mut f: impl FnMut(usize) -> f64) -> Self {
        f(0)
    }

    #[inline(always)]
    fn lane(&self, i: usize) -> f64 {
        if i == 0 { *self } else { f64::NAN }
    }

    #[inline(always)]
    fn load(values: &[f64]) -> Self {
        values.first().copied().unwrap_or(f64::NAN)
    }

    #[inline(always)]
    fn store(self, values: &mut [f64]) {
        if let Some(value) = values.first_mut() {
            *value = self;
        }
    }

    #[inline(always)]
    fn multiply_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }

    #[inline(always)]
    fn multiply_subtract(self, a: Self, b: Self) -> Self {
        self * a - b
    }

    #[inline(always)]
    fn negative_multiply_add(self, a: Self, b: Self) -> Self {
        b - self * a
    }
}
