//! The task of finding states between the samples of a run.

use crate::arrays::numbers;
use crate::errors::{failed, refused};
use crate::runs::interruption::Interruption;
use collective_integrators::{DenseOutput, DenseOutputError, Start};
use heavytop::methods::Task;
use lie_poisson::{Se3Dual, Vector};
use pyo3::PyResult;

/// The task of finding the states at times, which do not decrease.
pub(crate) struct Dense<'a> {
    pub(crate) start: Se3Dual,
    pub(crate) step: f64,
    pub(crate) times: &'a [f64],
}

impl Task for Dense<'_> {
    /// The states at the times, six numbers each.
    type Output = PyResult<Vec<f64>>;

    fn perform<I: Start<State: Vector, Momentum = Se3Dual>>(self, integrator: &I) -> Self::Output {
        let interruption = Interruption::default();
        let samples = integrator.trajectory(&self.start, self.step).map_err(refused)?;
        let mut run = DenseOutput::new(integrator, interruption.until(samples));
        let mut state = |&time: &f64| -> PyResult<[f64; 6]> {
            let sample = run.at(time).map_err(|error| match error {
                DenseOutputError::Integration(error) => failed(error),
                error => refused(error),
            })?;
            Ok(numbers(if time == 0.0 { &self.start } else { &sample.momentum }))
        };
        let states = self.times.iter().map(&mut state).collect::<PyResult<Vec<_>>>();
        drop(run);
        interruption.or(states.map(|states| states.into_iter().flatten().collect()))
    }
}
