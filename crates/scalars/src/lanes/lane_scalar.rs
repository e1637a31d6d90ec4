//! SIMD lanes as a scalar: [`Lanes`].

use crate::numbers::real::Real;

/// SIMD lanes: `COUNT` independent real numbers in one or two registers, for example one for each of several
/// trajectories.
///
/// The trait is implemented by `f64` (one lane), by [`DefaultLanes`](super::DefaultLanes), and by the types that
/// [`dispatch`](super::dispatch()) passes to a [`LaneTask`](super::LaneTask). For every type, the operators, √ and
/// the comparisons are bit-identical in each lane to those of `f64`. The methods
/// [`multiply_add`](Self::multiply_add), [`multiply_subtract`](Self::multiply_subtract) and
/// [`negative_multiply_add`](Self::negative_multiply_add) round once if the type is [`FUSED`](Self::FUSED), and twice
/// otherwise. So the result of a computation is bit-identical
///
/// * on every type, if it does not use those three methods;
/// * otherwise on all types that fuse, and on all types that do not. The two results differ by rounding.
///
/// # Example
/// Horner's rule evaluates a polynomial at as many points as there are lanes:
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
    /// The number of lanes.
    const COUNT: usize;

    /// Whether [`multiply_add`](Self::multiply_add) and its variants round once.
    const FUSED: bool;

    /// Creates lanes with f(i) in lane i; `f` is called once for each i = 0, …, `COUNT` − 1, in this order.
    fn from_lanes(f: impl FnMut(usize) -> f64) -> Self;

    /// Returns the number in lane `i`, or NaN for i ≥ `COUNT`.
    fn lane(&self, i: usize) -> f64;

    /// Loads the first `COUNT` values.
    ///
    /// If there are fewer values, the remaining lanes repeat the last one, so that the incomplete end of a
    /// batch computes something harmless. If there is no value, all lanes are NaN.
    fn load(values: &[f64]) -> Self;

    /// Writes lane i to `values[i]`, for as many lanes as there are values.
    fn store(self, values: &mut [f64]);

    /// Returns `self` · a + b, with one rounding if the type is [`FUSED`](Self::FUSED).
    ///
    /// The name differs from that of `f64::mul_add`, which always rounds once.
    #[must_use]
    fn multiply_add(self, a: Self, b: Self) -> Self;

    /// Returns `self` · a − b, with one rounding if the type is [`FUSED`](Self::FUSED).
    #[must_use]
    fn multiply_subtract(self, a: Self, b: Self) -> Self;

    /// Returns b − `self` · a, with one rounding if the type is [`FUSED`](Self::FUSED).
    #[must_use]
    fn negative_multiply_add(self, a: Self, b: Self) -> Self;
}

impl Lanes for f64 {
    const COUNT: usize = 1;
    const FUSED: bool = false;

    #[cfg_attr(optimised, inline(always))]
    fn from_lanes(mut f: impl FnMut(usize) -> f64) -> Self {
        f(0)
    }

    #[cfg_attr(optimised, inline(always))]
    fn lane(&self, i: usize) -> f64 {
        if i == 0 { *self } else { f64::NAN }
    }

    #[cfg_attr(optimised, inline(always))]
    fn load(values: &[f64]) -> Self {
        values.first().copied().unwrap_or(f64::NAN)
    }

    #[cfg_attr(optimised, inline(always))]
    fn store(self, values: &mut [f64]) {
        if let Some(value) = values.first_mut() {
            *value = self;
        }
    }

    #[cfg_attr(optimised, inline(always))]
    fn multiply_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }

    #[cfg_attr(optimised, inline(always))]
    fn multiply_subtract(self, a: Self, b: Self) -> Self {
        self * a - b
    }

    #[cfg_attr(optimised, inline(always))]
    fn negative_multiply_add(self, a: Self, b: Self) -> Self {
        b - self * a
    }
}
