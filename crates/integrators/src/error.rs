//! What can go wrong in a step, in a run, and in making a scheme.

use thiserror::Error;

/// A step that has no result.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum StepError {
    /// The stage equations were not solved.
    #[error(
        "the stage equations did not converge: residual {residual:e} after {iterations} \
         iterations (required {required:e}); a shorter step may help, and for a state far along a fibre of \
         its momentum map a nearer one, as PoissonMap::recentred finds"
    )]
    NotConverged {
        /// h |change of a stage derivative| in the last iteration, relative to the larger of |z| and h |k|, the
        /// largest over blocks of coordinates; NaN or ∞ if it blew up.
        residual: f64,
        /// The residual that would have been accepted.
        required: f64,
        /// Iterations made.
        iterations: usize,
    },
    /// The result of the step has a coordinate that is infinite or not a number.
    #[error("the state is not finite after the step")]
    NotFinite,
}

/// A run that could not go on.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("step {step} at t = {time}: {source}")]
pub struct IntegrationError {
    /// The number of the step that failed; the first is 1.
    pub step: u64,
    /// The time at which it started.
    pub time: f64,
    /// Why it failed.
    pub source: StepError,
}

/// A scheme that does not exist.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SchemeError {
    /// A method needs at least one stage.
    #[error("a Runge–Kutta method needs at least one stage, 0 were asked for")]
    NoStages,
    /// The coefficients do not form a tableau.
    #[error(
        "a tableau with {stages} stages needs {stages}×{stages} coefficients a and {stages} weights b; got {a} and {b}"
    )]
    Shape {
        /// The number of nodes.
        stages: usize,
        /// The number of coefficients a.
        a: usize,
        /// The number of weights b.
        b: usize,
    },
    /// A coefficient is infinite or not a number.
    #[error("a coefficient of the method is not finite")]
    NotFinite,
    /// The substeps of a composition do not add up to the step.
    #[error("the fractions of a step must add up to 1, their sum is {sum}")]
    SubstepSum {
        /// Their sum.
        sum: f64,
    },
    /// The two tableaux of a partitioned method have different numbers of stages.
    #[error("a partitioned method needs two tableaux of the same size, got {q} and {p} stages")]
    Stages {
        /// The stages for q.
        q: usize,
        /// The stages for p.
        p: usize,
    },
    /// The coefficients of a member of a family are not here.
    #[error("{family} has coefficients here for {least} to {most} stages, {stages} were asked for")]
    Family {
        /// The family.
        family: &'static str,
        /// The smallest number of stages.
        least: usize,
        /// The largest number of stages.
        most: usize,
        /// The number asked for.
        stages: usize,
    },
}
