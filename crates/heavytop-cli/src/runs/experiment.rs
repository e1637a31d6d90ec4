//! An experiment: a run, sample by sample.

use super::moment::{Moment, Saved};
use super::pace::Pace;
use super::run_check::RunCheck;
use super::schedule::Schedule;
use super::visited_samples::visit_samples;
use crate::Error;
use collective_integrators::diagnostics::RunAccuracy;
use collective_integrators::{AnyIntegrator, AnyState, SampleOf};
use heavytop::methods::{Method, attitude_of};
use heavytop::{HeavyTop, PrincipalAxes};
use lie_poisson::{Quaternion, Se3Dual, Vector};

/// A top, its initial state, and the method and steps of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Experiment {
    /// The top that is followed, in its principal axes.
    pub top: HeavyTop,
    /// The principal axes, in the axes of the output.
    pub axes: PrincipalAxes,
    /// The initial state (Π(0), Γ(0)), in the principal axes.
    pub start: Se3Dual,
    /// The integrator of the run.
    pub method: Method,
    /// The steps of the run.
    pub schedule: Schedule,
    /// The number n such that every n-th step is written, and the last one.
    pub every: u64,
    /// Whether the attitude is followed.
    pub attitude: bool,
}

impl Experiment {
    /// Passes the samples of [`Experiment::follow`] to `visit`: the number of the step, the time (s), (Π, Γ) and the
    /// attitude, if it is followed, of the principal axes. The initial state comes first.
    ///
    /// # Errors
    /// The errors of [`Experiment::follow`].
    pub fn run<V>(&self, mut visit: V) -> Result<(), Error>
    where
        V: FnMut(u64, f64, &Se3Dual, Option<&Quaternion>) -> Result<(), Error>,
    {
        self.follow(None, |m| visit(m.step, m.time, m.momentum, m.attitude))
    }

    /// Passes moments of the run to `visit`, from the initial one or from the first after a saved one: those that are
    /// [written](Self::keeps), those of a step whose number is a multiple of
    /// [`CHECKPOINT`](collective_integrators::CHECKPOINT), and the last one. The steps between them cost nothing else.
    ///
    /// A run that continues from such a multiple equals the uninterrupted run to the last bit.
    ///
    /// # Errors
    /// If the initial state has no lift, a step fails, `visit` fails, the formulation does not determine the attitude
    /// that is asked for, or the saved state does not fit this experiment.
    ///
    /// # Example
    /// ```
    /// use heavytop_cli::configuration::Config;
    /// let experiment = Config::default().experiment()?;
    /// let (mut saved, mut last) = (None, None);
    /// experiment.follow(None, |moment| {
    ///     if moment.step == 1024 {
    ///         saved = Some(moment.saved());
    ///     }
    ///     last = Some(*moment.momentum);
    ///     Ok(())
    /// })?;
    /// let mut again = None;
    /// experiment.follow(saved.as_ref(), |moment| Ok(again = Some(*moment.momentum)))?;
    /// assert_eq!(last, again);
    /// # Ok::<(), heavytop_cli::Error>(())
    /// ```
    pub fn follow<V>(&self, from: Option<&Saved>, mut visit: V) -> Result<(), Error>
    where
        V: FnMut(&Moment<'_>) -> Result<(), Error>,
    {
        let Self { start, method, .. } = self;
        let (integrator, names) = (self.integrator()?, (method.formulation(), method.scheme()));
        let place = (self.pace(), from);
        visit_samples(&integrator, &AnyState::of(start), place, names, |sample| {
            let SampleOf::<AnyIntegrator> { step, time, momentum, state, .. } = &sample;
            let values = momentum.as_slice();
            let momentum =
                &Vector::from_coordinates(|i| values.get(i).copied().unwrap_or(f64::NAN));
            let attitude = self.attitude.then(|| attitude_of(state.as_slice()));
            visit(&Moment {
                step: *step,
                time: *time,
                momentum,
                attitude: attitude.as_ref(),
                state,
            })
        })
    }

    /// Returns the number of coordinates of the state that the integrator advances.
    ///
    /// # Errors
    /// If there is no such integrator, or the formulation does not determine the attitude that is asked for.
    pub fn dimension(&self) -> Result<usize, Error> {
        Ok(self.integrator()?.state_dimension())
    }

    /// Measures how accurate the run is, by a repetition of its beginning with half the step. There is no estimate if
    /// `going` tells it to end.
    ///
    /// # Errors
    /// If there is no such integrator.
    pub fn accuracy(&self, going: &dyn Fn() -> bool) -> Result<RunAccuracy, Error> {
        let Schedule { step, steps } = self.schedule;
        Ok(self.method.accuracy(&self.top, &self.start, (step, steps), going)?)
    }

    /// Checks the whole run by runs with half the step and with twice the step, unless `going` tells the check to end.
    ///
    /// # Errors
    /// If a step fails.
    pub fn check(&self, going: &dyn Fn() -> bool) -> Result<RunCheck, Error> {
        let (Schedule { step, steps }, method) = (self.schedule, self.method);
        let checked = method.check(&self.top, &self.start, (step, steps), going)?;
        RunCheck::of(checked, (method.formulation(), method.scheme()))
    }

    /// Returns the steps, and which of them are written.
    #[must_use]
    pub fn pace(&self) -> Pace {
        Pace { schedule: self.schedule, every: self.every }
    }

    /// Returns the number of samples that are written, the initial and the last one included.
    #[must_use]
    pub fn rows(&self) -> u64 {
        self.pace().rows()
    }

    /// Returns the integrator, with the attitude if it is followed.
    fn integrator(&self) -> Result<AnyIntegrator, Error> {
        let formulation = self.method.formulation();
        match self.attitude {
            true => self
                .method
                .integrator_with_attitude(&self.top)?
                .ok_or(Error::NoAttitude { formulation }),
            false => Ok(self.method.integrator(&self.top)?),
        }
    }

    /// Returns whether the sample after this step is written.
    #[must_use]
    pub fn keeps(&self, step: u64) -> bool {
        self.pace().keeps(step)
    }
}
