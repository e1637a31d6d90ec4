//! The states between the samples of a run.

use super::interruption::Interruption;
use super::schedule::Schedule;
use crate::errors::{failed, refused};
use collective_integrators::{DenseOutput, DenseOutputError, Start};
use lie_poisson::Vector;
use pyo3::PyResult;

/// Returns the coordinates of the states at times, which do not decrease.
pub(crate) fn states_at<I>(integrator: &I, schedule: &Schedule, times: &[f64]) -> PyResult<Vec<f64>>
where
    I: Start<State: Vector, Momentum: Vector<Scalar = f64>>,
{
    let interruption = Interruption::default();
    let start = schedule.start();
    let samples = integrator.trajectory(&start, schedule.step).map_err(refused)?;
    let mut run = DenseOutput::new(integrator, interruption.until(samples));
    let mut states = Vec::with_capacity(times.len() * schedule.start.len());
    let mut append = |&time: &f64| -> PyResult<()> {
        let sample = run.at(time).map_err(|error| match error {
            DenseOutputError::Integration(error) => failed(error),
            error => refused(error),
        })?;
        let momentum = if time == 0.0 { &start } else { &sample.momentum };
        states.extend(schedule.coordinates(momentum));
        Ok(())
    };
    let done = times.iter().try_for_each(&mut append);
    drop(run);
    interruption.or(done.map(|()| states))
}
