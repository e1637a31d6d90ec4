//! The search for events in samples that the caller supplies: [`EventSearch`].

use crate::integrators::trajectories::integrator::{Integrator, SampleOf};
use crate::runs::crossing::{Crossings, Direction};
use crate::runs::event_values::{Approach, EventError, EventValues, Point};
use crate::runs::pairs::StepBetween;

/// The largest |g| at a start that may be a rounding error of zero, relative to |g| in the first step.
const START: f64 = 1.0 / (1 << 20) as f64;

/// The search for the points where g(μ) crosses zero along a run whose samples the caller supplies.
///
/// It finds what [`Events`](crate::Events) finds, with the same guarantees. `Events` takes samples from an iterator, so
/// that a run can have only one event function. Here the caller passes each sample to as many searches as there are
/// event functions, and may also record it.
///
/// # Example
/// The zeros of x and of y along one run of the oscillator:
/// ```
/// use collective_integrators::{Direct, Direction, EventSearch, RungeKutta, Start, from_fn};
/// use nalgebra::Vector2;
/// use std::f64::consts::FRAC_PI_2;
/// let oscillator = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x));
/// let gauss = Direct::new(RungeKutta::gauss(5)?, oscillator);
/// let mut x = EventSearch::new(&gauss, |z: &Vector2<f64>| z.x, Direction::Both);
/// let mut y = EventSearch::new(&gauss, |z: &Vector2<f64>| z.y, Direction::Both);
/// let (mut of_x, mut of_y) = (Vec::new(), Vec::new());
/// for sample in gauss.trajectory(&Vector2::x(), 0.2)?.take(40) {
///     let sample = sample?;
///     of_x.extend(x.observe(&sample)?.into_iter().flatten().map(|event| event.time));
///     of_y.extend(y.observe(&sample)?.into_iter().flatten().map(|event| event.time));
/// }
/// // x = cos t and y = −sin t; the start, where y = 0, is no crossing
/// let near = |found: &[f64], quarters: &[f64]| {
///     found.len() == quarters.len()
///         && found.iter().zip(quarters).all(|(t, k)| (t - k * FRAC_PI_2).abs() < 1e-13)
/// };
/// assert!(near(&of_x, &[1.0, 3.0]) && near(&of_y, &[2.0, 4.0]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct EventSearch<'a, I: Integrator, G> {
    crossings: Crossings<'a, I, G>,
    last: Option<Last<SampleOf<I>>>,
    counts_start: bool,
}

/// The last sample of a search, as the beginning of a step.
#[derive(Debug)]
struct Last<S> {
    point: Point<S>,
    /// The change of |g| in the step before, if there was one.
    change: Option<f64>,
    /// The side of the next step, if it is known and g is zero here.
    after: Option<Approach<S>>,
}

impl<'a, I: Integrator, G: Fn(&I::Momentum) -> f64> EventSearch<'a, I, G> {
    /// Creates the search before the first sample.
    pub fn new(integrator: &'a I, g: G, direction: Direction) -> Self {
        let values = EventValues::new(integrator, g);
        Self { crossings: Crossings { values, direction }, last: None, counts_start: false }
    }

    /// Returns the search for the points where g is a multiple of a period, such as 2π for an angle.
    ///
    /// g may jump by the period, as `atan2` does: that is no event. The step must resolve g, which may change by less
    /// than half of the period in a step.
    #[must_use]
    pub fn modulo(self, period: f64) -> Self {
        let Crossings { values, direction } = self.crossings;
        Self { crossings: Crossings { values: values.modulo(period), direction }, ..self }
    }

    /// Returns the search that also counts the start of the run, the sample of step 0, if g is zero there up to rounding and
    /// leaves zero in the requested direction.
    #[must_use]
    pub fn counting_start(self) -> Self {
        Self { counts_start: true, ..self }
    }

    /// Takes the next sample of this integrator, and returns the events between the last two samples, and at the last one,
    /// in the order of time.
    ///
    /// No event is returned later than with the first sample that is not before it. There are at most four: a start that
    /// [counts](Self::counting_start), two within the step, and one at its end.
    ///
    /// # Errors
    /// Returns [`EventError`] if a step of partial size fails, or if g is not a number.
    pub fn observe(
        &mut self,
        sample: &SampleOf<I>,
    ) -> Result<[Option<SampleOf<I>>; 4], EventError> {
        let value = self.crossings.values.of(sample)?;
        let here = Point { tau: 0.0, sample: sample.clone(), value };
        match self.last.take() {
            None => {
                self.last = Some(Last { point: here, change: None, after: None });
                Ok([const { None }; 4])
            }
            Some(last) => self.step(last, here),
        }
    }

    /// Returns the events of the step from the last sample to the next.
    fn step(
        &mut self,
        last: Last<SampleOf<I>>,
        here: Point<SampleOf<I>>,
    ) -> Result<[Option<SampleOf<I>>; 4], EventError> {
        let Last { point: mut begin, change, mut after } = last;
        let length = here.sample.time - begin.sample.time;
        if begin.sample.step == 0 && self.is_on_surface(&begin, &here, length)? {
            begin.value = 0.0;
        }
        let zeros = [begin.value == 0.0, here.value == 0.0];
        let values = &mut self.crossings.values;
        if zeros[0] && after.is_none() {
            after = Some(values.approach(&begin.sample, 0.0, length)?);
        }
        let before = match zeros[1] {
            true => Some(values.approach(&begin.sample, length, 0.0)?),
            false => None,
        };
        let end = Point { tau: length, ..here };
        let left = after.as_ref().map_or(&begin, |after| &after.beside);
        let right = before.as_ref().map_or(&end, |before| &before.beside);
        let now = (end.value - begin.value).abs();
        // A function that comes to zero and back within a step changes by more than it is at one of the ends.
        let least = left.value.abs().min(right.value.abs());
        let is_near = zeros[0] || zeros[1] || change.is_none_or(|change| least <= change.max(now));
        let start = (self.counts_start && begin.sample.step == 0 && zeros[0])
            .then(|| self.crossings.direction.crosses(-left.value, left.value))
            .is_some_and(|counts| counts)
            .then(|| begin.sample.clone());
        let step = StepBetween { from: &begin.sample, left, right, length, zeros };
        let [first, second] = self.crossings.within(&step, is_near)?;
        let here = Point { tau: 0.0, ..end };
        let (last, next) = self.at_end(&here, before, length);
        self.last = Some(Last { point: here, change: Some(now), after: next });
        Ok([start, first, second, last])
    }

    /// Returns the end of a step if g crosses zero there, and the side of the next step.
    ///
    /// A step of partial size beyond the end of a run may fail. In that case no crossing is known.
    fn at_end(
        &mut self,
        end: &Point<SampleOf<I>>,
        before: Option<Approach<SampleOf<I>>>,
        length: f64,
    ) -> (Option<SampleOf<I>>, Option<Approach<SampleOf<I>>>) {
        let Some(before) = before else { return (None, None) };
        let Ok(after) = self.crossings.values.approach(&end.sample, 0.0, length) else {
            return (None, None);
        };
        let crosses = before.vanishes
            && after.vanishes
            && self.crossings.direction.crosses(before.beside.value, after.beside.value);
        (crosses.then(|| end.sample.clone()), Some(after))
    }

    /// Returns whether g at a start is zero up to rounding.
    fn is_on_surface(
        &mut self,
        start: &Point<SampleOf<I>>,
        next: &Point<SampleOf<I>>,
        length: f64,
    ) -> Result<bool, EventError> {
        let (values, size) = (&mut self.crossings.values, start.value.abs());
        if size == 0.0 || size > values.rounding(start) {
            return Ok(size == 0.0);
        }
        // Where coordinates of one block have different units, the effect of rounding is overestimated.
        let middle = values.after(&start.sample, 0.5 * length)?.value.abs();
        Ok(size <= START * middle.max(next.value.abs()))
    }
}
