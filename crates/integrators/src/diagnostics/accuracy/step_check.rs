//! A run checked by runs with half the step and with twice the step: [`check_by_half_steps`].

use super::error_growth::of_whole_step;
use super::relative_distance::RelativeDistance;
use super::sampled_run::SampledRun;
use super::system_scales::SystemScales;
use crate::erased::AnyIntegrator;
use crate::error::RunError;
use core::fmt;
use lie_poisson::larger;

/// The number of samples at which the runs are compared.
const SAMPLES: u64 = 64;

/// The least difference of two runs that shows an order; below it there may be round-off alone.
const ROUND_OFF: f64 = 1e-12;

/// The result of a check of a whole run.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct StepCheck {
    /// The error at the end of the run: the largest |Δμ_b|/|μ_b| over the blocks b of coordinates, at most 1. It is `None`
    /// if it is not a number, since the differential of the Hamiltonian has no value.
    pub error: Option<f64>,
    /// The order with which the run converges: log₂ of the ratio of the differences between runs with the steps 2h, h and
    /// h/2, or the reason why there is none.
    pub order: Result<f64, NoOrder>,
}

/// The reason why a check shows no order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum NoOrder {
    /// The run has one step, or none: twice the step does not fit into it.
    OneStep,
    /// The difference between the runs with h and with h/2 is round-off.
    RoundOff,
    /// The run with twice the step fails.
    DoubleStep,
    /// The differences have no ratio, since one of them is not a number, or zero.
    NoRatio,
}

/// In words, without a full stop.
impl fmt::Display for NoOrder {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str(match self {
            Self::OneStep => "twice the step does not fit into the run",
            Self::RoundOff => "the differences are round-off",
            Self::DoubleStep => "the run with twice the step fails",
            Self::NoRatio => "the differences have no ratio",
        })
    }
}

/// Checks a run of `steps` steps of size `step` from the start with these coordinates, by a method of this order.
///
/// The whole run is made with the step h, with h/2, and with 2h. The error is the difference of the first two at the end,
/// times 2ᵖ/(2ᵖ − 1). The order tells whether to believe it: near that of the method the steps are short enough, far below
/// it they are not, or the motion is chaotic and the run too long. The check costs three and a half times the run.
///
/// Returns `None` if `going`, which is asked every 1024 steps, tells it to end.
///
/// # Errors
/// Returns the [`RunError`] of a step that fails with the step h or h/2.
///
/// # Example
/// ```
/// use collective_integrators::diagnostics::{SystemScales, check_by_half_steps};
/// use collective_integrators::{AnyIntegrator, Direct, RungeKutta, from_fn};
/// use core::ops::Range;
/// use nalgebra::Vector2;
///
/// struct Oscillator;
///
/// impl SystemScales for Oscillator {
///     fn blocks(&self) -> Vec<Range<usize>> {
///         vec![0..2]
///     }
///     fn differential(&self, z: &[f64]) -> Vec<f64> {
///         z.to_vec()
///     }
///     fn fastest_rate(&self, _: &[f64]) -> f64 {
///         1.0
///     }
/// }
///
/// let field = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x));
/// let rk4 = AnyIntegrator::new(Direct::new(RungeKutta::rk4(), field), 2);
/// let check = check_by_half_steps(&rk4, &Oscillator, &[1.0, 0.0], (0.1, 100), 4, &|| true)?;
/// let check = check.ok_or("it was not told to end")?;
/// // RK4 is behind by h⁴/120 per unit of time: 8.3e-6 at t = 10.
/// assert!(check.error.is_some_and(|error| (error / 8.3e-6 - 1.0).abs() < 0.1), "{check:?}");
/// assert!(check.order.is_ok_and(|order| (order - 4.0).abs() < 0.1), "{check:?}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn check_by_half_steps(
    integrator: &AnyIntegrator,
    system: &dyn SystemScales,
    start: &[f64],
    (step, steps): (f64, u64),
    order: u16,
    going: &dyn Fn() -> bool,
) -> Result<Option<StepCheck>, RunError> {
    // Pairs of steps, which twice the step reaches, and then the end.
    let pairs = move |sample: u64| {
        (u128::from(steps / 2) * u128::from(sample) / u128::from(SAMPLES)) as u64
    };
    let pairs = || (1..=SAMPLES).map(pairs);
    let run = |size: f64, at: &mut dyn Iterator<Item = u64>| {
        SampledRun::new(integrator, start, size, at, going)
    };
    let Some(whole) = run(step, &mut pairs().map(|n| 2 * n).chain([steps]))? else {
        return Ok(None);
    };
    let halves = pairs().map(|n| 4 * n).chain([steps.saturating_mul(2)]);
    let Some(half) = run(0.5 * step, &mut { halves })? else { return Ok(None) };
    let double = match run(2.0 * step, &mut pairs()) {
        _ if steps < 2 => Err(NoOrder::OneStep),
        Ok(None) => return Ok(None),
        Ok(Some(double)) => Ok(double),
        Err(_) => Err(NoOrder::DoubleStep),
    };
    Ok(Some(compare(system, start, order, [&whole, &half], double.as_ref())))
}

fn compare(
    system: &dyn SystemScales,
    start: &[f64],
    order: u16,
    [whole, half]: [&SampledRun; 2],
    double: Result<&SampledRun, &NoOrder>,
) -> StepCheck {
    let momenta = core::iter::once(start).chain(half.momenta());
    let distance = RelativeDistance::new(system, momenta);
    let differences = |one: &SampledRun, other: &SampledRun| {
        let both = one.momenta().zip(other.momenta()).take(SAMPLES as usize);
        both.map(|(a, b)| distance.between(a, b)).fold(0.0, larger)
    };
    let end = whole.momenta().zip(half.momenta()).last();
    let error = end.map_or(0.0, |(a, b)| of_whole_step(distance.between(a, b), order));
    let fine = differences(whole, half);
    let order = double.map_err(|reason| *reason).and_then(|double| {
        let order = (differences(double, whole) / fine).log2();
        match fine <= ROUND_OFF {
            true => Err(NoOrder::RoundOff),
            false if order.is_finite() => Ok(order),
            false => Err(NoOrder::NoRatio),
        }
    });
    StepCheck { error: (!error.is_nan()).then(|| error.min(1.0)), order }
}
