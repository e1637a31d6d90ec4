//! Torques that take a motion off its coadjoint orbit.

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

type Spin = Covector<Vector3<f64>>;

#[derive(Clone, Copy)]
struct Body;

impl Energy for Body {
    type Space = LiePoisson<So3>;

    fn energy<T: Real>(&self, Covector(pi): &Point<Self::Space, T>) -> T {
        (pi.x * pi.x / 2.0 + pi.y * pi.y / 1.5 + pi.z * pi.z) * 0.5
    }
}

fn body() -> Automatic<Body> {
    Automatic(Body)
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

fn start() -> Spin {
    Covector(Vector3::new(1.0, 2.0, 0.5))
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

fn order<I: Start<Momentum = Spin>>(integrator: &I, counts: &[u64]) -> (f64, Vec<(f64, f64)>) {
    let exact = reference();
    let errors = counts.iter().map(|&count| {
        let step = 4.0 / count as f64;
        (step, (integrator.after(&start(), step, count).unwrap().momentum.0 - exact).norm())
    });
    let errors: Vec<_> = errors.collect();
    (fitted_order(&errors, 1e-14).unwrap(), errors)
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
            None => order(&strang(), &counts),
            Some(substeps) => order(&Composition::new(strang(), substeps), &counts),
        };
        assert!((found - expected).abs() < 0.1 * expected, "{expected}: {found} {errors:?}");
    }
    // Any integrator that descends makes the part on the orbits.
    let reduced = LiftFree::new(RungeKutta::gauss(2).unwrap(), Quaternions, body());
    let (found, errors) = order(&Torqued::new(reduced, MOTOR), &[40, 80, 160]);
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

/// dC/dt = ⟨dC, F⟩ and dh/dt = ⟨F, dh⟩: the motion on the orbits drops out of both.
#[test]
fn casimirs_and_energy_obey_their_balance_laws() {
    let midpoint = Collective::new(RungeKutta::implicit_midpoint(), HOPF, body());
    let motor = Composition::new(Torqued::new(midpoint, MOTOR), Substeps::suzuki4());
    let balance = |count: u64| {
        let step = 4.0 / count as f64;
        let samples: Vec<_> =
            motor.trajectory(&start(), step).unwrap().take(count as usize + 1).collect();
        let powers = samples.iter().map(|sample| {
            let pi = sample.as_ref().unwrap().momentum.0;
            let (torque, omega) = (MOTOR.at(&pi), pi.component_div(&Vector3::new(2.0, 1.5, 1.0)));
            [2.0 * pi.dot(&torque), omega.dot(&torque)]
        });
        // Simpson's rule, of order 4 as the method is.
        let weights = (0..=count).map(|n| match n {
            0 => 1.0,
            n if n == count => 1.0,
            n => {
                if n % 2 == 1 {
                    4.0
                } else {
                    2.0
                }
            }
        });
        let sums = powers.zip(weights).fold([0.0; 2], |sum, (power, weight)| {
            [0, 1].map(|i| sum[i] + power[i] * weight * step / 3.0)
        });
        let end = samples.last().unwrap().as_ref().unwrap().momentum.0;
        let changes = [
            end.norm_squared() - start().0.norm_squared(),
            Body.energy(&Covector(end)) - Body.energy(&start()),
        ];
        assert!(changes.iter().all(|change| change.abs() > 0.1));
        (step, (sums[0] - changes[0]).abs().max((sums[1] - changes[1]).abs()))
    };
    let errors: Vec<_> = [20, 40, 80].map(balance).into();
    let order = fitted_order(&errors, 1e-14).unwrap();
    assert!((order - 4.0).abs() < 0.4, "{order} {errors:?}");
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
