//! The errors of runs.

use collective_integrators::{IntegrationError, RunError, VariationalError};
use heavytop::TopError;
use heavytop::methods::{Formulation, Method, MethodError};
use lie_poisson_formula_systems::FormulaSystemError;
use momentum_map::LiftError;

/// The reason why a run cannot be made, or failed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RunFailure {
    /// No run can start from the initial state.
    #[error(transparent)]
    Start(#[from] RunError),
    /// There is no integrator of the formulation and the scheme.
    #[error(transparent)]
    Method(#[from] MethodError),
    /// There is no such system, no method for it, or it has no value at the start.
    #[error(transparent)]
    System(Box<FormulaSystemError>),
    /// A top cannot have the initial state.
    #[error(transparent)]
    Top(#[from] TopError),
    /// The formulation does not determine the attitude.
    #[error(
        "{} has no attitude: its six equations do not determine it; collective, reduced and \
         splitting have one", formulation.name()
    )]
    NoAttitude {
        /// The formulation that was asked for.
        formulation: Formulation,
    },
    /// The system is no body that has an attitude.
    #[error("a system on the dual of {algebra} has no attitude")]
    NoBody {
        /// The name of the algebra.
        algebra: String,
    },
    /// The integrators of the system have no tangent maps in the formulation that is asked for.
    #[error("{kind} has tangent vectors in the formulation {has} alone")]
    NoTangents {
        /// The name of the kind of system.
        kind: &'static str,
        /// The formulation that has them.
        has: Formulation,
    },
    /// The integrator of a system with friction or noise has no tangent maps.
    #[error("{kind} with friction or noise has no tangent vectors")]
    NoTangentsOfForces {
        /// The name of the kind of system.
        kind: &'static str,
    },
    /// A saved state does not fit the integrator of the run.
    #[error("the saved state has {found} numbers, that of the integrator {expected}")]
    SavedState {
        /// The number of coordinates of the integrator's state.
        expected: usize,
        /// The number of coordinates of the saved state.
        found: usize,
    },
    /// The step or the end is zero or not finite.
    #[error("{name} must be finite and different from 0, got {value}")]
    NoDirection {
        /// `step` or `end`.
        name: &'static str,
        /// Its value, s.
        value: f64,
    },
    /// The steps go backward in time, and the end is after the start.
    #[error(
        "steps of {} s do not reach end = {}: a run backward in time has an end before 0",
        number(*step), number(*end)
    )]
    OppositeEnd {
        /// The size of the steps, s.
        step: f64,
        /// The end asked for, s.
        end: f64,
    },
    /// The motion turns too far in one step for any method to give meaningful results.
    #[error(
        "a step of {} s turns the motion by about {angle:.3e} rad; it must be at most {most}",
        number(*step)
    )]
    AbsurdStep {
        /// The step size, s.
        step: f64,
        /// The angle of the turn, rad.
        angle: f64,
        /// The largest angle allowed, rad.
        most: f64,
    },
    /// The run has more steps than could be computed in a lifetime.
    #[error(
        "the run would take {steps:e} steps, more than {most:e}: lower the end or raise the step"
    )]
    TooManySteps {
        /// The number of steps.
        steps: f64,
        /// The largest number of steps allowed.
        most: f64,
    },
    /// The end is not a whole number of steps.
    #[error(
        "end = {} is not a whole number of steps of {}; the nearest ends are {} and {}",
        number(*end), number(*step), number(*before), number(*after)
    )]
    BrokenStep {
        /// The end asked for, s.
        end: f64,
        /// The size of the steps, s.
        step: f64,
        /// The last end before it that is a whole number of steps, s.
        before: f64,
        /// The first end after it that is a whole number of steps, s.
        after: f64,
    },
    /// The integration failed: a stage equation did not converge, or a state is not finite.
    #[error("{formulation}, {scheme}: {reason}")]
    Integration {
        /// The formulation's name.
        formulation: &'static str,
        /// The scheme's name.
        scheme: &'static str,
        /// The step, the time and the reason.
        reason: IntegrationError,
    },
    /// A conserved quantity has no finite value at a moment of the run.
    #[error("at t = {time}: {reason}")]
    NoValue {
        /// The time, s.
        time: f64,
        /// The quantity, the part of it without a value, and the state.
        reason: String,
    },
    /// A function whose zeros are searched along a run has no value.
    #[error("the function {function} has no value at t = {time}")]
    NoEvent {
        /// The function.
        function: String,
        /// The time, s.
        time: f64,
    },
    /// The forces on a motion have no rates.
    #[error(
        "a balance is of a top or a system by formula with a drive, damping, a torque or the time in its energy, and without \
         noise: only there forces supply energy at a rate"
    )]
    NoBalance,
    /// An ensemble of paths has none.
    #[error("{reason}")]
    NoPaths {
        /// What is wrong with it.
        reason: String,
    },
    /// The statistics of an ensemble are too many.
    #[error(
        "the statistics of {numbers} numbers, rows times columns, are asked for, and {most} are the most: keep fewer rows"
    )]
    LargeEnsemble {
        /// The numbers asked for.
        numbers: u64,
        /// The most numbers.
        most: u64,
    },
    /// A path of an ensemble failed.
    #[error("path {path}: {reason}")]
    Path {
        /// The number of the path, with which a run of its own fails likewise.
        path: u64,
        /// Why it failed.
        reason: Box<RunFailure>,
    },
    /// The tangent vectors have lost their directions.
    #[error(transparent)]
    Tangent(VariationalError),
    /// A contest ends before the first of the times at which errors are measured.
    #[error("end must be finite and more than 10, got {end}")]
    EarlyEnd {
        /// The end asked for, s.
        end: f64,
    },
    /// An integrator that was to be timed failed.
    #[error("{name}: {reason}")]
    Timed {
        /// The name of the integrator.
        name: String,
        /// The step, the time and the reason.
        reason: IntegrationError,
    },
}

impl RunFailure {
    /// Returns the error of a step that failed by this method.
    #[must_use]
    pub fn of_step(method: &Method, reason: IntegrationError) -> Self {
        let (formulation, scheme) = (method.formulation().name(), method.scheme().name());
        Self::Integration { formulation, scheme, reason }
    }
}

impl From<FormulaSystemError> for RunFailure {
    fn from(error: FormulaSystemError) -> Self {
        Self::System(Box::new(error))
    }
}

impl From<LiftError> for RunFailure {
    fn from(error: LiftError) -> Self {
        Self::Start(error.into())
    }
}

/// Formats a number without hundreds of digits.
fn number(x: f64) -> String {
    if x == 0.0 || (1e-6..1e16).contains(&x.abs()) { x.to_string() } else { format!("{x:e}") }
}
