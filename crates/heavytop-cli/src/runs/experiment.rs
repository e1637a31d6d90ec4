//! An experiment: a run, sample by sample.

use super::moment::{Moment, Saved};
use super::pace::Pace;
use super::run_check::RunCheck;
use super::schedule::Schedule;
use super::visited_samples::visit_samples;
use crate::Error;
use collective_integrators::diagnostics::RunAccuracy;
use collective_integrators::{Integrator, Start};
use heavytop::methods::{Method, Task};
use heavytop::{HeavyTop, PrincipalAxes, Turning, WithAttitude};
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
        self.method.integrate(&self.top, Follow { experiment: self, from, visit: &mut visit })?
    }

    /// Returns the number of coordinates of the state that the integrator advances.
    ///
    /// # Errors
    /// If there is no such integrator, or the formulation does not determine the attitude that is asked for.
    pub fn dimension(&self) -> Result<usize, Error> {
        self.method.integrate(&self.top, Dimension { experiment: self })?
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

    fn require_no_attitude(&self) -> Result<(), Error> {
        let formulation = self.method.formulation();
        if self.attitude { Err(Error::NoAttitude { formulation }) } else { Ok(()) }
    }

    /// Returns whether the sample after this step is written.
    #[must_use]
    pub fn keeps(&self, step: u64) -> bool {
        self.pace().keeps(step)
    }
}

/// The task of counting the coordinates of a state.
struct Dimension<'a> {
    experiment: &'a Experiment,
}

impl Task for Dimension<'_> {
    type Output = Result<usize, Error>;

    fn perform<I: Start<State: Vector, Momentum = Se3Dual>>(self, _: &I) -> Result<usize, Error> {
        self.experiment.require_no_attitude().map(|()| I::State::DIM)
    }

    fn perform_turning<I: Turning + Start>(self, _: I) -> Result<usize, Error> {
        let attitude = self.experiment.attitude;
        Ok(if attitude { <WithAttitude<I> as Integrator>::State::DIM } else { I::State::DIM })
    }
}

/// A function of the moments of a run. As a trait object, so that the integrators are compiled once for all of them.
type Visit<'a> = &'a mut dyn FnMut(&Moment<'_>) -> Result<(), Error>;

/// The task of following an experiment.
struct Follow<'a> {
    experiment: &'a Experiment,
    from: Option<&'a Saved>,
    visit: Visit<'a>,
}

impl Follow<'_> {
    /// Follows an integrator; `attitude` reads the attitude from the state.
    fn follow<I: Start<State: Vector, Momentum = Se3Dual>>(
        self,
        integrator: &I,
        attitude: impl Fn(&I::State) -> Option<&Quaternion>,
    ) -> Result<(), Error> {
        let Experiment { start, method, .. } = self.experiment;
        let names = (method.formulation(), method.scheme());
        let place = (self.experiment.pace(), self.from);
        visit_samples(integrator, start, place, names, |step, time, momentum, state| {
            (self.visit)(&Moment { step, time, momentum, attitude: attitude(state), state })
        })
    }
}

impl Task for Follow<'_> {
    type Output = Result<(), Error>;

    fn perform<I: Start<State: Vector, Momentum = Se3Dual>>(
        self,
        integrator: &I,
    ) -> Result<(), Error> {
        self.experiment.require_no_attitude()?;
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
