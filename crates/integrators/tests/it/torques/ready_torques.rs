//! Constant and viscous torques against closed forms.

use super::support::{Body, order, orders, start};
use collective_integrators::{
    Collective, Composition, ConstantTorque, Driven, RungeKutta, Start, StepError, Substeps,
    TorqueError, TorqueFlow, Torqued, ViscousMatrix, ViscousTorque,
};
use lie_poisson::{Automatic, Autonomous, Covector, Pair, Time};
use momentum_map::{HOPF, HopfRealisation};
use nalgebra::{Matrix2, Matrix3, Matrix4, Rotation3, Vector2, Vector3};

const BODY: Automatic<Body> = Automatic(Body { unit: 1.0 });

fn midpoint() -> Collective<RungeKutta, HopfRealisation, Automatic<Body>> {
    Collective::new(RungeKutta::implicit_midpoint(), HOPF, BODY)
}

/// With equal rates c, Π(t) = exp(−ct) Π₀((1 − exp(−ct))/c), where Π₀ is the motion without friction.
#[test]
fn friction_with_equal_rates_slows_the_free_motion_down() {
    let rate = 0.1_f64;
    let slow = -(-4.0 * rate).exp_m1() / rate;
    let free = Collective::new(RungeKutta::gauss(8).unwrap(), HOPF, BODY);
    let free = free.after(&start(), slow / 100.0, 100).unwrap().momentum.0;
    let exact = free * (-4.0 * rate).exp();
    let viscous = ViscousTorque::new(Vector3::repeat(rate)).unwrap();
    assert_eq!(viscous.rates(), &Vector3::repeat(rate));
    for (expected, substeps, counts) in orders() {
        let mut torqued = Torqued::new(midpoint(), viscous);
        if let Some(substeps) = substeps {
            torqued = torqued.with_substeps(substeps);
        }
        let (found, errors) = order(&torqued, &exact, &counts);
        assert!((found - expected).abs() < 0.1 * expected, "{expected}: {found} {errors:?}");
        // The length decays without an error of the method.
        let end = torqued.after(&start(), 0.1, 200).unwrap().momentum.0.norm();
        let length = start().0.norm() * (-20.0 * rate).exp();
        assert!((end - length).abs() < 1e-13, "{end} {length}");
    }
    // Control: another rate, and rates that differ
    let end = |rates| {
        let torqued = Torqued::new(midpoint(), ViscousTorque::new(rates).unwrap());
        torqued.after(&start(), 0.1, 40).unwrap().momentum.0.norm()
    };
    assert!((end(Vector3::repeat(0.11)) - exact.norm()).abs() > 1e-2);
    assert!((end(Vector3::new(0.1, 0.1, 0.2)) - exact.norm()).abs() > 1e-2);
}

/// Substeps of the integrator itself are those of a composition, bit for bit.
#[test]
fn substeps_without_breakpoints_are_those_of_a_composition() {
    let viscous = || Torqued::new(midpoint(), ViscousTorque::new(Vector3::<f64>::x()).unwrap());
    for substeps in [Substeps::suzuki4(), Substeps::yoshida6()] {
        let within = viscous().with_substeps(substeps.clone()).after(&start(), 0.1, 50).unwrap();
        let around = Composition::new(viscous(), substeps).after(&start(), 0.1, 50).unwrap();
        assert_eq!(within.momentum, around.momentum);
    }
}

/// About a principal axis Π₃ = Π₃(0) + Ft, and with friction it tends to F/c.
#[test]
fn a_motor_about_a_principal_axis_is_exact() {
    let motor = ConstantTorque::new(Covector(Vector3::z() * 0.3_f64)).unwrap();
    assert_eq!(motor.torque().0, Vector3::z() * 0.3);
    let body = Torqued::new(midpoint(), motor);
    let end = |start| body.after(&Covector(start), 0.1, 40).unwrap().momentum.0;
    let (axis, across) = (end(Vector3::z() * 0.5), end(Vector3::new(0.3, 0.0, 0.5)));
    assert!((axis - Vector3::z() * 1.7).norm() < 1e-13, "{axis}");
    // Control: off the axis the body wobbles.
    assert!((across.z - 1.7).abs() > 1e-3, "{across}");
    // A torque is a constant of the body, and not of space: along Π it would leave the direction.
    assert!((across.normalize() - Vector3::new(0.3, 0.0, 0.5).normalize()).norm() > 0.1);
}

/// The motion with a motor and friction, by Runge–Kutta's method with steps so short that only rounding is left.
fn with_motor(motor: &Vector3<f64>, friction: &Matrix3<f64>) -> Vector3<f64> {
    let rate = |pi: &Vector3<f64>| {
        let omega = pi.component_div(&Vector3::new(2.0, 1.5, 1.0));
        pi.cross(&omega) + motor - friction * pi
    };
    let (mut pi, h) = (start().0, 4.0 / 16384.0);
    for _ in 0..16384 {
        let a = rate(&pi);
        let b = rate(&(pi + a * (h / 2.0)));
        let c = rate(&(pi + b * (h / 2.0)));
        let d = rate(&(pi + c * h));
        pi += (a + b * 2.0 + c * 2.0 + d) * (h / 6.0);
    }
    pi
}

/// One torque after the other, the second one around the first.
#[test]
fn torques_are_added_one_after_the_other() {
    let (motor, axes) =
        (Vector3::new(0.1, -0.2, 0.3), Rotation3::new(Vector3::new(0.4, 0.9, -0.5)));
    let rates = Vector3::new(0.05, 0.2, 0.1);
    let friction = axes.matrix() * Matrix3::from_diagonal(&rates) * axes.matrix().transpose();
    let exact = with_motor(&motor, &friction);
    let both = |friction: &Matrix3<f64>| {
        let viscous = Torqued::new(midpoint(), ViscousMatrix::new(friction).unwrap());
        Torqued::new(viscous, ConstantTorque::new(Covector(motor)).unwrap())
    };
    for (expected, substeps, counts) in orders() {
        let torqued = substeps
            .map_or_else(|| both(&friction), |substeps| both(&friction).with_substeps(substeps));
        let (found, errors) = order(&torqued, &exact, &counts);
        assert!((found - expected).abs() < 0.1 * expected, "{expected}: {found} {errors:?}");
    }
    // Control: the rates along the axes of the coordinates are another friction.
    let straight = both(&Matrix3::from_diagonal(&rates)).with_substeps(Substeps::yoshida6());
    assert!((straight.after(&start(), 0.1, 40).unwrap().momentum.0 - exact).norm() > 1e-2);
}

/// The exponential of a matrix, here by that of its rates in turned axes.
#[test]
fn friction_in_turned_axes_decays_along_each() {
    let axes = Rotation3::new(Vector3::new(0.4, 0.9, -0.5));
    for rates in [Vector3::new(0.0, 1.0, 7.0), Vector3::new(2.0, 2.0, 1e-9), Vector3::zeros()] {
        let matrix = axes.matrix() * Matrix3::from_diagonal(&rates) * axes.matrix().transpose();
        let viscous = ViscousMatrix::new(&matrix).unwrap();
        let mut pi = start();
        viscous.flow(&mut pi, 0.5).unwrap();
        let along = axes.inverse() * start().0;
        let exact = axes * along.component_mul(&rates.map(|c| (-0.5 * c).exp()));
        assert!((pi.0 - exact).norm() < 1e-14, "{rates}: {pi:?} {exact}");
        let found = viscous.rates();
        assert!(found.windows(2).all(|pair| pair[0] <= pair[1]) && found[0] >= 0.0, "{found:?}");
        // Back again
        viscous.flow(&mut pi, -0.5).unwrap();
        assert!((pi.0 - start().0).norm() < 1e-13);
    }
    // Control: more than rounding errors are not symmetric.
    let mut skew = Matrix3::identity();
    skew[(0, 1)] = 1e-14;
    assert!(ViscousMatrix::new(&skew).is_err());
    skew[(0, 1)] = 1e-15;
    assert!(ViscousMatrix::new(&skew).is_ok());
    // No friction changes no digit.
    let mut pi = start();
    ViscousMatrix::new(&Matrix3::zeros()).unwrap().flow(&mut pi, 1.0).unwrap();
    assert_eq!(pi, start());
}

/// A torque for momenta with the time has the coordinate 0 there.
#[test]
fn the_time_stays_as_it_is() {
    let orbits = || Driven::new(RungeKutta::implicit_midpoint(), HOPF, Autonomous(BODY));
    let (rates, motor) = (Vector3::new(0.05, 0.2, 0.1), Vector3::new(0.1, -0.2, 0.3));
    let viscous = ViscousTorque::new(Pair(rates, Time(0.0))).unwrap();
    let constant = ConstantTorque::new(Pair(Covector(motor), Time(0.0))).unwrap();
    let timed = Torqued::new(Torqued::new(orbits(), viscous), constant);
    let Pair(end, time) = timed.after(&Pair(start(), Time(0.0)), 0.1, 40).unwrap().momentum;
    assert!((time.0 - 4.0).abs() < 1e-14);
    let matrix = Matrix4::new(
        0.2, 0.1, 0.0, 0.0, 0.1, 0.3, -0.1, 0.0, 0.0, -0.1, 0.1, 0.0, 0.0, 0.0, 0.0, 0.0,
    );
    let mut late = Pair(start(), Time(12345.678));
    ViscousMatrix::new(&matrix).unwrap().flow(&mut late, 3.0).unwrap();
    assert!(late.1 == Time(12345.678) && late.0.0.norm() < 0.9 * start().0.norm());
    let plain = Torqued::new(midpoint(), ViscousTorque::new(rates).unwrap());
    let plain = Torqued::new(plain, ConstantTorque::new(Covector(motor)).unwrap());
    assert!((end.0 - plain.after(&start(), 0.1, 40).unwrap().momentum.0).norm() < 1e-13);
}

#[test]
fn numbers_that_are_no_torques_are_refused() {
    let rate = |rate| ViscousTorque::new(Vector2::new(1.0, rate)).map(|_| ());
    assert_eq!(rate(0.0), Ok(()));
    assert_eq!(rate(-0.5), Err(TorqueError::Rate { coordinate: 2, rate: -0.5 }));
    assert!(rate(f64::INFINITY).is_err() && rate(f64::NAN).is_err());
    let message = rate(f64::NAN).unwrap_err().to_string();
    assert_eq!(message, "a rate of friction is a finite number of at least 0, and rate 2 is NaN");
    let constant = ConstantTorque::new(Vector2::new(f64::NEG_INFINITY, 1.0));
    let number = f64::NEG_INFINITY;
    assert_eq!(constant, Err(TorqueError::NotFinite { coordinate: 1, number }));
    let matrix = |change: fn(&mut Matrix3<f64>)| {
        let mut matrix = Matrix3::identity();
        change(&mut matrix);
        ViscousMatrix::new(&matrix).map(|_| ())
    };
    assert_eq!(matrix(|_| ()), Ok(()));
    assert_eq!(
        matrix(|c| c[(0, 1)] = 0.5),
        Err(TorqueError::NotSymmetric { row: 2, column: 1, entry: 0.0, across: 0.5 })
    );
    let entry = matrix(|c| c[(0, 2)] = f64::INFINITY);
    let number = f64::INFINITY;
    assert_eq!(entry, Err(TorqueError::NotFiniteEntry { row: 1, column: 3, number }));
    assert!(matches!(
        matrix(|c| c[(2, 2)] = -1.0),
        Err(TorqueError::Rate { coordinate: 1, rate }) if (rate + 1.0).abs() < 1e-14
    ));
}

/// A torque for another space ends the run with both dimensions.
#[test]
fn a_torque_of_another_dimension_is_refused() {
    let flat = ConstantTorque::new(Vector2::<f64>::x()).unwrap();
    let expected = StepError::Dimension { expected: 2, found: 3 };
    assert_eq!(flat.flow(&mut start(), 0.1), Err(expected));
    assert_eq!(
        ViscousTorque::new(Vector2::<f64>::x()).unwrap().flow(&mut start(), 0.1),
        Err(expected)
    );
    let square = ViscousMatrix::new(&Matrix2::identity()).unwrap();
    assert_eq!(square.flow(&mut start(), 0.1), Err(expected));
    let error = Torqued::new(midpoint(), flat).after(&start(), 0.1, 1).unwrap_err().to_string();
    assert!(error.contains("dimension 2") && error.contains("dimension 3"), "{error}");
}

/// Momenta in units of 2^p and times in units of 2^q: the same digits.
#[test]
fn torques_have_no_units_of_their_own() {
    let rates = Vector3::new(0.05, 0.2, 0.1);
    let matrix = Matrix3::new(0.2, 0.1, 0.0, 0.1, 0.3, -0.1, 0.0, -0.1, 0.1);
    let end = |momentum: f64, time: f64| {
        let body = Automatic(Body { unit: 1.0 / (momentum * time) });
        let orbits = Collective::new(RungeKutta::implicit_midpoint(), HOPF, body);
        let motor = Vector3::new(0.1, -0.2, 0.3) * (momentum / time);
        let torqued = Torqued::new(orbits, ViscousTorque::new(rates / time).unwrap());
        let torqued = Torqued::new(torqued, ViscousMatrix::new(&(matrix / time)).unwrap());
        let torqued = Torqued::new(torqued, ConstantTorque::new(Covector(motor)).unwrap());
        let start = Covector(start().0 * momentum);
        torqued.after(&start, 0.1 * time, 40).unwrap().momentum.0 / momentum
    };
    let (large, small) = (2.0_f64.powi(100), 2.0_f64.powi(-100));
    for (momentum, time) in [(large, 1.0), (small, 1.0), (1.0, large), (1.0, small), (large, small)]
    {
        let (found, expected) = (end(momentum, time), end(1.0, 1.0));
        assert!((found - expected).norm() < 8.0 * f64::EPSILON, "{found} {expected}");
    }
}
