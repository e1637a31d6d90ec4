//! How far conserved quantities drift along a trajectory.

use collective_integrators::{RungeKutta, Scheme, Start};
use core::array::from_fn;
use lie_poisson::larger;

/// Casimirs and momentum maps of affine symmetries are quadratic: a Gauss method conserves them
/// to the round-off of this many steps.
pub const ROUND_OFF: f64 = 1e-12;

/// The schemes of each test.
pub fn schemes() -> [RungeKutta; 2] {
    [RungeKutta::implicit_midpoint(), RungeKutta::gauss(3).unwrap()]
}

/// What a symplectic scheme of order p may do to the energy: bounded by C hᵖ, C of size 1 here.
pub fn energy_bound(scheme: &RungeKutta, step: f64) -> f64 {
    step.powi(scheme.order() as i32) + ROUND_OFF
}

/// The largest deviation of each function from its initial value over a trajectory.
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
