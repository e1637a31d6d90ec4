//! Torques that take a motion off its coadjoint orbit.

use super::support::{Body, Spin, order, start};
use collective_integrators::diagnostics::fitted_order;
use collective_integrators::{
    Collective, Composition, Driven, LiftFree, RungeKutta, Start, StepError, Substeps, TorqueFlow,
    Torqued,
};
use lie_poisson::{
    Automatic, Autonomous, Covector, Energy, LiePoisson, Momentum, Pair, Point, Real, Se3, So3,
    Time,
};
use momentum_map::{HOPF, PARTICLE, Quaternions};
use nalgebra::Vector3;

fn body() -> Automatic<Body> {
    Automatic(Body { unit: 1.0 })
}

/// The torque F = (0, 0, a) − D Π with different frictions along the axes.
#[derive(Clone, Copy)]
struct Motor {
    torque: f64,
    friction: Vector3<f64>,
}

const MOTOR: Motor = Motor { torque: 0.3, friction: Vector3::new(0.2, 0.05, 0.1) };

impl Motor {
    fn at(&self, pi: &Vector3<f64>) -> Vector3<f64> {
        Vector3::z() * self.torque - self.friction.component_mul(pi)
    }
}

impl TorqueFlow<Spin> for Motor {
    /// Exact: each component tends to its limit.
    fn flow(&self, Covector(pi): &mut Spin, step: f64) -> Result<(), StepError> {
        let limit = (Vector3::z() * self.torque).component_div(&self.friction);
        let decay = self.friction.map(|d| (-d * step).exp());
        *pi = limit + (*pi - limit).component_mul(&decay);
        Ok(())
    }
}

/// Returns the motion at t = 4 by steps of Runge–Kutta's method so short that only rounding is left.
fn reference() -> Vector3<f64> {
    let rate = |pi: &Vector3<f64>| {
        let omega = pi.component_div(&Vector3::new(2.0, 1.5, 1.0));
        pi.cross(&omega) + MOTOR.at(pi)
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

#[test]
fn compositions_of_the_flows_have_orders_two_four_and_six() {
    let midpoint = || Collective::new(RungeKutta::implicit_midpoint(), HOPF, body());
    let strang = || Torqued::new(midpoint(), MOTOR);
    for (substeps, expected, counts) in [
        (None, 2.0, [40, 80, 160]),
        (Some(Substeps::suzuki4()), 4.0, [20, 40, 80]),
        (Some(Substeps::yoshida6()), 6.0, [20, 30, 40]),
    ] {
        let (found, errors) = match substeps {
            None => order(&strang(), &reference(), &counts),
            Some(substeps) => order(&Composition::new(strang(), substeps), &reference(), &counts),
        };
        assert!((found - expected).abs() < 0.1 * expected, "{expected}: {found} {errors:?}");
    }
    // Any integrator that descends makes the part on the orbits.
    let reduced = LiftFree::new(RungeKutta::gauss(2).unwrap(), Quaternions, body());
    let (found, errors) = order(&Torqued::new(reduced, MOTOR), &reference(), &[40, 80, 160]);
    assert!((found - 2.0).abs() < 0.2, "{found} {errors:?}");
}

/// A torque along e₃ that oscillates, for momenta with the time. It is frozen while it acts.
struct Oscillating;

impl TorqueFlow<Pair<Spin, Time>> for Oscillating {
    fn flow(&self, mu: &mut Pair<Spin, Time>, step: f64) -> Result<(), StepError> {
        let Pair(Covector(pi), Time(time)) = mu;
        pi.z += (3.0 * *time).cos() * step;
        Ok(())
    }
}

/// About its third axis a symmetric body turns faster by the integral of the torque, sin(3t)/3, and across it turns by ∫ (Ω₃
/// − Π₃/I₁) dt.
#[test]
fn a_torque_that_depends_on_time_keeps_the_orders() {
    struct Symmetric;
    impl Energy for Symmetric {
        type Space = LiePoisson<So3>;

        fn energy<T: Real>(&self, Covector(pi): &Point<Self::Space, T>) -> T {
            (pi.x * pi.x + pi.y * pi.y) * 0.25 + pi.z * pi.z * 0.5
        }
    }
    let end = 4.0_f64;
    let third = 0.5 + (3.0 * end).sin() / 3.0;
    // dΠ₁/dt = ½ Π₂Π₃ and dΠ₂/dt = −½ Π₃Π₁ turn by half the integral of Π₃.
    let angle = 0.5 * (0.5 * end + (1.0 - (3.0 * end).cos()) / 9.0);
    let (sine, cosine) = angle.sin_cos();
    let exact = Vector3::new(cosine + 2.0 * sine, 2.0 * cosine - sine, third);
    let orbits =
        || Driven::new(RungeKutta::implicit_midpoint(), HOPF, Autonomous(Automatic(Symmetric)));
    let errors = |substeps: Option<Substeps>, counts: [u64; 3]| -> Vec<(f64, f64)> {
        let begin = Pair(start(), Time(0.0));
        let errors = counts.map(|count| {
            let (motor, step) = (Torqued::new(orbits(), Oscillating), end / count as f64);
            let found = match &substeps {
                None => motor.after(&begin, step, count),
                Some(substeps) => {
                    Composition::new(motor, substeps.clone()).after(&begin, step, count)
                }
            };
            (step, (found.unwrap().momentum.0.0 - exact).norm())
        });
        errors.into()
    };
    for (substeps, expected, counts) in [
        (None, 2.0, [40, 80, 160]),
        (Some(Substeps::suzuki4()), 4.0, [20, 40, 80]),
        (Some(Substeps::yoshida6()), 6.0, [40, 60, 80]),
    ] {
        let found = errors(substeps, counts);
        let order = fitted_order(&found, 1e-14).unwrap();
        assert!((order - expected).abs() < 0.1 * expected, "{expected}: {order} {found:?}");
    }
}

/// A torque along a Casimir's gradient leaves the momentum without a point over it.
struct Crossing;

impl TorqueFlow<Momentum<Se3, f64>> for Crossing {
    fn flow(&self, Covector(mu): &mut Momentum<Se3, f64>, step: f64) -> Result<(), StepError> {
        mu.0 += mu.1 * step;
        Ok(())
    }
}

struct Free;

impl Energy for Free {
    type Space = LiePoisson<Se3>;

    fn energy<T: Real>(&self, Covector(mu): &Point<Self::Space, T>) -> T {
        mu.0.x * mu.0.x + mu.0.y * mu.0.y * 0.5
    }
}

#[test]
fn a_momentum_without_a_lift_ends_the_run() {
    let particle = Collective::new(RungeKutta::implicit_midpoint(), PARTICLE, Automatic(Free));
    let start = Covector(Pair(Vector3::x(), Vector3::z()));
    assert!(particle.after(&start, 0.1, 10).is_ok());
    let error = Torqued::new(particle, Crossing).after(&start, 0.1, 10).unwrap_err().to_string();
    assert!(
        error.starts_with("step 1 at t = 0: the torque takes the momentum to a value"),
        "{error}"
    );
}
