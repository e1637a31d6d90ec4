//! Coordinates in which the stage derivatives of steps in a row are points of one curve.

/// How the stage solver remembers stage derivatives k from step to step, to guess those that follow.
///
/// A field has a frame other than [`OwnFrame`] where each step has coordinates of its own, as for the
/// multipliers of [`LiftFree`](crate::LiftFree), which begin every step at Q = 1. The trait cannot be named
/// outside of this crate, and no scheme calls it.
pub trait StageFrame<V> {
    /// Returns whether a step continues the one before it wherever it starts, since the two have different
    /// coordinates.
    fn continues(&self) -> bool;

    /// Returns k in coordinates in which all steps are one curve, by a linear map.
    fn remembered(&self, k: &V) -> V;

    /// Returns k in the coordinates of this step: the inverse of [`remembered`](Self::remembered).
    fn recalled(&self, k: &V) -> V;
}

/// The frame of a field that has the same coordinates in every step.
pub(crate) struct OwnFrame;

impl<V: Copy> StageFrame<V> for OwnFrame {
    #[inline]
    fn continues(&self) -> bool {
        false
    }

    #[inline]
    fn remembered(&self, k: &V) -> V {
        *k
    }

    #[inline]
    fn recalled(&self, k: &V) -> V {
        *k
    }
}
