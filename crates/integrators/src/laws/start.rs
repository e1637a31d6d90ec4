//! The law suite of [`Start`].

use super::differences::{
    NOT_FINITE, at_least_one, broken_unless, different_bits, largest, largest_difference,
    not_finite,
};
use super::{Faulty, NoSamples, Report};
use crate::integrators::trajectories::integrator::SampleOf;
use crate::integrators::trajectories::start::Start;
use lie_poisson::Real;
use momentum_map::LiftError;

/// Evaluates the laws of an integrator that starts from momenta, on samples of momenta and for one step size.
///
/// The laws are those of [`integrator`](super::integrator) for the states that represent the momenta, and
///
/// * `start`: the state that represents μ has the momentum μ;
/// * `first sample`: a trajectory from μ begins at t = 0 with that state;
/// * `after`: [`after`](Start::after) n steps returns sample n of the trajectory;
/// * `refusal`: a momentum or a step size that is infinite or not a number is an error.
///
/// The residual of `start` is NaN for a momentum that no state represents.
///
/// # Errors
/// Returns [`NoSamples`] if there are no samples.
///
/// # Example
/// ```
/// use collective_integrators::{LiftFree, RungeKutta, laws};
/// use lie_poisson::{Covector, LiePoisson, So3, from_closure};
/// use momentum_map::Quaternions;
/// use nalgebra::Vector3;
/// let h = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| pi.x * pi.x * 0.5 + pi.y * pi.y);
/// let gauss = LiftFree::new(RungeKutta::gauss(3)?, Quaternions, h);
/// laws::start(&gauss, &[Covector(Vector3::new(0.6, 0.0, 0.8))], 0.1)?.check(1e-13)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn start<I: Start>(
    integrator: &I,
    momenta: &[I::Momentum],
    step: f64,
) -> Result<Report, NoSamples> {
    at_least_one("momenta", momenta)?;
    let mut report = Report::default();
    for mu in momenta {
        let Ok(state) = integrator.start(mu) else {
            report.note("start", f64::NAN, 1.0);
            continue;
        };
        report.note("start", largest_difference(&integrator.momentum(&state), mu), largest(mu));
        trajectories(integrator, (mu, &state), step, &mut report);
        refusal(integrator, mu, step, &mut report);
        for (law, residual) in super::integrator(integrator, &[state], step)?.residuals() {
            report.note(law, *residual, 1.0);
        }
    }
    Ok(report)
}

/// The number of steps to the sample that is compared.
const STEPS: u64 = 12;

fn trajectories<I: Start>(
    integrator: &I,
    (mu, state): (&I::Momentum, &I::State),
    step: f64,
    report: &mut Report,
) {
    let sample = |n: u64| integrator.trajectory(mu, step).ok()?.nth(n as usize)?.ok();
    let begins = |first: SampleOf<I>| {
        (first.step, first.time) == (0, 0.0) && different_bits(&first.state, state) == 0.0
    };
    report.note("first sample", broken_unless(sample(0).is_some_and(begins)), 1.0);
    for n in [0, STEPS] {
        let residual = match (integrator.after(mu, step, n), sample(n)) {
            (Ok(a), Some(b)) => different_bits(&a.state, &b.state) + broken_unless(a.step == n),
            _ => f64::NAN,
        };
        report.note("after", residual, 1.0);
    }
}

fn refusal<I: Start>(integrator: &I, mu: &I::Momentum, step: f64, report: &mut Report) {
    let bad_momenta = not_finite(mu).map(|bad| (bad, step));
    for (mu, step) in bad_momenta.chain(NOT_FINITE.map(|bad| (mu.clone(), bad))) {
        report.note("refusal", broken_unless(integrator.trajectory(&mu, step).is_err()), 1.0);
        report.note("refusal", broken_unless(integrator.after(&mu, step, 0).is_err()), 1.0);
    }
}

/// The start has no fault. The steps may have one.
impl<T: Real, I: Start<T>> Start<T> for Faulty<'_, I> {
    fn start(&self, mu: &I::Momentum) -> Result<I::State, LiftError> {
        self.object().start(mu)
    }
}
