//! A moment of a run, and what the run needs to go on from it.

use lie_poisson::{Quaternion, Se3Dual, Vector};

/// Where a run is.
#[derive(Clone, Copy)]
pub struct Moment<'a> {
    /// The number of steps made.
    pub step: u64,
    /// The time, s.
    pub time: f64,
    /// (Π, Γ)
    pub momentum: &'a Se3Dual,
    /// The attitude, if it is followed.
    pub attitude: Option<&'a Quaternion>,
    /// The state that the integrator advances.
    pub(super) state: &'a dyn Coordinates,
}

/// All that a run needs to go on.
#[derive(Clone, Debug, PartialEq)]
pub struct Saved {
    /// The number of steps made.
    pub step: u64,
    /// The coordinates of the state that the integrator advances.
    pub state: Vec<f64>,
}

impl Moment<'_> {
    /// What the run needs to go on from here.
    #[must_use]
    pub fn saved(&self) -> Saved {
        Saved { step: self.step, state: self.state.coordinates() }
    }
}

/// The states of all integrators alike.
pub(super) trait Coordinates {
    fn coordinates(&self) -> Vec<f64>;
}

impl<S: Vector<Scalar = f64>> Coordinates for S {
    fn coordinates(&self) -> Vec<f64> {
        (0..S::DIM).map(|i| self.coordinate(i)).collect()
    }
}
