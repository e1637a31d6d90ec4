//! The accuracy of a run: [`run_accuracy`].

use super::error_growth::{PIECES, growth, of_whole_step};
use super::relative_distance::RelativeDistance;
use super::reported_accuracy::RunAccuracy;
use super::sampled_run::SampledRun;
use super::sensitivity::Sensitivity;
use super::system_scales::SystemScales;
use crate::erased::AnyIntegrator;
use crate::error::RunError;
use crate::stages::checkpoints::CHECKPOINT;
use lie_poisson::larger;

/// The number of steps up to which the whole run is repeated.
const WHOLE: u64 = 5 * CHECKPOINT;

/// The share of a longer run that is repeated: one of so many parts of it.
const PARTS: u64 = 20;

/// The largest number of steps that are repeated.
const LONGEST: u64 = 1 << 18;

/// The number of samples at which the runs are compared.
const SAMPLES: u64 = 64;

/// The number of coordinates up to which so many samples are kept, and so many steps repeated. Of larger systems, whose
/// steps and samples cost as much more, there are as many fewer.
const FEW: u64 = 1 << 12;

/// The least number of repeated steps with which neighbours are followed.
const LEAST: u64 = 128;

/// The largest angle of the longer steps by which the growth of errors is followed, rad.
const MOST_TURN: f64 = 0.5;

/// How a run is repeated.
#[derive(Clone, Copy)]
struct Effort {
    /// The number of samples, a multiple of [`PIECES`].
    samples: u64,
    /// The number of steps that are repeated.
    repeated: u64,
}

impl Effort {
    /// Returns that of a run of so many steps with so many coordinates.
    fn of(steps: u64, dimension: usize) -> Self {
        let larger = (dimension as u64).div_ceil(FEW).max(1);
        let pieces = PIECES as u64;
        let samples = (SAMPLES / larger / pieces).max(1) * pieces;
        let [whole, longest] = [WHOLE, LONGEST].map(|most| (most / larger).max(samples));
        Self { samples, repeated: steps.min((steps / PARTS).clamp(whole, longest)) }
    }
}

/// Measures the accuracy of a run of `steps` steps of size `step` from the start with these coordinates, by a method of
/// this order.
///
/// A run of up to 5120 steps is repeated, with the step h and with h/2. The error of the run is the largest difference
/// d(t) of the two, times 2ᵖ/(2ᵖ − 1). Of a longer run only the beginning is repeated, 5120 steps or a twentieth of the
/// run, and at most 2¹⁸ steps; the error is then scaled to the whole run by the growth of d: by the power of the time
/// that fits it, from 1 to 2, or by an exponential, if d grows faster and is no round-off. Of a longer
/// run, and of one with an error above 10⁻³, the growth of the distances of two opposite neighbours is measured, too, with steps
/// of up to 0.5 rad, which show more of the run: the error is at least that to which the motion magnifies rounding errors of 10⁻¹⁶.
/// In chaotic motion, and about an unstable rotation, it grows as exp(λt), and is 1 after some 37/λ, with every step. If they
/// cannot be followed, or do not stay opposite, the estimate is that without them. It costs four and a half times the steps that it
/// repeats: 23 % of a long run, and three to four and a half times a run of up to 5120 steps. Of a system of more than 4096 coordinates as
/// many fewer steps are repeated as it is larger, but 8 at least, and no neighbours are followed; neither are they where fewer than 128 steps are repeated.
///
/// On integrable and on chaotic tops, for methods of order 2, 4 and 8 and steps from 0.02 to 1 rad, it was between 1/3 and
/// 3 times the true error where that is above 10⁻¹², as measured before neighbours were followed, with one exception: a weakly
/// chaotic top had an estimate of 0.03 where everything was wrong. What happens only beyond the part over which the neighbours
/// are followed is not seen.
///
/// The repetitions do not change the run: they begin again from the start. If a step of them fails, or a distance is not a
/// number, or the run has no steps, or `going`, which is asked every 4096 steps at least, tells them to end, there is no
/// estimate, and the angle is that at the start.
///
/// # Example
/// The pendulum of length 1, by the midpoint rule with 20 steps per unit of time:
/// ```
/// use collective_integrators::diagnostics::{SystemScales, run_accuracy};
/// use collective_integrators::{AnyIntegrator, Direct, RungeKutta, from_fn};
/// use core::ops::Range;
/// use nalgebra::Vector2;
///
/// struct Pendulum;
///
/// impl SystemScales for Pendulum {
///     fn blocks(&self) -> Vec<Range<usize>> {
///         vec![0..1, 1..2] // the angle and its momentum
///     }
///     fn differential(&self, z: &[f64]) -> Vec<f64> {
///         vec![z[0].sin(), z[1]]
///     }
///     fn fastest_rate(&self, _: &[f64]) -> f64 {
///         1.0
///     }
/// }
///
/// let pendulum = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x.sin()));
/// let midpoint = AnyIntegrator::new(Direct::new(RungeKutta::implicit_midpoint(), pendulum), 2);
/// let accuracy = run_accuracy(&midpoint, &Pendulum, &[1.0, 0.0], (0.05, 2000), 2, &|| true);
/// // After a period, 6.6999756643705, the pendulum is back at its start: 15 periods are 2010 steps.
/// assert_eq!(accuracy.angle, 0.05);
/// assert!(accuracy.error.is_some_and(|error| 0.005 < error && error < 0.03), "{accuracy:?}");
/// assert!(accuracy.warning().is_some_and(|text| text.contains("a step of ")));
///
/// let gauss = AnyIntegrator::new(Direct::new(RungeKutta::gauss(4)?, pendulum), 2);
/// let accuracy = run_accuracy(&gauss, &Pendulum, &[1.0, 0.0], (0.05, 2000), 8, &|| true);
/// assert!(accuracy.error.is_some_and(|error| error < 1e-12), "{accuracy:?}");
/// assert_eq!(accuracy.warning(), None);
/// # Ok::<(), collective_integrators::SchemeError>(())
/// ```
pub fn run_accuracy(
    integrator: &AnyIntegrator,
    system: &dyn SystemScales,
    start: &[f64],
    (step, steps): (f64, u64),
    order: u16,
    going: &dyn Fn() -> bool,
) -> RunAccuracy {
    let effort = Effort::of(steps, start.len());
    let runs = match steps {
        0 => None,
        _ => both(integrator, start, (step, effort), going).ok(),
    };
    let compared = compare(system, start, (step, steps), order, runs.map(|runs| (effort, runs)));
    let Compared { accuracy, part: Some((distance, of_part)) } = compared else {
        return compared.accuracy;
    };
    match accuracy.error {
        // Of a short run the differences show all, unless they are large.
        Some(error) if steps > effort.repeated || error > RunAccuracy::MOST_ERROR => {
            let parts = (&distance, of_part);
            let magnified = magnified(integrator, start, &accuracy, (steps, effort), parts, going);
            let Some(Magnified { error: more, chaos }) = magnified else { return accuracy };
            let error = two_digits(larger(error, more).min(1.0));
            RunAccuracy { error, chaos, ..accuracy }
        }
        _ => accuracy,
    }
}

/// What the motion makes of small errors.
struct Magnified {
    /// The error at the end.
    error: f64,
    /// The time in which errors grow e-fold, if the motion is chaotic and rounding errors become large.
    chaos: Option<f64>,
}

/// Returns the error at the end of a long run to which its motion magnifies the error of the part that was repeated, and
/// rounding errors; `None` if the growth of errors is not known.
///
/// Differences that are round-off at first hide how fast they grow. So neighbouring runs are followed, with longer steps, which
/// show more of the run.
fn magnified(
    integrator: &AnyIntegrator,
    start: &[f64],
    accuracy: &RunAccuracy,
    (steps, effort): (u64, Effort),
    (distance, of_part): (&RelativeDistance, f64),
    going: &dyn Fn() -> bool,
) -> Option<Magnified> {
    // Of a large system, of which few steps are repeated, as many more would take far longer.
    if effort.repeated < LEAST || start.len() as u64 > FEW {
        return None;
    }
    let [parts, of_each] = Sensitivity::parts(effort.repeated / 2);
    let most = steps as f64 / (parts * of_each) as f64;
    let longer = (MOST_TURN / accuracy.angle).clamp(1.0, most.max(1.0));
    let course = (accuracy.step * longer, [parts, of_each]);
    let grown = Sensitivity::of(integrator, start, distance, course, going).ok()??;
    let followed = longer * (parts * of_each) as f64;
    let rest = steps.saturating_sub(effort.repeated) as f64 / followed;
    let of_part = grown.rate().map_or(0.0, |rate| of_part * (rate * rest).exp());
    let rounding = grown.rounding(steps as f64 / followed);
    let is_large = rounding > RunAccuracy::MOST_ERROR;
    let chaos = grown.rate().filter(|_| is_large).map(|rate| followed * accuracy.step.abs() / rate);
    Some(Magnified { error: larger(of_part, rounding), chaos })
}

/// Makes the beginning of the run with the step and with half of it.
fn both(
    integrator: &AnyIntegrator,
    start: &[f64],
    (step, Effort { samples, repeated }): (f64, Effort),
    going: &dyn Fn() -> bool,
) -> Result<[Option<SampledRun>; 2], RunError> {
    let run = |step: f64, halves: u64| {
        let at = (1..=samples).map(|sample| halves * share(repeated, (sample, samples)));
        SampledRun::new(integrator, start, step, at, going)
    };
    let whole = run(step, 1)?;
    let half = if whole.is_some() { run(0.5 * step, 2)? } else { None };
    Ok([whole, half])
}

/// Returns a part of the steps.
fn share(steps: u64, (sample, samples): (u64, u64)) -> u64 {
    (u128::from(steps) * u128::from(sample) / u128::from(samples)) as u64
}

/// What two runs tell: the accuracy, and the distance of momenta with the error of the part.
struct Compared {
    accuracy: RunAccuracy,
    part: Option<(RelativeDistance, f64)>,
}

/// Compares the two runs.
fn compare(
    system: &dyn SystemScales,
    start: &[f64],
    (step, steps): (f64, u64),
    order: u16,
    runs: Option<(Effort, [Option<SampledRun>; 2])>,
) -> Compared {
    let turn = |mu: &[f64]| step.abs() * system.fastest_rate(mu);
    let unknown = || {
        let accuracy = RunAccuracy { step, order, angle: turn(start), error: None, chaos: None };
        Compared { accuracy, part: None }
    };
    let Some((Effort { samples, repeated }, [Some(whole), Some(half)])) = runs else {
        return unknown();
    };
    let momenta = || core::iter::once(start).chain(half.momenta());
    let angle = momenta().map(turn).fold(0.0, larger);
    let distance = RelativeDistance::new(system, momenta());
    let mut errors = [0.0_f64; PIECES];
    for (sample, (a, b)) in whole.momenta().zip(half.momenta()).enumerate() {
        if let Some(most) = errors.get_mut(sample * PIECES / samples as usize) {
            *most = larger(*most, distance.between(a, b));
        }
    }
    let largest = errors.iter().copied().fold(0.0, larger);
    if largest.is_nan() || angle.is_nan() {
        return unknown();
    }
    let whole = steps as f64 / repeated.max(1) as f64;
    let of_part = of_whole_step(largest, order);
    let error = two_digits((of_part * growth(&errors, whole)).min(1.0));
    let accuracy = RunAccuracy { step, order, angle, error, chaos: None };
    Compared { accuracy, part: Some((distance, of_part)) }
}

/// Rounds to two digits: an estimate has no more, and they do not depend on the processor.
fn two_digits(error: f64) -> Option<f64> {
    format!("{error:.1e}").parse().ok().filter(|error: &f64| error.is_finite())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::diagnostics::{NoOrder, StepCheck, check_by_half_steps};
    use crate::integrators::direct::Direct;
    use crate::schemes::runge_kutta::RungeKutta;
    use crate::vector_field::from_fn;
    use core::cell::Cell;
    use core::ops::Range;
    use nalgebra::Vector2;

    /// An oscillator, whose differential has no value beyond some x.
    struct Oscillator(f64);

    impl SystemScales for Oscillator {
        fn blocks(&self) -> Vec<Range<usize>> {
            vec![0..1, 1..2]
        }

        fn differential(&self, z: &[f64]) -> Vec<f64> {
            let x = if z[0] > self.0 { f64::NAN } else { z[0] };
            vec![x, z[1]]
        }

        fn fastest_rate(&self, _: &[f64]) -> f64 {
            1.0
        }
    }

    const START: [f64; 2] = [0.0, 1.0];

    fn accuracy(most: f64, steps: u64, going: &dyn Fn() -> bool) -> RunAccuracy {
        let field = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x));
        let midpoint = AnyIntegrator::new(Direct::new(RungeKutta::implicit_midpoint(), field), 2);
        run_accuracy(&midpoint, &Oscillator(most), &START, (0.1, steps), 2, going)
    }

    #[test]
    fn an_estimate_ends_where_it_is_told_to() {
        let asked = Cell::new(0);
        let going = || {
            asked.set(asked.get() + 1);
            asked.get() < 3
        };
        assert_eq!((accuracy(9.0, 1_000_000, &going).error, asked.get()), (None, 3));
        // Control: without that there is an estimate.
        assert!(accuracy(9.0, 1000, &|| true).error.is_some());
    }

    #[test]
    fn what_is_not_a_number_is_no_estimate() {
        assert_eq!(accuracy(0.5, 100, &|| true).error, None);
    }

    #[test]
    fn a_check_says_why_it_shows_no_order() {
        let check = |step: f64, steps: u64, most: f64| -> StepCheck {
            let field = from_fn(|z: &Vector2<f64>| {
                // The field ends at an x to which only stages of long steps come.
                Vector2::new(if z.x > 1.09 { f64::NAN } else { z.y }, -z.x)
            });
            let rk4 = AnyIntegrator::new(Direct::new(RungeKutta::rk4(), field), 2);
            let scales = Oscillator(most);
            check_by_half_steps(&rk4, &scales, &START, (step, steps), 4, &|| true).unwrap().unwrap()
        };
        assert_eq!(check(0.1, 1, 9.0).order, Err(NoOrder::OneStep));
        assert_eq!(check(1e-4, 100, 9.0).order, Err(NoOrder::RoundOff));
        assert_eq!(check(0.6, 13, 9.0).order, Err(NoOrder::DoubleStep));
        let not_a_number = check(0.1, 100, 0.5);
        assert_eq!((not_a_number.error, not_a_number.order), (None, Err(NoOrder::NoRatio)));
        let usual = check(0.1, 100, 9.0);
        assert!(usual.order.is_ok_and(|order| (order - 4.0).abs() < 0.2), "{usual:?}");
        assert!(usual.error.is_some_and(|error| 1e-6 < error && error < 1e-4), "{usual:?}");
    }
}
