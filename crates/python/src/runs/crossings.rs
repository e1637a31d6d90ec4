//! The task of finding the crossings of a plane through zero.

use crate::arrays::numbers;
use crate::errors::{failed, refused};
use crate::runs::interruption::Interruption;
use collective_integrators::{Direction, EventError, Events, SampleOf, Start};
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
        let interruption = Interruption::default();
        let samples = interruption.until(samples.take(self.steps as usize + 1));
        let events = Events::new(integrator, samples, distance, self.direction);
        let event = |event: Result<_, EventError>| match event {
            Ok(sample) => Ok(sample),
            Err(EventError::Integration(error)) => Err(failed(error)),
            Err(error) => Err(refused(error)),
        };
        let found = events.take(self.most).map(event).collect::<PyResult<Vec<SampleOf<I>>>>();
        interruption.or(found.map(|found| {
            let states = found.iter().flat_map(|sample| numbers(&sample.momentum)).collect();
            (found.iter().map(|sample| sample.time).collect(), states)
        }))
    }
}
