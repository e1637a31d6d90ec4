//! The states between the samples of a run.

use super::interruption::Interruption;
use super::schedule::Schedule;
use crate::errors::{failed, refused};
use collective_integrators::{DenseOutput, DenseOutputError, Start, TangentIntegrator};
use heavytop::methods::Task;
use lie_poisson::{Se3Dual, Vector};
use lie_poisson_formula_systems::SystemTask;
use pyo3::PyResult;

/// The task of finding the states at times, in the order of the run. The result has the coordinates of one after the other.
pub(crate) struct StatesAt<'a> {
    pub(crate) schedule: &'a Schedule,
    pub(crate) times: &'a [f64],
}

impl Task for StatesAt<'_> {
    type Output = PyResult<Vec<f64>>;

    fn perform<I: Start<State: Vector, Momentum = Se3Dual>>(self, integrator: &I) -> Self::Output {
        self.find(integrator)
    }
}

impl SystemTask for StatesAt<'_> {
    type Output = PyResult<Vec<f64>>;

    fn perform<I>(self, integrator: &I) -> Self::Output
    where
        I: Start<State: Vector, Momentum: Vector<Scalar = f64>> + TangentIntegrator,
    {
        self.find(integrator)
    }
}

impl StatesAt<'_> {
    fn find<I>(&self, integrator: &I) -> PyResult<Vec<f64>>
    where
        I: Start<State: Vector, Momentum: Vector<Scalar = f64>>,
    {
        let interruption = Interruption::default();
        let start = self.schedule.start();
        let samples = integrator.trajectory(&start, self.schedule.step).map_err(refused)?;
        let mut run = DenseOutput::new(integrator, interruption.until(samples));
        let mut states = Vec::with_capacity(self.times.len() * self.schedule.start.len());
        let mut append = |&time: &f64| -> PyResult<()> {
            let sample = run.at(time).map_err(|error| match error {
                DenseOutputError::Integration(error) => failed(error),
                error => refused(error),
            })?;
            states.extend(self.schedule.coordinates(&sample.momentum));
            Ok(())
        };
        let done = self.times.iter().try_for_each(&mut append);
        drop(run);
        interruption.or(done.map(|()| states))
    }
}
