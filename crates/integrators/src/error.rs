//! What can go wrong in a step, in a run, and in making a scheme.

use lie_poisson::{Real, Vector};
use momentum_map::LiftError;
use thiserror::Error;

/// A step that has no result.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum StepError {
    /// The stage equations were not solved.
    #[error(
        "the stage equations did not converge: residual {residual:e} after {iterations} \
         iterations (required {required:e}); a shorter step may help, and for a state far along a fibre of \
         its momentum map a nearer one, as PoissonMap::recentred finds"
    )]
    NotConverged {
        /// The change of the stage derivatives in the last iteration relative to their size, the largest over blocks
        /// of coordinates ([`Vector::BLOCKS`](lie_poisson::Vector::BLOCKS)); NaN or ∞ if it blew up.
        residual: f64,
        /// The residual that would have been accepted.
        required: f64,
        /// Iterations made.
        iterations: usize,
    },
    /// The result of the step has a coordinate that is infinite or not a number.
    #[error("the state is not finite after the step")]
    NotFinite,
    /// A coordinate of the state, or of the momentum, from which a run starts is infinite or not a
    /// number.
    #[error("coordinate {coordinate} of the start must be finite, its size is {size}")]
    NotFiniteStart {
        /// The number of the coordinate; the first is 0.
        coordinate: usize,
        /// Its size: ∞ or NaN.
        size: f64,
    },
    /// The step size is infinite or not a number.
    #[error("the step size must be finite, it is {step}")]
    StepSize {
        /// The step size.
        step: f64,
    },
    /// The steps before it are as many as can be counted.
    #[error("no step has a number above {}", u64::MAX)]
    Uncountable,
}

impl StepError {
    /// Checks that steps of this size can be tried from a state: everything is a finite number.
    ///
    /// Trajectories and ensembles ask this before their first step, for every integrator.
    ///
    /// # Errors
    /// [`NotFiniteStart`](Self::NotFiniteStart) with the first coordinate that is not finite, in any
    /// lane; [`StepSize`](Self::StepSize).
    pub fn check_start<V: Vector>(start: &V, step: f64) -> Result<(), Self> {
        let sizes = (0..V::DIM).map(|i| start.coordinate(i).max_abs());
        match sizes.enumerate().find(|(_, size)| !size.is_finite()) {
            Some((coordinate, size)) => Err(Self::NotFiniteStart { coordinate, size }),
            None if !step.is_finite() => Err(Self::StepSize { step }),
            None => Ok(()),
        }
    }
}

/// A run that could not go on. Its message says which step failed, that of its
/// [`source`](core::error::Error::source) why.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("step {step} at t = {time}")]
pub struct IntegrationError {
    /// The number of the step that failed; the first is 1.
    pub step: u64,
    /// The time at which it started.
    pub time: f64,
    /// Why it failed.
    pub source: StepError,
}

impl IntegrationError {
    /// The step that follows `made` steps of size `step` failed.
    #[must_use]
    pub fn after(made: u64, step: f64, source: StepError) -> Self {
        // The time of the start is 0 whatever the step size.
        let time = if made == 0 { 0.0 } else { made as f64 * step };
        Self { step: made.saturating_add(1), time, source }
    }
}

/// A run from a momentum that has no result.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum RunError {
    /// No state represents the momentum.
    #[error(transparent)]
    Lift(#[from] LiftError),
    /// A step failed. Where a run cannot start since its start or its step size is not finite, this is
    /// its first step.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
}

/// A scheme that does not exist.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SchemeError {
    /// A method needs at least one stage.
    #[error("a Runge–Kutta method needs at least one stage, 0 were asked for")]
    NoStages,
    /// The coefficients, or their low parts, do not form a tableau.
    #[error(
        "a tableau with {stages} stages needs {stages}×{stages} coefficients a and {stages} weights b; got {a} and {b}"
    )]
    Shape {
        /// The number of stages.
        stages: usize,
        /// The number of coefficients a.
        a: usize,
        /// The number of weights b.
        b: usize,
    },
    /// A coefficient, or its low part, is infinite or not a number.
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
    /// A composition raises the order of symmetric methods, and their orders are even.
    #[error("{family} raises methods of an even order of at least 2, order {order} was asked for")]
    OddOrder {
        /// The composition.
        family: &'static str,
        /// The order asked for.
        order: usize,
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
