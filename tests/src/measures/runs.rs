//! Runs of a trajectory, to their end or by their extremes.

use collective_integrators::Start;
use lie_poisson::larger;
use std::error::Error;

/// Returns the momentum after `steps` steps of size `step`.
///
/// # Errors
/// If there is no lift, or a step fails.
pub fn advance<I: Start>(
    integrator: &I,
    mu: &I::Momentum,
    step: f64,
    steps: usize,
) -> Result<I::Momentum, Box<dyn Error>> {
    let mut last = mu.clone();
    for sample in integrator.trajectory(mu, step)?.take(steps + 1) {
        last = sample?.momentum;
    }
    Ok(last)
}

/// Returns max |f(μ_n) − f(μ_0)| over `steps` steps; NaN if it is NaN at any step.
///
/// # Errors
/// If there is no lift, or a step fails.
pub fn largest_deviation<I: Start>(
    integrator: &I,
    mu: &I::Momentum,
    step: f64,
    steps: usize,
    f: impl Fn(&I::Momentum) -> f64,
) -> Result<f64, Box<dyn Error>> {
    let start = f(mu);
    let mut largest = 0.0;
    for sample in integrator.trajectory(mu, step)?.take(steps + 1) {
        largest = larger(largest, (f(&sample?.momentum) - start).abs());
    }
    Ok(largest)
}
