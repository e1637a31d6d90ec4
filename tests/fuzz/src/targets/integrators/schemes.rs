//! Schemes, spins and steps by the bytes of a case.

use crate::input::Input;
use collective_integrators::{RungeKutta, Sample, SampleOf, Start};
use lie_poisson::State;
use nalgebra::Vector3;

/// Returns a Runge–Kutta method, and whether it conserves quadratic invariants.
pub(super) fn scheme(input: &mut Input<'_>) -> (RungeKutta, bool) {
    let choice = input.choice(8);
    let scheme = match choice {
        0 => RungeKutta::rk4(),
        1 => RungeKutta::qin_zhang(),
        stages @ 2..=6 => RungeKutta::gauss(stages).unwrap_or(RungeKutta::implicit_midpoint()),
        _ => RungeKutta::implicit_midpoint(),
    };
    (scheme, choice != 0)
}

/// Returns a vector of any size, or in most cases one of length 1.
pub(super) fn spin(input: &mut Input<'_>) -> Vector3<f64> {
    match input.choice(8) {
        0 => input.vector(),
        1 => input.ordinary_vector(),
        _ => input.direction(),
    }
}

/// Makes up to three steps, and asserts that each leads to finite numbers. Returns whether `holds` could compare an end of
/// a step with its start.
pub(super) fn steps_hold<I: Start>(
    integrator: &I,
    start: &I::Momentum,
    step: f64,
    mut holds: impl FnMut(&I::Momentum, &SampleOf<I>) -> bool,
) -> bool {
    let Ok(run) = integrator.trajectory(start, step) else { return false };
    // The first sample is the start as the state represents it.
    let mut samples = run.take(4).map_while(Result::ok);
    let Some(Sample { momentum: mut before, .. }) = samples.next() else { return false };
    let mut compared = false;
    for sample in samples {
        let Sample { momentum, .. } = &sample;
        assert!(momentum.is_finite(), "{start:?}, {step:e}: {momentum:?}");
        compared |= holds(&before, &sample);
        before = sample.momentum;
    }
    compared
}
