//! Torques by tables, whose breakpoints divide steps.

use super::support::{Body, orders};
use collective_integrators::diagnostics::fitted_order;
use collective_integrators::{
    Composition, Driven, Ensemble, Laned, RungeKutta, Start, StepError, Substeps, TabulatedTorque,
    TorqueFlow, Torqued, ViscousTorque, laws,
};
use lie_poisson::{
    Automatic, Autonomous, Covector, InputTable, InputTableError, Inputs, InputsError,
    Interpolation, Pair, Time,
};
use momentum_map::{HOPF, HopfRealisation};
use nalgebra::{Vector2, Vector3};
use std::sync::Mutex;

type Timed = Pair<Covector<Vector3<f64>>, Time>;

const INTERPOLATIONS: [Interpolation; 3] =
    [Interpolation::Constant, Interpolation::Linear, Interpolation::Cubic];

/// Two inputs with times of their own; no step of the runs below ends at one of them.
fn tables(interpolation: Interpolation, unit: f64) -> [InputTable; 2] {
    let table = |times: &[f64], values: &[f64]| {
        let times = times.iter().map(|time| time * unit).collect();
        InputTable::new(times, values.into(), interpolation).unwrap()
    };
    let first = table(&[0.0, 0.71, 1.93, 2.9, 5.0], &[0.0, 1.0, -0.8, 0.5, 0.5]);
    [first, table(&[0.0, 1.27, 5.0], &[0.5, -0.5, 0.3])]
}

/// The torques of the inputs
const TORQUES: [Vector3<f64>; 2] = [Vector3::new(1.0, 0.0, 0.4), Vector3::new(0.0, -0.6, 0.8)];

fn torque(interpolation: Interpolation) -> TabulatedTorque<Covector<Vector3<f64>>> {
    let inputs = TORQUES.map(Covector).into_iter().zip(tables(interpolation, 1.0));
    TabulatedTorque(Inputs::new(inputs.collect()).unwrap())
}

fn orbits() -> Driven<RungeKutta, HopfRealisation, Autonomous<Automatic<Body>>> {
    let body = Autonomous(Automatic(Body { unit: 1.0 }));
    Driven::new(RungeKutta::implicit_midpoint(), HOPF, body)
}

fn start() -> Timed {
    Pair(Covector(Vector3::new(1.0, 2.0, 0.5)), Time(0.0))
}

/// Returns Π(4) by Runge–Kutta's method with many steps between any two times of the tables.
fn reference(interpolation: Interpolation) -> Vector3<f64> {
    reference_with_friction(interpolation, &Vector3::zeros())
}

/// The same with viscous friction, by its rates
fn reference_with_friction(interpolation: Interpolation, friction: &Vector3<f64>) -> Vector3<f64> {
    let (mut pi, times) = (start().0.0, [0.0, 0.71, 1.27, 1.93, 2.9, 4.0]);
    let tables = tables(interpolation, 1.0);
    for pair in times.windows(2) {
        let (middle, h) = (0.5 * (pair[0] + pair[1]), (pair[1] - pair[0]) / 4096.0);
        let rate = |pi: Vector3<f64>, time: f64| {
            let inputs = [0, 1].map(|i| TORQUES[i] * tables[i].continued(middle, time));
            let turned = pi.cross(&pi.component_div(&Vector3::new(2.0, 1.5, 1.0)));
            turned + inputs[0] + inputs[1] - friction.component_mul(&pi)
        };
        for step in 0..4096 {
            let time = pair[0] + f64::from(step) * h;
            let a = rate(pi, time);
            let b = rate(pi + a * (h / 2.0), time + h / 2.0);
            let c = rate(pi + b * (h / 2.0), time + h / 2.0);
            let d = rate(pi + c * h, time + h);
            pi += (a + b * 2.0 + c * 2.0 + d) * (h / 6.0);
        }
    }
    pi
}

/// Returns the order of a method by its errors, and the errors.
fn order<I: Start<Momentum = Timed>>(
    integrator: &I,
    exact: &Vector3<f64>,
    counts: &[u64],
) -> (f64, Vec<(f64, f64)>) {
    let errors = counts.iter().map(|&count| {
        let step = 4.0 / count as f64;
        let end = integrator.after(&start(), step, count).unwrap().momentum.0.0;
        (step, (end - exact).norm())
    });
    let errors: Vec<_> = errors.collect();
    (fitted_order(&errors, 1e-14).unwrap(), errors)
}

#[test]
fn breakpoints_keep_the_orders_two_four_and_six() {
    for interpolation in INTERPOLATIONS {
        let exact = reference(interpolation);
        for (expected, substeps, counts) in orders() {
            let mut torqued = Torqued::new(orbits(), torque(interpolation));
            if let Some(substeps) = substeps {
                torqued = torqued.with_substeps(substeps);
            }
            let (found, errors) = order(&torqued, &exact, &counts);
            assert!(
                (found - expected).abs() < 0.1 * expected,
                "{interpolation:?} {expected}: {found} {errors:?}"
            );
        }
    }
}

/// The torque that jumps comes last, around the others, so that the steps of all are divided.
#[test]
fn friction_within_a_torque_that_jumps_keeps_the_order() {
    let (rates, interpolation) = (Vector3::new(0.05, 0.2, 0.1), Interpolation::Constant);
    let exact = reference_with_friction(interpolation, &rates);
    let friction = || ViscousTorque::new(Pair(rates, Time(0.0))).unwrap();
    let last = Torqued::new(Torqued::new(orbits(), friction()), torque(interpolation))
        .with_substeps(Substeps::yoshida6());
    let (found, errors) = order(&last, &exact, &[20, 30, 40]);
    assert!((found - 6.0).abs() < 0.6, "{found} {errors:?}");
    // Control: steps of the friction across the jumps
    let first = Torqued::new(Torqued::new(orbits(), torque(interpolation)), friction())
        .with_substeps(Substeps::suzuki4());
    let (found, crossing) = order(&first, &exact, &[21, 43, 87]);
    assert!(found < 3.0, "{found} {crossing:?}");
}

/// A torque that tells no breakpoints, and acts at each time as the table says.
struct Blind<F>(F);

impl<F: TorqueFlow<Timed>> TorqueFlow<Timed> for Blind<F> {
    fn flow(&self, mu: &mut Timed, step: f64) -> Result<(), StepError> {
        self.0.flow(mu, step)
    }
}

/// A torque that tells its breakpoints, and acts at each time as the table says.
struct OneSided<F>(F);

impl<F: TorqueFlow<Timed>> TorqueFlow<Timed> for OneSided<F> {
    fn flow(&self, mu: &mut Timed, step: f64) -> Result<(), StepError> {
        self.0.flow(mu, step)
    }

    fn time(&self, mu: &Timed) -> Option<f64> {
        self.0.time(mu)
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        self.0.next_break(time, forward)
    }
}

/// Controls: the division, the side of a jump, and the substeps within each part are what keeps the order.
#[test]
fn the_order_is_lost_without_division() {
    let (held, exact) = (torque(Interpolation::Constant), reference(Interpolation::Constant));
    let counts = [21, 43, 87];
    let suzuki = Substeps::suzuki4;
    let kept = Torqued::new(orbits(), held.clone()).with_substeps(suzuki());
    let blind = Torqued::new(orbits(), Blind(held.clone())).with_substeps(suzuki());
    let one_sided = Torqued::new(orbits(), OneSided(held.clone())).with_substeps(suzuki());
    let around = Composition::new(Torqued::new(orbits(), held), suzuki());
    let (_, kept) = order(&kept, &exact, &counts);
    let (_, blind) = order(&blind, &exact, &counts);
    let (_, one_sided) = order(&one_sided, &exact, &counts);
    let (_, around) = order(&around, &exact, &counts);
    let last = [&kept, &blind, &one_sided, &around].map(|errors| errors[2].1);
    assert!(last[0] < 1e-6, "{last:?}");
    assert!(last[1] > 1e3 * last[0] && last[2] > 1e3 * last[0], "{last:?}");
    assert!(last[3] > 10.0 * last[0], "{last:?}");
    // With its own side of each jump alone, any order is at most 1.
    for errors in [blind, one_sided] {
        let order = fitted_order(&errors, 1e-14).unwrap();
        assert!(order < 1.5, "{order} {errors:?}");
    }
}

/// What a torque gives to a body that does not turn is its integral, whatever the steps; backward in time it takes it back.
#[test]
fn a_held_torque_gives_its_integral() {
    let held = torque(Interpolation::Constant);
    let axis = InputTable::new(vec![0.0, 0.7, 2.0], vec![2.0, -1.0, 0.0], Interpolation::Constant);
    let about_axis = Inputs::new(vec![(Covector(Vector3::<f64>::z()), axis.unwrap())]).unwrap();
    let about_axis = TabulatedTorque(about_axis);
    let start = Pair(Covector(Vector3::z()), Time(0.0));
    for (substeps, count) in [(Substeps::suzuki4(), 3), (Substeps::yoshida6(), 7)] {
        let torqued = Torqued::new(orbits(), about_axis.clone()).with_substeps(substeps);
        let end = torqued.after(&start, 2.0 / count as f64, count).unwrap().momentum;
        assert!((end.0.0 - Vector3::z() * (1.0 + 1.4 - 1.3)).norm() < 1e-13, "{end:?}");
        let back = torqued.after(&end, -2.0 / count as f64, count).unwrap().momentum;
        assert!((back.0.0 - start.0.0).norm() < 1e-13 && back.1.0.abs() < 1e-14, "{back:?}");
    }
    // Control: without division the number of steps matters.
    let blind = Torqued::new(orbits(), Blind(about_axis));
    let end = blind.after(&start, 2.0 / 3.0, 2).unwrap().momentum;
    let again = blind.after(&start, 2.0 / 7.0, 6).unwrap().momentum;
    assert!((end.0.0.z - again.0.0.z).abs() > 1e-2);
    // Symmetric: a step and back again, across breakpoints
    let torqued = Torqued::new(orbits(), held).with_substeps(Substeps::yoshida6());
    let there = torqued.after(&self::start(), 4.0 / 15.0, 15).unwrap().momentum;
    let back = torqued.after(&there, -4.0 / 15.0, 15).unwrap().momentum;
    assert!((back.0.0 - self::start().0.0).norm() < 1e-12, "{back:?}");
}

#[test]
fn a_torque_is_not_known_beyond_its_tables() {
    let held = torque(Interpolation::Constant);
    assert_eq!(held.0.require_until(5.0, 0.0), Ok(()));
    let (first, last, begin, end) = (0.0, 5.0, 0.0, 6.0);
    let outside = Err(InputTableError::Outside { first, last, begin, end });
    assert_eq!(held.0.require_until(0.0, 6.0), outside);
    let torqued = Torqued::new(orbits(), held);
    assert!(torqued.after(&start(), 0.25, 20).is_ok());
    let error = torqued.after(&start(), 0.25, 21).unwrap_err().to_string();
    assert!(error.starts_with("step 21 at t = 5: the state is not finite"), "{error}");
    assert!(torqued.after(&start(), -0.25, 1).is_err());
}

#[test]
fn elements_that_are_no_torques_are_refused() {
    let table = || tables(Interpolation::Linear, 1.0)[0].clone();
    let inputs = |number| {
        let wrong = Covector(Vector3::new(0.0, number, 0.0));
        Inputs::new(vec![(Covector(Vector3::x()), table()), (wrong, table())])
    };
    let error = inputs(f64::INFINITY).unwrap_err();
    let number = f64::INFINITY;
    assert_eq!(error, InputsError::NotFinite { input: 2, coordinate: 2, number });
    assert_eq!(
        error.to_string(),
        "coordinate 2 of the vector of input 2 is inf, which is not a finite number"
    );
    assert!(inputs(f64::NAN).is_err() && inputs(1.0).is_ok());
    let flat = TabulatedTorque(Inputs::new(vec![(Vector2::<f64>::x(), table())]).unwrap());
    let expected = StepError::Dimension { expected: 2, found: 3 };
    assert_eq!(flat.flow(&mut start(), 0.1), Err(expected));
    // Without inputs there is no torque, and no breakpoint.
    let none = TabulatedTorque(Inputs::<Covector<Vector3<f64>>>::new(Vec::new()).unwrap());
    assert_eq!(TorqueFlow::<Timed>::next_break(&none, 0.0, true), None);
    let free = Torqued::new(orbits(), none).after(&start(), 0.1, 10).unwrap().momentum;
    assert!((free.0.0.norm() - start().0.0.norm()).abs() < 1e-14);
}

/// Momenta in units of 2^p and times in units of 2^q: the same digits.
#[test]
fn tables_have_no_units_of_their_own() {
    for interpolation in INTERPOLATIONS {
        let end = |momentum: f64, time: f64| {
            let body = Autonomous(Automatic(Body { unit: 1.0 / (momentum * time) }));
            let orbits = Driven::new(RungeKutta::implicit_midpoint(), HOPF, body);
            let torques = TORQUES.map(|torque| Covector(torque * (momentum / time)));
            let inputs = torques.into_iter().zip(tables(interpolation, time)).collect();
            let torqued = Torqued::new(orbits, TabulatedTorque(Inputs::new(inputs).unwrap()))
                .with_substeps(Substeps::yoshida6());
            let start = Pair(Covector(start().0.0 * momentum), Time(0.0));
            torqued.after(&start, 4.0 / 15.0 * time, 15).unwrap().momentum.0.0 / momentum
        };
        let (large, small) = (2.0_f64.powi(100), 2.0_f64.powi(-100));
        let expected = end(1.0, 1.0);
        for (momentum, time) in
            [(large, 1.0), (small, 1.0), (1.0, large), (1.0, small), (large, small)]
        {
            let found = end(momentum, time);
            assert!((found - expected).norm() < 8.0 * f64::EPSILON, "{found} {expected}");
        }
    }
}

/// Returns the ends of 19 members in lanes, which begin at multiples of a time.
fn ends_in_lanes(apart: f64) -> Vec<(Timed, Timed)> {
    let torqued = || {
        Torqued::new(orbits(), torque(Interpolation::Linear)).with_substeps(Substeps::yoshida6())
    };
    let begin = |member: u64| {
        let pi = start().0.0 + Vector3::x() * (0.01 * member as f64);
        Pair(Covector(pi), Time(apart * member as f64))
    };
    let ends = Mutex::new(vec![None; 19]);
    Ensemble::new(Laned::new(torqued())).stream(19, begin, 0.04, 100, |chunk| {
        assert!(chunk.failures.is_empty());
        for (member, end) in (chunk.first as usize..).zip(chunk.members) {
            ends.lock().unwrap()[member] = Some(*end);
        }
    });
    let together = ends.into_inner().unwrap().into_iter().map(Option::unwrap);
    let alone = (0..).map(|member| torqued().after(&begin(member), 0.04, 100).unwrap().momentum);
    together.zip(alone).collect()
}

/// Also where members begin at different times, and so are advanced one by one.
#[test]
fn members_in_lanes_have_the_bits_of_single_runs() {
    for apart in [0.0, 0.03] {
        for (together, alone) in ends_in_lanes(apart) {
            assert_eq!(together, alone);
        }
    }
}

/// The suite makes 1036 steps, which the tables have to cover.
#[test]
fn the_laws_of_integrators_hold() {
    for interpolation in INTERPOLATIONS {
        let torqued =
            Torqued::new(orbits(), torque(interpolation)).with_substeps(Substeps::suzuki4());
        laws::integrator(&torqued, &[start()], 0.004).unwrap().check(1e-13).unwrap();
    }
}
