//! The stochastic midpoint rule in closed form, against that of the lift.

use super::support::{InField, isotropic, on_path};
use collective_integrators::{
    BrownianPaths, Ensemble, Integrator, Laned, NoiseRule, Noisy, NoisyReduced, RungeKutta,
    StageSolver, Start, StepError, laws,
};
use lie_poisson::{
    Automatic, Autonomous, Covector, DoubleBracket, Energy, InnerProduct, InstructionSet,
    IsotropicNoise, LiePoisson, Noise, OrbitField, Pair, Point, Power, PowerAlgebra, Real, So3,
    Time, Vector,
};
use momentum_map::{HOPF, InvertibleMultipliers, Lift, PowerMap, PowerMultipliers, Quaternions};
use nalgebra::Vector3;
use std::sync::Mutex;

const STEP: f64 = 0.1;

/// An energy of one spin.
#[derive(Clone, Copy)]
struct Cubic;

impl Energy for Cubic {
    type Space = LiePoisson<So3>;

    fn energy<T: Real>(&self, Covector(s): &Point<Self::Space, T>) -> T {
        s.x * s.x + s.y * s.y * s.z * 0.5 - s.z
    }
}

/// An energy of two spins.
#[derive(Clone, Copy)]
struct Exchange;

impl Energy for Exchange {
    type Space = LiePoisson<PowerAlgebra<So3, 2>>;

    fn energy<T: Real>(&self, Covector(Power([s, t])): &Point<Self::Space, T>) -> T {
        s.x * t.x * -1.3 - s.y * t.y - s.z * t.z * 0.7 + s.z * s.z * 0.4
    }
}

/// A field with the time in it, and a noise whose direction follows the spin.
#[derive(Clone, Copy)]
struct Turning;

impl<T: Real> OrbitField<LiePoisson<So3>, T> for Turning {
    fn element(&self, Covector(s): &Covector<Vector3<T>>, time: T) -> Vector3<T> {
        Vector3::new(time.cos(), time.sin(), s.x * 0.5)
    }

    /// The steps are divided at the times 0.25, 0.75, ….
    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        let place = (time - 0.25) / 0.5;
        let next = if forward { place.floor() + 1.0 } else { place.ceil() - 1.0 };
        Some(0.25 + 0.5 * next)
    }
}

impl<T: Real> Noise<LiePoisson<So3>, T> for Turning {
    fn count(&self) -> usize {
        2
    }

    fn element(&self, Covector(s): &Covector<Vector3<T>>, time: T, weights: &[T]) -> Vector3<T> {
        let first = Vector3::new(s.y * 0.3, T::from_f64(0.2), time.sin() * 0.1);
        first * weights[0] + s * (weights[1] * 0.4)
    }
}

fn paths() -> BrownianPaths {
    BrownianPaths::new(3, STEP).unwrap()
}

fn spin() -> Covector<Vector3<f64>> {
    Covector(Vector3::new(0.6, 0.0, 0.8))
}

/// Tests that both rules make the same steps of a system, and that another path is another one.
fn require_same_steps<M, K, X, N>(
    (map, multipliers, rule): (M, K, NoiseRule),
    (field, noise): (X, N),
    start: &Point<M::Target>,
) where
    M: Lift,
    K: InvertibleMultipliers<Space = M::Target>,
    X: OrbitField<M::Target> + Clone,
    N: Noise<M::Target> + Clone,
{
    let midpoint = RungeKutta::implicit_midpoint();
    let lifted = Noisy::new(midpoint, map, field.clone(), noise.clone(), paths()).with_rule(rule);
    let reduced = NoisyReduced::new(multipliers, field, noise, paths()).with_rule(rule);
    // Steps of an interval, of a part of one, and backward.
    for (step, steps) in [(STEP, 200), (0.07, 100), (-STEP, 100)] {
        let end = |path| {
            let start = on_path(*start, path);
            let one = reduced.after(&start, step, steps).unwrap().momentum;
            (one, lifted.after(&start, step, steps).unwrap().momentum)
        };
        let ((one, other), (another, _)) = (end(5), end(6));
        // A hundred steps of some ten roundings, which grow with the motion.
        assert!((one.0 - other.0).max_abs() < 1e-11, "{:e}", (one.0 - other.0).max_abs());
        assert!((one.1.1 - other.1.1).0.abs() < 1e-12 && one.1.0 == other.1.0);
        assert!((one.0 - another.0).max_abs() > 1e-2);
    }
}

#[test]
fn the_steps_are_those_of_the_lift() {
    let damped = |friction: f64| {
        let (space, product) = (LiePoisson::minus(So3), InnerProduct::euclidean());
        DoubleBracket::new(space, Autonomous(Automatic(Cubic)), friction, product).unwrap()
    };
    let thermal = IsotropicNoise::thermal(InnerProduct::euclidean(), (0.3, 0.7)).unwrap();
    let two = Covector(Power([spin().0, Vector3::new(0.1, 0.5, -0.4)]));
    let field = Autonomous(Automatic(Exchange));
    // Noise that follows the spin is made by the midpoint rule in both, too.
    for rule in [NoiseRule::Together, NoiseRule::Alternating] {
        let of_spin = || (HOPF, Quaternions, rule);
        require_same_steps(of_spin(), (damped(0.3), thermal.clone()), &spin());
        require_same_steps(of_spin(), (Turning, Turning), &spin());
        let (map, multipliers) = (PowerMap::<_, 2>(HOPF), PowerMultipliers::<_, 2>(Quaternions));
        require_same_steps((map, multipliers, rule), (field, isotropic(0.3)), &two);
    }
}

/// With σ√h = 10 a step turns the spin by many radians, and steps of the lift fail. The reduced rule turns by Cayley's map,
/// whatever the angle is.
#[test]
fn noise_of_any_size_keeps_the_spin_and_its_steps_have_solutions() {
    let (field, noise) = (Autonomous(Automatic(Cubic)), isotropic(10.0 / STEP.sqrt()));
    let reduced = NoisyReduced::new(Quaternions, field, noise.clone(), paths());
    let lifted = Noisy::new(RungeKutta::implicit_midpoint(), HOPF, field, noise, paths());
    let mut failed = 0;
    for path in 0..100 {
        let end = reduced.after(&on_path(spin(), path), STEP, 50).unwrap().momentum.0.0;
        assert!((end.norm() - 1.0).abs() < 1e-13, "{}", end.norm() - 1.0);
        failed += usize::from(lifted.after(&on_path(spin(), path), STEP, 50).is_err());
    }
    assert!(failed > 10, "{failed}");
}

/// In units in which a spin is s and a second τ times as large, B is 1/τ, kT is s/τ and θ is 1/s of what they were; at rest on
/// a pole at temperature 0, and for μ = 0, nothing moves.
#[test]
fn units_do_not_matter_and_what_is_at_rest_stays() {
    let end = |(s, tau): (f64, f64), temperature: f64, start: Vector3<f64>| {
        let (space, product) = (LiePoisson::minus(So3), InnerProduct::euclidean);
        let h = Autonomous(Automatic(InField(1.0 / tau)));
        let field = DoubleBracket::new(space, h, 0.3 / s, product()).unwrap();
        let noise = IsotropicNoise::thermal(product(), (0.3 / s, temperature * s / tau)).unwrap();
        let paths = BrownianPaths::new(1, STEP * tau).unwrap();
        let spin = NoisyReduced::new(Quaternions, field, noise, paths);
        let follow = |spin: &NoisyReduced<_, _, _>| {
            let start = on_path(Covector(start * s), 5);
            spin.after(&start, STEP * tau, 100).unwrap().momentum.0.0 / s
        };
        let exact = follow(&spin);
        // A hundred errors of the tolerance, in all units.
        assert!((follow(&spin.with_solver(solver(1e-6))) - exact).norm() <= 1e-4 * start.norm());
        exact
    };
    let one = end((1.0, 1.0), 0.7, spin().0);
    assert!((one - spin().0).norm() > 0.1);
    for units in [(1e30, 1.0), (1e-30, 1.0), (1.0, 1e30), (1.0, 1e-30), (1e-30, 1e30)] {
        // A hundred steps of some ten roundings.
        assert!((end(units, 0.7, spin().0) - one).norm() < 1e-12, "{units:?}");
    }
    for pole in [Vector3::z(), -Vector3::z()] {
        assert!((end((1.0, 1.0), 0.0, pole) - pole).norm() < 1e-13);
    }
    assert_eq!(end((1.0, 1.0), 0.7, Vector3::zeros()), Vector3::zeros());
}

/// A field that is too steep for the sweeps ends in an error.
#[test]
fn stages_that_do_not_converge_are_an_error() {
    #[derive(Clone, Copy)]
    struct Steep;
    impl<T: Real> OrbitField<LiePoisson<So3>, T> for Steep {
        fn element(&self, Covector(s): &Covector<Vector3<T>>, _: T) -> Vector3<T> {
            Vector3::new(s.z * 1e3, s.x * 1e3, s.y * 1e3)
        }
    }
    let reduced = NoisyReduced::new(Quaternions, Steep, isotropic(0.1), paths());
    let state = reduced.start(&on_path(spin(), 1)).unwrap();
    let failed = reduced.step(&state, STEP, &mut ()).unwrap_err();
    let has_none =
        matches!(failed, StepError::NotConverged { .. } | StepError::OtherSolution { .. });
    assert!(has_none, "{failed}");
}

/// Returns a solver that stops at a tolerance.
fn solver(tolerance: f64) -> StageSolver {
    StageSolver { tolerance, ..StageSolver::default() }
}

/// A tolerance is an error of the angle by which a step turns the spin. The turn is a rotation all the same, while the rule on the
/// space of the lift loses the Casimir to a tolerance.
#[test]
fn a_tolerance_saves_sweeps_and_keeps_the_casimir() {
    let field = Autonomous(Automatic(Cubic));
    let of_lift = |tolerance| {
        let midpoint = RungeKutta::implicit_midpoint().with_solver(solver(tolerance));
        Noisy::new(midpoint, HOPF, field, isotropic(0.5), paths())
    };
    let reduced = |tolerance| {
        NoisyReduced::new(Quaternions, field, isotropic(0.5), paths())
            .with_solver(solver(tolerance))
    };
    let start = on_path(spin(), 4);
    let follow = |tolerance: f64| {
        let integrator = reduced(tolerance);
        let (mut state, mut sweeps) = (integrator.start(&start).unwrap(), 0);
        for _ in 0..1000 {
            let made = integrator.step(&state, STEP, &mut ()).unwrap();
            (state, sweeps) = (made.point, sweeps + made.iterations);
        }
        (state.0.0, sweeps)
    };
    let ((exact, all), (near, few)) = (follow(0.0), follow(1e-6));
    // A thousand steps of some ten roundings.
    assert!((near.norm() - 1.0).abs() < 1e-12 && 2 * few < all, "{few} of {all}");
    // A thousand errors of 1e-6 at most; without any the states would be the same.
    let apart = (near - exact).norm();
    assert!(apart > 1e-12 && apart < 1e-3, "{apart:e}");
    let lost = of_lift(1e-6).after(&start, STEP, 1000).unwrap().momentum.0.0.norm() - 1.0;
    assert!(lost.abs() > 1e-10, "{lost:e}");
}

#[test]
fn members_in_lanes_have_the_bits_of_single_runs() {
    let methods = [0.0, 1e-6].map(|tolerance| (tolerance, NoiseRule::Together));
    for (tolerance, rule) in methods.into_iter().chain([(0.0, NoiseRule::Alternating)]) {
        require_bits_in_lanes(|| {
            NoisyReduced::new(Quaternions, Autonomous(Automatic(Cubic)), isotropic(0.5), paths())
                .with_solver(solver(tolerance))
                .with_rule(rule)
        });
    }
}

type CubicSpin = NoisyReduced<Quaternions, Autonomous<Automatic<Cubic>>, IsotropicNoise>;

fn require_bits_in_lanes(make: impl Fn() -> CubicSpin + Sync) {
    // At the beginning of an interval, in its midst, and where a clock has no digits for one more.
    for (set, begin) in
        InstructionSet::available().flat_map(|set| [0.0, 0.5, 1e17].map(|t| (set, t)))
    {
        let lanes = Laned::new(make()).with_instructions(set).unwrap();
        require_bits_of_single_runs(&make, lanes, begin * STEP);
    }
}

fn require_bits_of_single_runs(
    make: &(impl Fn() -> CubicSpin + Sync),
    lanes: Laned<CubicSpin>,
    begin: f64,
) {
    let start = |path| {
        let Pair(spin, Pair(path, _)) = on_path(spin(), path);
        Pair(spin, Pair(path, Time(begin)))
    };
    let ends = Mutex::new(vec![None; 19]);
    let first = |path| make().start(&start(path)).unwrap();
    Ensemble::new(lanes).stream(19, first, STEP, 60, |chunk| {
        assert!(chunk.failures.is_empty());
        for (path, member) in (chunk.first as usize..).zip(chunk.members) {
            ends.lock().unwrap()[path] = Some(*member);
        }
    });
    for (path, end) in (0..).zip(ends.into_inner().unwrap()) {
        let alone = make().after(&start(path), STEP, 60).unwrap().state;
        assert_eq!(end, Some(alone), "path {path} from {begin}");
    }
}

#[test]
fn the_laws_of_integrators_hold() {
    for rule in [NoiseRule::Together, NoiseRule::Alternating] {
        let field = Autonomous(Automatic(Cubic));
        let reduced =
            NoisyReduced::new(Quaternions, field, isotropic(0.5), paths()).with_rule(rule);
        let state = reduced.start(&on_path(spin(), 3)).unwrap();
        laws::integrator(&reduced, &[state], STEP).unwrap().check(1e-13).unwrap();
    }
}
