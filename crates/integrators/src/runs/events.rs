//! Events along a trajectory, such as Poincaré sections: [`Events`].

use crate::error::IntegrationError;
use crate::integrators::trajectories::integrator::{Integrator, SampleOf};
use crate::runs::crossing::Direction;
use crate::runs::event_search::EventSearch;
use crate::runs::event_values::EventError;

/// An iterator adaptor that returns the points of a trajectory where g(μ) crosses zero.
///
/// If g changes its sign between two samples, steps of partial size τ from the left one locate the zero: g(μ(Φ_τ(z))) =
/// 0 to round-off. The event is therefore as accurate as the integrator, and lies on the same level sets of conserved
/// quantities. Its `step` is the number of whole steps before it.
///
/// # What is a crossing
/// At a crossing g goes to zero and changes its sign:
///
/// * A change of sign at a jump or at a pole is no crossing. The residual on each side of the located point is compared
///   with g at the ends of the step, and with g at small distances from it. No unit plays a part, and a jump by less than
///   1e-6 of g at the ends is not recognised.
/// * A touch, as of (x − 1)² at x = 1, is no crossing, since its sign does not change. This holds wherever the samples
///   are, and also if g has the other sign by rounding alone.
/// * A function with a period, such as an angle, crosses every multiple of the period: see [`modulo`](Self::modulo).
/// * A start on the surface, where g is zero up to rounding, is no crossing, since the sign before it is not known:
///   [`counting_start`](Self::counting_start) counts it nevertheless.
///
/// # What is found
/// * One crossing in a step is found, and so is a crossing at a sample.
/// * Two crossings in a step are found if they are farther apart than about 1e-6 steps and the extremum between them is
///   the only one of g in this step. The step must resolve g: |g| at one of its ends must not exceed the change of g in
///   this step or in the step before. The first step of a run and steps that begin or end at a zero are always searched.
/// * Some crossings at smaller distances are missed: choose a step that resolves g.
///
/// The first and the last step of a run are searched as all others are, and each event is known with the first sample that
/// is not before it. The adaptor requests samples until there is an event or none are left: bound the run by `take`.
/// After an error it returns this error again for each remaining sample, so that `nth` and other adaptors that skip events
/// do not lose it. After `new` nothing is allocated, except for states on the heap. An event costs about ten steps, and so
/// does an extremum near zero without a crossing. A jump or a pole costs about sixty.
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
    /// The events of the last step that were not returned.
    found: [Option<SampleOf<I>>; 4],
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
        Self { search, samples, found: [const { None }; 4], failed: None }
    }

    /// Returns the points where g is a multiple of a period instead: see [`EventSearch::modulo`].
    ///
    /// # Example
    /// A vector that turns passes the angle π, where `atan2` jumps, and no other:
    /// ```
    /// use collective_integrators::{Direct, Direction, Events, RungeKutta, Start, from_fn};
    /// use nalgebra::Vector2;
    /// use std::f64::consts::{PI, TAU};
    /// let turning = from_fn(|z: &Vector2<f64>| Vector2::new(-z.y, z.x));
    /// let gauss = Direct::new(RungeKutta::gauss(5)?, turning);
    /// let run = gauss.trajectory(&Vector2::x(), 0.2)?.take(100);
    /// let angle = |z: &Vector2<f64>| z.y.atan2(z.x) - PI;
    /// let events: Vec<_> = Events::new(&gauss, run, angle, Direction::Up).modulo(TAU).collect();
    /// assert_eq!(events.len(), 3);
    /// for (k, event) in events.into_iter().enumerate() {
    ///     assert!((event?.time - (PI + TAU * k as f64)).abs() < 1e-13);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn modulo(self, period: f64) -> Self {
        Self { search: self.search.modulo(period), ..self }
    }

    /// Counts the start of the run, too, if it lies on the surface: see [`EventSearch::counting_start`].
    #[must_use]
    pub fn counting_start(self) -> Self {
        Self { search: self.search.counting_start(), ..self }
    }

    /// Proceeds by one sample, and keeps the events that it completes.
    fn advance(&mut self, sample: Result<SampleOf<I>, IntegrationError>) -> Result<(), EventError> {
        self.found = self.search.observe(&sample?)?;
        Ok(())
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
        loop {
            if let Some(event) = self.found.iter_mut().find_map(Option::take) {
                return Some(Ok(event));
            }
            let sample = self.samples.next()?;
            if let Err(error) = self.failed.map_or_else(|| self.advance(sample), Err) {
                self.failed = Some(error);
                return Some(Err(error));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrators::direct::Direct;
    use crate::schemes::runge_kutta::RungeKutta;
    use crate::vector_field::from_fn;
    use nalgebra::Vector1;

    /// Returns the events of g along x = t, t = 0, 0.25, …, 2, where the method does not round.
    fn events(g: impl Fn(f64) -> f64, direction: Direction) -> Vec<Result<f64, EventError>> {
        let clock =
            Direct::new(RungeKutta::explicit_midpoint(), from_fn(|_: &Vector1<f64>| Vector1::x()));
        let run = clock.trajectory_from(Vector1::zeros(), 0.25).take(9);
        let events = Events::new(&clock, run, |x: &Vector1<f64>| g(x[0]), direction);
        events.map(|event| event.map(|sample| sample.time)).collect()
    }

    /// The same events, and the start if it is on the surface.
    fn counting_start(
        g: impl Fn(f64) -> f64,
        direction: Direction,
    ) -> Vec<Result<f64, EventError>> {
        let clock =
            Direct::new(RungeKutta::explicit_midpoint(), from_fn(|_: &Vector1<f64>| Vector1::x()));
        let run = clock.trajectory_from(Vector1::zeros(), 0.25).take(9);
        let events = Events::new(&clock, run, |x: &Vector1<f64>| g(x[0]), direction);
        events.counting_start().map(|event| event.map(|sample| sample.time)).collect()
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
        // g = 0 at the start is no event, unless it is asked for
        assert_eq!(events(|x| x, Direction::Both), []);
        for (direction, counts) in
            [(Direction::Up, true), (Direction::Both, true), (Direction::Down, false)]
        {
            let found = counting_start(|x| x, direction);
            assert_eq!(found, if counts { vec![Ok(0.0)] } else { vec![] });
        }
        assert_eq!(counting_start(|x| x + 1e-3, Direction::Both), []);
    }

    /// A touch is no crossing, whether it lies at a sample, at the start or the end of the run, or between samples.
    #[test]
    fn touches_are_no_crossings() {
        for place in [0.0, 0.1, 0.25, 0.3, 1.0, 1.2, 1.75, 1.9, 2.0] {
            for sign in [1.0, -1.0] {
                let found =
                    |g: &dyn Fn(f64) -> f64| events(|x| sign * g(x - place), Direction::Both);
                assert_eq!(found(&|x| x * x), [], "{place}");
                assert_eq!(found(&|x| x * x * x * x), [], "{place}");
                assert_eq!(found(&|x| x.abs()), [], "{place}");
                // control: a crossing there
                let is_inside = place > 0.0;
                assert_eq!(found(&|x| x).len(), usize::from(is_inside), "{place}");
            }
        }
        // A touch on the way to a crossing in the same step.
        let found = events(|x| (x - 1.125) * (x - 1.125) * (x - 1.2), Direction::Both);
        assert!(matches!(found[..], [Ok(t)] if (t - 1.2).abs() < 1e-13), "{found:?}");
    }

    /// Changes of sign without a zero.
    #[test]
    fn jumps_and_poles_are_no_crossings() {
        for place in [0.03, 0.53, 1.0, 1.1, 1.999] {
            for size in [1e-30, 1.0, 1e30] {
                let none = |g: &dyn Fn(f64) -> f64| {
                    assert_eq!(events(|x| size * g(x - place), Direction::Both), [], "{place}");
                };
                none(&|x| if x < 0.0 { -1.0 } else { 1.0 });
                none(&|x| if x < 0.0 { -1.0 } else { 1e-4 });
                none(&|x| if x < 0.0 { x - 1e-4 } else { x + 1.0 });
                none(&|x| 1.0 / x);
                none(&|x| x.powi(-3));
                none(&|x| 1.0 / (x * x));
                none(&|x| -f64::signum(x) / x.abs().sqrt());
                // controls: zeros of any order
                let one = |g: &dyn Fn(f64) -> f64| {
                    let found = events(|x| size * g(x - place), Direction::Both);
                    assert!(matches!(found[..], [Ok(t)] if (t - place).abs() < 1e-9), "{found:?}");
                };
                one(&|x| x);
                one(&|x| x.cbrt());
                one(&|x| x * x * x);
                one(&|x| x.signum() * x.abs().sqrt());
                one(&|x| if x < 0.0 { 1e-6 * x } else { 1e3 * x });
            }
        }
    }

    /// A parabola dips below zero between the samples at 1 and 1.25.
    #[test]
    fn two_crossings_in_one_step_are_found() {
        let dip = |from: f64, to: f64| move |x: f64| (x - from) * (x - to);
        // near the left sample; near the right one; as far apart as a step allows (g is the same at both samples then,
        // and the crossings are found once); close together; in the first and in the last step; from and to samples
        for (from, to) in [
            (1.02, 1.08),
            (1.19, 1.23),
            (1.001, 1.249),
            (1.1, 1.1 + 2.5e-7),
            (0.02, 0.08),
            (0.001, 0.2499),
            (1.8, 1.9),
            (1.751, 1.9999),
            (1.0, 1.1),
            (1.1, 1.25),
            (1.0, 1.25),
            (1.75, 2.0),
        ] {
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
        // a dip that ends above zero is no event
        assert_eq!(events(|x| dip(1.02, 1.08)(x) + 1e-3, Direction::Both), []);
    }

    /// A start on the surface, and two crossings in the first step.
    #[test]
    fn two_crossings_beside_a_zero_are_found() {
        for zero in [0.0, 1.0] {
            for (from, to) in [(0.03, 0.05), (0.1, 0.24), (0.001, 0.01)] {
                let g = |x: f64| (x - zero) * (x - zero - from) * (x - zero - to);
                let found = events(g, Direction::Both);
                let expected = [zero, zero + from, zero + to];
                let expected = &expected[usize::from(zero == 0.0)..];
                let near = |(t, zero): (&Result<f64, EventError>, &f64)| {
                    t.as_ref().is_ok_and(|t| (t - zero).abs() < 1e-10)
                };
                assert!(
                    found.len() == expected.len() && found.iter().zip(expected).all(near),
                    "{found:?}"
                );
            }
        }
    }

    #[test]
    fn a_nan_ends_the_events() {
        let g = |x: f64| if x > 1.1 { f64::NAN } else { x - 0.9 };
        let found = events(g, Direction::Up);
        assert!(found[0].as_ref().is_ok_and(|t| (t - 0.9).abs() < 1e-15));
        // the samples at 1.25, 1.5, 1.75 and 2
        assert_eq!(found[1..], [Err(EventError::NotANumber { time: 1.25 }); 4]);
        // a single point without a value is a jump, or a zero if g goes to zero there
        assert_eq!(events(|x| (x - 1.1).abs() / (x - 1.1), Direction::Both), []);
        let found = events(|x| (x - 1.1) * (x - 1.1) / (x - 1.1), Direction::Both);
        assert!(matches!(found[..], [Ok(t)] if (t - 1.1).abs() < 1e-15), "{found:?}");
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
