//! The drifts of conserved quantities along a trajectory, for the tests of the systems.

use collective_integrators::{RungeKutta, Scheme, Start};
use core::array::from_fn;
use lie_poisson::larger;

/// The round-off of the tests' numbers of steps. Casimirs and momentum maps of affine symmetries are quadratic, and a
/// Gauss method conserves them to round-off.
pub const ROUND_OFF: f64 = 1e-12;

/// Returns the schemes of each test.
pub fn schemes() -> [RungeKutta; 2] {
    [RungeKutta::implicit_midpoint(), RungeKutta::gauss(3).unwrap()]
}

/// Returns the bound C hᵖ of the energy's deviation under a symplectic scheme of order p; C has size 1 here.
pub fn energy_bound(scheme: &RungeKutta, step: f64) -> f64 {
    step.powi(scheme.order() as i32) + ROUND_OFF
}

/// Returns the largest deviation of each function from its initial value over a trajectory.
pub fn drifts<I: Start, const K: usize>(
    integrator: &I,
    start: &I::Momentum,
    (step, steps): (f64, usize),
    functions: impl Fn(&I::Momentum) -> [f64; K],
) -> [f64; K] {
    let initial = functions(start);
    let mut worst = [0.0_f64; K];
    for sample in integrator.trajectory(start, step).unwrap().take(steps + 1) {
        let values = functions(&sample.unwrap().momentum);
        worst = from_fn(|k| larger(worst[k], (values[k] - initial[k]).abs()));
    }
    worst
}
