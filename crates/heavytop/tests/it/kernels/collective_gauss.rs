//! The kernel of collective Gauss methods against the general integrator, on every instruction set.

use collective_integrators::{
    Collective, Direction, Events, Integrator, RungeKutta, SchemeError, StageSolver, Start,
    StepError,
};
use heavytop::{Body, CollectiveGauss, HeavyTop, Invariant, SpinorRealisation, WithAttitude};
use lie_poisson::{InstructionSet, Se3Dual, State, Vector, larger};
use momentum_map::FibreSymmetry;
use nalgebra::Vector3;
use proptest::prelude::*;

fn vector(range: core::ops::Range<f64>) -> impl Strategy<Value = Vector3<f64>> {
    [range.clone(), range.clone(), range].prop_map(Vector3::from)
}

fn paper_start() -> Se3Dual {
    Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.5, 0.0, 0.75_f64.sqrt()))
}

fn paper_top() -> HeavyTop {
    HeavyTop::kovalevskaya(1.0, 1.0).unwrap()
}

fn generic_top() -> HeavyTop {
    top(Vector3::new(1.5, 2.0, 1.0), 1.0, Vector3::new(0.6, 0.64, 0.48))
}

fn top(inertia: Vector3<f64>, gravity: f64, center_of_mass: Vector3<f64>) -> HeavyTop {
    HeavyTop::new(&Body { inertia, mass: 1.0, gravity, length: 1.0, center_of_mass }).unwrap()
}

fn kernel(stages: usize, top: HeavyTop) -> CollectiveGauss {
    CollectiveGauss::new(stages, top).unwrap()
}

fn general(stages: usize, top: HeavyTop) -> Collective<RungeKutta, SpinorRealisation, HeavyTop> {
    Collective::new(RungeKutta::gauss(stages).unwrap(), SpinorRealisation, top)
}

/// Returns the same method on every instruction set of this processor.
fn everywhere(gauss: &CollectiveGauss) -> impl Iterator<Item = CollectiveGauss> {
    InstructionSet::available().map(|set| gauss.clone().with_instructions(set).unwrap())
}

/// Returns the largest distance of two trajectories, over all steps.
fn distance<A, B>(a: &A, b: &B, start: &Se3Dual, step: f64, steps: usize) -> f64
where
    A: Start<Momentum = Se3Dual>,
    B: Start<Momentum = Se3Dual>,
{
    let (a, b) = (a.trajectory(start, step).unwrap(), b.trajectory(start, step).unwrap());
    a.zip(b).take(steps + 1).fold(0.0, |worst, (a, b)| {
        larger(worst, (a.unwrap().momentum - b.unwrap().momentum).max_abs())
    })
}

/// Returns the factor by which the motion multiplies an error of the start, 1e-9 in every coordinate, over some
/// steps; at least 1.
fn growth<A>(a: &A, start: &Se3Dual, step: f64, steps: usize) -> f64
where
    A: Start<Momentum = Se3Dual>,
{
    let aside = *start + Vector::from_coordinates(|_| 1e-9);
    let (near, far) = (a.trajectory(start, step).unwrap(), a.trajectory(&aside, step).unwrap());
    near.zip(far).take(steps + 1).fold(1.0, |most, (near, far)| {
        larger(most, (near.unwrap().momentum - far.unwrap().momentum).max_abs() / 1e-9)
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_kernel_makes_the_steps_of_the_general_method(
        stages in 1_usize..9,
        inertia in vector(1.0..1.9),
        c in vector(-1.0..1.0),
        weight in 0.0..3.0,
        pi in vector(-4.0..4.0),
        gamma in vector(-1.5..1.5),
        step in -0.25..0.25,
    ) {
        prop_assume!(c.norm() > 0.2 && gamma.norm() > 0.1);
        let top = top(inertia, weight, c.normalize());
        let start = Se3Dual::new(pi, gamma);
        let reference = general(stages, top);
        // Rounding errors grow as an error of the start does. Of 9000 runs one half is below 1, one in a thousand above
        // 7, the largest at 19.
        let rounding = f64::EPSILON * (1.0 + start.max_abs());
        let bound = 100.0 * rounding * growth(&reference, &start, step, 20);
        for gauss in everywhere(&kernel(stages, top)) {
            let error = distance(&gauss, &reference, &start, step, 20);
            prop_assert!(error < bound, "{}: {error:e} {bound:e}", gauss.instructions());
        }
    }
}

/// The sweeps contract by a factor of about ½, which is complex: their changes rise now and then, long before they are
/// round-off. Sweeps that end at the first larger change leave an error of 550 roundings in each step.
#[test]
fn a_step_with_slow_sweeps_is_solved_to_round_off() {
    let axis = Vector3::new(0.8719195882730504, 0.0, 0.2769206184590991).normalize();
    let inertia = Vector3::new(1.2582604815934655, 1.2163993935904147, 1.1060662460753574);
    let top = top(inertia, 1.6133388767595658, axis);
    let start = Se3Dual::new(
        Vector3::new(-3.8699523180721713, 2.932515487813616, -2.90354713982175),
        Vector3::new(0.5522205370593267, 1.1473272497390399, 0.0),
    );
    let step = 0.23566872657570703;
    for gauss in everywhere(&kernel(1, top)) {
        // The general method ends within 28 roundings of Newton's.
        let error = distance(&gauss, &general(1, top), &start, step, 20);
        assert!(error < 100.0 * f64::EPSILON, "{}: {error:e}", gauss.instructions());
    }
}

#[test]
#[ignore = "long"]
fn over_ten_thousand_steps_the_difference_is_grown_round_off() {
    for (stages, step) in [(4, 0.05), (6, 0.1), (8, 0.1), (8, 0.25)] {
        for gauss in everywhere(&kernel(stages, paper_top())) {
            let reference = general(stages, paper_top());
            let error = distance(&gauss, &reference, &paper_start(), step, 10_000);
            // Rounding errors of 1e-15 grow like t (the top is integrable) and add up like √n: 1e-15 · 10⁴ · 10².
            // Measured: up to 6e-11.
            assert!(error < 1e-9, "{stages} {step} {}: {error:e}", gauss.instructions());
        }
    }
    // Negative control: with one stage less the two differ by 1e-10 at t = 10.
    let (five, six) = (kernel(5, paper_top()), general(6, paper_top()));
    let error = distance(&five, &six, &paper_start(), 0.2, 10_000);
    assert!(error > 1e-9, "{error:e}");
}

#[test]
fn every_instruction_set_agrees_and_none_leaves_steps_to_the_general_method() {
    for stages in 1..=8 {
        let (gauss, step) = (kernel(stages, generic_top()), 0.03 * stages as f64);
        for other in everywhere(&gauss) {
            // Measured: up to 2.4e-13 at t = 24, where round-off has grown with the motion.
            let error = distance(&gauss, &other, &paper_start(), step, 100);
            assert!(error < 2e-12, "{stages} {}: {error:e}", other.instructions());
            for sample in other.trajectory(&paper_start(), step).unwrap().take(1000) {
                // A step that is given up has 48 iterations behind it already.
                let sample = sample.unwrap();
                assert!(sample.iterations < 30, "{stages} {}", other.instructions());
            }
        }
    }
}

#[test]
#[ignore = "long"]
fn casimirs_over_a_hundred_thousand_steps() {
    let drift = |gauss: &CollectiveGauss, top: &HeavyTop, of: [Invariant; 2], steps: usize| {
        let run = gauss.trajectory(&paper_start(), 0.1).unwrap().take(steps + 1);
        let start = of.map(|f| f.value(top, &paper_start()));
        run.fold([0.0, 0.0], |worst, sample| {
            let mu = sample.unwrap().momentum;
            core::array::from_fn(|n| larger(worst[n], (of[n].value(top, &mu) - start[n]).abs()))
        })
    };
    let casimirs = [Invariant::VerticalSquared, Invariant::VerticalMomentum];
    for (top, stages) in [(paper_top(), 4), (paper_top(), 8), (generic_top(), 6)] {
        for gauss in everywhere(&kernel(stages, top)) {
            // Measured: up to 1.1e-13 and 5e-13 with 4 stages, 2e-14 and 1e-13 with 8, where f₁ = 1 and f₂ = 4.46:
            // less than a rounding error of one step in a thousand.
            let [f1, f2] = drift(&gauss, &top, casimirs, 100_000);
            assert!(f1 < 4e-13 && f2 < 2e-12, "{} {f1:e} {f2:e}", gauss.instructions());
        }
    }
    // Negative control: h is conserved up to the error of the method.
    let energy = drift(&kernel(4, paper_top()), &paper_top(), [Invariant::Energy; 2], 1000)[0];
    assert!(energy > 2e-12, "{energy:e}");
}

/// A tolerance ends the iteration earlier, by what the general method understands by it, and 0 is the floor.
#[test]
fn a_tolerance_ends_the_iteration_earlier() {
    // The same top in other units of mass, and of length.
    let unit = 1e30 * 1e-40;
    let scaled = top(Vector3::new(1.5, 2.0, 1.0) * unit, unit, Vector3::new(0.6, 0.64, 0.48));
    let start = paper_start();
    let scaled_start = Se3Dual::new(start.0.0 * unit, start.0.1);
    for gauss in everywhere(&kernel(8, generic_top())) {
        let run = |gauss: &CollectiveGauss, start: &Se3Dual, count: usize| {
            let run = gauss.trajectory(start, 0.25).unwrap().skip(1).take(count);
            let samples: Vec<_> = run.map(|sample| sample.unwrap()).collect();
            let sweeps = samples.iter().map(|sample| sample.iterations).sum::<usize>();
            (samples.last().unwrap().momentum, sweeps as f64 / count as f64)
        };
        let (exact, most) = run(&gauss, &start, 100);
        let mut before = (0.0, most);
        for tolerance in [1e-14, 1e-11, 1e-8] {
            let looser = gauss.clone().with_tolerance(tolerance);
            let (end, sweeps) = run(&looser, &start, 100);
            let error = (end - exact).max_abs();
            // Each step leaves a part of the tolerance, and errors grow with the motion, here up to 60 times.
            assert!(error > before.0 && error < 100.0 * 60.0 * tolerance, "{tolerance} {error:e}");
            assert!(sweeps < before.1 - 0.9, "{tolerance} {sweeps} {}", before.1);
            before = (error, sweeps);
            // Units do not matter.
            let other = CollectiveGauss::new(8, scaled).unwrap().with_tolerance(tolerance);
            let other = other.with_instructions(gauss.instructions()).unwrap();
            let (end_scaled, sweeps_scaled) = run(&other, &scaled_start, 100);
            assert!((sweeps_scaled - sweeps).abs() < 0.1, "{sweeps_scaled} {sweeps}");
            let same = Se3Dual::new(end_scaled.0.0 / unit, end_scaled.0.1);
            assert!((same - end).max_abs() < 1e-11 + error, "{tolerance}");
            // Steps that sweeps do not solve are made by the general method to the same tolerance.
            let solver = StageSolver { tolerance, ..StageSolver::default() };
            let scheme = RungeKutta::gauss(8).unwrap().with_solver(solver);
            let general = Collective::new(scheme, SpinorRealisation, generic_top());
            assert_eq!(*looser.general(), general.compensated());
        }
        for none in [0.0, -1.0, f64::NAN] {
            assert_eq!(gauss.clone().with_tolerance(none), gauss);
        }
    }
}

#[test]
fn tops_at_rest_and_sleeping_tops() {
    let top = HeavyTop::lagrange(2.0, 1.0, 1.0).unwrap();
    let (e3, aslant) = (Vector3::z(), Vector3::new(0.6, 0.0, -0.8));
    let rest = Vector3::zeros();
    for (pi, gamma) in
        [(rest, e3), (rest, -e3), (rest, aslant), (e3 * 5.0, e3), (e3 * 1e-9, aslant)]
    {
        let (start, reference) = (Se3Dual::new(pi, gamma), general(8, top));
        for gauss in everywhere(&kernel(8, top)) {
            let run = gauss.trajectory(&start, 0.1).unwrap();
            let same = reference.trajectory(&start, 0.1).unwrap();
            for (sample, same) in run.zip(same).take(200) {
                let (sample, same) = (sample.unwrap(), same.unwrap());
                assert!((sample.momentum - same.momentum).max_abs() < 1e-12);
                // ψ contains the attitude, which μ does not.
                assert!((sample.state.0.p - same.state.p).max_abs() < 1e-12);
                assert!(sample.iterations < 30, "{start:?} {}", sample.iterations);
            }
        }
    }
}

#[test]
fn the_lift_stays_short() {
    // A top that hangs almost still: Re(ψ∗χ) changes by 2γ·Γ, 8 per unit of time, all the time.
    let top = HeavyTop::lagrange(2.0, 1.0, 4.0).unwrap();
    let start = Se3Dual::new(Vector3::new(0.5, 0.2, 0.1), Vector3::new(0.1, 0.0, -0.99));
    let gauss = kernel(8, top);
    // The general method keeps Re(ψ∗χ) = 0. Measured: 1e-12.
    let error = distance(&gauss, &general(8, top), &start, 0.05, 2000);
    assert!(error < 1e-11, "{error:e}");
    let (mut slides, mut before) = (0, 0.0);
    for sample in gauss.trajectory(&start, 0.05).unwrap().take(2001) {
        let z = sample.unwrap().state.0;
        let (chi, psi) = (z.q, z.p.0);
        let overlap = (psi.x.conj() * chi.x + psi.y.conj() * chi.y).re;
        let square = 2.0 * SpinorRealisation.momentum(0, &z);
        let along = overlap / square;
        // ‖χ‖² ≤ 2‖χ⊥‖² + r/‖ψ‖², where r = mgl/(max 1/I) = 4
        let least = chi.norm_squared() - overlap * along;
        assert!(chi.norm_squared() <= (2.0 * least + 4.0) * (1.0 + 1e-14), "{along} {least}");
        slides += usize::from((along - before).abs() > 0.5);
        before = along;
    }
    // There are 395 slides, by ±2ψ each.
    assert!(slides > 300, "{slides}");
}

#[test]
fn large_steps_are_left_to_the_general_method() {
    let gauss = kernel(8, paper_top());
    let (state, mut space) = (gauss.start(&paper_start()).unwrap(), gauss.workspace());
    for step in [1.5, -1.5, 1e3, 1e9] {
        let large = gauss.step(&state, step, &mut space);
        let same = gauss.general().step(&state, step, &mut gauss.general().workspace());
        assert_eq!(large.map(|s| s.point), same.map(|s| s.point), "{step}");
    }
    // Control: the kernel's own steps have other last bits.
    let own = gauss.step(&state, 0.1, &mut gauss.workspace()).unwrap().point;
    let same = gauss.general().step(&state, 0.1, &mut gauss.general().workspace()).unwrap().point;
    assert_ne!(own, same);
    // The next step continues as if nothing had happened.
    let next = gauss.step(&state, 0.1, &mut space).unwrap();
    assert_eq!(next, gauss.step(&state, 0.1, &mut gauss.workspace()).unwrap());
    assert_eq!(gauss.step(&state, 0.0, &mut space).unwrap().point.0, state.0);
}

#[test]
fn what_has_no_result_is_an_error() {
    let gauss = kernel(8, paper_top());
    let (state, mut space) = (gauss.start(&paper_start()).unwrap(), gauss.workspace());
    for step in [f64::NAN, f64::INFINITY] {
        let outcome = gauss.step(&state, step, &mut space);
        let refused = Err(StepError::NotFinite) == outcome
            || matches!(outcome, Err(StepError::NotConverged { .. }));
        assert!(refused, "{step} {outcome:?}");
    }
    for value in [f64::NAN, f64::INFINITY, 1e200] {
        for place in 0..8 {
            let (mut broken, z) = (state, state.0);
            broken.0 =
                Vector::from_coordinates(|i| if i == place { value } else { z.coordinate(i) });
            for gauss in everywhere(&gauss) {
                assert!(gauss.step(&broken, 0.1, &mut space).is_err(), "{value} {place}");
            }
        }
    }
    let nowhere = Se3Dual::new(Vector3::x() * f64::NAN, Vector3::z());
    assert!(gauss.start(&nowhere).is_err() && gauss.start(&Se3Dual::zero()).is_err());
}

#[test]
fn there_are_one_to_eight_stages() {
    assert_eq!(CollectiveGauss::new(0, paper_top()), Err(SchemeError::NoStages));
    for stages in 1..=8 {
        assert_eq!(paper_top().gauss(stages), CollectiveGauss::new(stages, paper_top()));
    }
    let nine = CollectiveGauss::new(9, paper_top());
    assert!(matches!(nine, Err(SchemeError::Family { least: 1, most: 8, stages: 9, .. })));
}

#[test]
fn a_step_depends_on_the_one_before_by_round_off_until_it_is_forgotten() {
    let (gauss, step) = (kernel(8, paper_top()), 0.2);
    let mut space = gauss.workspace();
    let mut state = gauss.start(&paper_start()).unwrap();
    let (mut warm, mut cold, mut different) = (0, 0, 0);
    for _ in 0..50 {
        let next = gauss.step(&state, step, &mut space).unwrap();
        let alone = gauss.step(&state, step, &mut gauss.workspace()).unwrap();
        let apart = (next.point.0 - alone.point.0).max_abs();
        assert!(apart < 2e-14, "{apart:e}"); // a few roundings of ‖χ‖ = 10.8
        different += usize::from(next.point != alone.point);
        (warm, cold) = (warm + next.iterations, cold + alone.iterations);
        state = next.point;
    }
    // Measured: 12 against 16 iterations a step.
    assert!(different > 0 && warm + 100 < cold, "{different} {warm} {cold}");
    gauss.forget(&mut space);
    let forgotten = gauss.step(&state, step, &mut space);
    assert_eq!(forgotten, gauss.step(&state, step, &mut gauss.workspace()));
}

#[test]
fn the_attitude_goes_along() {
    let gauss = WithAttitude(kernel(8, generic_top()));
    for sample in gauss.trajectory(&paper_start(), 0.2).unwrap().take(1000) {
        let sample = sample.unwrap();
        let vertical = sample.state.1.conjugate().rotate(&Vector3::z());
        // The bound is 1000 rounding errors of a unit quaternion.
        assert!((vertical - sample.momentum.0.1).norm() < 1e-13);
    }
}

#[test]
fn events_are_found() {
    let section = |mu: &Se3Dual| mu.0.1.x;
    let (gauss, reference) = (kernel(8, paper_top()), general(8, paper_top()));
    let run = gauss.trajectory(&paper_start(), 0.1).unwrap().take(200);
    let events = Events::new(&gauss, run, section, Direction::Both);
    let found: Vec<f64> = events.map(|event| event.unwrap().time).collect();
    let run = reference.trajectory(&paper_start(), 0.1).unwrap().take(200);
    let events = Events::new(&reference, run, section, Direction::Both);
    let expected: Vec<f64> = events.map(|event| event.unwrap().time).collect();
    assert!(found.len() > 10 && found.len() == expected.len());
    assert!(found.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-11));
}
