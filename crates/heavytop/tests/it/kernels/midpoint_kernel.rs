//! The midpoint kernel for tops against the iteration for any system.

use collective_integrators::{
    BatchIntegrator, CHECKPOINT, IntegrationError, Integrator, LiftFree, RungeKutta, StageSolver,
    Start, StepError,
};
use core::ops::Range;
use heavytop::{Body, HeavyTop, MidpointBatch, ReducedMidpoint, TopMidpoint};
use lie_poisson::{Covector, InstructionSet, Pair, Se3Dual, Vector, Width};
use momentum_map::DualQuaternions;
use nalgebra::Vector3;
use twofloat::TwoFloat;

fn start() -> Se3Dual {
    Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.5, 0.0, 0.75_f64.sqrt()))
}

/// Returns Kovalevskaya's top, one with three different moments, a free body, and a fast one.
fn tops() -> [HeavyTop; 4] {
    let body = Body {
        inertia: Vector3::new(1.0, 2.0, 2.5),
        mass: 1.0,
        gravity: 1.0,
        length: 1.0,
        center_of_mass: Vector3::new(0.48, 0.64, 0.6),
    };
    [
        HeavyTop::kovalevskaya(1.0, 1.0).unwrap(),
        HeavyTop::new(&body).unwrap(),
        HeavyTop::free_rigid_body(Vector3::new(1.0, 2.0, 3.0)).unwrap(),
        HeavyTop::lagrange(0.5, 0.2, 3.0).unwrap(),
    ]
}

fn kernels(top: HeavyTop) -> impl Iterator<Item = TopMidpoint> {
    let on = move |set| TopMidpoint::new(top).with_instructions(set).unwrap();
    InstructionSet::available().map(on)
}

fn end<I>(midpoint: &I, start: &Se3Dual, step: f64, steps: usize) -> Se3Dual
where
    I: Start<Momentum = Se3Dual>,
{
    midpoint.trajectory(start, step).unwrap().nth(steps).unwrap().unwrap().momentum
}

/// Advances the members, and returns those that failed with the numbers of the steps in which they did.
fn advance<B: BatchIntegrator>(
    integrator: &B,
    members: &mut [B::Member],
    step: f64,
    steps: Range<u64>,
) -> Vec<(usize, u64)> {
    let mut failed = Vec::new();
    let mut report = |i, error: IntegrationError| failed.push((i, error.step));
    integrator.advance(members, step, steps, &mut integrator.workspace(), &mut report);
    failed
}

#[test]
#[ignore = "long"]
fn tops_move_as_any_system_does() {
    // The second top is chaotic: the effect of its start is lost after some hundred units of time.
    let runs = tops().into_iter().zip([10_000, 1_500, 10_000, 10_000]);
    for (top, steps, step) in runs.flat_map(|(top, n)| [0.01, 0.1].map(|h| (top, n, h))) {
        let general = ReducedMidpoint::new(top);
        let expected = end(&general, &start(), step, steps);
        let mut moved = start();
        moved.0.0.z += 4.0 * f64::EPSILON;
        moved.0.1.x -= f64::EPSILON;
        // The growth of one rounding error; a step has a few unbiased ones, which add up to √10⁴ times that.
        let growth = (end(&general, &moved, step, steps) - expected).max_abs();
        let tolerance = 4e2 * growth + 1e-12;
        assert!(tolerance < 1e-6);
        for midpoint in kernels(top) {
            let reached = end(&midpoint, &start(), step, steps);
            let gap = (reached - expected).max_abs();
            assert!(gap < tolerance, "{gap:e} {tolerance:e} {}", midpoint.instructions());
            // The kernel rounds differently, since it uses other formulas.
            assert_ne!(reached, expected);
            let other = end(&midpoint, &start(), step * (1.0 + 1e-5), steps);
            assert!((other - expected).max_abs() > tolerance, "{tolerance:e}");
        }
    }
}

#[test]
fn casimirs_walk_at_random() {
    casimirs_walk(100_000);
}

#[test]
#[ignore = "long"]
fn casimirs_walk_at_random_for_long() {
    casimirs_walk(1_000_000);
}

fn casimirs_walk(steps: u32) {
    let top = tops()[1];
    for midpoint in kernels(top) {
        let (mut mu, mut space) = (start(), Integrator::workspace(&midpoint));
        let casimirs = |mu: &Se3Dual| [mu.0.1.norm_squared(), mu.0.0.dot(&mu.0.1)];
        let (before, mut worst) = (casimirs(&mu), 0.0_f64);
        for _ in 0..steps {
            mu = midpoint.step(&mu, 0.01, &mut space).unwrap().point;
            let after = casimirs(&mu);
            worst = worst.max((after[0] - before[0]).abs()).max((after[1] - before[1]).abs());
        }
        // The bound is the root of the steps, with some ten unbiased rounding errors of |Π||Γ| ≈ 5.4, each ε/2 at most.
        let bound = (10.0 * f64::from(steps)).sqrt() * 5.4 * f64::EPSILON;
        assert!(worst < bound, "{worst:e}");
        assert!(worst > 0.0);
    }
}

/// The corrections of a are about a unit of round-off. Rounded with Γ and Π, they made |Γ|² and Π·Γ of this run drift by
/// 3.6e-18 and 1.6e-17 per step.
#[test]
fn casimirs_do_not_drift() {
    let product = |a: &Vector3<f64>, b: &Vector3<f64>| {
        let terms = a.iter().zip(b).map(|(&a, &b)| TwoFloat::new_mul(a, b));
        terms.fold(TwoFloat::from(0.0), |sum, term| sum + term)
    };
    let casimirs =
        |Covector(Pair(pi, gamma)): &Se3Dual| [product(gamma, gamma), product(pi, gamma)];
    let steps = 500_000_u32;
    for midpoint in kernels(tops()[0]) {
        let (mut mu, mut space) = (start(), Integrator::workspace(&midpoint));
        for _ in 0..steps {
            mu = midpoint.step(&mu, 0.021, &mut space).unwrap().point;
        }
        // A random walk with the measured rms changes of a step; the bounds are five of its standard deviations.
        let rms = [8.6e-17, 4.1e-16];
        for ((after, before), rms) in casimirs(&mu).iter().zip(casimirs(&start())).zip(rms) {
            let change = f64::from(*after - before);
            let deviation = rms * f64::from(steps).sqrt();
            assert!(change.abs() < 5.0 * deviation, "{change:e} {}", midpoint.instructions());
            assert_ne!(change, 0.0);
        }
    }
}

#[test]
fn many_tops_have_the_bits_of_one() {
    for (set, width) in InstructionSet::available().flat_map(|set| Width::ALL.map(|w| (set, w))) {
        let sweep = MidpointBatch::new().on(set, width).unwrap();
        let many = |i: usize| {
            let mut mu = start();
            mu.0.0.x += 0.1 * i as f64;
            (tops()[i % 4], mu)
        };
        let mut members: Vec<_> = (0..21).map(many).collect();
        let steps = CHECKPOINT + 500;
        assert_eq!(advance(&sweep, &mut members, 0.01, 0..CHECKPOINT), []);
        assert_eq!(advance(&sweep, &mut members, 0.01, CHECKPOINT..steps), []);
        for (i, (top, mu)) in members.iter().enumerate() {
            let one = TopMidpoint::new(*top).with_instructions(set).unwrap();
            assert_eq!(*mu, end(&one, &many(i).1, 0.01, steps as usize), "{i} on {set}");
        }
        let mut alike = [many(0).1, many(4).1];
        let one = TopMidpoint::new(tops()[0]).with_instructions(set).unwrap();
        assert_eq!(advance(&one, &mut alike, 0.01, 0..steps), []);
        assert_eq!(alike, [members[0].1, members[4].1]);
    }
}

#[test]
fn steps_too_large_for_the_formulas_are_made_by_newton() {
    let lift_free = |top| LiftFree::new(RungeKutta::implicit_midpoint(), DualQuaternions, top);
    for (top, step) in tops().into_iter().flat_map(|top| [0.6, 1.0].map(|step| (top, step))) {
        let expected = lift_free(top).trajectory(&start(), step).unwrap().nth(3).unwrap();
        let expected = expected.unwrap().momentum;
        let midpoint = TopMidpoint::new(top);
        let mut states = [start(); 3];
        assert_eq!(advance(&midpoint, &mut states, step, 0..3), []);
        for mu in states.iter().chain([&end(&midpoint, &start(), step, 3)]) {
            // The bound is the condition of a step that turns the body by some radians.
            assert!((*mu - expected).max_abs() < 1e-11, "{step}");
        }
    }
    // Control: without Newton's iteration these steps fail.
    let patient = StageSolver { newton: false, ..StageSolver::default() };
    let without = ReducedMidpoint::new(tops()[0]).with_solver(patient);
    assert!(without.trajectory(&start(), 1.0).unwrap().nth(1).unwrap().is_err());
}

#[test]
fn a_start_that_is_no_number_is_an_error() {
    for bad in [f64::NAN, f64::INFINITY, 1e300] {
        let mut mu = start();
        mu.0.1.y = bad;
        for midpoint in kernels(tops()[0]) {
            let step = midpoint.step(&mu, 0.01, &mut Integrator::workspace(&midpoint));
            assert!(
                matches!(step, Err(StepError::NotConverged { .. } | StepError::NotFinite)),
                "{step:?}"
            );
            let mut states = [start(), mu, start()];
            assert_eq!(advance(&midpoint, &mut states, 0.01, 0..50), [(1, 1)]);
            assert_eq!([states[0], states[2]], [end(&midpoint, &start(), 0.01, 50); 2]);
        }
    }
}

/// The sweeps of an abandoned fixed-point iteration count: two more sweeps before Newton's iteration are two more
/// iterations, and change no bit of the result.
#[test]
fn sweeps_without_convergence_are_counted() {
    let step = |max_iterations: usize| {
        let solver = StageSolver { max_iterations, ..StageSolver::default() };
        let midpoint = ReducedMidpoint::new(tops()[1]).with_solver(solver);
        midpoint.after(&start(), 0.1, 1).unwrap()
    };
    let (one, three) = (step(1), step(3));
    assert_eq!(three.iterations, one.iterations + 2);
    assert_eq!(three.state, one.state);
}
