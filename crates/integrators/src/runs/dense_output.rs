//! A trajectory at any time.

use crate::runs::partial_step::PartialStep;
use crate::{IntegrationError, Integrator, SampleOf};
use thiserror::Error;

/// A time at which a trajectory has no state.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum DenseOutputError {
    /// The run failed before.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
    /// The time lies behind: a trajectory is gone through once.
    #[error("t = {time} lies before t = {reached}, which was passed")]
    Passed {
        /// The time asked for.
        time: f64,
        /// The time of the sample before the last time asked for.
        reached: f64,
    },
    /// The trajectory ended before, or the time is not a number.
    #[error("there is no sample after t = {time}")]
    Ended {
        /// The time asked for.
        time: f64,
    },
}

/// The states of a trajectory between its samples: at time t, one step of the size t − tₙ from the
/// last sample at tₙ ≤ t.
///
/// Exactly as accurate as the integrator, and with its conserved quantities. It goes forward in
/// the direction of the trajectory: ask for times in order. Allocates nothing after `new`. Times
/// are in the units of the step.
///
/// # Example
/// ```
/// use collective_integrators::{DenseOutput, Direct, RungeKutta, Start, from_fn};
/// use nalgebra::Vector2;
/// let oscillator = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x));
/// let gauss = Direct::new(RungeKutta::gauss(4)?, oscillator);
/// let mut run = DenseOutput::new(&gauss, gauss.trajectory(&Vector2::x(), 0.2)?);
/// for t in [0.0, 0.7, 0.75, 3.0] {
///     let z = run.at(t)?.state;
///     assert!((z - Vector2::new(t.cos(), -t.sin())).norm() < 1e-12);
/// }
/// assert!(run.at(1.0).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct DenseOutput<'a, I: Integrator, J> {
    partial: PartialStep<'a, I>,
    samples: J,
    /// The last two samples; the second one is missing before the first call, and at the end.
    left: Option<SampleOf<I>>,
    right: Option<SampleOf<I>>,
}

impl<'a, I, J> DenseOutput<'a, I, J>
where
    I: Integrator,
    J: Iterator<Item = Result<SampleOf<I>, IntegrationError>>,
{
    /// The samples must come from this integrator.
    pub fn new(integrator: &'a I, samples: J) -> Self {
        Self { partial: PartialStep::new(integrator), samples, left: None, right: None }
    }

    /// The state at time t; its `step` counts the whole steps made before, and t is at `time` up
    /// to a rounding.
    ///
    /// # Errors
    /// If t lies before the sample that was reached, if the trajectory ends or fails before t, if t
    /// is not a number, or if the partial step fails.
    pub fn at(&mut self, time: f64) -> Result<SampleOf<I>, DenseOutputError> {
        loop {
            let left = match self.left {
                Some(left) => left,
                None => self.advance(time)?,
            };
            if time == left.time {
                return Ok(left);
            }
            let right = match self.right {
                Some(right) => right,
                None => self.advance(time)?,
            };
            let (length, tau) = (right.time - left.time, time - left.time);
            if tau * length < 0.0 {
                return Err(DenseOutputError::Passed { time, reached: left.time });
            }
            if tau.abs() < length.abs() {
                return Ok(self.partial.after(&left, tau)?);
            }
            // A time that is not a number is not reached by the end of an endless trajectory.
            if !tau.is_finite() || length == 0.0 {
                return Err(DenseOutputError::Ended { time });
            }
            (self.left, self.right) = (Some(right), None);
        }
    }

    /// Takes the next sample, into the place that is free.
    fn advance(&mut self, time: f64) -> Result<SampleOf<I>, DenseOutputError> {
        let sample = self.samples.next().ok_or(DenseOutputError::Ended { time })??;
        let place = if self.left.is_none() { &mut self.left } else { &mut self.right };
        *place = Some(sample);
        Ok(sample)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Direct, RungeKutta, StepError, from_fn};
    use nalgebra::Vector1;

    #[test]
    fn times_without_a_state_are_errors() {
        // ẋ = x² from 1 blows up at t = 1
        let blow_up = from_fn(|x: &Vector1<f64>| Vector1::new(x[0] * x[0]));
        let midpoint = Direct::new(RungeKutta::implicit_midpoint(), blow_up);
        let run =
            |n| DenseOutput::new(&midpoint, midpoint.trajectory_from(Vector1::x(), 0.1).take(n));
        let ended = |time| Some(DenseOutputError::Ended { time });
        assert!(matches!(run(5).at(f64::NAN), Err(DenseOutputError::Ended { .. })));
        assert_eq!(run(5).at(f64::INFINITY).err(), ended(f64::INFINITY));
        assert_eq!(run(5).at(0.45).err(), ended(0.45));
        assert_eq!(run(0).at(0.0).err(), ended(0.0));
        assert!(run(5).at(-0.01).is_err());
        assert!(run(5).at(0.4).is_ok_and(|s| s.step == 4));
        let error = run(50).at(3.0).err();
        let failed = |e| matches!(e, StepError::NotConverged { .. } | StepError::NotFinite);
        assert!(matches!(error, Some(DenseOutputError::Integration(e)) if failed(e.source)));
    }

    #[test]
    fn backwards_in_time() {
        let decay = from_fn(|x: &Vector1<f64>| -*x);
        let rk4 = Direct::new(RungeKutta::rk4(), decay);
        let mut run = DenseOutput::new(&rk4, rk4.trajectory_from(Vector1::x(), -0.01));
        for t in [-0.005, -0.25, -0.2512_f64] {
            assert!(run.at(t).is_ok_and(|s| (s.state[0] - (-t).exp()).abs() < 1e-9));
        }
        assert!(matches!(run.at(0.0), Err(DenseOutputError::Passed { .. })));
    }
}
