//! Isotropic noise that alternates, by one exponential: the step, its law in two representations, and means of paths.

use crate::examples::{Quadratic, distance, generic};
use crate::open_systems::support::{Large, Still, drift, on_path};
use isospectral_flows::collective_integrators::{
    BrownianPaths, Integrator, NoiseRule, RungeKutta, Start, fitted_order,
};
use isospectral_flows::lie_poisson::State;
use isospectral_flows::{
    IsospectralField, IsospectralNoise, IsospectralRungeKutta, IsotropicIsospectralNoise,
    LargeMatrix, NoisyIsospectral, Products,
};
use num_complex::Complex;

type Noisy<F> = NoisyIsospectral<RungeKutta, F, IsotropicIsospectralNoise>;

fn alternating<F: IsospectralField>(field: F, strength: f64, interval: f64) -> Noisy<F> {
    let noise = IsotropicIsospectralNoise { size: field.size(), strength };
    let paths = BrownianPaths::new(5, interval).unwrap();
    NoisyIsospectral::new(RungeKutta::implicit_midpoint(), field, noise, paths)
        .with_rule(NoiseRule::Alternating)
}

fn commutator(a: &Large, b: &Large) -> Large {
    let mut c = a.zeros_like();
    Products::default().commutator(a, b, &mut c);
    c
}

/// Returns the generators Ξ_k.
fn generators(noise: &IsotropicIsospectralNoise) -> Vec<Large> {
    let unit = |k: usize| {
        let (mut weights, mut xi) = (vec![0.0; noise.count()], Large::zeros(noise.size));
        weights[k] = 1.0;
        noise.add_to(&weights, &mut xi);
        xi
    };
    (0..noise.count()).map(unit).collect()
}

fn told_by(noise: impl IsospectralNoise) -> Option<f64> {
    noise.isotropic_casimir()
}

/// Σ_k [Ξ_k, [Ξ_k, V]] = −λ V, and Σ_ij `X_i X_j X_i X_j` = Δ² + ½ λ Δ on V, with the field `X_k` = [Ξ_k, ·].
#[test]
fn a_basis_has_the_casimir_that_its_noise_tells() {
    for size in [2, 3, 4] {
        let noise = &IsotropicIsospectralNoise { size, strength: 0.7 };
        let casimir = told_by(noise).unwrap();
        let (xi, mut v) = (generators(noise), generic(size, 0.3));
        let trace = v.trace() / size as f64;
        let unit = Large::from_upper(size, |j, k| Complex::new(0.0, f64::from(u8::from(j == k))));
        v.add_multiple(-trace, &unit);
        let (mut laplacian, mut crossed) = (v.zeros_like(), v.zeros_like());
        for i in &xi {
            laplacian.add_in_place(&commutator(i, &commutator(i, &v)));
            for j in &xi {
                let inner = commutator(i, &commutator(j, &v));
                crossed.add_in_place(&commutator(i, &commutator(j, &inner)));
            }
        }
        laplacian.add_multiple(casimir, &v);
        crossed.add_multiple(-0.5 * casimir.powi(2), &v);
        // Sums of 4⁴ products at most.
        assert!(laplacian.norm() < 1e-13 * casimir && crossed.norm() < 1e-12 * casimir.powi(2));
        // Control: the Laplacian alone is not the crossed sum.
        crossed.add_multiple(-0.5 * casimir.powi(2), &v);
        assert!(crossed.norm() > 0.1 * casimir.powi(2));
    }
    assert_eq!(told_by(vec![generic(3, 0.0)]), None);
}

/// Returns exp(Ω) W exp(−Ω).
fn turned(omega: &Large, w: &Large) -> Large {
    let (mut turn, mut end) = (LargeMatrix::zeros(w.size()), w.zeros_like());
    Products::default().exponential_minus_one(omega, &mut turn);
    Products::default().conjugate(&turn, w, &mut end);
    end
}

/// Half a step of the drift, exp(c Σ ΔW_k Ξ_k), half a step of the drift, with c² = 1/(1 + σ²hN/12): also in steps that are parts of an
/// interval, and backward.
#[test]
fn a_step_is_one_exponential_between_halves_of_the_drift() {
    let (interval, strength) = (0.2, 0.8_f64);
    for size in [1, 2, 3, 5] {
        let noisy = alternating(Quadratic(size), strength, interval);
        let still = IsospectralRungeKutta::new(RungeKutta::implicit_midpoint(), Quadratic(size));
        let start = generic(size, 0.3);
        for part in [1.0, 0.5, 2.0, -1.0] {
            let step: f64 = part * interval;
            let half = |w: Large| still.after(&w, 0.5 * step, 1).unwrap().momentum;
            let mut motion = vec![0.0; size * size];
            noisy.paths().write_increments(3, 0.0, part, &mut motion);
            let by = |factor: f64| {
                let mut omega = start.zeros_like();
                noisy.noise().add_to(&motion, &mut omega);
                omega.scale_in_place(factor);
                half(turned(&omega, &half(start.clone())))
            };
            let factor = (1.0 + strength.powi(2) * step.abs() * size as f64 / 12.0).sqrt().recip();
            let end = noisy.after(&on_path(start.clone(), 3), step, 1).unwrap().momentum.0;
            // The tolerance of the stage equations.
            assert!(distance(&end, &by(factor)) < 1e-14, "{size} {part}");
            assert!(size == 1 || distance(&end, &by(1.0)) > 1e-4, "{size} {part}");
            assert!(drift(&start, &end) < 1e-14);
        }
    }
}

#[test]
fn a_path_runs_back_to_its_start() {
    let (noisy, step) = (alternating(Quadratic(3), 0.8, 0.1), 0.1);
    let start = on_path(generic(3, 0.3), 2);
    let (mut state, mut workspace) = (start.clone(), noisy.workspace());
    noisy.advance(&mut state, step, 0..50, &mut workspace).unwrap();
    assert!(distance(&state.0, &start.0) > 0.1 && drift(&start.0, &state.0) < 1e-14);
    noisy.advance(&mut state, -step, 0..50, &mut workspace).unwrap();
    // 100 steps with some rounding errors each
    assert!(distance(&state.0, &start.0) < 1e-13);
}

/// The rates with which noise alone, of σ = 1, takes the means of the functions `W_1N` and `W_1N²`: of the highest weights of the adjoint
/// representation, whose Casimir is 2N, and of that with twice its weight, 4(N + 1).
fn rates(size: usize) -> [f64; 2] {
    [size as f64, 2.0 * (size as f64 + 1.0)]
}

/// Returns the factors of these means for exp(√s Σ ξ_k E_k) with normal numbers ξ_k, for N = 2 or 3: characters over dimensions,
/// averaged over the eigenvalues iλ_j of Σ ξ_k E_k without its trace, whose density is Π (λ_i − λ_j)² exp(−Σ λ_j²/2).
fn law(size: usize, s: f64) -> [f64; 2] {
    // The trapezoidal rule, which is exact to round-off for such densities.
    let nodes = || (-36..=36).map(|i| 0.25 * f64::from(i));
    let mut sum = [0.0; 3];
    for (x, y) in nodes().flat_map(|x| nodes().map(move |y| (x, y))) {
        let lambda = match size {
            2 => vec![x, -x],
            _ => vec![x, y, -x - y],
        };
        let squares: f64 = lambda.iter().map(|l| l * l).sum();
        let pairs = (0..size).flat_map(|i| (0..i).map(move |j| (i, j)));
        let weight: f64 = pairs.map(|(i, j)| (lambda[i] - lambda[j]).powi(2)).product();
        let weight = weight * (-0.5 * squares).exp();
        let adjoint = |times: f64| {
            let turns = lambda.iter().map(|l| Complex::from_polar(1.0, times * s.sqrt() * l));
            turns.sum::<Complex<f64>>().norm_sqr() - 1.0
        };
        // The symmetric square of the adjoint representation is 1 + 5 for N = 2, and 1 + 8 + 27 for N = 3.
        let symmetric = 0.5 * (adjoint(1.0).powi(2) + adjoint(2.0));
        let [double, dimensions] = match size {
            2 => [symmetric - 1.0, 5.0],
            _ => [symmetric - 1.0 - adjoint(1.0), 27.0],
        };
        let single = adjoint(1.0) / (size * size - 1) as f64;
        for (sum, value) in sum.iter_mut().zip([1.0, single, double / dimensions]) {
            *sum += weight * value;
        }
    }
    [sum[1] / sum[0], sum[2] / sum[0]]
}

/// The error of the mean of a step has the order 3, so that the weak order is 2; without the factor c it has the order 2.
#[test]
fn the_mean_of_a_step_has_the_error_of_the_weak_order_two() {
    for (size, function) in [(2, 0), (2, 1), (3, 0), (3, 1)] {
        let order = |squared_factor: &dyn Fn(f64) -> f64| {
            let errors = [0.02, 0.01, 0.005].map(|s| {
                let exact = (-rates(size)[function] * s).exp();
                (s, (law(size, squared_factor(s) * s)[function] - exact).abs())
            });
            fitted_order(&errors, 1e-14).unwrap()
        };
        let found = order(&|s| 1.0 / (1.0 + size as f64 * s / 12.0));
        assert!((found - 3.0).abs() < 0.15, "{size} {function} {found}");
        let others: [&dyn Fn(f64) -> f64; 2] =
            [&|_| 1.0, &|s| 1.0 / (1.0 + size as f64 * s / 24.0)];
        for other in others {
            assert!((order(other) - 2.0).abs() < 0.15);
        }
    }
}

/// Returns the means of Re `W_1N` and Re `W_1N²` after one step of paths that begin with `W_1N` = 1, and four standard errors.
fn means_of_paths(size: usize, strength: f64, paths: u64) -> [[f64; 2]; 2] {
    let noisy = alternating(Still(size), strength, 1.0);
    let start =
        Large::from_upper(size, |j, k| Complex::new(f64::from(u8::from(k - j == size - 1)), 0.0));
    let mut workspace = noisy.workspace();
    let mut sums = [[0.0; 2]; 2];
    for path in 0..paths {
        let mut state = on_path(start.clone(), path);
        noisy.step_in_place(&mut state, 1.0, &mut workspace).unwrap();
        let entry = state.0.at(0, size - 1);
        for ([sum, squares], value) in sums.iter_mut().zip([entry.re, (entry * entry).re]) {
            *sum += value;
            *squares += value * value;
        }
    }
    let count = paths as f64;
    sums.map(|[sum, squares]| {
        let mean = sum / count;
        [mean, 4.0 * ((squares / count - mean * mean) / count).sqrt()]
    })
}

/// With σ²h = 0.2.
#[test]
#[ignore = "long"]
fn means_of_paths_are_exact_to_the_weak_order_two() {
    let s = 0.2_f64;
    for size in [2, 3] {
        let squared_factor = 1.0 / (1.0 + size as f64 * s / 12.0);
        let found = means_of_paths(size, s.sqrt(), 20_000);
        // Noise which is stronger by 1/c: the increments as they are.
        let whole = means_of_paths(size, (s / (1.0 - size as f64 * s / 12.0)).sqrt(), 20_000);
        for function in 0..2 {
            let exact = (-rates(size)[function] * s).exp();
            let bias = (law(size, squared_factor * s)[function] - exact).abs();
            let [[mean, error], [other, error_of_other]] = [found[function], whole[function]];
            assert!((mean - exact).abs() < error + bias, "{size} {function} {mean} {exact}");
            assert!((other - exact).abs() > error_of_other, "{size} {function} {other} {exact}");
        }
    }
}

#[test]
#[ignore = "long"]
fn the_strong_order_of_one_exponential_is_one_half() {
    let (fine, paths, size) = (1.0 / 256.0, 40, 3);
    let noisy = alternating(Quadratic(size), 0.3, fine);
    // The drift is slow, so that its error, of order 2, is small beside that of the noise.
    let mut slow = generic(size, 0.3);
    slow.scale_in_place(0.2);
    let end = |path: u64, step: f64| {
        let start = on_path(slow.clone(), path);
        noisy.after(&start, step, (1.0 / step).round() as u64).unwrap().momentum.0
    };
    let exact: Vec<_> = (0..paths).map(|path| end(path, fine)).collect();
    let errors = [0.25, 0.125, 0.0625, 0.03125].map(|step| {
        let squares =
            (0..).zip(&exact).map(|(path, exact)| distance(&end(path, step), exact).powi(2));
        (step, (squares.sum::<f64>() / paths as f64).sqrt())
    });
    let order = fitted_order(&errors, 1e-14).unwrap();
    assert!((order - 0.5).abs() < 0.15, "{order} {errors:?}");
}
