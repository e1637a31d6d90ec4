//! Strong and weak orders of methods with noise.

use super::support::{Axial, isotropic, means, on_path};
use collective_integrators::diagnostics::fitted_order;
use collective_integrators::{BrownianPaths, NoiseRule, Noisy, RungeKutta, Start};
use lie_poisson::{Covector, IsotropicNoise, LiePoisson, Noise, Real, So3};
use momentum_map::{HOPF, HopfRealisation};
use nalgebra::Vector3;

/// A spin in the field e₃ with isotropic noise: E s(t) = exp(−σ²t) R(t) s(0), since Σ_k (e_k ×)² = −2 on vectors.
const STRENGTH: f64 = 0.7;

fn start() -> Vector3<f64> {
    Vector3::new(0.8, 0.0, 0.6)
}

fn exact_mean(t: f64) -> Vector3<f64> {
    let turned = Vector3::new(0.8 * t.cos(), -0.8 * t.sin(), 0.6);
    turned * (-STRENGTH * STRENGTH * t).exp()
}

type Spin<N> = Noisy<RungeKutta, HopfRealisation, Axial, N>;

fn spin<N>(rule: NoiseRule, noise: N, interval: f64) -> Spin<N>
where
    N: Noise<LiePoisson<So3>>,
{
    let paths = BrownianPaths::new(9, interval).unwrap();
    let scheme = RungeKutta::implicit_midpoint();
    Noisy::new(scheme, HOPF, Axial(1.0), noise, paths).with_rule(rule)
}

/// One field of noise, along e₃ as the field is.
struct Commuting;

impl<T: Real> Noise<LiePoisson<So3>, T> for Commuting {
    fn count(&self) -> usize {
        1
    }

    fn element(&self, _: &Covector<Vector3<T>>, _: T, weights: &[T]) -> Vector3<T> {
        Vector3::new(T::zero(), T::zero(), weights[0] * STRENGTH)
    }
}

/// Returns the root mean square distances of paths from those of a much smaller step, for steps of 1/4, 1/8, ….
fn strong_errors<N: Noise<LiePoisson<So3>>>(noise: impl Fn() -> N, paths: u64) -> Vec<(f64, f64)> {
    let fine = 1.0 / 256.0;
    let noisy = spin(NoiseRule::Together, noise(), fine);
    let ends = |path: u64, step: f64| {
        let start = on_path(Covector(start()), path);
        noisy.after(&start, step, (1.0 / step).round() as u64).unwrap().momentum.0.0
    };
    let reference: Vec<_> = (0..paths).map(|path| ends(path, fine)).collect();
    let errors = [0.25, 0.125, 0.0625, 0.03125].map(|step| {
        let squares =
            (0..).zip(&reference).map(|(path, end)| (ends(path, step) - end).norm_squared());
        (step, (squares.sum::<f64>() / paths as f64).sqrt())
    });
    errors.into()
}

#[test]
fn the_strong_order_is_one_half_or_one_if_the_noise_commutes() {
    let any = strong_errors(|| isotropic(3, STRENGTH), 60);
    let order = fitted_order(&any, 1e-14).unwrap();
    assert!((order - 0.5).abs() < 0.15, "{order} {any:?}");
    let commuting = strong_errors(|| Commuting, 60);
    let order = fitted_order(&commuting, 1e-14).unwrap();
    assert!((order - 1.0).abs() < 0.2, "{order} {commuting:?}");
}

/// Returns the errors of the mean at t = 2 with their standard errors, for steps.
fn weak_errors(rule: NoiseRule, paths: u64, counts: &[u64]) -> Vec<(f64, f64, f64)> {
    let errors = counts.iter().map(|&count| {
        let step = 2.0 / count as f64;
        let noisy: Spin<IsotropicNoise> = spin(rule, isotropic(3, STRENGTH), step);
        let found = means(&noisy, Covector(start()), (paths, step, count), |s| s.0.into());
        let mean = Vector3::from(found.map(|(mean, _)| mean));
        let deviation = Vector3::from(found.map(|(_, deviation)| deviation)).norm();
        (step, (mean - exact_mean(2.0)).norm(), deviation)
    });
    errors.collect()
}

/// With few paths the error of the mean is seen at long steps, and that the second rule is better there.
#[test]
fn means_converge() {
    let together = weak_errors(NoiseRule::Together, 10_000, &[2, 4]);
    let alternating = weak_errors(NoiseRule::Alternating, 10_000, &[2]);
    let [first, second] = [0, 1].map(|i| together[i].1);
    assert!(first > 4.0 * together[0].2 && second < 0.8 * first, "{together:?}");
    assert!(alternating[0].1 < 0.6 * first, "{alternating:?} {together:?}");
}

#[test]
#[ignore = "a million paths for each step"]
fn the_weak_orders_are_one_and_two_over_a_million_paths_many_times() {
    for (rule, order, counts) in
        [(NoiseRule::Together, 1.0, [3, 4, 6, 8]), (NoiseRule::Alternating, 2.0, [2, 3, 4, 5])]
    {
        let errors = weak_errors(rule, 1_000_000, &counts);
        let points: Vec<(f64, f64)> =
            errors.iter().map(|(step, error, _)| (*step, *error)).collect();
        let found = fitted_order(&points, 1e-14).unwrap();
        // The smallest error is ten or more standard errors.
        assert!((found - order).abs() < 0.25 * order, "{rule:?}: {found} {errors:?}");
    }
}
