//! The states of a trajectory at any time: [`DenseOutput`].

use crate::error::IntegrationError;
use crate::integrators::trajectories::integrator::{Integrator, SampleOf};
use crate::runs::partial_step::PartialStep;
use thiserror::Error;

/// The reason why a trajectory has no state at a time.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum DenseOutputError {
    /// The run failed before the requested time.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
    /// The requested time has been passed. A trajectory is traversed only once.
    #[error("t = {time} lies before t = {reached}, which was passed")]
    Passed {
        /// The requested time.
        time: f64,
        /// The time of the sample before the last requested time.
        reached: f64,
    },
    /// The trajectory ended before the requested time, or the time is not a number.
    #[error("there is no sample after t = {time}")]
    Ended {
        /// The requested time.
        time: f64,
    },
}

/// The states of a trajectory between its samples.
///
/// The state at time t is the result of one step of size t − tₙ from the last sample at tₙ ≤ t. It is as accurate as
/// the integrator, and keeps the conserved quantities of the integrator. The output advances in the direction of the
/// trajectory: request times in order, in the units of the step. It allocates nothing after `new`, except for states on
/// the heap.
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
    /// The last two samples. The second one is missing before the first call, and at the end.
    left: Option<SampleOf<I>>,
    right: Option<SampleOf<I>>,
}

impl<'a, I, J> DenseOutput<'a, I, J>
where
    I: Integrator,
    J: Iterator<Item = Result<SampleOf<I>, IntegrationError>>,
{
    /// Creates the output from samples of the trajectory, which must come from this integrator.
    pub fn new(integrator: &'a I, samples: J) -> Self {
        Self { partial: PartialStep::new(integrator), samples, left: None, right: None }
    }

    /// Returns the state at time t. Its `step` is the number of whole steps before t, and its `time` is t to round-off.
    ///
    /// # Errors
    /// Returns [`DenseOutputError::Passed`] if t lies before the sample that was reached. Returns
    /// [`DenseOutputError::Ended`] if the trajectory ends before t, or if t is not a number. Returns
    /// [`DenseOutputError::Integration`] if the trajectory or the partial step fails.
    pub fn at(&mut self, time: f64) -> Result<SampleOf<I>, DenseOutputError> {
        loop {
            let left = match &mut self.left {
                Some(left) => left,
                none => none.insert(next_of::<I, _>(&mut self.samples, time)?),
            };
            if time == left.time {
                return Ok(left.clone());
            }
            let right = match &mut self.right {
                Some(right) => right,
                none => none.insert(next_of::<I, _>(&mut self.samples, time)?),
            };
            let (length, tau) = (right.time - left.time, time - left.time);
            if tau * length < 0.0 {
                return Err(DenseOutputError::Passed { time, reached: left.time });
            }
            if tau.abs() < length.abs() {
                return Ok(self.partial.after(left, tau)?);
            }
            // The end of an endless trajectory does not reach a time that is not a number.
            if !tau.is_finite() || length == 0.0 {
                return Err(DenseOutputError::Ended { time });
            }
            self.left = self.right.take();
        }
    }
}

/// Returns the next sample of a trajectory in which a sample after t is sought.
fn next_of<I, J>(samples: &mut J, time: f64) -> Result<SampleOf<I>, DenseOutputError>
where
    I: Integrator,
    J: Iterator<Item = Result<SampleOf<I>, IntegrationError>>,
{
    Ok(samples.next().ok_or(DenseOutputError::Ended { time })??)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::StepError;
    use crate::integrators::direct::Direct;
    use crate::schemes::runge_kutta::RungeKutta;
    use crate::vector_field::from_fn;
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
        let failed = |e| {
            matches!(
                e,
                StepError::NotConverged { .. }
                    | StepError::OtherSolution { .. }
                    | StepError::NotFinite
            )
        };
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

    #[test]
    fn no_time_is_sought_without_end() {
        let decay = from_fn(|x: &Vector1<f64>| -*x);
        let rk4 = Direct::new(RungeKutta::rk4(), decay);
        let at =
            |step, time| DenseOutput::new(&rk4, rk4.trajectory_from(Vector1::x(), step)).at(time);
        for (step, time) in [(0.1, f64::NAN), (0.1, f64::INFINITY), (0.0, 1.0)] {
            assert!(matches!(at(step, time), Err(DenseOutputError::Ended { .. })), "{step} {time}");
        }
        assert!(at(0.1, 1.0).is_ok());
    }
}
