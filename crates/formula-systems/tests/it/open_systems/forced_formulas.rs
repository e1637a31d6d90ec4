//! Torques, and attitudes.

use super::support::{Texts, after, distance, method, open};
use collective_integrators::{AnyState, Start, fitted_order};
use heavytop::methods::attitude_of;
use lie_poisson::Quaternion;
use nalgebra::Vector3;

const BODY: &str = "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2";

#[test]
fn friction_slows_a_body_down() {
    let texts =
        Texts { torque: Some(vec!["-0.1*Pi1", "-0.1*Pi2", "-0.1*Pi3"]), ..Texts::default() };
    let body = open("so(3)", BODY, &texts, 0.1).unwrap();
    assert!(!body.keeps_energy() && !body.keeps_casimirs());
    let end = after(&body, ("direct", "gauss-8"), &[0.6, -0.5, 1.2], 0.1, 100);
    let length = |mu: &[f64]| mu.iter().map(|x| x * x).sum::<f64>().sqrt();
    assert!((length(&end) / length(&[0.6, -0.5, 1.2]) - (-1.0_f64).exp()).abs() < 1e-12);
    // The direction is that of the free body at the time (1 − exp(−ct))/c, since Ω is homogeneous.
    let free = open("so(3)", BODY, &Texts::default(), 0.1).unwrap();
    let late = (1.0 - (-1.0_f64).exp()) / 0.1;
    let free = after(&free, ("direct", "gauss-8"), &[0.6, -0.5, 1.2], late / 100.0, 100);
    let scaled: Vec<f64> = free.iter().map(|x| x * (-1.0_f64).exp()).collect();
    assert!(distance(&end, &scaled) < 1e-10, "{end:?} {scaled:?}");
}

/// dh/dt = ⟨F, dh⟩ and dC/dt = ⟨dC, F⟩.
#[test]
fn the_balance_laws_hold_to_the_order_of_the_method() {
    let texts =
        Texts { torque: Some(vec!["sin(t)", "-0.2*Pi2", "0.1*cos(2*t)"]), ..Texts::default() };
    let errors = [0.2, 0.1, 0.05].map(|step| {
        let body = open("so(3)", BODY, &texts, step).unwrap();
        let start = [0.6, -0.5, 1.2];
        let integrator =
            body.tangent_integrator(&method(&body, "direct", "gauss-4"), &start).unwrap();
        let trajectory = integrator.trajectory(&AnyState::from_slice(&start), step).unwrap();
        let last = (2.0 / step).round() as u64;
        let samples: Vec<_> = trajectory.map(Result::unwrap).take(last as usize + 1).collect();
        let torque = |t: f64, pi: &[f64]| [t.sin(), -0.2 * pi[1], 0.1 * (2.0 * t).cos()];
        let power = |t: f64, pi: &[f64]| {
            let [a, b, c] = torque(t, pi);
            [
                a * pi[0] + b * pi[1] / 2.0 + c * pi[2] / 3.0,
                2.0 * (a * pi[0] + b * pi[1] + c * pi[2]),
            ]
        };
        // Simpson's rule over pairs of steps has the order 4, too.
        let mut work = [0.0; 2];
        for part in samples.windows(3).step_by(2) {
            for (sample, weight) in part.iter().zip([1.0, 4.0, 1.0]) {
                let power = power(sample.time, sample.momentum.as_slice());
                work.iter_mut()
                    .zip(power)
                    .for_each(|(work, power)| *work += weight * power * step / 3.0);
            }
        }
        let (first, end) = (&samples[0], &samples[last as usize]);
        let casimir = |pi: &[f64]| pi.iter().map(|x| x * x).sum::<f64>();
        let energy = body.energy(end.momentum.as_slice(), end.time)
            - body.energy(first.momentum.as_slice(), 0.0);
        let square = casimir(end.momentum.as_slice()) - casimir(first.momentum.as_slice());
        assert!(square.abs() > 0.1);
        (step, (energy - work[0]).abs().max((square - work[1]).abs()))
    });
    let fitted = fitted_order(&errors, 0.0).unwrap();
    assert!((fitted - 4.0).abs() < 0.5, "{fitted} {errors:?}");
}

/// The spatial angular momentum changes by the torque, turned into space by the attitude.
#[test]
fn the_attitude_follows_the_torque() {
    let texts = Texts {
        torque: Some(vec!["0.3", "-0.1*Pi2", "cos(t)", "0", "0", "0"]),
        ..Texts::default()
    };
    let h = "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2 + 0.7*Gamma3";
    let body = open("se(3)", h, &texts, 0.01).unwrap();
    assert!(body.has_attitude());
    let start = [0.6, -0.5, 1.2, 0.0, 0.0, 1.0];
    let upright = Quaternion { scalar: 1.0, vector: Vector3::zeros() };
    for (formulation, texts) in [("direct", texts), ("collective", Texts::default())] {
        let body = open("se(3)", h, &texts, 0.01).unwrap();
        let method = method(&body, formulation, "gauss-8");
        let integrator = body.integrator_with_attitude(&method, &start, upright).unwrap();
        let trajectory = integrator.trajectory(&AnyState::from_slice(&start), 0.01).unwrap();
        let mut impulse = Vector3::zeros();
        let mut before: Option<(Vector3<f64>, Vector3<f64>)> = None;
        for sample in trajectory.map(Result::unwrap).take(201) {
            let attitude = attitude_of(sample.state.as_slice());
            let mu = sample.momentum.as_slice();
            let [pi, gamma] = [&mu[..3], &mu[3..]].map(Vector3::from_column_slice);
            // Γ is the vertical in the body frame.
            assert!((attitude.rotate(&gamma) - Vector3::z()).norm() < 1e-11);
            let own = match formulation {
                "direct" => Vector3::new(0.3, -0.1 * pi.y, sample.time.cos()),
                _ => Vector3::zeros(),
            };
            // The weight's torque is Γ × 0.7 e₃ in the body frame.
            let force = attitude.rotate(&(own + gamma.cross(&(Vector3::z() * 0.7))));
            let momentum = attitude.rotate(&pi);
            if let Some((last, first)) = before {
                impulse += (last + force) * 0.005;
                // The trapezoidal rule leaves an error of the order h² of the derivatives, some 1e-5.
                assert!((momentum - first - impulse).norm() < 1e-4 * (1.0 + impulse.norm()));
                before = Some((force, first));
            } else {
                before = Some((force, momentum));
            }
        }
        assert!(impulse.norm() > 0.3);
    }
}
