//! Coordinates in which the stage derivatives of successive steps are points of one curve.

/// Coordinates in which the stage solver remembers stage derivatives k from step to step, to predict those that follow.
///
/// A field has a frame other than [`OwnFrame`] if each step has its own coordinates. The multipliers of
/// [`LiftFree`](crate::LiftFree) are such a case: they begin every step at Q = 1. The trait cannot be named outside
/// this crate, and no scheme calls it.
pub trait StageFrame<V> {
    /// Returns whether the step continues the one before it wherever it starts.
    ///
    /// The starting points of two steps in different coordinates cannot be compared.
    fn continues(&self) -> bool;

    /// Returns k in the coordinates in which all steps are one curve. The map is linear.
    fn remembered(&self, k: &V) -> V;

    /// Returns a remembered k in the coordinates of this step. It is the inverse of [`remembered`](Self::remembered).
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
