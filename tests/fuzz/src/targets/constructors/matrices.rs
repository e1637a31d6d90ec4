//! Isospectral equations of matrices: steps fail, or are finite and conserve the norm.

use crate::input::Input;
use crate::targets::conservation::{LARGEST_TURN, SAFE};
use collective_integrators::{Integrator, RungeKutta};
use isospectral_flows::{
    ExponentialMidpoint, GaussMagnus, IsospectralField, IsospectralRungeKutta, LargeSkewHermitian,
};
use lie_poisson::State;
use lie_poisson_systems::{GeneralisedRigidBody, Zeitlin};

/// Asserts that a step fails, or is finite and conserves the norm up to the rounding errors of the step times the generator.
fn isospectral<I: Integrator<f64, State = LargeSkewHermitian>>(
    integrator: &I,
    field: &impl IsospectralField,
    mut w: LargeSkewHermitian,
    step: f64,
) {
    let rate = |w: &LargeSkewHermitian| {
        let mut generator = w.clone();
        field.generator_into(w, &mut generator);
        step.abs() * generator.norm()
    };
    let (norm, before) = (w.norm(), rate(&w));
    let size = w.size();
    let stiff = (0..size).any(|i| {
        let unit = LargeSkewHermitian::from_upper(size, |j, k| {
            nalgebra::Complex::new(if j == i && k > j { norm } else { 0.0 }, 0.0)
        });
        rate(&unit) > LARGEST_TURN
    });
    let mut workspace = integrator.workspace();
    if integrator.step_in_place(&mut w, step, &mut workspace).is_ok() {
        assert!((0..w.dimension()).all(|i| w.coordinate(i).is_finite()), "{step:e}: {w:?}");
        let after = w.norm();
        let round_off = 1e-11 + 1e-12 * before.max(rate(&w));
        // Where another matrix of this norm turns by many radians, Q need only be unitary to 1e-3.
        let allowed = if stiff { 1e-2 } else { round_off.min(1e-2) };
        assert!(
            (after / norm - 1.0).abs() <= allowed || !SAFE.contains(&norm),
            "{step:e}: {norm:e} {after:e}, {before:e} {:e}",
            rate(&w)
        );
    }
}

pub(super) fn generalised_rigid_body(input: &mut Input<'_>) {
    let size = input.choice(6);
    let Ok(body) = GeneralisedRigidBody::new((0..size).map(|_| input.number()).collect()) else {
        return;
    };
    let entries: [f64; 15] = input.numbers();
    let start = body.momentum(|j, k| entries[(j * 5 + k) % 15]);
    let step = input.number();
    let midpoint = IsospectralRungeKutta::new(RungeKutta::implicit_midpoint(), &body);
    isospectral(&midpoint, &body, start.clone(), step);
    if let Ok(magnus) = GaussMagnus::new(2, &body) {
        isospectral(&magnus, &body, start, step);
    }
}

pub(super) fn zeitlin(input: &mut Input<'_>) {
    let Ok(fluid) = Zeitlin::new(input.choice(6)) else { return };
    let Ok(fluid) = fluid.with_rotation(input.number()) else { return };
    let entries: [f64; 8] = input.numbers();
    let size = fluid.laplacian().size();
    let start = LargeSkewHermitian::from_upper(size, |j, k| {
        let at = |i: usize| entries[i % 8];
        nalgebra::Complex::new(if j == k { 0.0 } else { at(j + 2 * k) }, at(3 * j + k))
    });
    isospectral(&ExponentialMidpoint::new(&fluid), &fluid, start, input.number());
}
