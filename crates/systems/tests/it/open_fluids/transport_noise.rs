//! Transport noise on a fluid on the sphere: the Casimirs of paths, exact paths, and exact means.

use crate::fluids::zeitlin::{difference, largest};
use crate::open_fluids::support::{distance, drift, eddies, on_path, paths};
use lie_poisson_systems::collective_integrators::{Integrator, Start};
use lie_poisson_systems::isospectral_flows::{
    IsospectralField, IsospectralNoise, LargeSkewHermitian, Products,
};
use lie_poisson_systems::lie_poisson::State;
use lie_poisson_systems::num_complex::Complex;
use lie_poisson_systems::{
    HarmonicNoise, StochasticFluid, ViscousForcing, VorticityCoefficients, Zeitlin,
};
use std::f64::consts::PI;

/// Returns a fluid with transport noise alone.
fn carried(fluid: &Zeitlin, noise: HarmonicNoise, interval: f64) -> StochasticFluid {
    let none = ViscousForcing::new(fluid.clone());
    StochasticFluid::new(none, paths(interval)).with_transport(noise).unwrap()
}

/// A fluid with transport noise in small eddies, its start, and the length of its steps.
fn turbulence() -> (Zeitlin, StochasticFluid, LargeSkewHermitian, f64) {
    let (size, step) = (16, 0.02);
    let fluid = Zeitlin::new(size).unwrap();
    let noise = HarmonicNoise::none(&fluid).with_shell([4, 6], 0.02).unwrap();
    let start = fluid.vorticity(&eddies(size, [1, 6]));
    (fluid.clone(), carried(&fluid, noise, step), start, step)
}

#[test]
fn transport_noise_keeps_the_casimirs_of_each_path_and_euler_and_maruyama_do_not() {
    let (fluid, method, start, step) = turbulence();
    let steps = 100;
    let end = method.after(&on_path(start.clone(), 3), step, steps).unwrap().momentum.0;
    // 100 steps with some rounding errors each
    assert!(drift(&fluid, &start, &end) < 1e-14, "{:e}", drift(&fluid, &start, &end));
    assert!(difference(&start, &end) > 0.1 * largest(&start));
    // dW = [P, W]/ħ dt + Σ_k [Ξ_k, W] dW_k + ½ Σ_k [Ξ_k, [Ξ_k, W]] dt, in Itô's sense
    let mut explicit = start.clone();
    for n in 0..steps {
        let mut increments = vec![0.0; method.transport().count()];
        paths(step).write_increments(3, n as f64, n as f64 + 1.0, &mut increments);
        let mut change = fluid.rate(&explicit);
        change.add_in_place(&mean_rate(method.transport(), &explicit));
        change.scale_in_place(step);
        let (mut generator, mut kick) = (start.zeros_like(), start.zeros_like());
        method.transport().add_to(&increments, &mut generator);
        Products::default().commutator(&generator, &explicit, &mut kick);
        change.add_in_place(&kick);
        explicit.add_in_place(&change);
    }
    assert!(drift(&fluid, &start, &explicit) > 1e-4);
}

#[test]
#[ignore = "long"]
fn casimirs_of_a_path_stay_when_it_is_advanced_many_times() {
    let (fluid, method, start, step) = turbulence();
    let end = method.after(&on_path(start.clone(), 3), step, 1_000_000).unwrap().momentum.0;
    let drift = drift(&fluid, &start, &end);
    println!("the Casimirs after 1e6 steps: {drift:e}");
    assert!(drift < 1e-12, "{drift:e}");
}

/// Returns ½ Σ_k [Ξ_k, [Ξ_k, W]], the rate of the mean of W by noise.
fn mean_rate(noise: &HarmonicNoise, w: &LargeSkewHermitian) -> LargeSkewHermitian {
    let (mut sum, mut products) = (w.zeros_like(), Products::default());
    let (mut once, mut twice) = (w.zeros_like(), w.zeros_like());
    for k in 0..noise.count() {
        let mut weights = vec![0.0; noise.count()];
        weights[k] = 1.0;
        let mut xi = w.zeros_like();
        noise.add_to(&weights, &mut xi);
        products.commutator(&xi, w, &mut once);
        products.commutator(&xi, &once, &mut twice);
        sum.add_multiple(0.5, &twice);
    }
    sum
}

#[test]
fn the_mean_decays_by_the_eddy_viscosity() {
    let size = 9;
    let fluid = Zeitlin::new(size).unwrap();
    let noise = |shell| HarmonicNoise::none(&fluid).with_shell(shell, 0.3).unwrap();
    let defect = |noise: &HarmonicNoise, degree: usize| {
        let w = fluid.vorticity(&eddies(size, [degree, degree]));
        let mut expected = w.clone();
        expected.scale_in_place(-noise.eddy_viscosity() * (degree * (degree + 1)) as f64);
        difference(&mean_rate(noise, &w), &expected) / largest(&expected)
    };
    // Dozens of products of N terms
    let round_off = 1e-13;
    for shell in [[1, 1], [2, 2], [3, 5], [8, 8]] {
        assert!(defect(&noise(shell), 1) < round_off, "{shell:?}");
    }
    for degree in [2, 5, 8] {
        assert!(defect(&noise([1, 1]), degree) < round_off, "{degree}");
    }
    // Controls: eddies of the size of the noise, and noise that is not isotropic
    assert!(defect(&noise([3, 3]), 2) > 0.01);
    let one = HarmonicNoise::none(&fluid).with_harmonic(2, 1, 0.3).unwrap();
    assert!(defect(&one, 1) > 0.01);
}

/// The generators are the matrices of the real harmonics, as stream functions.
#[test]
fn components_are_the_real_harmonics() {
    let size = 6;
    let fluid = Zeitlin::new(size).unwrap();
    let noise = HarmonicNoise::none(&fluid).with_harmonic(3, 0, 0.5).unwrap();
    let noise = noise.with_harmonic(4, 2, 0.7).unwrap();
    let mut psi = VorticityCoefficients::zeros(size);
    psi.set(3, 0, Complex::from(0.5 * 1.1));
    psi.set(4, 2, Complex::new(-0.2, 0.3) * (0.7 * 0.5_f64.sqrt()));
    let mut expected = fluid.vorticity(&psi);
    expected.scale_in_place(1.0 / fluid.planck_constant());
    let mut generator = expected.zeros_like();
    noise.add_to(&[1.1, -0.2, 0.3], &mut generator);
    assert!(difference(&generator, &expected) < 1e-14);
}

/// Noise of degree 1 and order 0 turns the sphere about x₃ by the angle σ √(3/4π) W(t), and a flow of one degree with
/// it.
#[test]
fn noise_along_the_axis_turns_a_steady_flow() {
    let (size, l, step, steps) = (8, 3, 0.005, 200);
    let fluid = Zeitlin::new(size).unwrap();
    let noise = HarmonicNoise::none(&fluid).with_harmonic(1, 0, 0.6).unwrap();
    let method = carried(&fluid, noise, step);
    let omega = eddies(size, [l, l]);
    let end = method.after(&on_path(fluid.vorticity(&omega), 5), step, steps).unwrap().momentum;
    let mut motion = [0.0];
    paths(step).write_increments(5, 0.0, steps as f64, &mut motion);
    let angle = 0.6 * (3.0 / (4.0 * PI)).sqrt() * motion[0];
    let turned = |sign: f64| {
        VorticityCoefficients::from_fn(size, |l, m| {
            omega.at(l, m) * Complex::from_polar(1.0, sign * m as f64 * angle)
        })
    };
    let end = fluid.coefficients(&end.0);
    // The error of the midpoint rule, φ³/12 in a step that turns by φ ≈ (N/2) σ √h/2, as a random walk of 200 steps
    assert!(distance(&end, &turned(1.0)) < 1e-2, "{:e}", distance(&end, &turned(1.0)));
    assert!(distance(&end, &turned(-1.0)) > 0.1);
}

#[test]
fn a_path_without_viscosity_runs_back_to_its_start() {
    let (fluid, carried, start, step) = turbulence();
    // Drag and stirring run back, too: from the end the decay of the noise is a growth.
    let drag = ViscousForcing::new(fluid.clone()).with_drag(0.2).unwrap();
    let method = StochasticFluid::new(drag, paths(step));
    let method = method.with_transport(carried.transport().clone()).unwrap();
    let stirring = HarmonicNoise::none(&fluid).with_shell([2, 3], 0.3).unwrap();
    let method = method.with_stirring(stirring).unwrap();
    let start = on_path(start, 2);
    let (mut state, mut workspace) = (start.clone(), method.workspace());
    method.advance(&mut state, step, 0..20, &mut workspace).unwrap();
    assert!(difference(&state.0, &start.0) > 1e-2);
    method.advance(&mut state, -step, 0..20, &mut workspace).unwrap();
    // 40 steps with some rounding errors each
    assert!(difference(&state.0, &start.0) < 1e-13);
    assert!(state.1.1.0.abs() < 1e-12);
}
