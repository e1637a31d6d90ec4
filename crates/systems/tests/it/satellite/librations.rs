//! A satellite on a circle: its equations, the frequencies of its librations against closed forms, attitudes that are
//! unstable, and what a collective Gauss method conserves.

use super::attitudes::{directions, on_circle, pitch};
use crate::all_systems::drifts::{ROUND_OFF, drifts, energy_bound, schemes};
use collective_integrators::{Direction, Events, RungeKutta, Start};
use lie_poisson::{Covector, Hamiltonian, LiePoisson, Pair, PoissonSpace, Power, Vector};
use lie_poisson_systems::{Satellite, SatelliteAlgebra, SatelliteDual, SystemError};
use nalgebra::{Matrix2, Vector2, Vector3};
use std::f64::consts::TAU;

/// The moments about the velocity, the normal and the radius: a boom that points to the centre.
const BOOM: Vector3<f64> = Vector3::new(1.0, 1.2, 0.4);

/// The angular velocity of the orbit, in a unit in which it is not 1.
const RATE: f64 = 1.3;

fn boom() -> Satellite {
    Satellite::new(BOOM, RATE).unwrap()
}

#[test]
fn the_equations_are_those_of_a_body_in_a_tide() {
    let mu = Covector(Pair(
        Vector3::new(0.4, -0.8, 0.6),
        Power([Vector3::new(0.6, 0.3, -0.5), Vector3::new(-0.2, 0.9, 0.1)]),
    ));
    let Covector(Pair(pi, Power([radial, normal]))) = mu;
    let omega = pi.component_div(&BOOM);
    let dh = Hamiltonian::<LiePoisson<SatelliteAlgebra>>::differential(&boom(), &mu);
    let rate = LiePoisson::minus(SatelliteAlgebra::default()).hamiltonian_vector(&mu, &dh);
    let torque = radial.cross(&radial.component_mul(&BOOM)) * (3.0 * RATE * RATE);
    let relative = omega - normal * RATE;
    let expected = Covector(Pair(
        pi.cross(&omega) + torque,
        Power([radial.cross(&relative), normal.cross(&relative)]),
    ));
    assert!((rate - expected).max_abs() < 1e-15);
    // At rest in the orbit nothing changes, if the axes are along its directions, and only then.
    let at_rest = |turn| {
        let mu = boom().momentum(directions(turn), &Vector3::zeros());
        let dh = Hamiltonian::<LiePoisson<SatelliteAlgebra>>::differential(&boom(), &mu);
        LiePoisson::minus(SatelliteAlgebra::default()).hamiltonian_vector(&mu, &dh).max_abs()
    };
    assert!(at_rest(Vector3::zeros()) < 1e-15 && at_rest(Vector3::new(0.0, 0.1, 0.0)) > 0.1);
}

/// In the plane of the orbit the satellite is a pendulum, d²θ/dt² = −(3/2) k n² sin 2θ with k = (I₁ − I₃)/I₂: its
/// period from the amplitude θ₀ is 4K(sin θ₀)/(n √(3k)), where K = π/(2 agm(1, cos θ₀)).
#[test]
fn librations_in_the_plane_have_the_period_of_a_pendulum() {
    let frequency = RATE * (3.0 * (BOOM.x - BOOM.z) / BOOM.y).sqrt();
    let gauss = on_circle(RungeKutta::gauss(5).unwrap(), boom());
    for amplitude in [1e-3_f64, 0.3, 1.2] {
        let (mut a, mut b) = (1.0, amplitude.cos());
        for _ in 0..6 {
            (a, b) = (0.5 * (a + b), (a * b).sqrt());
        }
        let period = TAU / (a * frequency);
        let turned = directions(Vector3::y() * amplitude);
        let start = boom().momentum(turned, &Vector3::zeros());
        let run = gauss.trajectory(&start, period / 60.0).unwrap().take(200);
        let times: Vec<f64> = Events::new(&gauss, run, pitch, Direction::Up)
            .map(|event| event.unwrap().time)
            .collect();
        // 0.75, 1.75 and 2.75 periods; order ten with sixty steps in a period.
        assert_eq!(times.len(), 3);
        for (time, turns) in times.iter().zip([0.75, 1.75, 2.75]) {
            assert!((time / (turns * period) - 1.0).abs() < 1e-9, "{amplitude} {time}");
        }
        // Control: the frequency of small librations does not do for large ones.
        let other = (times[1] - times[0]) * frequency / TAU - 1.0;
        assert!(other > 0.2 * amplitude * amplitude, "{amplitude} {other}");
    }
}

/// Returns ω₁² and ω₂² of a sum of two oscillations by the recurrence y(t ± 2h) = 2(c₁ + c₂) y(t ± h) − (4c₁c₂ + 2)
/// y(t) of its samples, where cᵢ = cos ωᵢh, and y(t ± h) are sums.
fn two_frequencies(samples: &[f64], step: f64) -> [f64; 2] {
    let (mut matrix, mut right) = (Matrix2::zeros(), Vector2::zeros());
    for y in samples.windows(5) {
        let row = Vector2::new(y[1] + y[3], y[2]);
        matrix += row * row.transpose();
        right += row * (y[0] + y[4]);
    }
    let solved = matrix.lu().solve(&right).unwrap();
    let (sum, product) = (0.5 * solved.x, -0.25 * (solved.y + 2.0));
    let root = (0.25 * sum * sum - product).sqrt();
    [0.5 * sum + root, 0.5 * sum - root].map(|c| (c.acos() / step).powi(2))
}

/// Returns ω² of roll and yaw: the roots of ω⁴ − (1 + 3r + ry) n² ω² + 4ry n⁴ with r = (I₂ − I₃)/I₁ and y = (I₂ −
/// I₁)/I₃ (Hughes, Spacecraft Attitude Dynamics, §9.3).
fn roll_and_yaw(moments: Vector3<f64>, rate: f64) -> [f64; 2] {
    let (r, y) = ((moments.y - moments.z) / moments.x, (moments.y - moments.x) / moments.z);
    let half = 0.5 * (1.0 + 3.0 * r + r * y);
    let root = (half * half - 4.0 * r * y).sqrt();
    [half - root, half + root].map(|square| square * rate * rate)
}

#[test]
fn roll_and_yaw_have_the_frequencies_of_their_quartic() {
    let gauss = on_circle(RungeKutta::gauss(4).unwrap(), boom());
    // The normal is seen along e₃ after a roll, and along e₁ after a yaw.
    for axis in [0, 2] {
        let turn = Vector3::new(2e-4, 0.0, -1e-4);
        let start = boom().momentum(directions(turn), &Vector3::new(-1e-4, 0.0, 3e-4));
        let samples: Vec<f64> = gauss
            .trajectory(&start, 0.1)
            .unwrap()
            .take(1000)
            .step_by(5)
            .map(|sample| sample.unwrap().momentum.0.1.0[1][axis])
            .collect();
        let found = two_frequencies(&samples, 0.5);
        let expected = roll_and_yaw(BOOM, RATE);
        for (found, expected) in found.iter().zip(expected) {
            // The square of an amplitude of 3e-4.
            assert!((found / expected - 1.0).abs() < 1e-6, "{found} {expected}");
        }
        // Control: the frequencies without the gyroscopic coupling, 4r and y.
        let uncoupled = [(BOOM.y - BOOM.x) / BOOM.z, 4.0 * (BOOM.y - BOOM.z) / BOOM.x]
            .map(|square| square * RATE * RATE);
        assert!((found[0] / uncoupled[0] - 1.0).abs() > 0.01, "{found:?} {uncoupled:?}");
        assert!((found[1] / uncoupled[1] - 1.0).abs() > 0.01, "{found:?} {uncoupled:?}");
    }
}

/// A boom along the velocity falls over with the rate n √(3 (I₃ − I₁)/I₂).
#[test]
fn a_boom_along_the_velocity_falls_over() {
    let moments = Vector3::new(BOOM.z, BOOM.y, BOOM.x);
    let satellite = Satellite::new(moments, RATE).unwrap();
    let growth = RATE * (3.0 * (moments.z - moments.x) / moments.y).sqrt();
    let gauss = on_circle(RungeKutta::gauss(4).unwrap(), satellite);
    let small = 1e-6;
    let turn = Vector3::y() * small;
    let start = satellite.momentum(directions(turn), &(turn * growth));
    assert!((pitch(&start) / small - 1.0).abs() < 1e-9);
    let end = gauss.after(&start, 0.05 / growth, 120).unwrap().momentum;
    // e⁶ = 403 times as far; the square of 4e-4 is the nonlinear part.
    assert!((pitch(&end) / (small * 6.0_f64.exp()) - 1.0).abs() < 1e-6, "{}", pitch(&end));
    let far = gauss.after(&start, 0.05 / growth, 280).unwrap().momentum;
    assert!(pitch(&far).abs() > 0.5);
    // Control: along the radius it stays where it is.
    let gauss = on_circle(RungeKutta::gauss(4).unwrap(), boom());
    let start = boom().momentum(directions(turn), &(turn * growth));
    let largest = gauss.trajectory(&start, 0.05).unwrap().take(1000);
    let largest = largest.map(|s| pitch(&s.unwrap().momentum).abs()).fold(0.0, f64::max);
    assert!(largest < 3.0 * small, "{largest}");
}

/// The start of a satellite that tumbles.
fn tumbling() -> SatelliteDual {
    boom().momentum(directions(Vector3::new(0.3, -0.5, 0.4)), &Vector3::new(0.7, -0.4, 1.1))
}

#[test]
fn jacobis_integral_and_the_casimirs_are_conserved() {
    for scheme in schemes() {
        let gauss = on_circle(scheme.clone(), boom());
        let [energy, casimirs @ ..] = drifts(&gauss, &tumbling(), (0.05, 1000), |mu| {
            let [a, b, c] = Satellite::casimirs(mu);
            [boom().value(mu), a, b, c]
        });
        assert!(casimirs.iter().all(|drift| *drift < ROUND_OFF), "{casimirs:?}");
        // The motion has frequencies of up to 5, and energies of up to 5.
        assert!(energy < 100.0 * energy_bound(&scheme, 0.05), "{energy:e}");
        // Control: the energy against the stars is no constant.
        let kinetic = |mu: &SatelliteDual| 0.5 * mu.0.0.dot(&boom().angular_velocity(mu));
        let [changed] = drifts(&gauss, &tumbling(), (0.05, 1000), |mu| [kinetic(mu)]);
        assert!(changed > 0.1, "{changed}");
    }
}

/// The same motion in units of 1e±30 of mass and of time.
#[test]
fn a_satellite_does_not_know_its_units() {
    let gauss = |satellite| on_circle(RungeKutta::gauss(3).unwrap(), satellite);
    let plain = gauss(boom()).after(&tumbling(), 0.05, 200).unwrap().momentum;
    for [mass, time] in [[1e30, 1e30], [1e-30, 1e30], [1e30, 1e-30], [1e-30, 1e-30]] {
        let satellite = Satellite::new(BOOM * mass, RATE / time).unwrap();
        let Covector(Pair(pi, seen)) = tumbling();
        let start = Covector(Pair(pi * (mass / time), seen));
        let end = gauss(satellite).after(&start, 0.05 * time, 200).unwrap().momentum;
        let scaled = Covector(Pair(end.0.0 * (time / mass), end.0.1));
        // Some 200 steps of rounding errors, which grow with the tumbling.
        assert!((scaled - plain).max_abs() < 1e-11, "{mass:e} {time:e}");
    }
}

#[test]
fn the_parameters_are_checked() {
    let new = Satellite::new;
    assert!(matches!(new(BOOM, 0.0), Err(SystemError::NotPositive { .. })));
    assert!(matches!(new(BOOM, f64::NAN), Err(SystemError::NotFinite { .. })));
    assert!(matches!(new(BOOM, 1e-200), Err(SystemError::NotPositive { name: "its square", .. })));
    let flat = Vector3::new(1.0, 1.0, 2.1);
    assert!(matches!(new(flat, 1.0), Err(SystemError::Triangle { .. })));
    assert!(matches!(
        new(BOOM * 1e300, 1e10),
        Err(SystemError::NotFinite { name: "torque of the tide, 3 GM/r³ times a moment", .. })
    ));
    assert!(new(BOOM, 1.0).is_ok());
}
