//! Errors of a step, of a run, and of the construction of a scheme.

use core::fmt;
use lie_poisson::{Real, State};
use momentum_map::LiftError;
use thiserror::Error;

/// The reason why a step has no result.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum StepError {
    /// The iteration for the stage equations did not converge.
    #[error("the stage equations did not converge: {}", residue(*residual, *required, *iterations))]
    NotConverged {
        /// The change of the stage derivatives in the last iteration, relative to their size. It is the largest over
        /// blocks of coordinates ([`State::BLOCKS`](lie_poisson::State::BLOCKS)), and NaN or ∞ if the iteration
        /// diverged.
        residual: f64,
        /// The largest residual that would have been accepted.
        required: f64,
        /// The number of iterations made.
        iterations: usize,
    },
    /// The iteration for the stage equations converged to a solution that is not seen to belong to the state.
    #[error(
        "the stage equations have a solution, but short steps are not seen to lead to it: the iteration went \
         {distance:.1e} times the size of the stage derivatives to it; a shorter step may help"
    )]
    OtherSolution {
        /// The sum of the changes of the stage derivatives in the iteration, relative to their size, or to that of the
        /// terms whose sums they are if it is larger.
        distance: f64,
    },
    /// The Hamiltonian or a Casimir has changed by more than the errors of the method.
    #[error(
        "the step changes {} by {change:e}, of which the order of the method explains {allowed:e}: the step does not \
         follow the motion; use a shorter one, or the direct formulation",
        invariant_name(.index)
    )]
    InvariantLost {
        /// The index of the invariant: 0 for the Hamiltonian, then those of the Casimirs, from 1.
        index: usize,
        /// The change of the invariant.
        change: f64,
        /// The largest change that the order of the method allows.
        allowed: f64,
    },
    /// The result of the step, or its momentum, has a coordinate that is infinite or not a number.
    #[error(
        "the state is not finite after the step: the motion goes to infinity there, or the step is too long"
    )]
    NotFinite,
    /// The steps of the lanes of a register would be divided at different places, since their breakpoints are at different
    /// distances. [`Laned`](crate::Laned) makes such steps one by one.
    #[error(
        "the next breakpoints of the lanes are between {first} and {last} away, so that no division of the step is that \
         of each lane"
    )]
    BreakpointsApart {
        /// The shortest distance of a lane from its next breakpoint.
        first: f64,
        /// The longest one; ∞ if a lane has none.
        last: f64,
    },
    /// A torque has taken the momentum to a value that no state represents.
    #[error("the torque takes the momentum to a value that no state represents: {reason}")]
    NoLift {
        /// Why there is no state.
        reason: &'static str,
    },
    /// A coordinate of the initial state or momentum is infinite or not a number.
    #[error("coordinate {coordinate} of the start must be finite, its size is {size}")]
    NotFiniteStart {
        /// The index of the coordinate; the first is 0.
        coordinate: usize,
        /// The size of the coordinate: ∞ or NaN.
        size: f64,
    },
    /// The dimension of the state differs from that of the equations.
    #[error("the equations have dimension {expected}, the state has dimension {found}")]
    Dimension {
        /// The dimension of the space of the equations.
        expected: usize,
        /// The dimension of the state.
        found: usize,
    },
    /// The step size is infinite or not a number.
    #[error("the step size must be finite, it is {step}")]
    StepSize {
        /// The rejected step size.
        step: f64,
    },
    /// The number of the step would exceed [`u64::MAX`].
    #[error("no step has a number above {}", u64::MAX)]
    Uncountable,
}

/// Returns what is left of stage equations that were not solved, and what may help.
fn residue(residual: f64, required: f64, iterations: usize) -> String {
    if residual.is_finite() {
        format!(
            "residual {residual:e} after {iterations} iterations (required {required:e}); a shorter step may help, and \
             for a state far along a fibre of its momentum map a nearer one"
        )
    } else {
        format!(
            "residual {residual} after {iterations} iterations: the stage derivatives are too large for numbers; the \
             motion goes to infinity there, or the step is too long"
        )
    }
}

/// Returns the name of an invariant of a system: h, c1, c2, …
fn invariant_name(index: &usize) -> String {
    if *index == 0 { "h".to_owned() } else { format!("c{index}") }
}

impl StepError {
    /// Checks that a state has the dimension of the equations. For large states it is known only when the program runs.
    ///
    /// # Errors
    /// Returns [`Dimension`](Self::Dimension) with both numbers.
    pub fn check_dimension<V: State>(state: &V, expected: usize) -> Result<(), Self> {
        let found = state.dimension();
        if found == expected { Ok(()) } else { Err(Self::Dimension { expected, found }) }
    }

    /// Checks that the start and the step size are finite numbers.
    ///
    /// Trajectories and ensembles make this check before the first step of every integrator.
    ///
    /// # Errors
    /// Returns [`NotFiniteStart`](Self::NotFiniteStart) with the first coordinate that is not finite in some SIMD lane,
    /// or [`StepSize`](Self::StepSize).
    pub fn check_start<V: State>(start: &V, step: f64) -> Result<(), Self> {
        let sizes = (0..start.dimension()).map(|i| start.coordinate(i).max_abs());
        match sizes.enumerate().find(|(_, size)| !size.is_finite()) {
            Some((coordinate, size)) => Err(Self::NotFiniteStart { coordinate, size }),
            None if !step.is_finite() => Err(Self::StepSize { step }),
            None => Ok(()),
        }
    }
}

/// The error of a run, with the step that failed.
///
/// The message says which step failed and why, so that a program that prints it alone says all. The reason is therefore
/// no [`source`](core::error::Error::source): a program that prints the sources, too, would print it twice.
///
/// # Example
/// ```
/// use collective_integrators::{IntegrationError, StepError};
/// use std::error::Error;
/// let error = IntegrationError::after(4, 0.125, StepError::NotFinite);
/// assert!(error.to_string().starts_with("step 5 at t = 0.5: the state is not finite after the step"));
/// assert!(error.source().is_none());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IntegrationError {
    /// The number of the step that failed; the first is 1.
    pub step: u64,
    /// The time at which the failed step started.
    pub time: f64,
    /// The reason for the failure.
    pub source: StepError,
}

impl fmt::Display for IntegrationError {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { step, time, source } = self;
        write!(to, "step {step} at t = {time}: {source}")
    }
}

/// The reason is in the message, and no source.
impl core::error::Error for IntegrationError {}

impl IntegrationError {
    /// Creates the error for the step that follows `made` steps of size `step`.
    #[must_use]
    pub fn after(made: u64, step: f64, source: StepError) -> Self {
        // The run starts at time 0 whatever the step size.
        let time = if made == 0 { 0.0 } else { made as f64 * step };
        Self { step: made.saturating_add(1), time, source }
    }
}

/// The error of a run that starts from a momentum.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum RunError {
    /// No state represents the momentum.
    #[error(transparent)]
    Lift(#[from] LiftError),
    /// A step failed. If the start or the step size is not finite, this is the first step of the run.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
}

/// The reason why a scheme cannot be constructed.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SchemeError {
    /// There are no stages, but a method needs at least one.
    #[error("a Runge–Kutta method needs at least one stage, 0 were asked for")]
    NoStages,
    /// The number of coefficients, or of their low parts, does not fit a tableau.
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
    /// The substeps of a composition do not add up to 1.
    #[error("the fractions of a step must add up to 1, their sum is {sum}")]
    SubstepSum {
        /// The sum of the substeps.
        sum: f64,
    },
    /// The two tableaux of a partitioned method have different numbers of stages.
    #[error("a partitioned method needs two tableaux of the same size, got {q} and {p} stages")]
    Stages {
        /// The number of stages for q.
        q: usize,
        /// The number of stages for p.
        p: usize,
    },
    /// The order of the base method is odd or 0. The composition raises the order of symmetric methods, whose orders
    /// are even.
    #[error("{family} raises methods of an even order of at least 2, order {order} was asked for")]
    OddOrder {
        /// The name of the composition.
        family: &'static str,
        /// The requested order of the base method.
        order: usize,
    },
    /// This crate has no coefficients of the family for the requested number of stages.
    #[error("{family} has coefficients here for {least} to {most} stages, {stages} were asked for")]
    Family {
        /// The name of the family.
        family: &'static str,
        /// The smallest available number of stages.
        least: usize,
        /// The largest available number of stages.
        most: usize,
        /// The requested number of stages.
        stages: usize,
    },
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failed_step_is_named_with_its_start() {
        let failed = |made, step| IntegrationError::after(made, step, StepError::NotFinite);
        assert_eq!((failed(3, 0.5).step, failed(3, 0.5).time), (4, 1.5));
        assert_eq!((failed(0, f64::NAN).step, failed(0, f64::NAN).time), (1, 0.0));
        assert_eq!(failed(u64::MAX, 1.0).step, u64::MAX);
    }
}
