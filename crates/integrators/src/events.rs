//! Events along a trajectory: Poincaré sections.

use crate::chandrupatla::Bracket;
use crate::partial_step::PartialStep;
use crate::{IntegrationError, Integrator, SampleOf};
use thiserror::Error;

/// An event that cannot be located.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum EventError {
    /// The run failed.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
    /// g is not a number, so that it may or may not have crossed zero.
    #[error("the event function is not a number at t = {time}")]
    NotANumber {
        /// When.
        time: f64,
    },
}

/// The direction in which g crosses zero, along the trajectory as it is traversed (backwards in
/// time for negative steps).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// From g < 0 to g ≥ 0.
    Up,
    /// From g > 0 to g ≤ 0.
    Down,
    /// Either.
    Both,
}

impl Direction {
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

/// The points of a trajectory where g(μ) crosses zero: an iterator adaptor.
///
/// A change of the sign of g between two samples is followed up by steps of partial size τ from the
/// left one, with τ such that g(μ(Φ_τ(z))) = 0 to round-off. The event is therefore as accurate as
/// the integrator, and lies on the same level sets of what the integrator conserves. Its `step`
/// counts the whole steps before it.
///
/// Two crossings within one step are not seen. A sample with g = 0 exactly ends a crossing and
/// begins none, so that each crossing is found once. The adaptor asks for samples until there is
/// an event or none are left: bound the run by `take`. After `new` nothing is allocated; an event
/// costs about ten steps.
///
/// Source of the idea: M. Hénon, *On the numerical computation of Poincaré maps*, Physica D 5
/// (1982), who changes the independent variable for the last step; here, the size of the last step
/// is solved for.
///
/// # Example
/// The oscillator passes x = 0 upwards at t = 3π/2, 7π/2, …:
/// ```
/// use collective_integrators::{Direct, Direction, Events, RungeKutta, Start, from_fn};
/// use nalgebra::Vector2;
/// use std::f64::consts::PI;
/// let oscillator = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x));
/// let gauss = Direct::new(RungeKutta::gauss(5)?, oscillator);
/// let run = gauss.trajectory(&Vector2::x(), 0.2)?.take(100);
/// let events: Vec<_> = Events::new(&gauss, run, |z| z.x, Direction::Up).collect();
/// assert_eq!(events.len(), 3);
/// for (k, event) in events.into_iter().enumerate() {
///     let event = event?;
///     assert!((event.time - (1.5 + 2.0 * k as f64) * PI).abs() < 1e-13);
///     assert!(event.momentum.x.abs() < 1e-15);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Events<'a, I: Integrator, J, G> {
    partial: PartialStep<'a, I>,
    samples: J,
    g: G,
    direction: Direction,
    left: Option<(SampleOf<I>, f64)>,
    failed: bool,
}

impl<'a, I, J, G> Events<'a, I, J, G>
where
    I: Integrator,
    J: Iterator<Item = Result<SampleOf<I>, IntegrationError>>,
    G: Fn(&I::Momentum) -> f64,
{
    /// The samples must come from this integrator.
    pub fn new(integrator: &'a I, samples: J, g: G, direction: Direction) -> Self {
        let partial = PartialStep::new(integrator);
        Self { partial, samples, g, direction, left: None, failed: false }
    }

    /// g at a sample, which must be a number.
    fn value(&self, sample: &SampleOf<I>) -> Result<f64, EventError> {
        let value = (self.g)(&sample.momentum);
        let time = sample.time;
        if value.is_nan() { Err(EventError::NotANumber { time }) } else { Ok(value) }
    }

    /// Goes on by one sample; the event in between, if there is one.
    fn advance(
        &mut self,
        right: Result<SampleOf<I>, IntegrationError>,
    ) -> Result<Option<SampleOf<I>>, EventError> {
        let right = right?;
        let after = self.value(&right)?;
        match self.left.replace((right, after)) {
            Some((left, before)) if self.direction.crosses(before, after) => {
                self.locate(&left, before, &right, after).map(Some)
            }
            _ => Ok(None),
        }
    }

    fn locate(
        &mut self,
        left: &SampleOf<I>,
        before: f64,
        right: &SampleOf<I>,
        after: f64,
    ) -> Result<SampleOf<I>, EventError> {
        let length = right.time - left.time;
        let mut bracket = Bracket::new(before, length, after);
        let mut best = if after.abs() < before.abs() { (*right, after) } else { (*left, before) };
        while let Some(tau) = bracket.next() {
            let sample = self.partial.after(left, tau)?;
            let value = self.value(&sample)?;
            if value.abs() <= best.1.abs() {
                best = (sample, value);
            }
            bracket.insert(tau, value);
        }
        Ok(best.0)
    }
}

impl<I, J, G> Iterator for Events<'_, I, J, G>
where
    I: Integrator,
    J: Iterator<Item = Result<SampleOf<I>, IntegrationError>>,
    G: Fn(&I::Momentum) -> f64,
{
    type Item = Result<SampleOf<I>, EventError>;

    fn next(&mut self) -> Option<Self::Item> {
        while !self.failed {
            let right = self.samples.next()?;
            match self.advance(right) {
                Ok(None) => {}
                Ok(Some(event)) => return Some(Ok(event)),
                Err(error) => {
                    self.failed = true;
                    return Some(Err(error));
                }
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Direct, RungeKutta, from_fn};
    use nalgebra::Vector1;

    /// The events of g along x = t, t = 0, 0.25, …, 2.
    fn events(g: impl Fn(f64) -> f64, direction: Direction) -> Vec<Result<f64, EventError>> {
        let clock = Direct::new(RungeKutta::rk4(), from_fn(|_: &Vector1<f64>| Vector1::x()));
        let run = clock.trajectory_from(Vector1::zeros(), 0.25).take(9);
        let events = Events::new(&clock, run, |x: &Vector1<f64>| g(x[0]), direction);
        events.map(|event| event.map(|sample| sample.time)).collect()
    }

    #[test]
    fn directions_and_zeros_at_samples() {
        let wave = |x: f64| (x - 0.3) * (x - 1.0) * (x - 1.6);
        let times = |direction| -> Vec<f64> {
            let near = |time: Result<f64, _>| time.map_or(f64::NAN, |t| (t * 1e12).round() / 1e12);
            events(wave, direction).into_iter().map(near).collect()
        };
        assert_eq!(times(Direction::Up), [0.3, 1.6]);
        assert_eq!(times(Direction::Down), [1.0]);
        assert_eq!(times(Direction::Both), [0.3, 1.0, 1.6]);
        // g = 0 at the start is no event
        assert_eq!(events(|x| x, Direction::Both), []);
    }

    #[test]
    fn a_nan_ends_the_events() {
        let g = |x: f64| if x > 1.1 { f64::NAN } else { x - 0.9 };
        let found = events(g, Direction::Up);
        assert!(found[0].as_ref().is_ok_and(|t| (t - 0.9).abs() < 1e-15));
        assert_eq!(found[1..], [Err(EventError::NotANumber { time: 1.25 })]);
        // between the samples, too
        let g = |x: f64| {
            if x == 1.25 {
                1.0
            } else if x > 1.1 {
                f64::NAN
            } else {
                -1.0
            }
        };
        assert!(matches!(events(g, Direction::Up)[..], [Err(EventError::NotANumber { .. })]));
    }
}
