//! A run, whatever it follows: [`Run`].

use super::moment::{Moment, Saved};
use super::pace::Pace;
use super::schedule::Schedule;
use crate::RunFailure;
use collective_integrators::diagnostics::{RunAccuracy, StepCheck};
use collective_integrators::{AnyIntegrator, AnyState, Integrator, RunError, SampleOf, Start};
use heavytop::methods::{Formulation, SchemeName};
use serde::Serialize;
use serde_json::{Map, Value};

/// The sample of a run.
pub type AnySample = SampleOf<AnyIntegrator>;

/// Replaces a row by that of a sample.
pub type Fill<'a> = dyn FnMut(&mut Vec<f64>, &AnySample) -> Result<(), RunFailure> + 'a;

/// A top or another Lie–Poisson system, its initial state, and the method and steps by which it is followed.
pub trait Run {
    /// Returns the coordinates: the name of each vector or scalar, with the names of its columns.
    fn coordinates(&self) -> Vec<(String, Vec<String>)>;

    /// Returns the names of the conserved quantities.
    fn conserved(&self) -> Vec<String>;

    /// Returns the initial values of the conserved quantities.
    ///
    /// # Errors
    /// If one has no value there.
    fn initial(&self) -> Result<Vec<f64>, RunFailure>;

    /// Returns whether the attitude is followed.
    fn has_attitude(&self) -> bool;

    /// Returns the formulation and the scheme.
    fn method(&self) -> (Formulation, SchemeName);

    /// Returns the steps, and which of them are written.
    fn pace(&self) -> Pace;

    /// Returns the integrator, and the state from which it starts.
    ///
    /// # Errors
    /// If there is no such integrator, or the formulation does not determine the attitude that is asked for.
    fn begin(&self) -> Result<(AnyIntegrator, AnyState), RunFailure>;

    /// Returns what replaces a row by that of a sample: the time, the coordinates, the conserved quantities and the
    /// attitude, if it is followed. It fails where a conserved quantity has no value.
    fn rows(&self) -> Box<Fill<'_>>;

    /// Measures how accurate the run is, by a repetition of its beginning with half the step. There is no estimate if
    /// `going` tells it to end.
    ///
    /// # Errors
    /// If there is no such integrator.
    fn accuracy(&self, going: &dyn Fn() -> bool) -> Result<RunAccuracy, RunFailure>;

    /// Repeats the whole run with half the step and with twice the step, unless `going` tells it to end.
    ///
    /// # Errors
    /// If there is no such integrator; within, if a step fails.
    fn compared(
        &self,
        going: &dyn Fn() -> bool,
    ) -> Result<Result<Option<StepCheck>, RunError>, RunFailure>;

    /// Returns a warning for users about what the method does not conserve.
    ///
    /// # Errors
    /// If there is no such method.
    fn warning(&self) -> Result<Option<String>, RunFailure>;

    /// Returns what the summary of the run tells of a system.
    ///
    /// # Errors
    /// If there is no such method.
    fn described(&self) -> Result<Described, RunFailure>;

    /// Returns the last coordinates for the summary, by their names there.
    fn last(&self, row: &[f64]) -> Map<String, Value>;
}

/// What the summary of a run tells of a system by formula; nothing of a top.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Described {
    /// The name of the algebra.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub algebra: Option<String>,
    /// The Hamiltonian as a formula.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hamiltonian: Option<String>,
    /// Whether the steps descend to 𝔤∗; if not, they are not Poisson maps.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub descends: Option<bool>,
    /// The Casimirs by the names of their columns, as formulas.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub casimirs: Option<Map<String, Value>>,
}

impl dyn Run + '_ {
    /// Passes moments of the run to `visit`, from the initial one or from the first after a saved one: those that are
    /// [written](Pace::keeps), those of a step whose number is a multiple of
    /// [`CHECKPOINT`](collective_integrators::CHECKPOINT), and the last one. The steps between them cost nothing else.
    ///
    /// A run that continues from such a multiple equals the uninterrupted run to the last bit.
    ///
    /// # Errors
    /// If the initial state has no lift, a step fails, a conserved quantity has no value, `visit` fails, or the saved
    /// state does not fit this run.
    ///
    /// # Example
    /// ```
    /// use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra, SystemMethod};
    /// use lie_poisson_runs::{RunFailure, Pace, Run, Schedule, SystemExperiment};
    /// let algebra = SystemAlgebra::named("so(3)")?;
    /// let method = SystemMethod::new(&algebra, "collective".parse()?, "gauss-4".parse()?, 0.0)?;
    /// let system = FormulaSystem::new(algebra, "(Pi1^2 + Pi2^2/2 + Pi3^2/4)/2", &Default::default())?;
    /// let pace = Pace { schedule: Schedule::new(0.1, 200.0)?, every: 500 };
    /// let run = SystemExperiment { system, start: vec![1.0, 2.0, 0.5], method, pace };
    /// let run: &dyn Run = &run;
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
        visit_samples(self, from, &mut |sample| {
            fill(&mut row, sample)?;
            visit(&Moment { step: sample.step, row: &row, state: &sample.state })
        })
    }

    /// Returns the number of coordinates of the state that the integrator advances.
    ///
    /// # Errors
    /// Those of [`Run::begin`].
    pub fn dimension(&self) -> Result<usize, RunFailure> {
        Ok(self.begin()?.0.state_dimension())
    }
}

/// Passes samples to `visit`: from the start on, or from the first one after a saved state, those that the pace visits.
///
/// # Errors
/// If the start has no lift, the saved state does not fit, a step fails, or `visit` fails.
pub(super) fn visit_samples<E: From<RunFailure>>(
    run: &dyn Run,
    from: Option<&Saved>,
    visit: &mut dyn FnMut(&AnySample) -> Result<(), E>,
) -> Result<(), E> {
    let ((integrator, start), pace) = (run.begin()?, run.pace());
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
    // The saved moment has been visited before.
    let mut visited = from.map_or(0, |_| pace.next_visited(made));
    let mut following = made;
    while let Some(sample) = trajectory.nth(visited.saturating_sub(following) as usize) {
        let sample = sample.map_err(|source| RunFailure::of_step(run.method(), source))?;
        visit(&sample)?;
        if sample.step >= steps {
            break;
        }
        following = sample.step.saturating_add(1);
        visited = pace.next_visited(sample.step);
    }
    Ok(())
}
