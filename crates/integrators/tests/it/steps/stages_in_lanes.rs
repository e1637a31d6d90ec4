//! Stages side by side: the steps are those of the integrator alone to round-off, on every instruction set.

use crate::laws::integrator_laws::{Body, STEP, momenta};
use crate::support::{ROUND_OFF, field, laws, start};
use collective_integrators::*;
use lie_poisson::*;
use momentum_map::{HOPF, Quaternions};
use nalgebra::{Vector1, Vector2};

/// Implicit methods with two to nine stages, with and without low parts of the coefficients, of which one has a matrix
/// that is not full. The last one has more stages than there are lanes.
fn implicit_methods() -> Vec<RungeKutta> {
    let gauss = (2..=9).map(|stages| RungeKutta::gauss(stages).unwrap());
    let lobatto = (2..=4).map(|stages| RungeKutta::new(Tableau::lobatto_iiia(stages).unwrap()));
    gauss.chain(lobatto).chain([RungeKutta::sanz_serna_abia()]).collect()
}

/// Returns the largest distance of the states of two integrators over 40 steps, relative to the states.
fn distance<I, J>(one: &I, other: &J, start: &I::State, step: f64) -> f64
where
    I: Integrator<State: Vector>,
    J: Integrator<State = I::State>,
{
    let both = one.trajectory_from(*start, step).zip(other.trajectory_from(*start, step));
    both.take(41).fold(0.0, |largest: f64, (a, b)| {
        let (a, b) = (a.unwrap().state, b.unwrap().state);
        larger(largest, (a - b).max_abs() / b.max_abs())
    })
}

/// Returns the integrator with its stages side by side, for each instruction set of the processor.
fn on_every_set<I: FieldInLanes + Clone>(integrator: &I) -> impl Iterator<Item = StagesInLanes<I>> {
    let lanes = StagesInLanes::new(integrator.clone());
    InstructionSet::available().map(move |set| lanes.clone().with_instructions(set).unwrap())
}

/// Stages are solved to round-off, and 40 steps add up 40 such errors, which grow with the distance of trajectories.
const NEAR: f64 = 2e-14;

#[test]
fn steps_are_those_of_the_integrator_alone_to_round_off() {
    for method in implicit_methods() {
        let direct = Direct::new(method.clone(), field());
        for side_by_side in on_every_set(&direct) {
            let apart = distance(&side_by_side, &direct, &start(), STEP);
            assert!(apart < NEAR, "{method:?} {:?} {apart:e}", side_by_side.instructions());
        }
        let collective = Collective::new(method.clone(), HOPF, Automatic(Body));
        let lift_free = LiftFree::new(method, Quaternions, Automatic(Body));
        for mu in momenta() {
            let z = collective.start(&mu).unwrap();
            for side_by_side in on_every_set(&collective) {
                assert!(distance(&side_by_side, &collective, &z, STEP) < NEAR);
            }
            for side_by_side in on_every_set(&lift_free) {
                assert!(distance(&side_by_side, &lift_free, &mu, STEP) < NEAR);
            }
        }
    }
}

/// A sweep that misses some stages would not converge, and the step would be made again by the integrator alone.
#[test]
fn sweeps_side_by_side_converge_as_those_of_the_integrator_alone() {
    for method in implicit_methods() {
        let direct = Direct::new(method, field());
        let alone = direct.step(&start(), STEP, &mut direct.workspace()).unwrap().iterations;
        for lanes in on_every_set(&direct) {
            let together = lanes.step(&start(), STEP, &mut lanes.workspace()).unwrap().iterations;
            // Each ends by its own measure of round-off. Sweeps that miss a stage end at the limit, 64.
            assert!(together <= alone + 2, "{:?}: {together} {alone}", lanes.instructions());
        }
    }
}

/// A spring that is a hundred times as stiff near x = 0, so that a step there needs twice as many sweeps as the one before it.
#[derive(Clone)]
struct Bumper;

impl<T: Real> VectorField<T> for Bumper {
    type Point = Vector2<T>;
    fn at(&self, z: &Vector2<T>) -> Vector2<T> {
        let stiffness = (-(z.x * z.x) * 400.0).exp() * 99.0 + 1.0;
        Vector2::new(z.y, -(z.x * stiffness))
    }
}

/// Only the last sweeps of a step are watched, as many as the step before it lets expect. Where that expectation is wrong the
/// steps are right nonetheless.
#[test]
fn sweeps_that_are_not_watched_find_the_same_stages() {
    for stages in [2, 4, 8] {
        let direct = Direct::new(RungeKutta::gauss(stages).unwrap(), Bumper);
        let start = Vector2::new(1.0, 0.0);
        let counts: Vec<usize> = {
            let (mut z, mut workspace) = (start, direct.workspace());
            (0..400)
                .map(|_| {
                    let step = direct.step(&z, 0.05, &mut workspace).unwrap();
                    z = step.point;
                    step.iterations
                })
                .collect()
        };
        let jump = counts.windows(2).skip(20).map(|pair| pair[1].abs_diff(pair[0])).max();
        assert!(jump >= Some(4), "{stages}: the sweeps hardly vary, by {jump:?}");
        for lanes in on_every_set(&direct) {
            let alone = direct.after_from(start, 0.05, 400).unwrap().state;
            let together = lanes.after_from(start, 0.05, 400).unwrap().state;
            // The bumper magnifies errors of 1e-16 by its slope, some fifty times in six passes.
            assert!((alone - together).amax() < 1e-12, "{stages} {:?}", lanes.instructions());
        }
    }
}

/// Negative control: with a tolerance of 1e-6 the two iterations end at stages of that accuracy.
#[test]
fn stages_that_are_not_solved_to_round_off_differ() {
    let solver = StageSolver { tolerance: 1e-6, ..Default::default() };
    let gauss = RungeKutta::gauss(4).unwrap().with_solver(solver);
    let direct = Direct::new(gauss, field());
    let apart = distance(&StagesInLanes::new(direct.clone()), &direct, &start(), STEP);
    assert!(apart > 100.0 * NEAR && apart < 1e-4, "{apart:e}");
}

/// A sweep computes all stages from those of the previous one, however many a register holds. The control is that the
/// distance sees the round-off of sweeps that use the newest stages.
#[test]
fn steps_in_all_registers_have_the_same_bits() {
    let (mut apart, z, h) = (0.0, start(), 8.0 * STEP);
    for stages in 2..=9 {
        let direct = Direct::new(RungeKutta::gauss(stages).unwrap(), field());
        let portable = StagesInLanes::new(direct.clone());
        apart += distance(&portable, &direct, &z, h);
        for lanes in on_every_set(&direct).chain([StagesInLanes::widest(direct.clone())]) {
            assert_eq!(distance(&lanes, &portable, &z, h), 0.0, "{stages}");
            let [lanes, portable] = [&lanes, &portable].map(|lanes| lanes.clone().compensated());
            assert_eq!(distance(&lanes, &portable, &Pair(z, z.scaled(0.0)), h), 0.0, "{stages}");
        }
    }
    assert!(apart > f64::EPSILON, "{apart:e}");
}

#[test]
fn methods_without_stages_to_put_side_by_side_keep_their_bits() {
    let nine = RungeKutta::gauss(9).unwrap();
    for method in [RungeKutta::rk4(), RungeKutta::implicit_midpoint(), nine] {
        let direct = Direct::new(method, field());
        for side_by_side in on_every_set(&direct) {
            assert_eq!(distance(&side_by_side, &direct, &start(), STEP), 0.0);
        }
    }
    let verlet = PartitionedRungeKutta::<FirstHalf>::kick_drift_kick();
    let direct = Direct::new(verlet, field());
    assert_eq!(distance(&StagesInLanes::widest(direct.clone()), &direct, &start(), STEP), 0.0);
}

#[test]
#[ignore = "long"]
fn the_laws_of_integrators_hold() {
    let gauss = || RungeKutta::gauss(4).unwrap();
    let composed = || Composition::new(RungeKutta::gauss(2).unwrap(), Substeps::yoshida4());
    let direct = Direct::new(gauss(), field());
    let collective = Collective::new(gauss(), HOPF, Automatic(Body));
    let lift_free = LiftFree::new(gauss(), Quaternions, Automatic(Body));
    let of_composed = Collective::new(composed(), HOPF, Automatic(Body));
    let obeys = |report: Result<laws::Report, _>| report.unwrap().check(ROUND_OFF).unwrap();
    let (z, momenta) = (start(), momenta());
    for set in InstructionSet::available() {
        let direct = StagesInLanes::new(direct.clone()).with_instructions(set).unwrap();
        obeys(laws::start(&direct, &[z, -z], STEP));
        obeys(laws::start(&direct.compensated(), &[z, -z], STEP));
        let collective = StagesInLanes::new(collective.clone()).with_instructions(set).unwrap();
        obeys(laws::start(&collective, &momenta, STEP));
        obeys(laws::start(&collective.compensated(), &momenta, STEP));
        let lift_free = StagesInLanes::new(lift_free.clone()).with_instructions(set).unwrap();
        obeys(laws::start(&lift_free, &momenta, STEP));
        obeys(laws::start(&lift_free.compensated(), &momenta, STEP));
        let composed = StagesInLanes::new(of_composed.clone()).with_instructions(set).unwrap();
        obeys(laws::start(&composed, &momenta, STEP));
    }
}

/// The compensated integrator conserves the Casimir |Π|² by a random walk of roundings of the increments, which are h|Ω|
/// times as large as those of the state; the integrator alone by one of the roundings of the state.
#[test]
#[ignore = "long"]
fn casimirs_are_conserved_over_long_runs() {
    let collective = Collective::new(RungeKutta::gauss(4).unwrap(), HOPF, Automatic(Body));
    let mu = momenta()[1];
    let square = mu.0.norm_squared();
    let drift = |integrator: &dyn Fn() -> Covector<nalgebra::Vector3<f64>>| {
        (integrator().0.norm_squared() / square - 1.0).abs()
    };
    let steps = 10_000;
    let alone = StagesInLanes::widest(collective);
    let plain = drift(&|| alone.after(&mu, STEP, steps).unwrap().momentum);
    // four standard deviations of √(10⁴) roundings of a sum of squares
    assert!(plain < 4.0 * 100.0 * f64::EPSILON, "{plain:e}");
    let compensated = alone.compensated();
    let carried = drift(&|| compensated.after(&mu, STEP, steps).unwrap().momentum);
    assert!(carried < 0.2 * 4.0 * 100.0 * f64::EPSILON, "{carried:e}");
}

/// A stiff oscillator dq/dt = ωp, dp/dt = −ωq at hω = 10: the sweeps diverge, and Newton's iteration takes over.
#[derive(Clone, Copy)]
struct Stiff;

impl<T: Real> VectorField<T> for Stiff {
    type Point = Vector2<T>;
    fn at(&self, z: &Vector2<T>) -> Vector2<T> {
        Vector2::new(z.y * 100.0, z.x * -100.0)
    }
}

/// The field dx/dt = λx.
#[derive(Clone, Copy)]
struct Growth(f64);

impl<T: Real> VectorField<T> for Growth {
    type Point = Vector1<T>;
    fn at(&self, x: &Vector1<T>) -> Vector1<T> {
        x * T::from_f64(self.0)
    }
}

/// With λh = 1 the derivatives grow by e in a step, which a guess may not, and X(x) begins each step. The control grows less.
#[test]
fn what_is_predicted_to_grow_too_much_is_no_guess() {
    let iterations = |rate: f64, remembers: bool| {
        let lanes = StagesInLanes::widest(Direct::new(RungeKutta::gauss(8).unwrap(), Growth(rate)));
        let (mut x, mut workspace) = (Vector1::x(), lanes.workspace());
        let count = |_| {
            if !remembers {
                lanes.forget(&mut workspace);
            }
            lanes.step_in_place(&mut x, 1.0, &mut workspace).unwrap()
        };
        let sum: usize = (0..10).map(count).sum();
        // Ten steps, each with a rounding error or two.
        assert!((x.x / (10.0 * rate).exp() - 1.0).abs() < 20.0 * f64::EPSILON, "{rate}");
        sum
    };
    assert_eq!(iterations(1.0, true), iterations(1.0, false));
    assert!(iterations(0.1, true) + 10 < iterations(0.1, false));
}

#[test]
fn newtons_iteration_follows_where_sweeps_diverge() {
    let direct = Direct::new(RungeKutta::gauss(4).unwrap(), Stiff);
    for side_by_side in on_every_set(&direct) {
        let step = |i: &dyn Fn() -> Result<Step<Vector2<f64>>, StepError>| i().unwrap();
        let z = Vector2::new(1.0, 0.5);
        let made = step(&|| side_by_side.step(&z, 0.1, &mut side_by_side.workspace()));
        let expected = step(&|| direct.step(&z, 0.1, &mut direct.workspace()));
        assert!((made.point - expected.point).norm() < 1e-13);
        assert!((made.point.norm_squared() - z.norm_squared()).abs() < 1e-13);
    }
    let sweeps_alone = StageSolver { newton: false, ..Default::default() };
    let gauss = RungeKutta::gauss(4).unwrap().with_solver(sweeps_alone);
    let side_by_side = StagesInLanes::widest(Direct::new(gauss, Stiff));
    let refused = side_by_side.step(&Vector2::x(), 0.1, &mut side_by_side.workspace());
    assert!(matches!(refused, Err(StepError::NotConverged { .. })));
}

/// The field dx/dt = √x, which is not a number for x < 0.
#[derive(Clone, Copy)]
struct Root;

impl<T: Real> VectorField<T> for Root {
    type Point = Vector1<T>;
    fn at(&self, x: &Vector1<T>) -> Vector1<T> {
        Vector1::new(Real::sqrt(x.x))
    }
}

#[test]
fn what_is_not_a_number_is_an_error() {
    for side_by_side in on_every_set(&Direct::new(RungeKutta::gauss(3).unwrap(), Root)) {
        let step = |x: f64| side_by_side.step(&Vector1::new(x), 0.1, &mut side_by_side.workspace());
        // x(t) = (√x + t/2)²
        assert!((step(1.0).unwrap().point.x - 1.05 * 1.05).abs() < 1e-9);
        for bad in [-1.0, f64::NAN, f64::INFINITY] {
            assert!(step(bad).is_err(), "{bad}");
        }
    }
}

#[test]
fn a_workspace_that_forgets_makes_the_first_step_again() {
    for side_by_side in on_every_set(&Direct::new(RungeKutta::gauss(6).unwrap(), field())) {
        let mut workspace = side_by_side.workspace();
        let mut step = |z| side_by_side.step(&z, STEP, &mut workspace).unwrap().point;
        let first = step(start());
        step(first);
        side_by_side.forget(&mut workspace);
        let again = side_by_side.step(&start(), STEP, &mut workspace).unwrap().point;
        assert_eq!(again, first);
    }
}

/// Powers of two as units of the two blocks (q, p) change no bit but the exponents.
#[test]
fn units_do_not_matter() {
    /// A harmonic oscillator with its length and its momentum in units of 2^LENGTH and 2^MOMENTUM.
    #[derive(Clone, Copy)]
    struct Oscillator(f64, f64);
    impl<T: Real> VectorField<T> for Oscillator {
        type Point = Pair<Vector1<T>, Vector1<T>>;
        fn at(&self, Pair(q, p): &Self::Point) -> Self::Point {
            Pair(Vector1::new(p.x * (self.0 / self.1)), Vector1::new(q.x * -(self.1 / self.0)))
        }
    }
    for set in InstructionSet::available() {
        let end = |length: f64, momentum: f64| {
            let direct = Direct::new(RungeKutta::gauss(5).unwrap(), Oscillator(length, momentum));
            let lanes = StagesInLanes::new(direct).with_instructions(set).unwrap();
            let start = Pair(Vector1::new(0.8 * length), Vector1::new(0.3 * momentum));
            let Pair(q, p) = lanes.after(&start, 0.3, 50).unwrap().state;
            (q.x / length, p.x / momentum)
        };
        let plain = end(1.0, 1.0);
        let two = |n: i32| 2.0_f64.powi(n);
        assert_eq!(end(two(100), two(100)), plain);
        assert_eq!(end(two(-100), two(100)), plain);
        assert_eq!(end(two(40), two(-60)), plain);
    }
}
