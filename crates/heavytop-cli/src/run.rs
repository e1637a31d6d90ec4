//! A run, sample by sample.

use crate::Error;
use crate::integrators::{Method, Task};
use crate::schedule::Schedule;
use collective_integrators::Start;
use heavytop::{HeavyTop, Turning, WithAttitude};
use lie_poisson::{Quaternion, Se3Dual};

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
    /// Whether the attitude is followed.
    pub attitude: bool,
}

impl Experiment {
    /// Hands step number, time (s), (Π, Γ) and the attitude if it is followed of each sample to
    /// `visit`, the initial state first.
    ///
    /// # Errors
    /// If the initial state has no lift, a step fails, `visit` does, or the attitude is asked of a
    /// formulation that has none.
    pub fn run<V>(&self, visit: V) -> Result<(), Error>
    where
        V: FnMut(u64, f64, &Se3Dual, Option<&Quaternion>) -> Result<(), Error>,
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

impl<V> Follow<'_, V>
where
    V: FnMut(u64, f64, &Se3Dual, Option<&Quaternion>) -> Result<(), Error>,
{
    /// Follows an integrator; `attitude` reads it off the state.
    fn follow<I: Start<Momentum = Se3Dual>>(
        mut self,
        integrator: &I,
        attitude: impl Fn(&I::State) -> Option<&Quaternion>,
    ) -> Result<(), Error> {
        let Experiment { start, method, schedule, .. } = self.experiment;
        for sample in integrator.trajectory(start, schedule.step)? {
            let sample = sample.map_err(|source| Error::Integration {
                formulation: method.formulation().name(),
                scheme: method.scheme().name(),
                source,
            })?;
            // M of the lift of the start is the start up to rounding; say what was asked for.
            let mu = if sample.step == 0 { start } else { &sample.momentum };
            (self.visit)(sample.step, sample.time, mu, attitude(&sample.state))?;
            if sample.step >= schedule.steps {
                break;
            }
        }
        Ok(())
    }
}

impl<V> Task for Follow<'_, V>
where
    V: FnMut(u64, f64, &Se3Dual, Option<&Quaternion>) -> Result<(), Error>,
{
    type Output = ();

    fn perform<I: Start<Momentum = Se3Dual>>(self, integrator: &I) -> Result<(), Error> {
        if self.experiment.attitude {
            let formulation = self.experiment.method.formulation();
            return Err(Error::NoAttitude { formulation });
        }
        self.follow(integrator, |_| None)
    }

    fn perform_turning<I: Turning + Start>(self, integrator: I) -> Result<(), Error> {
        if self.experiment.attitude {
            self.follow(&WithAttitude(integrator), |state| Some(&state.1))
        } else {
            self.follow(&integrator, |_| None)
        }
    }
}
