//! The values of an event function g along a run: [`EventValues`].

use crate::error::IntegrationError;
use crate::integrators::trajectories::integrator::{Integrator, SampleOf};
use crate::iteration::block_sizes::BlockSizes;
use crate::runs::partial_step::PartialStep;
use core::slice::from_ref;
use lie_poisson::State;
use thiserror::Error;

/// The change of a coordinate that rounding may have caused, relative to the size of its block.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// The number of neighbouring states by which the effect of rounding on g is measured.
const NEIGHBOURS: u64 = 8;

/// The distance of the nearest point that is looked at, relative to the distance to the other end.
const NEAREST: f64 = 1.0 / (1 << 30) as f64;

/// The distance of the last point that is looked at.
const FARTHEST: f64 = 1.0 / (1 << 10) as f64;

/// The ratio of the distances of one point and the next.
const RATIO: f64 = 16.0;

/// The least ratio of the values at two such points if g goes to zero. A zero of order p has the ratio 16ᵖ, where p = ⅓
/// for a cube root. Before a jump the values do not change, and at a pole they fall with the distance.
const GROWTH: f64 = 1.4;

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

/// A point of a step: the sample a time τ after the beginning of the step, with its value of g.
#[derive(Clone, Debug)]
pub(crate) struct Point<S> {
    pub(crate) tau: f64,
    pub(crate) sample: S,
    pub(crate) value: f64,
}

/// One side of a zero of g.
#[derive(Clone, Debug)]
pub(crate) struct Approach<S> {
    /// A point beside the zero, as near as rounding allows, whose sign is that of this side.
    pub(crate) beside: Point<S>,
    /// Whether g goes to zero on this side.
    pub(crate) vanishes: bool,
}

/// The values of g(μ) at samples and at steps of partial size.
///
/// If g has a period, as an angle has, its values are those between −½ and ½ periods.
#[derive(Debug)]
pub(crate) struct EventValues<'a, I: Integrator, G> {
    partial: PartialStep<'a, I>,
    g: G,
    period: Option<f64>,
}

impl<'a, I: Integrator, G: Fn(&I::Momentum) -> f64> EventValues<'a, I, G> {
    pub(crate) fn new(integrator: &'a I, g: G) -> Self {
        Self { partial: PartialStep::new(integrator), g, period: None }
    }

    /// Makes the values those of a function with this period.
    pub(crate) fn modulo(self, period: f64) -> Self {
        Self { period: Some(period), ..self }
    }

    fn at(&self, mu: &I::Momentum) -> f64 {
        let value = (self.g)(mu);
        match self.period {
            Some(period) => value - period * (value / period).round(),
            None => value,
        }
    }

    /// Returns the value of g at a sample, or an error if it is not a number.
    pub(crate) fn of(&self, sample: &SampleOf<I>) -> Result<f64, EventError> {
        let (value, time) = (self.at(&sample.momentum), sample.time);
        if value.is_nan() { Err(EventError::NotANumber { time }) } else { Ok(value) }
    }

    /// Returns the point τ after the sample with which a step begins.
    pub(crate) fn after(
        &mut self,
        from: &SampleOf<I>,
        tau: f64,
    ) -> Result<Point<SampleOf<I>>, EventError> {
        let point = self.after_or_hole(from, tau)?;
        let time = point.sample.time;
        if point.value.is_nan() { Err(EventError::NotANumber { time }) } else { Ok(point) }
    }

    /// Returns the point τ after the sample with which a step begins. Its value may be NaN, as that of |x|/x is at 0.
    pub(crate) fn after_or_hole(
        &mut self,
        from: &SampleOf<I>,
        tau: f64,
    ) -> Result<Point<SampleOf<I>>, EventError> {
        let sample = self.partial.after(from, tau)?;
        let value = self.at(&sample.momentum);
        Ok(Point { tau, sample, value })
    }

    /// Returns whether the way from one value to another of the other sign leads over ½ period and not over 0.
    pub(crate) fn wraps(&self, before: f64, after: f64) -> bool {
        self.period.is_some_and(|period| (after - before).abs() > 0.5 * period.abs())
    }

    /// Returns by how much g changes at a point if each coordinate changes by 64 ε of its block, in one of eight random
    /// patterns: the largest change.
    ///
    /// A value of this size may be the rounding error of a zero. The number has the unit of g, and no other unit plays a
    /// part.
    pub(crate) fn rounding(&self, point: &Point<SampleOf<I>>) -> f64 {
        let mu = &point.sample.momentum;
        let sizes = BlockSizes::of(from_ref(mu));
        let (mut moved, mut most) = (mu.clone(), 0.0_f64);
        for pattern in 0..NEIGHBOURS {
            moved.set_coordinates(|i| {
                let change = ROUNDING * sizes.at(mu.block(i));
                mu.coordinate(i) + change * weight(NEIGHBOURS.wrapping_mul(i as u64) + pattern)
            });
            // A neighbour at a pole or outside the domain of g does not count.
            let change = (self.at(&moved) - point.value).abs();
            if change.is_finite() {
                most = most.max(change);
            }
        }
        most
    }
}

impl<I: Integrator, G: Fn(&I::Momentum) -> f64> EventValues<'_, I, G> {
    /// Looks at the side of a zero that lies towards another point of the step; both are given by their τ.
    ///
    /// g goes to zero if it grows with the distance over three points in succession, or if it is not larger than the effect
    /// of rounding. The first distance is 2⁻³⁰ of that to the other point. Where rounding hides g there, larger ones are
    /// tried.
    pub(crate) fn approach(
        &mut self,
        from: &SampleOf<I>,
        zero: f64,
        towards: f64,
    ) -> Result<Approach<SampleOf<I>>, EventError> {
        let span = towards - zero;
        let mut distance = NEAREST;
        let mut near = self.after(from, zero + distance * span)?;
        let mut smallest = None;
        while distance < FARTHEST {
            distance *= RATIO;
            let far = self.after(from, zero + distance * span)?;
            let grows = have_one_sign(near.value, far.value)
                && far.value.abs() >= GROWTH * near.value.abs();
            smallest = match (grows, smallest) {
                (true, Some(beside)) => return Ok(Approach { beside, vanishes: true }),
                (true, None) => Some(near),
                (false, _) => None,
            };
            near = far;
        }
        // Where g changes by little more than rounding it need not grow.
        let vanishes = near.value.abs() <= self.rounding(&near);
        Ok(Approach { beside: near, vanishes })
    }
}

/// Returns the n-th of a sequence of numbers in [−1, 1) without any pattern.
///
/// Source: G. L. Steele, D. Lea & C. H. Flood, *Fast splittable pseudorandom number generators*, OOPSLA 2014: the
/// generator SplitMix64.
fn weight(n: u64) -> f64 {
    let mut bits = n.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((bits ^ (bits >> 31)) >> 11) as f64 * 0.5_f64.powi(52) - 1.0
}

/// Returns whether two numbers have one sign. Zero has none.
pub(crate) fn have_one_sign(x: f64, y: f64) -> bool {
    (x > 0.0 && y > 0.0) || (x < 0.0 && y < 0.0)
}
