//! The iteration that solves stage equations, for equations of the caller.

use collective_integrators::{Direct, Integrator, RungeKutta, StageSolver, StepError, from_fn};
use core::sync::atomic::{AtomicUsize, Ordering};
use lie_poisson::{DefaultLanes, Lanes, Real};
use nalgebra::{SVector, Vector1, Vector2};

/// Returns k₁ = 1/2 + k₂/4 and k₂ = 1 + k₁/8, whose solution is (24/31, 34/31).
fn linear(i: usize, k: &[Vector1<f64>]) -> Vector1<f64> {
    match i {
        0 => k[1].map(|k| 0.5 + k / 4.0),
        _ => k[0].map(|k| 1.0 + k / 8.0),
    }
}

#[test]
fn equations_with_a_known_solution() {
    let mut k = [Vector1::new(0.0); 2];
    let made = StageSolver::default().solve(Vector1::new(1.0), &mut k, linear).unwrap();
    // Each sweep contracts by at least 4, so that 2⁻⁵³ is reached after 27 sweeps at most.
    assert!((2..=28).contains(&made), "{made}");
    for (k, exact) in k.iter().zip([24.0 / 31.0, 34.0 / 31.0]) {
        // A sweep rounds three times.
        assert!((k.x - exact).abs() <= 3.0 * f64::EPSILON, "{k}, not {exact}");
    }
}

/// Negative control: an iteration without a limit, or with too few sweeps, is an error.
#[test]
fn iterations_that_do_not_converge() {
    let plain = StageSolver { newton: false, ..StageSolver::default() };
    let mut k = [Vector1::new(0.0)];
    let outcome = plain.solve(Vector1::new(1.0), &mut k, |_, k| k[0] * 3.0);
    assert!(matches!(outcome, Err(StepError::NotConverged { .. })), "{outcome:?}");
    let hasty = StageSolver { max_iterations: 2, ..plain };
    let outcome = hasty.solve(Vector1::new(1.0), &mut [Vector1::new(0.0); 2], linear);
    assert!(matches!(outcome, Err(StepError::NotConverged { .. })), "{outcome:?}");
}

/// With a tolerance the iteration ends as soon as no unknown changes by more than that part of itself.
#[test]
fn a_tolerance_ends_the_iteration_earlier() {
    let exact = [24.0 / 31.0, 34.0 / 31.0];
    let solved = |tolerance: f64, unit: f64| {
        let solver = StageSolver { tolerance, ..StageSolver::default() };
        let mut k = [Vector1::new(0.0); 2];
        let scaled = |i: usize, k: &[Vector1<f64>]| linear(i, &[k[0] / unit, k[1] / unit]) * unit;
        let made = solver.solve(Vector1::new(unit), &mut k, scaled).unwrap();
        let errors = k.iter().zip(exact).map(|(k, exact)| (k.x / (unit * exact) - 1.0).abs());
        (made, errors.fold(0.0, f64::max))
    };
    let (all, round_off) = solved(0.0, 1.0);
    for tolerance in [1e-3, 1e-6, 1e-9] {
        let (made, error) = solved(tolerance, 1.0);
        // The changes contract by 4 at least, so that what is left is below a third of the last one.
        assert!(made < all && error < tolerance / 3.0, "{tolerance:e}: {made} of {all}, {error:e}");
        assert!(error > round_off, "{tolerance:e}: {error:e}");
        // No unit matters.
        for unit in [2.0_f64.powi(-90), 2.0_f64.powi(90)] {
            assert_eq!(solved(tolerance, unit), (made, error), "{unit:e}");
        }
    }
}

/// The equation k = c cos k with another c in each SIMD lane (several numbers in one register).
#[test]
fn a_lane_has_the_bits_that_it_has_alone() {
    fn solved<T: Real>(c: T) -> T {
        let mut k = [Vector1::new(T::from_f64(0.0))];
        let solver = StageSolver { max_iterations: 200, newton: false, ..StageSolver::default() };
        let start = Vector1::new(T::from_f64(0.3));
        solver.solve(start, &mut k, |_, k| Vector1::new(k[0].x.cos() * c)).unwrap();
        k[0].x
    }
    let c = [0.1, 0.9, 0.5, 0.3];
    let together = solved(DefaultLanes::load(&c));
    for (i, c) in c.into_iter().enumerate() {
        let alone = solved(c);
        assert_eq!(together.lane(i).to_bits(), alone.to_bits(), "{c}");
        assert!((alone - c * alone.cos()).abs() < 1e-15, "{c}: {alone}");
    }
    // Negative control: the lanes differ from each other.
    assert_ne!(together.lane(0), together.lane(1));
}

#[test]
fn sweeps_that_diverge_or_lose_their_numbers_are_errors() {
    let solver = StageSolver::default();
    let mut k = 1.0_f64;
    let grown = solver.solve_by_sweeps(|| {
        k *= 2.0;
        [k / 2.0, k]
    });
    assert!(matches!(grown, Err(StepError::NotConverged { .. })), "{grown:?}");
    let lost = solver.solve_by_sweeps(|| [f64::NAN, 1.0]);
    assert!(lost.is_err(), "{lost:?}");
    // Negative control: sweeps whose changes decrease converge.
    let mut change = 1.0;
    let made = solver.solve_by_sweeps(|| {
        change /= 16.0;
        [change, 1.0]
    });
    assert!(made.is_ok(), "{made:?}");
}

/// Newton's iteration has a dense matrix, whose entries take an evaluation for each coordinate. A state or a step that is no
/// number does not get that far.
#[test]
fn what_is_no_number_is_refused_without_newtons_iteration() {
    const COORDINATES: usize = 32;
    let evaluations = |start: f64, step: f64| {
        let count = AtomicUsize::new(0);
        let stiff = from_fn(|z: &SVector<f64, COORDINATES>| {
            count.fetch_add(1, Ordering::Relaxed);
            z * -1e3
        });
        let gauss = Direct::new(RungeKutta::gauss(2).unwrap(), stiff);
        let mut z = SVector::repeat(0.5);
        z[7] = start;
        let outcome = gauss.step(&z, step, &mut Integrator::<f64>::workspace(&gauss));
        (outcome.is_ok(), count.load(Ordering::Relaxed))
    };
    for (start, step) in
        [(f64::NAN, 0.1), (f64::INFINITY, 0.1), (1.0, f64::NAN), (1.0, f64::INFINITY)]
    {
        let (made, count) = evaluations(start, step);
        assert!(!made && count < COORDINATES, "{start} {step}: {count}");
    }
    // control: sweeps diverge in a long step, and Newton's iteration makes it
    let (made, count) = evaluations(1.0, 0.1);
    assert!(made && count > COORDINATES, "{count}");
}

/// On the dual of the affine algebra of the line, with h = (X² + Y²)/2, Y decays below the normal numbers and to 0. The
/// derivative of the whole state decays with it. X tends to the radius √0.34.
#[test]
fn a_state_whose_derivative_underflows_goes_on() {
    let field = from_fn(|z: &Vector2<f64>| Vector2::new(z.y * z.y, -z.x * z.y));
    let midpoint = RungeKutta::implicit_midpoint();
    for scheme in [midpoint, RungeKutta::gauss(2).unwrap(), RungeKutta::gauss(4).unwrap()] {
        let gauss = Direct::new(scheme, field);
        let end = gauss.trajectory_from(Vector2::new(0.3, 0.5), 0.25).nth(6000).unwrap();
        let end = end.unwrap_or_else(|error| panic!("{error}")).state;
        // the round-off of 6000 additions
        assert!((end.x - 0.34_f64.sqrt()).abs() < 1e-12 && end.y.abs() < 1e-307, "{end:?}");
    }
}
