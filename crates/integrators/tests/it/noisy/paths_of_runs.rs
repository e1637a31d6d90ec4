//! That the noise of a run depends on the seed, the path and the time alone, and is divided where its strength jumps.

use super::support::{Axial, InField, OnPath, isotropic, langevin, on_path};
use collective_integrators::{
    BrownianPaths, Ensemble, Integrator, Laned, NoiseRule, Noisy, NoisyReduced, RungeKutta, Start,
    laws,
};
use lie_poisson::{
    Automatic, Covector, Energy, InputTable, Interpolation, LiePoisson, Noise, Pair, Point, Real,
    So3, Time,
};
use momentum_map::{HOPF, Quaternions};
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

/// A field along e₃ with a held strength, which jumps within the steps.
#[derive(Clone)]
struct Held {
    strength: InputTable,
    /// Whether the noise tells its jumps.
    tells: bool,
}

const TIMES: [f64; 4] = [0.0, 0.33, 0.77, 5.0];

const STRENGTHS: [f64; 4] = [0.5, 2.0, -1.0, -1.0];

impl Held {
    fn new(tells: bool) -> Self {
        let (times, values) = (TIMES.to_vec(), STRENGTHS.to_vec());
        Self { strength: InputTable::new(times, values, Interpolation::Constant).unwrap(), tells }
    }
}

impl<T: Real> Noise<LiePoisson<So3>, T> for Held {
    fn count(&self) -> usize {
        1
    }

    fn element(&self, _: &Covector<Vector3<T>>, time: T, weights: &[T]) -> Vector3<T> {
        Vector3::new(T::zero(), T::zero(), weights[0] * self.strength.at(time))
    }

    fn is_constant(&self) -> bool {
        true
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        self.strength.next_break(time, forward).filter(|_| self.tells)
    }
}

/// Returns the spin at t = 1 on a path: dΠ = Π × e₃ σ(t) ∘ dW turns it by −∫ σ dW.
fn exact(path: u64) -> Vector3<f64> {
    let noise = (0..3).map(|i| {
        let mut increment = [0.0];
        let (from, to) = (TIMES[i] / STEP, TIMES[i + 1].min(1.0) / STEP);
        paths(5).write_increments(path, from, to, &mut increment);
        STRENGTHS[i] * increment[0]
    });
    let angle = -noise.sum::<f64>();
    Vector3::new(0.6 * angle.cos(), 0.6 * angle.sin(), 0.8)
}

/// Returns the largest error at t = 1 over some paths.
fn error<I: Start<Momentum = OnPath<Covector<Vector3<f64>>>>>(integrator: &I) -> f64 {
    let errors = (0..5).map(|path| {
        let end = integrator.after(&on_path(start(), path), STEP, 20).unwrap();
        (end.momentum.0.0 - exact(path)).norm()
    });
    errors.fold(0.0, f64::max)
}

#[test]
fn steps_are_divided_at_the_jumps_of_a_noise() {
    let rule = NoiseRule::Alternating;
    let lifted = |tells| {
        let scheme = RungeKutta::implicit_midpoint();
        error(&Noisy::new(scheme, HOPF, Axial(0.0), Held::new(tells), paths(5)).with_rule(rule))
    };
    let reduced = |tells| {
        let noise = Held::new(tells);
        error(&NoisyReduced::new(Quaternions, Axial(0.0), noise, paths(5)).with_rule(rule))
    };
    // Turns by constant fields are exact. A path has slopes up to 10⁴ at its finest resolution, 2⁻²⁴ of a step, times the errors
    // of 1e-15 of the time.
    assert!(lifted(true) < 1e-10, "{:e}", lifted(true));
    assert!(reduced(true) < 1e-10, "{:e}", reduced(true));
    // Control: two steps of twenty have the strength of their middle.
    assert!(lifted(false) > 0.01, "{:e}", lifted(false));
    assert!(reduced(false) > 0.01, "{:e}", reduced(false));
}
