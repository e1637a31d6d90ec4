//! The top of this instance, which the functions for JavaScript share.

use crate::error::PageError;
use crate::simulation::running_top::Simulation;
use std::cell::RefCell;

/// The number of parameters of a throw: I (3), m g l, c (3), Π (3), Γ (3).
pub(crate) const PARAMETERS: usize = 13;

/// The number of numbers that [`show`](super::numbers::show) returns.
pub(crate) const NUMBERS: usize = 33;

/// The top of this instance, and the memory that JavaScript reads and writes.
#[derive(Debug)]
pub(crate) struct Desk {
    pub(crate) simulation: Option<Simulation>,
    pub(crate) parameters: [f64; PARAMETERS],
    pub(crate) numbers: [f64; NUMBERS],
    pub(crate) text: String,
}

impl Desk {
    /// Returns the simulation of the top that was thrown.
    ///
    /// # Errors
    /// Returns [`PageError::NotThrown`] before the first throw.
    pub(crate) fn thrown(&mut self) -> Result<&mut Simulation, PageError> {
        self.simulation.as_mut().ok_or(PageError::NotThrown)
    }
}

thread_local! {
    static DESK: RefCell<Desk> = const {
        RefCell::new(Desk {
            simulation: None,
            parameters: [0.0; PARAMETERS],
            numbers: [0.0; NUMBERS],
            text: String::new(),
        })
    };
}

/// Reads or writes the desk; returns the fallback if it is in use, which no call of JavaScript can find.
pub(crate) fn with<R>(fallback: R, task: impl FnOnce(&mut Desk) -> R) -> R {
    DESK.with(|desk| match desk.try_borrow_mut() {
        Ok(mut desk) => task(&mut desk),
        Err(_) => fallback,
    })
}

/// Performs a task that can fail: 0 if it succeeds; 1 with its message as the text if it fails.
pub(crate) fn attempt(task: impl FnOnce(&mut Desk) -> Result<(), PageError>) -> u32 {
    with(1, |desk| match task(desk) {
        Ok(()) => 0,
        Err(error) => {
            desk.text = error.message();
            1
        }
    })
}
