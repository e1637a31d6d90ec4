//! Isospectral equations with noise: spectra, strong orders, and paths that are functions of time.

use crate::examples::{Quadratic, distance, generic};
use crate::open_systems::support::{Large, drift, on_path};
use isospectral_flows::collective_integrators::{
    BrownianPaths, Integrator, RungeKutta, Start, StepError, fitted_order,
};
use isospectral_flows::lie_poisson::{Pair, PathNumber, State, Time};
use isospectral_flows::{
    IsospectralField, IsospectralNoise, IsospectralRungeKutta, NoisyIsospectral, Products,
};

const SIZE: usize = 3;

/// The length of the intervals of the paths, and the shortest step.
const FINE: f64 = 1.0 / 256.0;

type Midpoint = NoisyIsospectral<RungeKutta, Quadratic, Vec<Large>>;

fn midpoint(noise: Vec<Large>) -> Midpoint {
    let paths = BrownianPaths::new(5, FINE).unwrap();
    NoisyIsospectral::new(RungeKutta::implicit_midpoint(), Quadratic(SIZE), noise, paths)
}

/// Returns so many generators, which do not commute.
fn generators(count: usize) -> Vec<Large> {
    let scaled = |seed: f64| {
        let mut xi = generic(SIZE, seed);
        xi.scale_in_place(0.3);
        xi
    };
    (0..count).map(|k| scaled(k as f64)).collect()
}

/// A step of Heun's method, the explicit method that has Stratonovich's noise too.
fn heun(noisy: &Midpoint, w: &Large, increments: &[f64], step: f64) -> Large {
    let (mut products, mut rate) = (Products::default(), w.zeros_like());
    let mut change = |at: &Large, sum: &mut Large, weight: f64| {
        let mut generator = noisy.field().rate(at);
        generator.scale_in_place(step);
        sum.add_multiple(weight, &generator);
        generator.set_zero();
        noisy.noise().add_to(increments, &mut generator);
        products.commutator(&generator, at, &mut rate);
        sum.add_multiple(weight, &rate);
    };
    let (mut predicted, mut end) = (w.clone(), w.clone());
    change(w, &mut predicted, 1.0);
    change(w, &mut end, 0.5);
    change(&predicted, &mut end, 0.5);
    end
}

#[test]
fn each_path_keeps_the_spectrum_and_an_explicit_method_does_not() {
    let (noisy, steps, step) = (midpoint(generators(2)), 200, FINE);
    for path in 0..3 {
        let start = on_path(generic(SIZE, 0.3), path);
        let end = noisy.after(&start, step, steps).unwrap().momentum;
        // 200 steps with a few rounding errors each, which are unbiased
        assert!(drift(&start.0, &end.0) < 1e-14);
        let mut explicit = start.0.clone();
        for n in 0..steps {
            let mut increments = [0.0; 2];
            let [from, to] = [n, n + 1].map(|n| n as f64);
            noisy.paths().write_increments(path, from, to, &mut increments);
            explicit = heun(&noisy, &explicit, &increments, step);
        }
        // The same path, by another method
        let apart = distance(&explicit, &end.0);
        assert!(apart < 0.2 * distance(&start.0, &end.0), "{apart}");
        assert!(drift(&start.0, &explicit) > 1e-6);
    }
}

/// Returns the root mean square distances of paths at t = 1 from those of the shortest step, for steps of 1/4, 1/8, ….
fn strong_errors(noise: &[Large]) -> Vec<(f64, f64)> {
    let (noisy, paths) = (midpoint(noise.to_vec()), 40);
    // The drift is slow, so that its error, of order 2, is small beside that of the noise.
    let mut slow = generic(SIZE, 0.3);
    slow.scale_in_place(0.2);
    let end = |path: u64, step: f64| {
        let start = on_path(slow.clone(), path);
        noisy.after(&start, step, (1.0 / step).round() as u64).unwrap().momentum.0
    };
    let exact: Vec<_> = (0..paths).map(|path| end(path, FINE)).collect();
    let error = |step: f64| {
        let squares =
            (0..).zip(&exact).map(|(path, exact)| distance(&end(path, step), exact).powi(2));
        (squares.sum::<f64>() / paths as f64).sqrt()
    };
    [0.25, 0.125, 0.0625, 0.03125].map(|step| (step, error(step))).into()
}

#[test]
#[ignore = "long"]
fn the_strong_order_is_one_half() {
    let errors = strong_errors(&generators(3));
    let order = fitted_order(&errors, 1e-14).unwrap();
    assert!((order - 0.5).abs() < 0.15, "{order} {errors:?}");
}

/// One generator, which does not commute with the drift.
#[test]
#[ignore = "long"]
fn the_strong_order_is_one_if_the_noise_commutes() {
    let errors = strong_errors(&generators(1));
    let order = fitted_order(&errors, 1e-14).unwrap();
    assert!((order - 1.0).abs() < 0.2, "{order} {errors:?}");
}

#[test]
fn without_noise_it_is_the_method_without_noise() {
    let start = generic(SIZE, 0.3);
    let still = IsospectralRungeKutta::new(RungeKutta::implicit_midpoint(), Quadratic(SIZE));
    let end = still.after(&start, 0.1, 20).unwrap().momentum;
    let Pair(noisy, Pair(path, time)) =
        midpoint(Vec::new()).after(&on_path(start, 3), 0.1, 20).unwrap().momentum;
    assert_eq!(noisy, end);
    assert!(path.0 == 3.0 && (time.0 - 2.0).abs() < 1e-14);
}

#[test]
fn what_cannot_be_integrated_is_refused() {
    let noisy = midpoint(generators(1));
    let refused = |w: Large, path: f64, time: f64, step: f64| {
        let start = Pair(w, Pair(PathNumber(path), Time(time)));
        noisy.step(&start, step, &mut noisy.workspace()).unwrap_err()
    };
    let w = || generic(SIZE, 0.3);
    let dimension = refused(generic(SIZE + 1, 0.3), 0.0, 0.0, 0.1);
    let [expected, found] = [SIZE * SIZE, (SIZE + 1) * (SIZE + 1)];
    assert_eq!(dimension, StepError::Dimension { expected, found });
    let not_finite = |refused, at| matches!(refused, StepError::NotFiniteStart { coordinate, .. } if coordinate == at);
    assert!(not_finite(refused(w(), f64::NAN, 0.0, 0.1), 0));
    assert!(not_finite(refused(w(), 0.0, f64::INFINITY, 0.1), 1));
    assert!(matches!(refused(w(), 0.0, 0.0, f64::NAN), StepError::StepSize { .. }));
    // Generators of another size
    let other = midpoint(vec![generic(SIZE + 1, 0.0)]);
    assert!(other.step(&on_path(w(), 0), 0.1, &mut other.workspace()).is_err());
}
