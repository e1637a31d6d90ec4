//! The law suite of conserved functions.

use super::differences::at_least_one;
use super::{NoSamples, Report};
use crate::integrators::trajectories::integrator::Integrator;
use lie_poisson::{State, larger};

/// Evaluates the law `invariants`: an integrator conserves the given functions of the momentum.
///
/// The law is tested over 100 steps of one size from samples of states. The residual is relative to the larger of
/// |C(μ)| and the largest change of C when one coordinate of μ is doubled, so that C(μ) may be 0. It is NaN if a step
/// fails.
///
/// # Errors
/// Returns [`NoSamples`] if there are no states or no invariants.
///
/// # Example
/// ```
/// use collective_integrators::{Direct, RungeKutta, from_fn, laws};
/// use nalgebra::Vector2;
/// let oscillator = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x));
/// let energy = |z: &Vector2<f64>| z.norm_squared();
/// let residual = |scheme| {
///     let (direct, z) = (Direct::new(scheme, oscillator), Vector2::new(0.6, 0.8));
///     laws::invariants(&direct, &[z], 0.1, &[&energy])
/// };
/// residual(RungeKutta::implicit_midpoint())?.check(1e-13)?;
/// assert!(residual(RungeKutta::rk4())?.check(1e-8).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn invariants<V: State<Scalar = f64>, I: Integrator<Momentum = V>>(
    integrator: &I,
    states: &[I::State],
    step: f64,
    invariants: &[&dyn Fn(&V) -> f64],
) -> Result<Report, NoSamples> {
    at_least_one("states", states)?;
    at_least_one("invariants", invariants)?;
    let mut report = Report::default();
    for state in states {
        let start = integrator.momentum(state);
        for sample in integrator.trajectory_from(state.clone(), step).take(STEPS + 1) {
            let Ok(sample) = sample else {
                report.note("invariants", f64::NAN, 1.0);
                break;
            };
            for invariant in invariants {
                let change = invariant(&sample.momentum) - invariant(&start);
                report.note("invariants", change.abs(), size(invariant, &start));
            }
        }
    }
    Ok(report)
}

/// The number of steps of each run.
const STEPS: usize = 100;

/// Returns the largest of |C(μ)| and |C(ν) − C(μ)| over the ν in which one coordinate of μ is doubled.
fn size<V: State<Scalar = f64>>(invariant: &dyn Fn(&V) -> f64, mu: &V) -> f64 {
    let value = invariant(mu);
    let doubled = |i| {
        let mut doubled = mu.clone();
        doubled.set_coordinate(i, 2.0 * mu.coordinate(i));
        doubled
    };
    (0..mu.dimension())
        .fold(value.abs(), |size, i| larger(size, (invariant(&doubled(i)) - value).abs()))
}
