//! A run: [`Experiment`].

use super::moment::{Moment, Saved};
use super::pace::Pace;
use super::schedule::Schedule;
use super::strides::Strides;
use crate::error::RunFailure;
use crate::models::conserved::Conserved;
use crate::models::model::Model;
use crate::models::top_in_axes::TopInAxes;
use collective_integrators::diagnostics::{RunAccuracy, StepCheck};
use collective_integrators::{AnyIntegrator, AnyState, Integrator, RunError, SampleOf, Start};
use core::ops::Deref;
use heavytop::methods::{Method, attitude_of};
use lie_poisson::{Quaternion, Se3Dual};

/// The sample of a run.
type AnySample = SampleOf<AnyIntegrator>;

/// A system, its initial state, and the method and steps by which it is followed.
///
/// What writes tables, draws or shows progress needs no more than an `Experiment<dyn Model>`, which every experiment is by
/// reference.
#[derive(Clone, Debug)]
pub struct Experiment<M: Model + ?Sized = dyn Model> {
    /// The coordinates of the initial momentum, in the axes of the computation.
    pub start: Vec<f64>,
    /// The integrator of the run.
    pub method: Method,
    /// The steps of the run, and which of them are written.
    pub pace: Pace,
    /// Whether the attitude is followed.
    pub attitude: bool,
    /// The system that is followed.
    pub model: M,
}

/// A run of a model that is known is a run of any model.
impl<M: Model + 'static> Deref for Experiment<M> {
    type Target = Experiment;

    fn deref(&self) -> &Experiment {
        self
    }
}

impl Experiment<TopInAxes> {
    /// Returns the initial state (Π(0), Γ(0)), in the principal axes.
    #[must_use]
    pub fn initial_state(&self) -> Se3Dual {
        TopInAxes::state(&self.start)
    }

    /// Passes moments of the run to `visit`, those of [`follow`](Experiment::follow): the number of the step, the time (s),
    /// (Π, Γ) and the attitude, if it is followed, of the principal axes. The initial state comes first.
    ///
    /// # Errors
    /// If the initial state has no lift, a step fails, `visit` fails, or the formulation does not determine the attitude
    /// that is asked for.
    pub fn run<E: From<RunFailure>, V>(&self, mut visit: V) -> Result<(), E>
    where
        V: FnMut(u64, f64, &Se3Dual, Option<&Quaternion>) -> Result<(), E>,
    {
        let model = &self.model;
        let turn = model.initial_attitude.map(|_| model.turn_about_vertical(&self.initial_state()));
        self.visit_samples(None, &mut |sample| {
            let attitude = self.attitude.then(|| attitude_of(sample.state.as_slice()));
            let attitude = attitude.map(|attitude| turn.map_or(attitude, |turn| turn * attitude));
            let momentum = TopInAxes::state(sample.momentum.as_slice());
            visit(sample.step, sample.time, &momentum, attitude.as_ref())
        })
    }
}

impl Experiment {
    /// Returns the coordinates: the name of each vector or scalar, with the names of its columns.
    #[must_use]
    pub fn coordinates(&self) -> Vec<(String, Vec<String>)> {
        self.model.coordinates()
    }

    /// Returns the names of the conserved quantities that have columns of their own.
    #[must_use]
    pub fn conserved(&self) -> Vec<String> {
        let mut names = self.model.conserved(&self.start).names();
        names.retain(|name| !self.model.is_coordinate(name));
        names
    }

    /// Returns whether the motion keeps each of the quantities that have columns of their own: forces, friction and noise change
    /// some.
    #[must_use]
    pub fn kept(&self) -> Vec<bool> {
        let conserved = self.model.conserved(&self.start);
        self.conserved().iter().map(|name| conserved.is_kept(name)).collect()
    }

    /// Returns the initial values of the conserved quantities that have columns of their own.
    ///
    /// # Errors
    /// If one has no value there.
    pub fn initial(&self) -> Result<Vec<f64>, RunFailure> {
        let conserved = self.model.conserved(&self.start);
        let values = conserved.values(0.0, &self.start);
        let mut values = values.map_err(|reason| RunFailure::NoValue { time: 0.0, reason })?;
        for place in self.repeated(&*conserved) {
            values.remove(place);
        }
        Ok(values)
    }

    /// Returns the places of the conserved quantities that are coordinates, the last one first.
    fn repeated(&self, conserved: &dyn Conserved) -> Vec<usize> {
        let names = conserved.names();
        let is_repeated = |place: &usize| self.model.is_coordinate(&names[*place]);
        (0..names.len()).rev().filter(is_repeated).collect()
    }

    /// Returns the integrator, and the state from which it starts.
    ///
    /// # Errors
    /// If the start has another number of coordinates than the model, there is no such integrator, or it does not determine
    /// the attitude that is asked for.
    pub fn begin(&self) -> Result<(AnyIntegrator, AnyState), RunFailure> {
        self.model.require_dimension(&self.start)?;
        let integrator = match self.attitude {
            true => self.model.integrator_with_attitude(&self.method, &self.start)?,
            false => self.model.integrator(&self.method, &self.start)?,
        };
        Ok((integrator, AnyState::from_slice(&self.start)))
    }

    /// Measures how accurate the run is, by a repetition of its beginning with half the step. There is no estimate if
    /// `going` tells it to end.
    ///
    /// # Errors
    /// If there is no such integrator.
    pub fn accuracy(&self, going: &dyn Fn() -> bool) -> Result<RunAccuracy, RunFailure> {
        let Schedule { step, steps } = self.pace.schedule;
        self.model.accuracy(&self.method, &self.start, (step, steps), going)
    }

    /// Repeats the whole run with half the step and with twice the step, unless `going` tells it to end.
    ///
    /// # Errors
    /// If there is no such integrator; within, if a step fails.
    pub fn compared(
        &self,
        going: &dyn Fn() -> bool,
    ) -> Result<Result<Option<StepCheck>, RunError>, RunFailure> {
        let Schedule { step, steps } = self.pace.schedule;
        self.model.check(&self.method, &self.start, (step, steps), going)
    }

    /// Returns a warning for users about what the method does not conserve.
    ///
    /// # Errors
    /// If there is no such method.
    pub fn warning(&self) -> Result<Option<String>, RunFailure> {
        self.model.warning(&self.method, &self.start)
    }

    /// Passes moments of the run to `visit`, from the initial one or from the first after a saved one: those that are
    /// [written](Pace::keeps), the last one, and some of those from which the run can be resumed, whose step is a multiple of
    /// [`Model::resumable_after`]: all if that is [`CHECKPOINT`](collective_integrators::CHECKPOINT), and otherwise one
    /// about each second. The steps between them cost nothing else.
    ///
    /// A run that continues from such a multiple equals the uninterrupted run to the last bit.
    ///
    /// # Errors
    /// If the initial state has no lift, a step fails, a conserved quantity has no value, `visit` fails, or the saved
    /// state does not fit this run.
    ///
    /// # Example
    /// ```
    /// use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
    /// use lie_poisson_runs::{Experiment, Pace, RunFailure, Schedule};
    /// let algebra = SystemAlgebra::named("so(3)")?;
    /// let method = algebra.method("collective".parse()?, "gauss-4".parse()?, 0.0)?;
    /// let model = FormulaSystem::new(algebra, "(Pi1^2 + Pi2^2/2 + Pi3^2/4)/2", &Default::default())?;
    /// let pace = Pace { schedule: Schedule::new(0.1, 200.0)?, every: 500 };
    /// let run = Experiment { model, start: vec![1.0, 2.0, 0.5], method, pace, attitude: false };
    /// let (mut saved, mut last) = (None, None);
    /// run.follow(None, |moment| -> Result<(), RunFailure> {
    ///     if moment.step == 1024 {
    ///         saved = Some(moment.saved());
    ///     }
    ///     last = Some(moment.row.to_vec());
    ///     Ok(())
    /// })?;
    /// let mut again = None;
    /// run.follow(saved.as_ref(), |moment| Ok::<_, RunFailure>(again = Some(moment.row.to_vec())))?;
    /// assert!(saved.is_some() && last == again);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn follow<E: From<RunFailure>>(
        &self,
        from: Option<&Saved>,
        mut visit: impl FnMut(&Moment<'_>) -> Result<(), E>,
    ) -> Result<(), E> {
        let (mut fill, mut row) = (self.rows(), Vec::new());
        self.visit_samples(from, &mut |sample| {
            // The conserved quantities of a large system may take longer than a step.
            match self.pace.keeps(sample.step) {
                true => fill(&mut row, sample)?,
                false => row.clear(),
            }
            visit(&Moment { step: sample.step, row: &row, state: &sample.state })
        })
    }

    /// Returns what replaces a row by that of a sample: the time, the coordinates, the conserved quantities and the
    /// attitude, if it is followed. It fails where a conserved quantity has no value.
    pub(super) fn rows(&self) -> impl FnMut(&mut Vec<f64>, &AnySample) -> Result<(), RunFailure> {
        let (model, conserved) = (&self.model, self.model.conserved(&self.start));
        let repeated = self.repeated(&*conserved);
        let present_attitude = self.attitude.then(|| model.present_attitude(&self.start));
        move |row, sample| {
            let (time, momentum) = (sample.time, sample.momentum.as_slice());
            row.clear();
            row.push(time);
            row.extend_from_slice(momentum);
            if let Some(coordinates) = row.get_mut(1..) {
                model.present(coordinates);
            }
            let first = row.len();
            conserved
                .append_finite(time, momentum, row)
                .map_err(|reason| RunFailure::NoValue { time, reason })?;
            for place in &repeated {
                row.remove(first + place);
            }
            if let Some(present) = &present_attitude {
                let Quaternion { scalar, vector } = present(attitude_of(sample.state.as_slice()));
                row.extend([scalar, vector.x, vector.y, vector.z]);
            }
            Ok(())
        }
    }

    /// Returns the number of coordinates of the state that the integrator advances.
    ///
    /// # Errors
    /// Those of [`begin`](Self::begin).
    pub fn dimension(&self) -> Result<usize, RunFailure> {
        Ok(self.begin()?.0.state_dimension())
    }

    /// Passes the moments that are written to `visit`, from a state of the integrator and its momentum on.
    ///
    /// # Errors
    /// If a step fails, or a conserved quantity has no value.
    pub(super) fn follow_state(
        &self,
        integrator: &AnyIntegrator,
        (state, start): (AnyState, AnyState),
        mut visit: impl FnMut(&Moment<'_>),
    ) -> Result<(), RunFailure> {
        let Schedule { step, steps } = self.pace.schedule;
        let mut trajectory = integrator.trajectory_from(state, step).through(start);
        let (mut fill, mut row, mut skipped) = (self.rows(), Vec::new(), 0);
        while let Some(sample) = trajectory.nth(skipped) {
            let sample = sample.map_err(|source| RunFailure::of_step(&self.method, source))?;
            fill(&mut row, &sample)?;
            visit(&Moment { step: sample.step, row: &row, state: &sample.state });
            if sample.step >= steps {
                break;
            }
            let next = self.pace.next_visited(sample.step, u64::MAX);
            skipped = (next - sample.step - 1) as usize;
        }
        Ok(())
    }

    /// Passes samples to `visit`: from the start on, or from the first one after a saved state, those that the pace visits.
    ///
    /// # Errors
    /// If the start has no lift, the saved state does not fit, a step fails, or `visit` fails.
    fn visit_samples<E: From<RunFailure>>(
        &self,
        from: Option<&Saved>,
        visit: &mut dyn FnMut(&AnySample) -> Result<(), E>,
    ) -> Result<(), E> {
        let ((integrator, start), pace) = (self.begin()?, self.pace);
        let Schedule { step, steps } = pace.schedule;
        let (mut trajectory, made) = match from {
            None => (integrator.trajectory(&start, step).map_err(RunFailure::from)?, 0),
            Some(Saved { step: made, state }) => {
                let (expected, found) = (integrator.state_dimension(), state.len());
                if expected != found {
                    return Err(RunFailure::SavedState { expected, found }.into());
                }
                let state = AnyState::from_slice(state);
                (integrator.trajectory_resumed(state, *made, step), *made)
            }
        };
        if from.is_some() && made >= steps {
            return Ok(());
        }
        let mut between = Strides::new(self.model.resumable_after());
        // The saved moment has been visited before.
        let mut visited = from.map_or(0, |_| pace.next_visited(made, between.stride));
        let mut following = made;
        while let Some(sample) = trajectory.nth(visited.saturating_sub(following) as usize) {
            let sample = sample.map_err(|source| RunFailure::of_step(&self.method, source))?;
            visit(&sample)?;
            if sample.step >= steps {
                break;
            }
            following = sample.step.saturating_add(1);
            visited = pace.next_visited(sample.step, between.next());
        }
        Ok(())
    }
}
