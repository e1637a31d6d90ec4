//! The parts of a step of a driven and noisy motion: [`StepParts`].

use crate::error::StepError;
use crate::open_systems::noise_rule::{MOST_FIELDS, NoisePart, NoiseRule};
use crate::open_systems::paths::brownian_paths::{BrownianPaths, MOST_LANES};
use crate::open_systems::smooth_pieces::{Window, smooth_pieces};
use lie_poisson::Real;
use smallvec::{SmallVec, smallvec};

/// How a step is divided at the breakpoints of a field, and by the rule of the noise: for integrators of one's own, on states that
/// contain the number of the path and the time in intervals, as those of [`Noisy`](crate::Noisy).
///
/// # Example
/// A number x that a held input u drives, u = 1 until t = 0.25 and 3 afterwards:
/// ```
/// use collective_integrators::{StepError, StepParts};
/// let input = |time: f64| if time < 0.25 { 1.0 } else { 3.0 };
/// let next_break = |time: f64, forward: bool| match forward {
///     true => (time < 0.25).then_some(0.25),
///     false => (time > 0.25).then_some(0.25),
/// };
/// let (mut x, mut t) = (0.0, 0.0);
/// StepParts { interval: 1.0, noise: None }.make((0.0, 0.0), 1.0, next_break, |window, part| {
///     x += part.step * input(window.nearest(t + 0.5 * part.step)); // the midpoint rule
///     t += part.step;
///     Ok(1)
/// })?;
/// assert_eq!(x, 0.25 + 0.75 * 3.0);
/// # Ok::<(), StepError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct StepParts<'a> {
    /// The length of an interval, the unit of the times of states.
    pub interval: f64,
    /// The Brownian motions, their rule, and the number of the fields of the noise, if there is noise.
    pub noise: Option<(&'a BrownianPaths, NoiseRule, usize)>,
}

impl StepParts<'_> {
    /// Makes the parts of a step one after the other, from a path and a time in intervals, and returns the sum of what they
    /// return. `next_break` returns the next breakpoint strictly after a time, or strictly before it.
    ///
    /// # Errors
    /// That of the part that fails.
    #[cfg_attr(optimised, inline(always))]
    pub fn make<T: Real>(
        &self,
        (path, clock): (T, T),
        step: f64,
        next_break: impl Fn(f64, bool) -> Option<f64>,
        mut part: impl FnMut(Window<T>, NoisePart<'_, T>) -> Result<usize, StepError>,
    ) -> Result<usize, StepError> {
        let interval = self.interval;
        smooth_pieces(
            clock * interval,
            step,
            next_break,
            #[cfg_attr(optimised, inline(always))]
            |window, elapsed, step| {
                let Some((paths, rule, fields)) = self.noise else {
                    return part(window, NoisePart { drift: 1.0, weights: &[], step });
                };
                let between = [elapsed, elapsed + step].map(|time| time / interval);
                let mut increments: SmallVec<[T; MOST_FIELDS]> =
                    smallvec![T::zero(); rule.components(fields)];
                write_increments(paths, (path, clock), between.into(), &mut increments);
                rule.parts(
                    &increments,
                    step,
                    #[cfg_attr(optimised, inline(always))]
                    |noise| part(window, noise),
                )
            },
        )
    }
}

/// The number of increments of all lanes up to which a step allocates nothing.
const MOST_NUMBERS: usize = 8 * MOST_FIELDS;

/// Writes the increments of the components of a path in each lane, between two times after that of the clock.
#[cfg_attr(optimised, inline(always))]
fn write_increments<T: Real>(
    paths: &BrownianPaths,
    (path, clock): (T, T),
    (from, to): (f64, f64),
    increments: &mut [T],
) {
    if !T::HAS_SLOW_PATHS {
        let mut lanes: SmallVec<[(u64, f64); MOST_LANES]> = SmallVec::new();
        let mut are_whole = true;
        let _ = path.lane_by_lane(clock, |path, clock| {
            let begin = clock + from;
            are_whole &= path.is_finite() && begin.floor() == begin && clock + to - begin == 1.0;
            lanes.push((path as u64, begin));
            begin
        });
        if are_whole {
            return paths.write_whole::<T>(&lanes, increments);
        }
    }
    write_lane_by_lane(paths, (path, clock), (from, to), increments);
}

/// Writes the increments lane by lane.
fn write_lane_by_lane<T: Real>(
    paths: &BrownianPaths,
    (path, clock): (T, T),
    (from, to): (f64, f64),
    increments: &mut [T],
) {
    let count = increments.len();
    let mut lanes: SmallVec<[f64; MOST_NUMBERS]> = SmallVec::new();
    let mut begin = |path: f64, clock: f64| {
        let first = lanes.len();
        lanes.resize(first + count, 0.0);
        let lane = lanes.get_mut(first..).unwrap_or_default();
        match path.is_finite() {
            true => paths.write_increments(path as u64, clock + from, clock + to, lane),
            false => lane.fill(f64::NAN),
        }
        0.0
    };
    let zero = path.lane_by_lane(clock, &mut begin);
    for (k, increment) in increments.iter_mut().enumerate() {
        let mut place = k;
        *increment = zero.lane_by_lane(zero, |_, _| {
            let value = lanes.get(place).copied().unwrap_or(f64::NAN);
            place += count;
            value
        });
    }
}
