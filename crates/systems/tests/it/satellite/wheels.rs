//! A body with reaction wheels: a motion in closed form, its conserved angular momentum, its power, and refused
//! parameters.

use collective_integrators::{Driven, RungeKutta, Start};
use lie_poisson::{
    Covector, DualNumber, Hamiltonian, InTime, LiePoisson, Pair, Real, So3, Time, TimeDependent,
    parts,
};
use lie_poisson_systems::{ReactionWheels, SystemError, WheelMomenta};
use momentum_map::HOPF;
use nalgebra::Vector3;

/// A wheel with the angular momentum A sin ωt.
#[derive(Clone, Copy, Debug)]
struct ToAndFro {
    size: f64,
    frequency: f64,
}

impl WheelMomenta<1> for ToAndFro {
    fn momenta<T: Real>(&self, time: T) -> [T; 1] {
        [(time * self.frequency).sin() * self.size]
    }
}

const WHEEL: ToAndFro = ToAndFro { size: 0.6, frequency: 1.7 };

fn body(inertia: Vector3<f64>, axis: Vector3<f64>) -> ReactionWheels<ToAndFro, 1> {
    ReactionWheels::new(inertia, [axis], WHEEL).unwrap()
}

fn start() -> Pair<Covector<Vector3<f64>>, Time> {
    Pair(Covector(Vector3::new(0.8, -0.3, 1.1)), Time(0.0))
}

/// With I₁ = I₂ and the wheel along e₃, Π₃ is constant, and (Π₁, Π₂) turns by −∫(Ω₃ − Π₃/I₁) dt, Ω₃ = (Π₃ − A sin
/// ωt)/I₃.
#[test]
fn a_symmetric_body_has_a_closed_form() {
    let (across, along) = (2.0, 0.7);
    let body = body(Vector3::new(across, across, along), Vector3::z() * 3.0);
    let gauss = Driven::new(RungeKutta::gauss(5).unwrap(), HOPF, TimeDependent(body));
    let Pair(Covector(first), _) = start();
    for sample in gauss.trajectory(&start(), 0.1).unwrap().take(101) {
        let Pair(Covector(pi), time) = sample.unwrap().momentum;
        let wheel = WHEEL.size * (1.0 - (WHEEL.frequency * time.0).cos()) / WHEEL.frequency;
        let turned = |wheel: f64| {
            let angle = -(first.z * time.0 * (1.0 / along - 1.0 / across) - wheel / along);
            let (sin, cos) = angle.sin_cos();
            Vector3::new(first.x * cos - first.y * sin, first.x * sin + first.y * cos, first.z)
        };
        // Order ten with steps of a fifth of a radian.
        assert!((pi - turned(wheel)).norm() < 1e-9, "{}", time.0);
        // Control: without the wheel the body turns otherwise.
        assert!(time.0 < 0.5 || wheel < 0.1 || (pi - turned(0.0)).norm() > 0.05, "{}", time.0);
    }
}

#[test]
fn motors_keep_the_angular_momentum_and_change_the_energy_by_their_power() {
    let axis = Vector3::new(0.2, -0.7, 0.4);
    let body = body(Vector3::new(2.0, 1.5, 0.7), axis);
    let gauss = Driven::new(RungeKutta::gauss(4).unwrap(), HOPF, TimeDependent(body));
    let length = start().0.0.norm();
    let energy = |z: &_| Hamiltonian::<InTime<LiePoisson<So3>>>::value(&body, z);
    let run: Vec<_> = gauss.trajectory(&start(), 0.01).unwrap().take(1001).collect();
    let run: Vec<_> = run.into_iter().map(|sample| sample.unwrap().momentum).collect();
    let [mut least, mut most] = [f64::INFINITY, 0.0_f64];
    for three in run.windows(3) {
        assert!((three[1].0.0.norm() / length - 1.0).abs() < 1e-13);
        let torque = WHEEL.momenta(DualNumber::variable(three[1].1.0))[0].derivative();
        let power = -body.angular_velocity(&three[1]).dot(&axis.normalize()) * torque;
        let change = (energy(&three[2]) - energy(&three[0])) / 0.02;
        // The difference quotient has an error of h²/6 times a third derivative of about ten.
        assert!((change - power).abs() < 1e-3, "{change} {power}");
        let (_, rate) =
            parts(&Hamiltonian::<InTime<LiePoisson<So3>>>::differential(&body, &three[1]));
        assert!((rate.0.0 - power).abs() < 1e-14);
        (least, most) = (least.min(energy(&three[1])), most.max(energy(&three[1])));
    }
    // Control: the energy changes.
    assert!(most > 1.2 * least, "{least} {most}");
}

#[test]
fn the_parameters_are_checked() {
    let inertia = Vector3::new(2.0, 1.5, 0.7);
    let new = |inertia, axis| ReactionWheels::new(inertia, [axis], WHEEL);
    assert!(matches!(new(inertia, Vector3::zeros()), Err(SystemError::Zero { .. })));
    let bad = Vector3::new(0.0, f64::INFINITY, 0.0);
    assert!(matches!(new(inertia, bad), Err(SystemError::NotFinite { .. })));
    assert!(matches!(new(-inertia, Vector3::x()), Err(SystemError::NotPositive { .. })));
    // An axis has no unit.
    for power in [-300, 300] {
        let axis = Vector3::new(0.0, 3.0, -4.0) * 10.0_f64.powi(power);
        let momentum = new(inertia, axis).unwrap().momentum(1.0_f64);
        let expected = Vector3::new(0.0, 0.6, -0.8) * WHEEL.momenta(1.0)[0];
        assert!((momentum - expected).norm() < 1e-15);
    }
}
