//! A fluid on the sphere with noise: Casimirs of paths, exact paths and means, strong orders, and what is refused.

use crate::fluids::viscous_fluid::{distance, eddies};
use crate::fluids::zeitlin::{difference, largest};
use lie_poisson_systems::collective_integrators::{
    BrownianPaths, Integrator, PathAndTime, Start, StepError, fitted_order,
};
use lie_poisson_systems::isospectral_flows::{
    IsospectralField, IsospectralNoise, LargeSkewHermitian, Products,
};
use lie_poisson_systems::lie_poisson::{Pair, State, larger};
use lie_poisson_systems::nalgebra::Vector1;
use lie_poisson_systems::num_complex::Complex;
use lie_poisson_systems::{
    HarmonicNoise, StochasticFluid, SystemError, ViscousForcing, VorticityCoefficients, Zeitlin,
};
use std::f64::consts::PI;

fn on_path(w: LargeSkewHermitian, path: u64) -> Pair<LargeSkewHermitian, PathAndTime<f64>> {
    Pair(w, Pair(Vector1::new(path as f64), Vector1::new(0.0)))
}

fn paths(interval: f64) -> BrownianPaths {
    BrownianPaths::new(11, interval).unwrap()
}

/// Returns a fluid with transport noise alone.
fn carried(fluid: &Zeitlin, noise: HarmonicNoise, interval: f64) -> StochasticFluid {
    let none = ViscousForcing::new(fluid.clone());
    StochasticFluid::new(none, paths(interval)).with_transport(noise).unwrap()
}

/// Returns the largest change of the Casimirs tr(−iW/|W|)ᵏ, k = 1 … N.
fn drift(fluid: &Zeitlin, start: &LargeSkewHermitian, end: &LargeSkewHermitian) -> f64 {
    let casimirs = |w: &LargeSkewHermitian| {
        let mut w = w.clone();
        w.scale_in_place(1.0 / start.norm());
        let count = w.size() as f64 / (4.0 * PI);
        fluid.casimirs(&w, w.size()).into_iter().map(move |c| c * count)
    };
    casimirs(start).zip(casimirs(end)).map(|(a, b)| (a - b).abs()).fold(0.0, larger)
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

/// Noise of degree 1 and order 0 turns the sphere about x₃ by the angle σ √(3/4π) W(t), and a flow of one degree with it.
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
    let (_, method, start, step) = turbulence();
    let start = on_path(start, 2);
    let (mut state, mut workspace) = (start.clone(), method.workspace());
    method.advance(&mut state, step, 0..20, &mut workspace).unwrap();
    assert!(difference(&state.0, &start.0) > 1e-2);
    method.advance(&mut state, -step, 0..20, &mut workspace).unwrap();
    // 40 steps with some rounding errors each
    assert!(difference(&state.0, &start.0) < 1e-13);
    assert!(state.1.1.x.abs() < 1e-12);
}

/// Returns the ends of so many paths of a small fluid that is stirred from rest, as coefficients.
fn ends(
    method: &StochasticFluid,
    (step, steps): (f64, u64),
    count: u64,
) -> Vec<VorticityCoefficients> {
    let fluid = method.forcing().fluid();
    let rest = LargeSkewHermitian::zeros(fluid.laplacian().size());
    let end = |path| method.after(&on_path(rest.clone(), path), step, steps).unwrap().momentum.0;
    (0..count).map(|path| fluid.coefficients(&end(path))).collect()
}

fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0.0), |(sum, count), x| (sum + x, count + 1.0));
    sum / count
}

/// A stirred harmonic with damping has the variance σ²/2λ, also with steps that are longer than 1/λ.
#[test]
fn stirring_and_damping_balance_at_every_step_size() {
    let (sigma, drag, step, count) = (0.4, 1.5, 2.0, 1500);
    let fluid = Zeitlin::new(2).unwrap();
    let forcing = ViscousForcing::new(fluid.clone()).with_drag(drag).unwrap();
    let stirring = HarmonicNoise::none(&fluid).with_shell([1, 1], sigma).unwrap();
    let method = StochasticFluid::new(forcing, paths(step)).with_stirring(stirring).unwrap();
    let ends = ends(&method, (step, 5), count);
    let expected = sigma * sigma / (2.0 * drag);
    // The three standard errors of a variance, and of |ω₁₁|², whose mean is that of one real and one imaginary part
    let error = 3.0 * (2.0 / count as f64).sqrt();
    let zonal = mean(ends.iter().map(|end| end.at(1, 0).re.powi(2)));
    assert!((zonal / expected - 1.0).abs() < error, "{zonal} {expected}");
    let tilted = mean(ends.iter().map(|end| end.at(1, 1).norm_sqr()));
    assert!((tilted / expected - 1.0).abs() < error, "{tilted} {expected}");
    // Control: the variance of half a step of increments without the factor, σ² (h/2)/(1 − e^(−λh)), is far away.
    assert!(0.5 * step * 2.0 * drag / (1.0 - (-drag * step).exp()) > 1.0 + 3.0 * error);
}

#[test]
fn stirring_feeds_energy_and_enstrophy_at_its_rates() {
    let (size, step, steps, count) = (4, 0.05, 20, 400);
    let fluid = Zeitlin::new(size).unwrap();
    let stirring = HarmonicNoise::none(&fluid).with_shell([2, 3], 0.5).unwrap();
    let carrying = HarmonicNoise::none(&fluid).with_shell([1, 1], 0.1).unwrap();
    let rates = [stirring.energy_injection(), stirring.enstrophy_injection()];
    assert!((rates[1] - 0.25 * (5.0 + 7.0)).abs() < 1e-14);
    assert!((rates[0] - 0.25 * (5.0 / 12.0 + 7.0 / 24.0)).abs() < 1e-14);
    let none = ViscousForcing::new(fluid.clone());
    let method = StochasticFluid::new(none, paths(step)).with_transport(carrying).unwrap();
    let method = method.with_stirring(stirring).unwrap();
    let ends = ends(&method, (step, steps), count);
    let mean_of = |f: &dyn Fn(&LargeSkewHermitian) -> f64| {
        mean(ends.iter().map(|end| f(&fluid.vorticity(end))))
    };
    let found = [mean_of(&|w| fluid.energy(w)), mean_of(&|w| fluid.enstrophy(w))];
    // Three standard errors of a sum of 5 squares, the fewest that carry most of it
    let error = 3.0 * (2.0 / (5 * count) as f64).sqrt();
    for (found, rate) in found.iter().zip(rates) {
        let expected = rate * step * steps as f64;
        assert!((found / expected - 1.0).abs() < error, "{found} {expected}");
    }
}

/// Returns the root mean square distances of paths at t = 1 from those of a short step.
fn strong_order(method: &StochasticFluid, omega: &VorticityCoefficients, fine: f64) -> f64 {
    let (start, paths) = (method.forcing().fluid().vorticity(omega), 24);
    let end = |path: u64, step: f64| {
        let steps = (1.0 / step).round() as u64;
        method.after(&on_path(start.clone(), path), step, steps).unwrap().momentum.0
    };
    let exact: Vec<_> = (0..paths).map(|path| end(path, fine)).collect();
    let errors = [0.25, 0.125, 0.0625, 0.03125].map(|step| {
        let pairs = (0..).zip(&exact);
        let squares = pairs.map(|(path, exact)| difference(&end(path, step), exact).powi(2));
        (step, mean(squares).sqrt())
    });
    fitted_order(&errors, 1e-14).unwrap()
}

#[test]
fn the_strong_order_is_one_with_stirring_and_one_half_with_isotropic_transport() {
    let (size, fine) = (4, 1.0 / 256.0);
    let fluid = Zeitlin::new(size).unwrap();
    let forcing = ViscousForcing::new(fluid.clone()).with_viscosity(0.05, 1).unwrap();
    let method = StochasticFluid::new(forcing.clone(), paths(fine));
    let noise = |shell, strength| HarmonicNoise::none(&fluid).with_shell(shell, strength).unwrap();
    let omega = eddies(size, [1, 3]);
    let stirred = method.clone().with_stirring(noise([1, 3], 0.5)).unwrap();
    let order = strong_order(&stirred, &omega, fine);
    assert!((order - 1.0).abs() < 0.2, "{order}");
    let one = HarmonicNoise::none(&fluid).with_harmonic(2, 0, 0.3).unwrap();
    let order = strong_order(&method.clone().with_transport(one).unwrap(), &omega, fine);
    assert!((order - 1.0).abs() < 0.25, "{order}");
    let all = method.with_transport(noise([2, 2], 0.3)).unwrap();
    let order = strong_order(&all, &omega, fine);
    assert!((order - 0.5).abs() < 0.2, "{order}");
}

#[test]
fn what_cannot_be_is_refused_by_name() {
    let fluid = Zeitlin::new(4).unwrap();
    let none = || HarmonicNoise::none(&fluid);
    for (refused, expected) in [
        (
            none().with_harmonic(4, 0, 1.0),
            "the degree of noise must be between 1e0 and 3e0, got 4.0",
        ),
        (
            none().with_harmonic(0, 0, 1.0),
            "the degree of noise must be between 1e0 and 3e0, got 0.0",
        ),
        (
            none().with_harmonic(2, 3, 1.0),
            "the order of noise must be between 0e0 and 2e0, got 3.0",
        ),
        (none().with_harmonic(2, 1, -1.0), "the strength of noise must not be negative, got -1.0"),
        (
            none().with_shell([1, 2], f64::NAN),
            "the strength of noise must be a finite number, got NaN",
        ),
        (
            none().with_shell([1, 4], 1.0),
            "the largest degree of noise must be between 1e0 and 3e0, got 4.0",
        ),
        (
            none().with_shell([3, 2], 1.0),
            "the least degree of noise must be between 1e0 and 2e0, got 3.0",
        ),
    ] {
        assert_eq!(refused.unwrap_err().to_string(), expected);
    }
    let method = || StochasticFluid::new(ViscousForcing::new(fluid.clone()), paths(0.1));
    let other = || HarmonicNoise::none(&Zeitlin::new(5).unwrap());
    for refused in [method().with_transport(other()), method().with_stirring(other())] {
        assert!(matches!(refused, Err(SystemError::Count { expected: 4, found: 5, .. })));
    }
    // Backward in time with viscosity
    let viscous = ViscousForcing::new(fluid.clone()).with_viscosity(0.1, 1).unwrap();
    let method = StochasticFluid::new(viscous, paths(0.1));
    let start = on_path(fluid.vorticity(&eddies(4, [1, 3])), 0);
    let backward = method.step(&start, -0.1, &mut method.workspace());
    assert!(matches!(backward, Err(StepError::NoLift { .. })));
    let larger = on_path(LargeSkewHermitian::zeros(5), 0);
    let refused = method.step(&larger, 0.1, &mut method.workspace());
    assert!(matches!(refused, Err(StepError::Dimension { expected: 16, found: 25 })));
}
