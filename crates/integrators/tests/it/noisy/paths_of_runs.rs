//! That the noise of a run depends on the seed, the path and the time alone.

use super::support::{Axial, InField, isotropic, langevin, on_path};
use collective_integrators::{
    BrownianPaths, Ensemble, Integrator, Laned, NoiseRule, Noisy, RungeKutta, Start, laws,
};
use lie_poisson::{Automatic, Covector, Energy, LiePoisson, Pair, Point, Real, So3, Time};
use momentum_map::HOPF;
use nalgebra::Vector3;
use std::sync::Mutex;

#[derive(Clone, Copy)]
struct Cubic;

impl Energy for Cubic {
    type Space = LiePoisson<So3>;

    fn energy<T: Real>(&self, Covector(s): &Point<Self::Space, T>) -> T {
        s.x * s.x + s.y * s.y * s.z * 0.5 - s.z
    }
}

const STEP: f64 = 0.05;

fn start() -> Covector<Vector3<f64>> {
    Covector(Vector3::new(0.6, 0.0, 0.8))
}

fn paths(seed: u64) -> BrownianPaths {
    BrownianPaths::new(seed, STEP).unwrap()
}

#[test]
fn members_in_lanes_and_on_threads_have_the_bits_of_single_runs() {
    for rule in [NoiseRule::Together, NoiseRule::Alternating] {
        let spin = || {
            langevin((HOPF, LiePoisson::minus(So3), Automatic(Cubic)), (0.3, 0.7), paths(1))
                .with_rule(rule)
        };
        let (single, laned) = (spin(), Laned::new(spin()));
        let ends = Mutex::new(vec![None; 37]);
        let first = |path| single.start(&on_path(start(), path)).unwrap();
        Ensemble::new(laned).stream(37, first, STEP, 60, |chunk| {
            assert!(chunk.failures.is_empty());
            for (path, member) in (chunk.first as usize..).zip(chunk.members) {
                ends.lock().unwrap()[path] = Some(*member);
            }
        });
        for (path, end) in (0..).zip(ends.into_inner().unwrap()) {
            let alone = single.after(&on_path(start(), path), STEP, 60).unwrap().state;
            assert_eq!(end, Some(alone), "{rule:?}, path {path}");
        }
    }
}

#[test]
fn a_run_that_is_resumed_has_the_bits_of_one_that_is_not() {
    let spin = langevin((HOPF, LiePoisson::minus(So3), Automatic(Cubic)), (0.3, 0.7), paths(1));
    let whole = spin.after(&on_path(start(), 5), STEP, 1500).unwrap().state;
    let first = spin.after(&on_path(start(), 5), STEP, 1024).unwrap().state;
    let resumed = spin.trajectory_resumed(first, 1024, STEP).take(477).last().unwrap().unwrap();
    assert_eq!(resumed.state, whole);
    // Another path and another seed are other noise.
    let other = langevin((HOPF, LiePoisson::minus(So3), Automatic(Cubic)), (0.3, 0.7), paths(2));
    let ends = [(&spin, 5), (&spin, 6), (&other, 5)]
        .map(|(spin, path)| spin.after(&on_path(start(), path), STEP, 1500).unwrap().momentum.0.0);
    assert!((ends[0] - ends[1]).norm() > 0.1 && (ends[0] - ends[2]).norm() > 0.1);
}

#[test]
fn a_step_back_undoes_a_step() {
    let noise = isotropic(0.5);
    let spin = Noisy::new(RungeKutta::gauss(2).unwrap(), HOPF, Axial(1.0), noise, paths(3));
    let there = spin.after(&on_path(start(), 2), STEP, 200).unwrap().momentum;
    let back = spin.after(&there, -STEP, 200).unwrap().momentum;
    assert!((back.0.0 - start().0).norm() < 1e-12 && back.1.1.0.abs() < 1e-12);
    assert!((there.0.0 - start().0).norm() > 0.1);
}

#[test]
fn no_noise_is_the_driven_motion() {
    let noise = isotropic(0.0);
    let gauss = || RungeKutta::gauss(2).unwrap();
    let noisy = Noisy::new(gauss(), HOPF, Axial(1.0), noise, paths(3));
    let driven = collective_integrators::Driven::new(gauss(), HOPF, Axial(1.0));
    let Pair(end, Pair(_, Time(time))) =
        noisy.after(&on_path(start(), 2), STEP, 200).unwrap().momentum;
    let expected = driven.after(&Pair(start(), Time(0.0)), STEP, 200).unwrap().momentum;
    assert!((end.0 - expected.0.0).norm() < 1e-13 && (time - 10.0).abs() < 1e-12);
}

/// In units in which a spin is s and a second τ times as large, B is 1/τ, kT is s/τ and θ is 1/s of what they were.
#[test]
fn units_do_not_matter() {
    let end = |(s, tau): (f64, f64)| {
        let paths = BrownianPaths::new(1, STEP * tau).unwrap();
        let system = (HOPF, LiePoisson::minus(So3), Automatic(InField(1.0 / tau)));
        let spin = langevin(system, (0.3 / s, 0.7 * s / tau), paths);
        let start = on_path(Covector(start().0 * s), 5);
        spin.after(&start, STEP * tau, 100).unwrap().momentum.0.0 / s
    };
    let one = end((1.0, 1.0));
    assert!((one - start().0).norm() > 0.1);
    for (s, tau) in [(1e30, 1.0), (1e-30, 1.0), (1.0, 1e30), (1.0, 1e-30), (1e-30, 1e30)] {
        // A hundred steps of some ten roundings.
        assert!((end((s, tau)) - one).norm() < 1e-12, "{s:e} {tau:e}");
    }
}

/// At the temperature 0 there is no noise, and both poles are at rest, also the one that is unstable.
#[test]
fn poles_are_at_rest_at_temperature_zero() {
    for pole in [Vector3::z(), -Vector3::z()] {
        let end = |temperature| {
            let system = (HOPF, LiePoisson::minus(So3), Automatic(InField(1.0)));
            let spin = langevin(system, (0.3, temperature), paths(1));
            spin.after(&on_path(Covector(pole), 5), STEP, 100).unwrap().momentum.0.0
        };
        assert!((end(0.0) - pole).norm() < 1e-13);
        assert!((end(1e-3) - pole).norm() > 1e-3);
    }
}

/// A step of size 0 has no noise, resumption and forgetting keep the bits, and what is not a number is refused, also as the number of
/// a path.
#[test]
fn noisy_motions_obey_the_laws_of_integrators() {
    for rule in [NoiseRule::Together, NoiseRule::Alternating] {
        let h = (HOPF, LiePoisson::minus(So3), Automatic(Cubic));
        let spin = langevin(h, (0.3, 0.7), paths(1)).with_rule(rule);
        let state = spin.start(&on_path(start(), 3)).unwrap();
        laws::integrator(&spin, &[state], STEP).unwrap().check(1e-13).unwrap();
        // Control: another path is another step.
        let other = spin.start(&on_path(start(), 4)).unwrap();
        let [one, two] =
            [state, other].map(|z| spin.step(&z, STEP, &mut spin.workspace()).unwrap().point);
        assert_ne!(one.0, two.0);
    }
}
