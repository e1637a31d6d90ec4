//! A moment of a run, and the state from which the run continues.

use collective_integrators::AnyState;

/// A moment of a run: the number of the step, and the row with the time, the coordinates, the conserved quantities and
/// the attitude, if it is followed.
#[derive(Clone, Copy)]
pub struct Moment<'a> {
    /// The number of steps made.
    pub step: u64,
    /// The numbers of the row; none at a moment that is not [written](crate::Pace::keeps).
    pub row: &'a [f64],
    /// The state that the integrator advances.
    pub(crate) state: &'a AnyState,
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
