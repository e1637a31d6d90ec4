//! Events along a trajectory, such as Poincaré sections: [`Events`].

use crate::runs::event_search::EventSearch;
use crate::{Direction, EventError, IntegrationError, Integrator, SampleOf};

/// An iterator adaptor that returns the points of a trajectory where g(μ) crosses zero.
///
/// If g changes its sign between two samples, steps of partial size τ from the left one locate the zero: g(μ(Φ_τ(z))) =
/// 0 to round-off. The event is therefore as accurate as the integrator, and lies on the same level sets of conserved
/// quantities. Its `step` is the number of whole steps before it.
///
/// Two crossings within one step do not change the sign at the samples. If |g| is least at the middle one of three
/// samples of one sign, steps of partial size follow g to its extremum near that sample. If g has the other sign there,
/// the crossings on both sides are located. The guarantees are:
///
/// * one crossing in a step is found;
/// * two crossings in a step are found if they are farther apart than about 1e-6 steps, and if the extremum between the
///   crossings is the only one of g in this step and the two adjacent steps. The first and the last step of a run lack
///   a neighbour: two crossings may be missed there.
/// * some crossings at smaller distances are missed: choose a step that resolves g.
///
/// A sample with g = 0 exactly ends a crossing and begins none, so that each crossing is found once. The adaptor
/// requests samples until there is an event or none are left: bound the run by `take`. After an error it returns this
/// error again for each remaining sample, so that `nth` and other adaptors that skip events do not lose it. After `new`
/// nothing is allocated, except for states on the heap. An event costs about ten steps, and so does an extremum at
/// which
/// |g| is least without a crossing.
///
/// [`EventSearch`] does the same for samples that the caller supplies, so that several event functions can be used
/// along one run.
///
/// Source of the idea: M. Hénon, *On the numerical computation of Poincaré maps*, Physica D 5 (1982). Hénon changes the
/// independent variable for the last step; here, the size of the last step is solved for.
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
///     assert!(event.state.x.abs() < 1e-15);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Events<'a, I: Integrator, J, G> {
    search: EventSearch<'a, I, G>,
    samples: J,
    /// The second of two crossings within one step.
    second: Option<SampleOf<I>>,
    failed: Option<EventError>,
}

impl<'a, I, J, G> Events<'a, I, J, G>
where
    I: Integrator,
    J: Iterator<Item = Result<SampleOf<I>, IntegrationError>>,
    G: Fn(&I::Momentum) -> f64,
{
    /// Creates the events from samples of the trajectory, which must come from this integrator.
    pub fn new(integrator: &'a I, samples: J, g: G, direction: Direction) -> Self {
        let search = EventSearch::new(integrator, g, direction);
        Self { search, samples, second: None, failed: None }
    }

    /// Proceeds by one sample, and returns the first event that it completes, if any.
    fn advance(
        &mut self,
        sample: Result<SampleOf<I>, IntegrationError>,
    ) -> Result<Option<SampleOf<I>>, EventError> {
        let [first, second] = self.search.observe(&sample?)?;
        self.second = second;
        Ok(first)
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
        if let Some(event) = self.second.take() {
            return Some(Ok(event));
        }
        loop {
            let right = self.samples.next()?;
            match self.failed.map_or_else(|| self.advance(right), Err) {
                Ok(None) => {}
                Ok(Some(event)) => return Some(Ok(event)),
                Err(error) => {
                    self.failed = Some(error);
                    return Some(Err(error));
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Direct, RungeKutta, from_fn};
    use nalgebra::Vector1;

    /// Returns the events of g along x = t, t = 0, 0.25, …, 2, where the method does not round.
    fn events(g: impl Fn(f64) -> f64, direction: Direction) -> Vec<Result<f64, EventError>> {
        let clock =
            Direct::new(RungeKutta::explicit_midpoint(), from_fn(|_: &Vector1<f64>| Vector1::x()));
        let run = clock.trajectory_from(Vector1::zeros(), 0.25).take(9);
        let events = Events::new(&clock, run, |x: &Vector1<f64>| g(x[0]), direction);
        events.map(|event| event.map(|sample| sample.time)).collect()
    }

    #[test]
    fn directions_and_zeros_at_samples() {
        let wave = |x: f64| (x - 0.3) * (x - 1.0) * (x - 1.6);
        let times = |sign: f64, direction| -> Vec<f64> {
            let near = |time: Result<f64, _>| time.map_or(f64::NAN, |t| (t * 1e12).round() / 1e12);
            events(|x| sign * wave(x), direction).into_iter().map(near).collect()
        };
        // A zero at a sample belongs to the step that ends there, downwards and upwards.
        for (sign, rises, falls) in
            [(1.0, Direction::Up, Direction::Down), (-1.0, Direction::Down, Direction::Up)]
        {
            assert_eq!(times(sign, rises), [0.3, 1.6]);
            assert_eq!(times(sign, falls), [1.0]);
            assert_eq!(times(sign, Direction::Both), [0.3, 1.0, 1.6]);
        }
        // the same for a zero that g touches and leaves again
        let touch = |x: f64| (x - 1.0) * (x - 1.0);
        assert_eq!(events(touch, Direction::Both), [Ok(1.0)]);
        assert_eq!(events(touch, Direction::Up), []);
        assert_eq!(events(|x| -touch(x), Direction::Up), [Ok(1.0)]);
        assert_eq!(events(|x| -touch(x), Direction::Down), []);
        // g = 0 at the start is no event
        assert_eq!(events(|x| x, Direction::Both), []);
    }

    /// A parabola dips below zero between the samples at 1 and 1.25.
    #[test]
    fn two_crossings_in_one_step_are_found() {
        let dip = |from: f64, to: f64| move |x: f64| (x - from) * (x - to);
        // near the left sample; near the right one; as far apart as a step allows (g is the same at both samples then,
        // and the crossings are found once); close together
        for (from, to) in [(1.02, 1.08), (1.19, 1.23), (1.001, 1.249), (1.1, 1.1 + 2.5e-7)] {
            for sign in [1.0, -1.0] {
                let g = move |x: f64| sign * dip(from, to)(x);
                let times = |direction| {
                    let found = events(g, direction);
                    found.into_iter().map(|t| t.unwrap_or(f64::NAN)).collect::<Vec<_>>()
                };
                let is = |found: &[f64], zeros: &[f64]| {
                    // g has rounding errors of ε, and slope ±|to − from| at its zeros
                    let tolerance = 1e-15 / (to - from) + 1e-15;
                    let near = |(t, zero): (&f64, &f64)| (t - zero).abs() < tolerance;
                    found.len() == zeros.len() && found.iter().zip(zeros).all(near)
                };
                assert!(is(&times(Direction::Both), &[from, to]), "{from} {to} {sign}");
                let (first, second) = if sign > 0.0 {
                    (Direction::Down, Direction::Up)
                } else {
                    (Direction::Up, Direction::Down)
                };
                assert!(is(&times(first), &[from]) && is(&times(second), &[to]));
            }
        }
        // control: the values at the samples do not change sign
        let samples = (0..9).map(|n| dip(1.02, 1.08)(0.25 * f64::from(n)));
        assert!(samples.into_iter().all(|g| g > 0.0));
        // a dip that ends above zero is no event, and the first step is not searched
        assert_eq!(events(|x| dip(1.02, 1.08)(x) + 1e-3, Direction::Both), []);
        assert_eq!(events(|x| dip(0.02, 0.08)(x), Direction::Both), []);
    }

    /// Beyond t = 1, g dips below zero in each step. The sample at 1 is the least one, and the search around it ends at
    /// the next sample.
    #[test]
    fn the_search_for_a_dip_ends_at_the_next_sample() {
        let turn = core::f64::consts::TAU / 0.25;
        let dips = move |x: f64| (1.0 + 0.5 * (x - 1.0)) * (0.99 - (turn * (x - 1.05)).cos());
        let g = move |x: f64| if x < 1.0 { 2.0 - x } else { dips(x) };
        let found = events(g, Direction::Both);
        // cos α = 0.99
        let half = 0.99_f64.acos() / turn;
        assert_eq!(found.len(), 2, "{found:?}");
        for (found, zero) in found.into_iter().zip([1.05 - half, 1.05 + half]) {
            // g has rounding errors of a few ε, and slopes of 3.5 at its zeros
            assert!(found.as_ref().is_ok_and(|t| (t - zero).abs() < 1e-14), "{found:?} {zero}");
        }
    }

    #[test]
    fn a_nan_ends_the_events() {
        let g = |x: f64| if x > 1.1 { f64::NAN } else { x - 0.9 };
        let found = events(g, Direction::Up);
        assert!(found[0].as_ref().is_ok_and(|t| (t - 0.9).abs() < 1e-15));
        // the samples at 1.25, 1.5, 1.75 and 2
        assert_eq!(found[1..], [Err(EventError::NotANumber { time: 1.25 }); 4]);
        // a NaN between the samples is found, too
        let g = |x: f64| {
            if x == 1.25 {
                1.0
            } else if x > 1.1 {
                f64::NAN
            } else {
                -1.0
            }
        };
        let found = events(g, Direction::Up);
        assert!(matches!(found[..], [Err(EventError::NotANumber { .. }), ..]));
        assert!(found.len() == 4 && found.iter().all(|event| *event == found[0]));
    }

    /// A skipped error is not lost, and a bounded run stays bounded.
    #[test]
    fn the_error_of_a_run_is_returned_until_the_run_ends() {
        // ẋ = x² from 1 blows up at t = 1
        let blow_up = from_fn(|x: &Vector1<f64>| Vector1::new(x[0] * x[0]));
        let midpoint = Direct::new(RungeKutta::implicit_midpoint(), blow_up);
        let run = || midpoint.trajectory_from(Vector1::x(), 0.1).take(100);
        let events = || Events::new(&midpoint, run(), |x: &Vector1<f64>| x[0] - 1.5, Direction::Up);
        let failed = |event| matches!(event, Some(Err(EventError::Integration(_))));
        assert!(events().next().is_some_and(|event| event.is_ok()));
        assert!(failed(events().nth(1)) && failed(events().nth(30)) && failed(events().last()));
        assert!(events().count() < 100);
    }
}
