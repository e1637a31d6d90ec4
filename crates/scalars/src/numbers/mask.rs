//! Truth, lane by lane: [`Mask`].

use core::fmt::Debug;

/// What a comparison of two scalars returns: one truth value for each lane, a `bool` for `f64`.
///
/// It is read by [`Real::select`](crate::Real::select), so that lanes in which different things
/// are true go on side by side.
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
    /// How many lanes there are.
    const COUNT: usize;

    /// `truth` in every lane.
    fn from_bool(truth: bool) -> Self;

    /// Where both are true.
    #[must_use]
    fn and(self, other: Self) -> Self;

    /// Where one or both are true.
    #[must_use]
    fn or(self, other: Self) -> Self;

    /// Where it is false.
    #[must_use]
    fn not(self) -> Self;

    /// Whether it is true in every lane.
    fn all(self) -> bool;

    /// Whether it is true in some lane.
    #[inline(always)]
    fn any(self) -> bool {
        !self.not().all()
    }

    /// Whether it is true in lane `i`; false for i ≥ `COUNT`.
    fn lane(self, i: usize) -> bool;
}

impl Mask for bool {
    const COUNT: usize = 1;

    #[inline(always)]
    fn from_bool(truth: bool) -> Self {
        truth
    }

    #[inline(always)]
    fn and(self, other: Self) -> Self {
        self & other
    }

    #[inline(always)]
    fn or(self, other: Self) -> Self {
        self | other
    }

    #[inline(always)]
    fn not(self) -> Self {
        !self
    }

    #[inline(always)]
    fn all(self) -> bool {
        self
    }

    #[inline(always)]
    fn lane(self, i: usize) -> bool {
        self && i == 0
    }
}
