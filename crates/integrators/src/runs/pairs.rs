//! The crossings within one step, of which there may be two: [`StepBetween`].

use crate::integrators::trajectories::integrator::{Integrator, SampleOf};
use crate::runs::crossing::Crossings;
use crate::runs::event_values::{EventError, Point, have_one_sign};
use crate::runs::minimum::Minimum;

/// The distance from the end of a step, in steps, at which the slope of g is measured.
const BESIDE: f64 = 1.0 / (1 << 20) as f64;

/// The same distances if g is zero at the end, where g is divided by the distance.
const BESIDE_ZERO: [f64; 2] = [1.0 / (1 << 16) as f64, 1.0 / (1 << 10) as f64];

/// A step of a run, between two points of one sign or of different signs.
#[derive(Debug)]
pub(crate) struct StepBetween<'s, S> {
    /// The sample with which the step begins.
    pub(crate) from: &'s S,
    /// The first point of the step: its beginning, or a point beside it if g is zero there.
    pub(crate) left: &'s Point<S>,
    /// The last point of the step: its end, or a point beside it if g is zero there.
    pub(crate) right: &'s Point<S>,
    /// The size of the step.
    pub(crate) length: f64,
    /// Whether g is zero at the beginning and at the end of the step.
    pub(crate) zeros: [bool; 2],
}

impl<I: Integrator, G: Fn(&I::Momentum) -> f64> Crossings<'_, I, G> {
    /// Returns the crossings within a step, in the order of time. `is_near` says whether g can have come to zero and back.
    pub(crate) fn within(
        &mut self,
        step: &StepBetween<'_, SampleOf<I>>,
        is_near: bool,
    ) -> Result<[Option<SampleOf<I>>; 2], EventError> {
        let StepBetween { from, left, right, .. } = *step;
        if have_one_sign(left.value, right.value) {
            return if is_near { self.pair(step) } else { Ok([None, None]) };
        }
        Ok([self.between(from, left, right)?, None])
    }

    /// Returns the requested ones of two crossings around an extremum of g within a step whose ends have one sign.
    ///
    /// There are crossings if |g| falls from both ends inward and g has the other sign at the extremum. A zero at an end is
    /// divided out: there, g/τ takes the place of g.
    fn pair(
        &mut self,
        step: &StepBetween<'_, SampleOf<I>>,
    ) -> Result<[Option<SampleOf<I>>; 2], EventError> {
        // The smaller end is more likely to be the one from which |g| does not fall.
        let order = if step.left.value.abs() < step.right.value.abs() { [0, 1] } else { [1, 0] };
        let mut inner = [(0.0, 0.0); 2];
        let mut outer = [0.0; 2];
        for end in order {
            let [(x, before), (y, after)] = match self.beside(step, end)? {
                Beside::Values(values) => values,
                Beside::Beyond(beyond) => return self.both(step, &beyond),
            };
            if after >= before || after.is_nan() {
                return Ok([None, None]);
            }
            (outer[end], inner[end]) = (x, (y, after));
        }
        let lesser = if inner[1].1 < inner[0].1 { inner[1] } else { inner[0] };
        let mut minimum = Minimum::new(outer[0], lesser, outer[1]);
        while let Some(x) = minimum.next() {
            match self.deflated(step, x)? {
                Deflated::Value(value) => minimum.insert(x, value),
                Deflated::Beyond(beyond) => return self.both(step, &beyond),
            }
        }
        Ok([None, None])
    }

    /// Returns the places and the deflated |g| at an end of a step and next to it.
    fn beside(
        &mut self,
        step: &StepBetween<'_, SampleOf<I>>,
        end: usize,
    ) -> Result<Beside<SampleOf<I>>, EventError> {
        let place = |distance: f64| if end == 0 { distance } else { 1.0 - distance };
        let [far, near] =
            if step.zeros[end] { BESIDE_ZERO.map(place) } else { [0.0, BESIDE].map(place) };
        let before = if step.zeros[end] {
            match self.deflated(step, far)? {
                Deflated::Value(value) => value,
                Deflated::Beyond(beyond) => return Ok(Beside::Beyond(beyond)),
            }
        } else {
            let point = if end == 0 { step.left } else { step.right };
            step.deflate(far, point.value.abs())
        };
        Ok(match self.deflated(step, near)? {
            Deflated::Value(after) => Beside::Values([(far, before), (near, after)]),
            Deflated::Beyond(beyond) => Beside::Beyond(beyond),
        })
    }

    /// Returns the deflated |g| at a place x of a step, in units of the step, or the point there if g has the other sign by
    /// more than rounding.
    fn deflated(
        &mut self,
        step: &StepBetween<'_, SampleOf<I>>,
        x: f64,
    ) -> Result<Deflated<SampleOf<I>>, EventError> {
        let point = self.values.after(step.from, x * step.length)?;
        let height = point.value * step.right.value.signum();
        if height < 0.0 && -height > self.values.rounding(&point) {
            return Ok(Deflated::Beyond(point));
        }
        Ok(Deflated::Value(step.deflate(x, height)))
    }

    /// Returns the crossings before and after a point of the other sign within a step.
    fn both(
        &mut self,
        step: &StepBetween<'_, SampleOf<I>>,
        beyond: &Point<SampleOf<I>>,
    ) -> Result<[Option<SampleOf<I>>; 2], EventError> {
        let first = self.between(step.from, step.left, beyond)?;
        let second = self.between(step.from, beyond, step.right)?;
        Ok(if first.is_some() { [first, second] } else { [second, None] })
    }
}

/// |g| within a step, divided by the distances from zeros at its ends, or a point at which g has the other sign.
enum Deflated<S> {
    Value(f64),
    Beyond(Point<S>),
}

/// The places and the deflated |g| of two points at an end of a step, or a point at which g has the other sign.
enum Beside<S> {
    Values([(f64, f64); 2]),
    Beyond(Point<S>),
}

impl<S> StepBetween<'_, S> {
    /// Divides a value at the place x by the distances from the zeros at the ends, in units of the step.
    fn deflate(&self, x: f64, value: f64) -> f64 {
        let [left, right] = self.zeros;
        value / if left { x } else { 1.0 } / if right { 1.0 - x } else { 1.0 }
    }
}
