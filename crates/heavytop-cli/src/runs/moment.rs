//! A moment of a run, and the state from which the run continues.

use collective_integrators::AnyState;
use lie_poisson::{Quaternion, Se3Dual};

/// A moment of a run: the step, the time and the state, in the principal axes of the top.
#[derive(Clone, Copy)]
pub struct Moment<'a> {
    /// The number of steps made.
    pub step: u64,
    /// The time of the moment, s.
    pub time: f64,
    /// The momentum (Π, Γ) of the moment.
    pub momentum: &'a Se3Dual,
    /// The attitude, if it is followed.
    pub attitude: Option<&'a Quaternion>,
    /// The state that the integrator advances.
    pub(super) state: &'a AnyState,
}

/// The data from which a run continues.
#[derive(Clone, Debug, PartialEq)]
pub struct Saved {
    /// The number of steps made.
    pub step: u64,
    /// The coordinates of the state that the integrator advances.
    pub state: Vec<f64>,
}

impl Moment<'_> {
    /// Returns the data from which the run continues after this moment.
    #[must_use]
    pub fn saved(&self) -> Saved {
        Saved { step: self.step, state: self.state.as_slice().to_vec() }
    }
}
