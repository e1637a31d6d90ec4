//! Strong and weak orders of methods with noise.

use super::support::{Axial, Told, means, on_path};
use collective_integrators::diagnostics::fitted_order;
use collective_integrators::{BrownianPaths, NoiseRule, Noisy, RungeKutta, Start};
use lie_poisson::{Covector, InnerProduct, IsotropicNoise, LiePoisson, Noise, Real, So3};
use momentum_map::{HOPF, HopfRealisation};
use nalgebra::{Matrix3, Rotation3, Unit, Vector3};

/// A spin in the field e₃ with noise of different strengths along the axes, so that its mean does not commute with the turn: E s(t) =
/// exp(t(E₃ + ½ Σ_k σ_k² E_k²)) s(0) with the matrices E_k of s ↦ s × e_k.
pub const STRENGTHS: [f64; 3] = [0.9, 0.4, 0.7];

pub fn noise() -> IsotropicNoise {
    let [x, y, z] = STRENGTHS.map(|strength| strength * strength);
    let inner_product = InnerProduct::new(&[x, 0.0, 0.0, 0.0, y, 0.0, 0.0, 0.0, z]).unwrap();
    IsotropicNoise { inner_product, strength: 1.0 }
}

pub fn start() -> Vector3<f64> {
    Vector3::new(0.8, 0.0, 0.6)
}

pub fn exact_mean(t: f64) -> Vector3<f64> {
    let matrix =
        |k: usize| Matrix3::from_fn(|i, j| Vector3::ith(j, 1.0).cross(&Vector3::ith(k, 1.0))[i]);
    let noise = (0..3).map(|k| matrix(k).pow(2) * (0.5 * STRENGTHS[k].powi(2)));
    let rate = matrix(2) + noise.sum::<Matrix3<f64>>();
    (1..40).rev().fold(start(), |sum, k| start() + rate * sum * (t / f64::from(k)))
}

pub type Spin<N> = Noisy<RungeKutta, HopfRealisation, Axial, N>;

pub fn spin<N>((rule, stages): (NoiseRule, usize), noise: N, interval: f64) -> Spin<N>
where
    N: Noise<LiePoisson<So3>>,
{
    let paths = BrownianPaths::new(9, interval).unwrap();
    let scheme = RungeKutta::gauss(stages).unwrap();
    Noisy::new(scheme, HOPF, Axial(1.0), noise, paths).with_rule(rule)
}

/// One field of noise, along e₃ as the field is.
struct Commuting;

impl<T: Real> Noise<LiePoisson<So3>, T> for Commuting {
    fn count(&self) -> usize {
        1
    }

    fn element(&self, _: &Covector<Vector3<T>>, _: T, weights: &[T]) -> Vector3<T> {
        Vector3::new(T::zero(), T::zero(), weights[0] * STRENGTHS[2])
    }
}

/// Fields along the first axes whose strengths depend on the spin, (0.6 + 0.5 Π₁) e₁ and (0.6 + 0.5 Π₂) e₂.
struct Following(usize);

impl<T: Real> Noise<LiePoisson<So3>, T> for Following {
    fn count(&self) -> usize {
        self.0
    }

    fn element(&self, Covector(s): &Covector<Vector3<T>>, _: T, weights: &[T]) -> Vector3<T> {
        let second = weights.get(1).map_or(T::zero(), |weight| *weight * (s.y * 0.5 + 0.6));
        Vector3::new(weights[0] * (s.x * 0.5 + 0.6), second, T::zero())
    }
}

/// Returns the end of a path at t = 1.
fn end_of_path<N>(noisy: &Spin<N>, path: u64, step: f64) -> Vector3<f64>
where
    N: Noise<LiePoisson<So3>>,
{
    let start = on_path(Covector(start()), path);
    noisy.after(&start, step, (1.0 / step).round() as u64).unwrap().momentum.0.0
}

/// Returns the root mean square distances of paths from those of a step `fine` with all noise together, for 64, 32, 16 and 8 of
/// these steps.
fn strong_errors<N: Noise<LiePoisson<So3>>>(
    rule: NoiseRule,
    noise: impl Fn() -> N,
    (paths, fine): (u64, f64),
) -> Vec<(f64, f64)> {
    let [noisy, other] = [rule, NoiseRule::Together].map(|rule| spin((rule, 1), noise(), fine));
    let reference: Vec<_> = (0..paths).map(|path| end_of_path(&other, path, fine)).collect();
    let errors = [64.0, 32.0, 16.0, 8.0].map(|count| {
        let (step, squares) = (count * fine, (0..).zip(&reference));
        let squares =
            squares.map(|(path, end)| (end_of_path(&noisy, path, step) - end).norm_squared());
        (step, (squares.sum::<f64>() / paths as f64).sqrt())
    });
    errors.into()
}

#[test]
#[ignore = "long"]
fn the_strong_order_is_one_half_or_one_if_the_noise_commutes() {
    let any = strong_errors(NoiseRule::Together, noise, (60, 1.0 / 256.0));
    let order = fitted_order(&any, 1e-14).unwrap();
    assert!((order - 0.5).abs() < 0.15, "{order} {any:?}");
    let commuting = strong_errors(NoiseRule::Together, || Commuting, (60, 1.0 / 256.0));
    let order = fitted_order(&commuting, 1e-14).unwrap();
    assert!((order - 1.0).abs() < 0.2, "{order} {commuting:?}");
}

/// One field commutes with itself, whatever its strength depends on.
#[test]
#[ignore = "long"]
fn noise_that_follows_the_spin_has_the_strong_orders_of_noise_that_does_not() {
    for rule in [NoiseRule::Together, NoiseRule::Alternating] {
        for (count, expected) in [(2, 0.5), (1, 1.0)] {
            let errors = strong_errors(rule, || Following(count), (60, 1.0 / 1024.0));
            let order = fitted_order(&errors, 1e-14).unwrap();
            assert!((order - expected).abs() < 0.2, "{rule:?} {count}: {order} {errors:?}");
        }
    }
}

/// A field along e₃ as strong as a function of Π₃, which is constant along its turns.
struct OfLatitude;

fn strength<T: Real>(z: T) -> T {
    z * z * 0.8 + 0.5
}

impl<T: Real> Noise<LiePoisson<So3>, T> for OfLatitude {
    fn count(&self) -> usize {
        1
    }

    fn element(&self, Covector(s): &Covector<Vector3<T>>, _: T, weights: &[T]) -> Vector3<T> {
        Vector3::new(T::zero(), T::zero(), weights[0] * strength(s.z))
    }
}

/// Returns the strong and the weak errors at t = 1 against the turns by −1 − σ(Π₃) W(1) on the same paths, relative to which the
/// errors of sampling are small.
fn errors_at_latitudes(method: (NoiseRule, usize)) -> [Vec<(f64, f64)>; 2] {
    let (paths, fine) = (200, 1.0 / 32.0);
    let noisy = spin(method, OfLatitude, fine);
    let exact = |path| {
        let mut increment = [0.0];
        noisy.paths().write_increments(path, 0.0, 32.0, &mut increment);
        let angle = -1.0 - strength(start().z) * increment[0];
        Rotation3::from_axis_angle(&Vector3::z_axis(), angle) * start()
    };
    let errors = [0.25, 0.125, 0.0625, 0.03125].map(|step| {
        let (mut squares, mut mean) = (0.0, Vector3::zeros());
        for path in 0..paths {
            let error = end_of_path(&noisy, path, step) - exact(path);
            squares += error.norm_squared() / paths as f64;
            mean += error / paths as f64;
        }
        (step, squares.sqrt(), mean.norm())
    });
    [errors.map(|(step, error, _)| (step, error)), errors.map(|(step, _, error)| (step, error))]
        .map(Vec::from)
}

/// The midpoint rule misses a turn by φ by φ³/12, and that of two stages by φ⁵/720, with φ² of the size h.
#[test]
fn noise_that_depends_on_the_state_has_orders_one_and_two() {
    let (together, alternating) = (NoiseRule::Together, NoiseRule::Alternating);
    for (method, expected) in [
        ((together, 1), 1.0),
        ((alternating, 1), 1.0),
        ((together, 2), 2.0),
        ((alternating, 2), 2.0),
    ] {
        let [strong, weak] = errors_at_latitudes(method);
        for errors in [strong, weak] {
            let order = fitted_order(&errors, 1e-14).unwrap();
            assert!((order - expected).abs() < 0.25, "{method:?}: {order} {errors:?}");
        }
    }
}

/// A rule, the number of stages of Gauss's method, and whether the noise says that it is constant.
type Method = (NoiseRule, usize, bool);

/// The methods and their weak orders. The noise acts for times of the size √h, so that the second rule needs exact flows, or two stages.
const METHODS: [(Method, f64); 5] = [
    ((NoiseRule::Together, 1, true), 1.0),
    ((NoiseRule::Alternating, 1, false), 1.0),
    ((NoiseRule::Alternating, 2, false), 2.0),
    ((NoiseRule::Alternating, 1, true), 2.0),
    ((NoiseRule::Alternating, 2, true), 2.0),
];

/// Returns the turn of a step with the constant field v, dΠ/dt = Π × v over the time 1. On C² Gauss's method is the diagonal
/// Padé approximation of exp(iφ) with φ = |v|/2, whose angle is twice that of its numerator; Π turns by twice the angle of C².
/// Without stages the turn is exact.
pub fn turn(v: Vector3<f64>, stages: Option<usize>) -> Matrix3<f64> {
    let phi = v.norm() / 2.0;
    let numerator = match stages {
        None => phi / 2.0,
        Some(1) => (phi / 2.0).atan(),
        Some(_) => (phi / 2.0).atan2(1.0 - phi * phi / 12.0),
    };
    match Unit::try_new(-v, 0.0) {
        Some(axis) => Rotation3::from_axis_angle(&axis, 4.0 * numerator).into_inner(),
        None => Matrix3::identity(),
    }
}

/// Returns the mean of a function of normal numbers by the trapezoidal rule, which converges faster than any power.
fn mean_over_normals(f: &dyn Fn(f64) -> Matrix3<f64>) -> Matrix3<f64> {
    let sum = (-16..=16).map(|i| {
        let x = 0.5 * f64::from(i);
        let density = (-0.5 * x * x).exp() / core::f64::consts::TAU.sqrt();
        f(x) * (0.5 * density)
    });
    sum.fold(Matrix3::zeros(), |sum, term| sum + term)
}

/// Returns the mean of the method itself at t = 2, without sampling.
fn mean_of_method((rule, stages, is_exact): Method, count: u64) -> Vector3<f64> {
    let is_exact = is_exact && rule == NoiseRule::Alternating;
    mean_of_turns(rule, [Some(stages), if is_exact { None } else { Some(stages) }], count)
}

/// Returns the mean at t = 2 of steps whose turns by the drift and by the noise have so many stages or are exact; those together have
/// the turns of the noise. The equations are linear, so that it is a power of the mean matrix of a step.
pub fn mean_of_turns(
    rule: NoiseRule,
    [of_drift, of_noise]: [Option<usize>; 2],
    count: u64,
) -> Vector3<f64> {
    let step = 2.0 / count as f64;
    let drift = Vector3::z() * step;
    let [a, b, c] = STRENGTHS.map(|strength| strength * step.sqrt());
    let mean = match rule {
        NoiseRule::Together => mean_over_normals(&|x| {
            mean_over_normals(&|y| {
                mean_over_normals(&|z| turn(drift + Vector3::new(a * x, b * y, c * z), of_noise))
            })
        }),
        NoiseRule::Alternating => {
            let [a, b, c] = [Vector3::x() * a, Vector3::y() * b, Vector3::z() * c]
                .map(|axis| mean_over_normals(&|x| turn(axis * x, of_noise)));
            let half = turn(drift * 0.5, of_drift);
            half * (a * b * c + c * b * a) * half * 0.5
        }
    };
    (0..count).fold(start(), |s, _| mean * s)
}

/// Without errors of sampling the orders are seen at short steps.
#[test]
fn the_weak_orders_are_one_and_two() {
    for (method, expected) in METHODS {
        let errors: Vec<_> = [32, 64, 128]
            .map(|count| {
                (2.0 / count as f64, (mean_of_method(method, count) - exact_mean(2.0)).norm())
            })
            .into();
        let order = fitted_order(&errors, 1e-14).unwrap();
        assert!((order - expected).abs() < 0.1, "{method:?}: {order} {errors:?}");
    }
}

/// Checks that means over paths are those of the methods, which are far from the exact ones: within four standard errors.
fn require_means_of_methods(paths: u64, counts: &[u64]) {
    for (method, _) in METHODS {
        for &count in counts {
            let step = 2.0 / count as f64;
            let (rule, stages, is_constant) = method;
            let noise = Told { noise: noise(), is_constant };
            let noisy: Spin<Told> = spin((rule, stages), noise, step);
            let found = means(&noisy, Covector(start()), (paths, step, count), |s| s.0.into());
            let expected = mean_of_method(method, count);
            for ((mean, deviation), expected) in found.iter().zip(&expected) {
                assert!((mean - expected).abs() < 4.0 * deviation, "{method:?} {count}: {found:?}");
            }
        }
    }
}

#[test]
#[ignore = "long"]
fn means_over_paths_are_those_of_the_methods() {
    require_means_of_methods(2_000, &[2, 4]);
    // Control: the exact mean is far from that of the midpoint rule at these steps.
    let error = (mean_of_method((NoiseRule::Together, 1, true), 2) - exact_mean(2.0)).norm();
    assert!(error > 0.05, "{error}");
}

#[test]
#[ignore = "a million paths for each step"]
fn means_over_a_million_paths_are_those_of_the_methods_many_times() {
    require_means_of_methods(1_000_000, &[2, 3, 4, 6, 8]);
}
