//! The estimated error of a run against its true one, that of a run by Gauss's method of order 16 with shorter steps.

use heavytop::HeavyTop;
use heavytop::collective_integrators::AnyState;
use heavytop::lie_poisson::Vector;
use heavytop::methods::{Formulation, Method, SchemeName};
use heavytop::prelude::*;
use heavytop::{Body, Invariant};

/// The number of samples that are compared.
const SAMPLES: usize = 64;

/// Makes a run, and keeps samples at equal distances of so many steps.
fn samples(
    method: Method,
    (top, start): (&HeavyTop, &Se3Dual),
    (step, stride): (f64, u64),
) -> Vec<Se3Dual> {
    let integrator = method.integrator(top).unwrap();
    let run = integrator.trajectory(&AnyState::of(start), step).unwrap();
    let samples = run.step_by(stride as usize).skip(1).take(SAMPLES);
    let momentum = |mu: AnyState| Se3Dual::from_coordinates(|i| mu.as_slice()[i]);
    samples.map(|sample| momentum(sample.unwrap().momentum)).collect()
}

/// Returns the estimated and the true error of a run; the reference makes `finer` steps for `coarser` of the run.
fn errors(
    (top, start): (&HeavyTop, &Se3Dual),
    (formulation, scheme): (Formulation, SchemeName),
    (step, steps): (f64, u64),
    (finer, coarser): (u64, u64),
) -> (f64, f64) {
    let method = Method::new(formulation, scheme, 0.0).unwrap();
    let reference = Method::new(Formulation::Reduced, SchemeName::Gauss(8), 0.0).unwrap();
    let stride = steps / SAMPLES as u64;
    let run = samples(method, (top, start), (step, stride));
    let fine = (step * coarser as f64 / finer as f64, stride * finer / coarser);
    let exact = samples(reference, (top, start), fine);
    let size = |of: fn(&Se3Dual) -> f64| exact.iter().map(of).fold(of(start), f64::max);
    let (pi, gamma) = (size(|mu| mu.0.0.norm()), size(|mu| mu.0.1.norm()));
    let relative = |(a, b): (&Se3Dual, &Se3Dual)| {
        let apart = *a - *b;
        (apart.0.0.norm() / pi).max(apart.0.1.norm() / gamma)
    };
    let truth = run.iter().zip(&exact).map(relative).fold(0.0, f64::max).min(1.0);
    (method.accuracy(top, start, (step, steps), &|| true).unwrap().error.unwrap(), truth)
}

fn mu(pi: [f64; 3], gamma: [f64; 3]) -> Se3Dual {
    Se3Dual::new(pi.into(), gamma.into())
}

/// An integrable top and its start, and a chaotic one with an exponent of 0.22 per second.
fn integrable() -> (HeavyTop, Se3Dual) {
    (HeavyTop::kovalevskaya(1.0, 1.0).unwrap(), mu([2.0, 3.0, 4.0], [0.6, 0.0, 0.8]))
}

fn chaotic() -> (HeavyTop, Se3Dual) {
    let body = Body {
        inertia: Vector3::new(1.0, 1.7, 2.2),
        mass: 1.0,
        gravity: 9.81,
        length: 0.5,
        center_of_mass: Vector3::new(0.6, 0.0, 0.8),
    };
    (HeavyTop::new(&body).unwrap(), mu([1.0, 2.0, 1.0], [0.0, 0.6, 0.8]))
}

/// Runs that are repeated as a whole: the estimate has no model, so that it differs from the true error by the error of
/// half the step, and by what happens between the samples.
#[test]
#[ignore = "long"]
fn the_estimate_of_a_whole_run_is_the_error() {
    use Formulation::{Collective, Direct, Reduced};
    for (name, (top, start)) in [("integrable", integrable()), ("chaotic", chaotic())] {
        for (method, run) in [
            ((Collective, SchemeName::ImplicitMidpoint), (0.01, 1024)),
            ((Collective, SchemeName::Gauss(4)), (0.1, 512)),
            ((Collective, SchemeName::Gauss(4)), (0.2, 128)),
            ((Reduced, SchemeName::Gauss(2)), (0.05, 512)),
            ((Direct, SchemeName::Rk4), (0.02, 512)),
        ] {
            let (estimate, truth) = errors((&top, &start), method, run, (4, 1));
            let ratio = estimate / truth;
            assert!(
                0.5 < ratio && ratio < 2.0,
                "{name} {method:?} {run:?}: {estimate:e} {truth:e}"
            );
        }
    }
}

/// Only 5120 of 20480 steps are repeated; the rest is the growth of the error, linear here and quadratic by RK4.
#[test]
fn the_estimate_of_a_long_run_grows_as_the_error() {
    let (top, start) = integrable();
    for (method, step) in [
        ((Formulation::Reduced, SchemeName::ImplicitMidpoint), 0.004),
        ((Formulation::Direct, SchemeName::Rk4), 0.004),
    ] {
        let (estimate, truth) = errors((&top, &start), method, (step, 20_480), (1, 10));
        let ratio = estimate / truth;
        assert!(1.0 / 3.0 < ratio && ratio < 3.0, "{method:?}: {estimate:e} {truth:e}");
    }
}

/// A run that is right to round-off is said to be, and one that is wrong altogether, too. The invariants are the same.
#[test]
fn the_finest_and_the_coarsest_steps_are_what_they_are() {
    let (top, start) = integrable();
    let gauss = Method::new(Formulation::Collective, SchemeName::Gauss(8), 0.0).unwrap();
    let fine = gauss.accuracy(&top, &start, (0.05, 1000), &|| true).unwrap();
    assert!(fine.error.unwrap() < 1e-12 && fine.warning().is_none(), "{fine:?}");
    let midpoint = Method::new(Formulation::Reduced, SchemeName::ImplicitMidpoint, 0.0).unwrap();
    let coarse = midpoint.accuracy(&top, &start, (0.1, 1000), &|| true).unwrap();
    assert!(coarse.error.unwrap() > 0.5 && coarse.warning().is_some(), "{coarse:?}");
    let ends = samples(midpoint, (&top, &start), (0.1, 15));
    let f1 = Invariant::VerticalSquared;
    assert!(ends.iter().all(|mu| (f1.value(&top, mu) - 1.0).abs() < 1e-12));
}

/// The estimate is a pure number: the same with other units of mass, and for a motion backward in time.
#[test]
fn the_estimate_has_no_units_and_no_direction() {
    let (top, start) = integrable();
    let gauss = Method::new(Formulation::Reduced, SchemeName::Gauss(2), 0.0).unwrap();
    let plain = gauss.accuracy(&top, &start, (0.05, 400), &|| true).unwrap();
    for unit in [1e-30, 1e30] {
        let heavy = HeavyTop::kovalevskaya(unit, unit).unwrap();
        let scaled = Se3Dual::new(start.0.0 * unit, start.0.1);
        let found = gauss.accuracy(&heavy, &scaled, (0.05, 400), &|| true).unwrap();
        let ratio = found.error.unwrap() / plain.error.unwrap();
        assert!(
            (ratio - 1.0).abs() < 0.2 && (found.angle / plain.angle - 1.0).abs() < 1e-9,
            "{found:?}"
        );
    }
    let back = gauss.accuracy(&top, &start, (-0.05, 400), &|| true).unwrap();
    assert!(back.error > Some(plain.error.unwrap() / 10.0) && back.angle > 0.2, "{back:?}");
}
