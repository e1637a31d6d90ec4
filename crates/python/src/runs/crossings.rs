//! The task of finding the crossings of a plane through zero.

use crate::arrays::numbers;
use crate::errors::{failed, refused};
use collective_integrators::{Direction, EventError, Events, Start};
use heavytop::methods::Task;
use lie_poisson::{Se3Dual, Vector};
use pyo3::PyResult;

/// The task of finding the points where n·(Π, Γ) − c crosses zero.
pub(crate) struct Crossings {
    pub(crate) start: Se3Dual,
    pub(crate) step: f64,
    pub(crate) steps: u64,
    pub(crate) normal: [f64; 6],
    pub(crate) level: f64,
    pub(crate) direction: Direction,
    pub(crate) most: usize,
}

impl Task for Crossings {
    /// The times and the states of the crossings, six numbers each.
    type Output = PyResult<(Vec<f64>, Vec<f64>)>;

    fn perform<I: Start<State: Vector, Momentum = Se3Dual>>(self, integrator: &I) -> Self::Output {
        let samples = integrator.trajectory(&self.start, self.step).map_err(refused)?;
        let distance = |mu: &Se3Dual| {
            let terms = numbers(mu).into_iter().zip(self.normal);
            terms.map(|(x, n)| n * x).sum::<f64>() - self.level
        };
        let samples = samples.take(self.steps as usize + 1);
        let events = Events::new(integrator, samples, distance, self.direction);
        let (mut times, mut states) = (Vec::new(), Vec::new());
        for event in events.take(self.most) {
            let event = event.map_err(|error| match error {
                EventError::Integration(error) => failed(error),
                error => refused(error),
            })?;
            times.push(event.time);
            states.extend(numbers(&event.momentum));
        }
        Ok((times, states))
    }
}
