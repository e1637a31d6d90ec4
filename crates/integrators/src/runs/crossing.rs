//! Sign changes of a function along a trajectory.

use crate::runs::minimum::Minimum;
use crate::runs::partial_step::PartialStep;
use crate::runs::root_bracketing::Bracket;
use crate::{IntegrationError, Integrator, SampleOf};
use thiserror::Error;

/// The reason why an event cannot be located.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum EventError {
    /// The run in which the event was searched failed.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
    /// The event function g is not a number, so a crossing can neither be found nor excluded.
    #[error("the event function is not a number at t = {time}")]
    NotANumber {
        /// The time at which g is not a number.
        time: f64,
    },
}

/// The direction in which g crosses zero along the trajectory.
///
/// For negative steps the trajectory runs backwards in time, and a function that grows along it falls in time. A Poincaré
/// section is a set of states, whatever the direction of a run: [`along_run`](Self::along_run) gives the direction in
/// which the run crosses it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Direction {
    /// A crossing upwards, from g < 0 to g ≥ 0.
    Up,
    /// A crossing downwards, from g > 0 to g ≤ 0.
    Down,
    /// A crossing in either direction.
    Both,
}

impl Direction {
    /// Returns the direction along a run with steps of size `step` of the crossings that have this direction in time.
    ///
    /// # Example
    /// ```
    /// use collective_integrators::Direction;
    /// assert_eq!(Direction::Up.along_run(0.1), Direction::Up);
    /// assert_eq!(Direction::Up.along_run(-0.1), Direction::Down);
    /// ```
    #[must_use]
    pub fn along_run(self, step: f64) -> Self {
        match self {
            Self::Up if step < 0.0 => Self::Down,
            Self::Down if step < 0.0 => Self::Up,
            same => same,
        }
    }

    fn crosses(self, before: f64, after: f64) -> bool {
        let up = before < 0.0 && after >= 0.0;
        let down = before > 0.0 && after <= 0.0;
        match self {
            Self::Up => up,
            Self::Down => down,
            Self::Both => up || down,
        }
    }
}

/// A sample with its value of g.
type Valued<I> = (SampleOf<I>, f64);

/// The crossings of zero by g(μ) in the requested direction, located by steps of partial size.
#[derive(Debug)]
pub(crate) struct Crossings<'a, I: Integrator, G> {
    partial: PartialStep<'a, I>,
    g: G,
    direction: Direction,
}

impl<'a, I: Integrator, G: Fn(&I::Momentum) -> f64> Crossings<'a, I, G> {
    pub(crate) fn new(integrator: &'a I, g: G, direction: Direction) -> Self {
        Self { partial: PartialStep::new(integrator), g, direction }
    }

    /// Returns the value of g at a sample, or an error if it is not a number.
    pub(crate) fn value(&self, sample: &SampleOf<I>) -> Result<f64, EventError> {
        let value = (self.g)(&sample.momentum);
        let time = sample.time;
        if value.is_nan() { Err(EventError::NotANumber { time }) } else { Ok(value) }
    }

    /// Returns the crossing between two neighbouring samples if g changes its sign.
    pub(crate) fn between(
        &mut self,
        left: &Valued<I>,
        right: &Valued<I>,
    ) -> Result<Option<SampleOf<I>>, EventError> {
        if !self.direction.crosses(left.1, right.1) {
            return Ok(None);
        }
        self.locate(&left.0, left, right).map(Some)
    }

    /// Returns the requested ones of two crossings around an extremum of g near the middle one of three samples.
    ///
    /// The samples have one sign. There are crossings if |g| is least at the middle one and g has the other sign at the
    /// extremum.
    pub(crate) fn near(
        &mut self,
        left: &Valued<I>,
        middle: &Valued<I>,
        right: &Valued<I>,
    ) -> Result<[Option<SampleOf<I>>; 2], EventError> {
        if !is_least(left.1, middle.1, right.1) {
            return Ok([None, None]);
        }
        let sign = middle.1.signum();
        let lengths = [middle.0.time - left.0.time, right.0.time - middle.0.time];
        // Units of the step: negative x starts from the left sample, positive x from the middle one.
        let mut minimum = Minimum::new(-1.0, (0.0, middle.1.abs()), 1.0);
        while let Some(x) = minimum.next() {
            let (from, to, tau) = if x < 0.0 {
                (left, middle, (1.0 + x) * lengths[0])
            } else {
                (middle, right, x * lengths[1])
            };
            let sample = self.partial.after(&from.0, tau)?;
            let value = self.value(&sample)?;
            let beyond = (sample, value);
            if beyond.1 * sign < 0.0 {
                return self.both(from, &beyond, to);
            }
            minimum.insert(x, beyond.1 * sign);
        }
        Ok([None, None])
    }

    /// Returns the crossings before and after a point within the step from `from` to `to`.
    fn both(
        &mut self,
        from: &Valued<I>,
        beyond: &Valued<I>,
        to: &Valued<I>,
    ) -> Result<[Option<SampleOf<I>>; 2], EventError> {
        let there = self.direction.crosses(from.1, beyond.1);
        let back = self.direction.crosses(beyond.1, to.1);
        let second = if back { Some(self.locate(&from.0, beyond, to)?) } else { None };
        if !there {
            return Ok([second, None]);
        }
        Ok([Some(self.locate(&from.0, from, beyond)?), second])
    }

    /// Locates the zero between two points of different signs, by steps from the sample before them.
    fn locate(
        &mut self,
        from: &SampleOf<I>,
        left: &Valued<I>,
        right: &Valued<I>,
    ) -> Result<SampleOf<I>, EventError> {
        let offset = left.0.time - from.time;
        let mut bracket = Bracket::new(left.1, right.0.time - left.0.time, right.1);
        let mut best = if right.1.abs() < left.1.abs() { right.clone() } else { left.clone() };
        while let Some(tau) = bracket.next() {
            let sample = self.partial.after(from, offset + tau)?;
            let value = self.value(&sample)?;
            if value.abs() <= best.1.abs() {
                best = (sample, value);
            }
            bracket.insert(tau, value);
        }
        Ok(best.0)
    }
}

/// Returns whether |g| is least at the middle one of three samples of one sign.
///
/// If two samples have the same value, the first one counts, so that an extremum between them is followed once.
fn is_least(left: f64, middle: f64, right: f64) -> bool {
    let (above, below) = (middle > 0.0, middle < 0.0);
    (above && left > middle && right >= middle) || (below && left < middle && right <= middle)
}
