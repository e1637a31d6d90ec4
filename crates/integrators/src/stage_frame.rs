//! Coordinates in which the stage derivatives of successive steps are points of one curve.

use lie_poisson::State;

/// Coordinates in which the stage solver remembers stage derivatives k from step to step, to predict those that follow.
///
/// A field has a frame of its own if each step has its own coordinates. The multipliers of
/// [`LiftFree`](crate::LiftFree) are such a case: they begin every step at Q = 1. The solver of stage equations calls
/// the methods; a scheme has no reason to do so.
pub trait StageFrame<V> {
    /// Returns whether the step continues the one before it wherever it starts.
    ///
    /// The starting points of two steps in different coordinates cannot be compared.
    fn continues(&self) -> bool;

    /// Writes k, in the coordinates in which all steps are one curve, to `past`. The map is linear.
    fn remember(&self, k: &V, past: &mut V);

    /// Changes a remembered k to the coordinates of this step. It is the inverse of [`remember`](Self::remember).
    fn recall(&self, k: &mut V);
}

/// The frame of a field that has the same coordinates in every step.
pub(crate) struct OwnFrame;

impl<V: State> StageFrame<V> for OwnFrame {
    #[cfg_attr(optimised, inline(always))]
    fn continues(&self) -> bool {
        false
    }

    #[cfg_attr(optimised, inline(always))]
    fn remember(&self, k: &V, past: &mut V) {
        past.assign(k);
    }

    #[cfg_attr(optimised, inline(always))]
    fn recall(&self, _: &mut V) {}
}
