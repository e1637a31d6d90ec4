//! The search for events in samples that the caller supplies: [`EventSearch`].

use crate::runs::crossing::Crossings;
use crate::{Direction, EventError, Integrator, SampleOf};

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
    /// The last two samples with their values of g, the last one first.
    last: [Option<(SampleOf<I>, f64)>; 2],
}

impl<'a, I: Integrator, G: Fn(&I::Momentum) -> f64> EventSearch<'a, I, G> {
    /// Creates the search before the first sample.
    pub fn new(integrator: &'a I, g: G, direction: Direction) -> Self {
        Self { crossings: Crossings::new(integrator, g, direction), last: [None, None] }
    }

    /// Takes the next sample of this integrator, and returns the events that it completes: none, one or two, in the
    /// order of time.
    ///
    /// An event lies between the last two samples. If two crossings within one step leave the sign at the samples
    /// unchanged, they lie between the last three.
    ///
    /// # Errors
    /// Returns [`EventError`] if a step of partial size fails, or if g is not a number.
    pub fn observe(
        &mut self,
        sample: &SampleOf<I>,
    ) -> Result<[Option<SampleOf<I>>; 2], EventError> {
        let value = self.crossings.value(sample)?;
        self.last.swap(0, 1);
        let left = self.last[0].replace((sample.clone(), value));
        let [Some(right), Some(middle)] = &self.last else { return Ok([None, None]) };
        if let Some(event) = self.crossings.between(middle, right)? {
            return Ok([Some(event), None]);
        }
        let Some(left) = left else { return Ok([None, None]) };
        self.crossings.near(&left, middle, right)
    }
}
