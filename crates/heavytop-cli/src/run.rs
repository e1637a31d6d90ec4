//! A run, sample by sample.

use crate::Error;
use crate::integrators::{Method, Task};
use crate::schedule::Schedule;
use collective_integrators::Start;
use heavytop::HeavyTop;
use lie_poisson::Se3Dual;

/// A top, its initial state, and how to follow it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Experiment {
    /// The top.
    pub top: HeavyTop,
    /// (Π(0), Γ(0))
    pub start: Se3Dual,
    /// The integrator.
    pub method: Method,
    /// The steps.
    pub schedule: Schedule,
    /// Every n-th step is written, and the last.
    pub every: u64,
}

impl Experiment {
    /// Hands step number, time (s) and (Π, Γ) of each sample to `visit`, the initial state first.
    ///
    /// # Errors
    /// If the initial state has no lift, a step fails, or `visit` does.
    pub fn run<V>(&self, visit: V) -> Result<(), Error>
    where
        V: FnMut(u64, f64, &Se3Dual) -> Result<(), Error>,
    {
        self.method.integrate(&self.top, Follow { experiment: self, visit })
    }

    /// Whether the sample after this step is written.
    #[must_use]
    pub fn keeps(&self, step: u64) -> bool {
        step.is_multiple_of(self.every) || step == self.schedule.steps
    }
}

/// The task of following an experiment.
struct Follow<'a, V> {
    experiment: &'a Experiment,
    visit: V,
}

impl<V> Task for Follow<'_, V>
where
    V: FnMut(u64, f64, &Se3Dual) -> Result<(), Error>,
{
    type Output = ();

    fn perform<I: Start<Momentum = Se3Dual>>(mut self, integrator: &I) -> Result<(), Error> {
        let Experiment { start, method, schedule, .. } = self.experiment;
        for sample in integrator.trajectory(start, schedule.step)? {
            let sample = sample.map_err(|source| Error::Integration {
                formulation: method.formulation().name(),
                scheme: method.scheme().name(),
                source,
            })?;
            // M of the lift of the start is the start up to rounding; say what was asked for.
            let mu = if sample.step == 0 { start } else { &sample.momentum };
            (self.visit)(sample.step, sample.time, mu)?;
            if sample.step >= schedule.steps {
                break;
            }
        }
        Ok(())
    }
}
