//! How much a run magnifies small errors: [`Sensitivity`].

use super::relative_distance::RelativeDistance;
use crate::erased::{AnyIntegrator, AnyState};
use crate::error::RunError;
use crate::integrators::trajectories::integrator::Integrator;
use crate::integrators::trajectories::start::Start;
use lie_poisson::larger;

/// The least number of parts of a run after which the distances of its neighbours are made small again, and the largest number of
/// steps of a part: few, so that the distances stay small.
const PARTS: u64 = 64;
const STEPS: u64 = 64;

/// The distance of the neighbour, relative to the sizes of the blocks: rounding errors are far smaller, and what is quadratic
/// in it is no larger than these.
const DISTANCE: f64 = 1e-8;

/// The relative rounding error of a state, which the motion magnifies.
const ROUNDING: f64 = 1e-16;

/// The share of the run from which on the growth is fitted.
const FITTED_FROM: f64 = 0.375;

/// The share of its distance up to which one of two opposite neighbours may differ from the other. If stages are solved to a
/// tolerance, the differences are noise.
const ODD: f64 = 0.5;

/// The power of the time above which a growth is no power: errors of motions without chaos grow by 1 or 2.
const MOST_POWER: f64 = 2.6;

/// The growth of a small distance between two neighbouring runs.
pub(super) struct Sensitivity {
    /// The logarithm of the largest growth until the end of each part.
    logarithms: Vec<f64>,
}

impl Sensitivity {
    /// Returns the number of parts and of the steps of each for so many steps.
    pub(super) fn parts(steps: u64) -> [u64; 2] {
        let of_part = (steps / PARTS).clamp(1, STEPS);
        [steps / of_part, of_part]
    }

    /// Follows a run and two opposite neighbours, which are brought back to a small distance after each part (Benettin). Returns
    /// `None` if `going` tells it to end, if a distance is zero or no number, or if the neighbours do not stay opposite, so
    /// that the distances are noise.
    ///
    /// # Errors
    /// Returns the [`RunError`] of a start or a step that fails: not every neighbour of a start has a lift.
    pub(super) fn of(
        integrator: &AnyIntegrator,
        start: &[f64],
        distance: &RelativeDistance,
        (step, [parts, steps_of_part]): (f64, [u64; 2]),
        going: &dyn Fn() -> bool,
    ) -> Result<Option<Self>, RunError> {
        let mut workspaces = [(); 3].map(|()| integrator.workspace());
        let mut state = integrator.start(&AnyState::from_slice(start))?;
        let neighbour = distance.displaced(start, DISTANCE);
        let first = distance.between(start, &neighbour);
        let mut neighbours = [neighbour.clone(), mirrored(&neighbour, start, -1.0)];
        let (mut sum, mut most) = ((DISTANCE / first).ln(), f64::NEG_INFINITY);
        let mut logarithms = Vec::new();
        for part in 0..parts {
            if !going() {
                return Ok(None);
            }
            let steps = part * steps_of_part..(part + 1) * steps_of_part;
            let [workspace, others @ ..] = &mut workspaces;
            integrator.advance(&mut state, step, steps.clone(), workspace)?;
            let here = integrator.momentum(&state);
            let here = here.as_slice();
            let mut moved = [Vec::new(), Vec::new()];
            for ((moved, from), workspace) in moved.iter_mut().zip(&neighbours).zip(others) {
                let mut beside = integrator.start(&AnyState::from_slice(from))?;
                integrator.advance(&mut beside, step, steps.clone(), workspace)?;
                *moved = integrator.momentum(&beside).as_slice().to_vec();
            }
            let [one, other] = &moved;
            let apart = distance.between(here, one);
            let odd = distance.between(other, &mirrored(one, here, -1.0));
            if !(apart > 0.0 && apart.is_finite() && odd <= ODD * apart) {
                return Ok(None);
            }
            sum += (apart / DISTANCE).ln();
            most = larger(most, sum);
            logarithms.push(most);
            neighbours = [1.0, -1.0].map(|side| mirrored(one, here, side * DISTANCE / apart));
            neighbours.iter_mut().for_each(|neighbour| neighbour.truncate(start.len()));
        }
        Ok(Some(Self { logarithms }))
    }

    /// Returns the rate of the growth per length of the followed run, if the run is chaotic: if the growth is faster than every
    /// power of the time that motions without chaos have.
    pub(super) fn rate(&self) -> Option<f64> {
        let parts = self.logarithms.len() as f64;
        let ends = (1..).map(|part| f64::from(part) / parts);
        let fitted = (FITTED_FROM * parts) as usize;
        let points: Vec<(f64, f64)> =
            ends.zip(self.logarithms.iter().copied()).skip(fitted).collect();
        let count = points.len() as f64;
        let mean = |f: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / count;
        let slope = |x: &dyn Fn(f64) -> f64| {
            let (middle, height) = (mean(&|p| x(p.0)), mean(&|p| p.1));
            mean(&|p| (x(p.0) - middle) * (p.1 - height)) / mean(&|p| (x(p.0) - middle).powi(2))
        };
        (slope(&f64::ln) > MOST_POWER).then(|| slope(&|t| t))
    }

    /// Returns the error of a run that is `whole` times as long, as far as rounding causes it.
    pub(super) fn rounding(&self, whole: f64) -> f64 {
        let last = self.logarithms.last().copied().unwrap_or_default();
        let more = match self.rate() {
            Some(rate) => rate * (whole - 1.0),
            None => whole.ln(),
        };
        ROUNDING * (last + more.max(0.0)).exp()
    }
}

/// Returns the point whose distance from `here` is that of `there`, times a factor.
fn mirrored(there: &[f64], here: &[f64], factor: f64) -> Vec<f64> {
    here.iter().zip(there).map(|(here, there)| here + (there - here) * factor).collect()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn rate(growth: impl Fn(f64) -> f64) -> Option<f64> {
        let ends = (1..=PARTS).map(|part| part as f64 / PARTS as f64);
        Sensitivity { logarithms: ends.map(|t| growth(t).ln()).collect() }.rate()
    }

    #[test]
    fn exponentials_are_chaos_and_powers_are_not() {
        assert!((rate(|t| (20.0 * t).exp()).unwrap() - 20.0).abs() < 1e-9);
        assert_eq!(rate(|t| 1e8 * t * t), None);
        // A motion that flips over once and then repeats itself.
        assert_eq!(rate(|t| 1e8_f64.min((200.0 * t).exp()) * (1.0 + t)), None);
    }

    #[test]
    fn rounding_grows_with_the_run() {
        let of = |growth: &dyn Fn(f64) -> f64, whole: f64| {
            let ends = (1..=PARTS).map(|part| part as f64 / PARTS as f64);
            Sensitivity { logarithms: ends.map(|t| growth(t).ln()).collect() }.rounding(whole)
        };
        let regular = of(&|t| 100.0 * t, 10.0);
        assert!((regular / 1e-13 - 1.0).abs() < 1e-9, "{regular:e}");
        let chaotic = of(&|t| (10.0 * t).exp(), 3.0);
        assert!((chaotic / (1e-16 * 30.0_f64.exp()) - 1.0).abs() < 1e-9, "{chaotic:e}");
    }
}
