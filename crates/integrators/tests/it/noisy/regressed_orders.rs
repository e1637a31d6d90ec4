//! Strong and weak orders by regression over many paths, with the standard errors of the slopes.

use super::noisy_orders::{STRENGTHS, Spin, exact_mean, mean_of_turns, noise, spin, start, turn};
use super::support::{AboutAxis, on_path};
use collective_integrators::{
    BatchIntegrator, BrownianPaths, Ensemble, Integrator, Laned, NoiseRule, Start,
};
use lie_poisson::{Covector, LiePoisson, Noise, So3};
use momentum_map::{HOPF, PoissonMap};
use nalgebra::{Matrix4, Vector3, Vector4};
use rayon::prelude::*;
use std::sync::Mutex;

/// Returns the ends of so many paths, in lanes and on all threads.
fn ends<N>(make: impl Fn() -> Spin<N>, paths: u64, step: f64, steps: u64) -> Vec<Vector3<f64>>
where
    N: Noise<LiePoisson<So3>> + Sync,
    Laned<Spin<N>>: BatchIntegrator<Member = <Spin<N> as Integrator>::State> + Sync,
{
    let (alone, lanes) = (make(), Laned::new(make()));
    let first = |path| alone.start(&on_path(Covector(start()), path)).unwrap();
    let ends = Mutex::new(vec![Vector3::zeros(); paths as usize]);
    Ensemble::new(lanes).stream(paths, first, step, steps, |chunk| {
        assert!(chunk.failures.is_empty());
        let found: Vec<_> = chunk.members.iter().map(|z| HOPF.apply(&z.0).0).collect();
        ends.lock().unwrap()[chunk.first as usize..][..found.len()].copy_from_slice(&found);
    });
    ends.into_inner().unwrap()
}

/// The slope p of a fit ln e = a + p ln h + b h + c h², whose last terms are the next powers of the expansion, as weights of the ln e.
fn slope_weights(steps: &[f64]) -> Vec<f64> {
    let row = |h: f64| Vector4::new(1.0, h.ln(), h, h * h);
    let normal = steps.iter().map(|h| row(*h) * row(*h).transpose()).sum::<Matrix4<f64>>();
    let inverse = normal.try_inverse().unwrap();
    steps.iter().map(|h| (inverse * row(*h)).y).collect()
}

fn mean_and_error(values: &[f64]) -> (f64, f64) {
    let number = values.len() as f64;
    let mean = values.iter().sum::<f64>() / number;
    let variance = values.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (number - 1.0);
    (mean, (variance / number).sqrt())
}

/// Returns the end of the exact turns with the increments of a path: all together, or in the order that the coin says. They have a mean
/// that is known by quadrature.
fn end_of_turns(rule: NoiseRule, path: u64, count: u64) -> Vector3<f64> {
    let step = 2.0 / count as f64;
    let paths = BrownianPaths::new(9, step).unwrap();
    let drift = Vector3::z() * step;
    (0..count).fold(start(), |s, n| {
        let mut noise = [0.0; 4];
        paths.write_increments(
            path,
            n as f64,
            (n + 1) as f64,
            &mut noise[..3 + usize::from(rule == NoiseRule::Alternating)],
        );
        let of_noise = |k: usize| Vector3::ith(k, STRENGTHS[k] * noise[k]);
        match rule {
            NoiseRule::Together => turn(drift + of_noise(0) + of_noise(1) + of_noise(2), None) * s,
            NoiseRule::Alternating => {
                let half = turn(drift * 0.5, None);
                let order = if noise[3] >= 0.0 { [0, 1, 2] } else { [2, 1, 0] };
                half * order.iter().fold(half * s, |s, k| turn(of_noise(*k), None) * s)
            }
        }
    })
}

/// Returns the order of the mean along a direction by paths of 2/h steps for several h, with its standard error. The means are those of
/// the differences from the exact turns on the same paths, whose means are known.
fn weak_order(rule: NoiseRule, paths: u64) -> (f64, f64) {
    let counts = [4_u64, 6, 8, 16, 32];
    let steps = counts.map(|count| 2.0 / count as f64);
    let exact = exact_mean(2.0);
    let direction = (mean_of_turns(
        rule,
        [Some(1), if rule == NoiseRule::Together { Some(1) } else { None }],
        32,
    ) - exact)
        .normalize();
    let (mut order, mut variance) = (0.0, 0.0);
    for ((count, step), weight) in counts.into_iter().zip(steps).zip(slope_weights(&steps)) {
        let ends = ends(|| spin((rule, 1), noise(), step), paths, step, count);
        let raw: Vec<f64> = ends.iter().map(|s| direction.dot(&(s - exact))).collect();
        let differences: Vec<f64> = (0..paths)
            .into_par_iter()
            .map(|path| direction.dot(&(ends[path as usize] - end_of_turns(rule, path, count))))
            .collect();
        let known = direction.dot(&(mean_of_turns(rule, [None, None], count) - exact));
        let (mean, deviation) = mean_and_error(&differences);
        let (bias, (of_paths, their_error)) = (known + mean, mean_and_error(&raw));
        println!(
            "{rule:?} h = {step}: bias {bias:e} ± {deviation:e}, without the control {of_paths:e} ± {their_error:e}"
        );
        // The statistical error is far below the bias, and the paths themselves agree.
        assert!(deviation < 0.05 * bias && (of_paths - bias).abs() < 4.0 * their_error);
        order += weight * bias.ln();
        variance += (weight * deviation / bias).powi(2);
    }
    (order, variance.sqrt())
}

#[test]
#[ignore = "a million paths for each step"]
fn weak_orders_by_a_million_paths_many_times() {
    let [one, two] =
        [NoiseRule::Together, NoiseRule::Alternating].map(|rule| weak_order(rule, 1_000_000));
    println!("weak orders {one:?} {two:?}");
    for ((order, error), (expected, other)) in [(one, (1.0, 2.0)), (two, (2.0, 1.0))] {
        assert!((order - expected).abs() < 4.0 * error, "{order} ± {error}");
        // Control: the other rule fails the fit.
        assert!((order - other).abs() > 4.0 * error, "{order} ± {error}");
    }
}

/// Returns the order of the root mean square distance at t = 1 from paths of a much smaller step, with its standard error from groups
/// of paths.
fn strong_order<N>(noise: impl Fn() -> N, paths: u64) -> (f64, f64)
where
    N: Noise<LiePoisson<So3>> + Sync,
    Laned<Spin<N>>: BatchIntegrator<Member = <Spin<N> as Integrator>::State> + Sync,
{
    const FINE: f64 = 1.0 / 4096.0;
    const GROUPS: usize = 20;
    let steps = [4.0, 8.0, 16.0, 32.0, 64.0].map(f64::recip);
    let make = || spin((NoiseRule::Together, 1), noise(), FINE);
    let all = |step: f64| ends(make, paths, step, step.recip() as u64);
    let (exact, ends) = (all(FINE), steps.map(all));
    let (length, weights) = (exact.len() / GROUPS, slope_weights(&steps));
    let of_group = |group: usize| {
        let range = group * length..(group + 1) * length;
        let error = |ends: &[Vector3<f64>]| {
            let pairs = ends[range.clone()].iter().zip(&exact[range.clone()]);
            pairs.map(|(end, exact)| (end - exact).norm_squared()).sum::<f64>().sqrt()
        };
        ends.iter().zip(&weights).map(|(ends, weight)| weight * error(ends).ln()).sum()
    };
    mean_and_error(&(0..GROUPS).map(of_group).collect::<Vec<f64>>())
}

#[test]
#[ignore = "twenty thousand paths for each step"]
fn strong_orders_by_many_paths_many_times() {
    let (any, commuting) =
        (strong_order(noise, 20_000), strong_order(|| AboutAxis(STRENGTHS[0]), 20_000));
    println!("strong orders {any:?} {commuting:?}");
    for ((order, error), (expected, other)) in [(any, (0.5, 1.0)), (commuting, (1.0, 0.5))] {
        assert!((order - expected).abs() < 4.0 * error, "{order} ± {error}");
        // Control: noise of the other kind fails the fit.
        assert!((order - other).abs() > 4.0 * error, "{order} ± {error}");
    }
}
