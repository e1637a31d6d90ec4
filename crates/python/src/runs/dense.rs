//! The states between the samples of a run.

use super::interruption::Interruption;
use crate::errors::{failed, refused};
use collective_integrators::{AnyIntegrator, AnyState, DenseOutput, DenseOutputError, Start};
use pyo3::PyResult;

/// Finds the states at times, in the order of the run. The result has the coordinates of one after the other.
///
/// # Errors
/// Returns `ValueError` for times that are not in order, `IntegrationError` where a step fails, and `KeyboardInterrupt`.
pub(crate) fn states_at(
    integrator: &AnyIntegrator,
    (start, step): (&[f64], f64),
    times: &[f64],
) -> PyResult<Vec<f64>> {
    let interruption = Interruption::default();
    let samples = integrator.trajectory(&AnyState::from_slice(start), step).map_err(refused)?;
    let mut run = DenseOutput::new(integrator, interruption.until(samples));
    let mut states = Vec::with_capacity(times.len() * start.len());
    let mut append = |&time: &f64| -> PyResult<()> {
        let sample = run.at(time).map_err(|error| match error {
            DenseOutputError::Integration(error) => failed(error),
            error => refused(error),
        })?;
        states.extend_from_slice(sample.momentum.as_slice());
        Ok(())
    };
    let done = times.iter().try_for_each(&mut append);
    drop(run);
    interruption.or(done.map(|()| states))
}
