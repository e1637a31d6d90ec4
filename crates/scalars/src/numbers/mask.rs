//! Truth values, one for each lane: [`Mask`].

use core::fmt::Debug;

/// The result of a comparison: one truth value for each SIMD lane (several numbers in one register).
///
/// The mask of `f64` is `bool`. [`Real::select`](crate::Real::select) accepts a mask, so that lanes with different
/// truth values continue side by side.
///
/// # Example
/// ```
/// use generic_scalars::{DefaultLanes, Lanes, Mask, Real};
/// let x = DefaultLanes::from_lanes(|i| i as f64); // 0, 1, 2, 3
/// let small = x.at_most(DefaultLanes::from_f64(1.0));
/// assert!(small.any() && !small.all() && small.lane(1) && !small.lane(2));
/// assert!(small.or(small.not()).all());
/// assert_eq!(DefaultLanes::select(small, -x, x).lane(1), -1.0);
/// ```
pub trait Mask: Copy + Debug + Send + Sync + 'static {
    /// The number of lanes.
    const COUNT: usize;

    /// Creates a mask with `truth` in every lane.
    fn from_bool(truth: bool) -> Self;

    /// Returns a mask that is true where both masks are true.
    #[must_use]
    fn and(self, other: Self) -> Self;

    /// Returns a mask that is true where one or both masks are true.
    #[must_use]
    fn or(self, other: Self) -> Self;

    /// Returns a mask that is true where this one is false.
    #[must_use]
    fn not(self) -> Self;

    /// Returns whether the mask is true in every lane.
    fn all(self) -> bool;

    /// Returns whether the mask is true in at least one lane.
    #[cfg_attr(optimised, inline(always))]
    fn any(self) -> bool {
        !self.not().all()
    }

    /// Returns whether the mask is true in lane `i`; false for i ≥ `COUNT`.
    fn lane(self, i: usize) -> bool;
}

impl Mask for bool {
    const COUNT: usize = 1;

    #[cfg_attr(optimised, inline(always))]
    fn from_bool(truth: bool) -> Self {
        truth
    }

    #[cfg_attr(optimised, inline(always))]
    fn and(self, other: Self) -> Self {
        self & other
    }

    #[cfg_attr(optimised, inline(always))]
    fn or(self, other: Self) -> Self {
        self | other
    }

    #[cfg_attr(optimised, inline(always))]
    fn not(self) -> Self {
        !self
    }

    #[cfg_attr(optimised, inline(always))]
    fn all(self) -> bool {
        self
    }

    #[cfg_attr(optimised, inline(always))]
    fn lane(self, i: usize) -> bool {
        self && i == 0
    }
}
