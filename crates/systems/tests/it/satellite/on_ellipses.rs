//! A satellite on an ellipse: its limit on a circle, the libration that the orbit drives, the orders of Gauss methods,
//! and what they conserve.

use super::attitudes::{directions, on_circle, on_ellipse, pitch};
use collective_integrators::diagnostics::fitted_order;
use collective_integrators::{Integrator, RungeKutta, Start};
use lie_poisson::{Pair, Time, Vector};
use lie_poisson_systems::{KeplerOrbit, Satellite, SatelliteDual, SatelliteOnEllipse, SystemError};
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// The moments about the velocity, the normal and the radius: a boom that points to the centre.
const BOOM: Vector3<f64> = Vector3::new(1.0, 1.2, 0.4);

/// The mean motion, in a unit in which it is not 1.
const RATE: f64 = 1.3;

fn satellite(eccentricity: f64) -> SatelliteOnEllipse {
    let orbit = KeplerOrbit::new(RATE, eccentricity, 0.3).unwrap();
    SatelliteOnEllipse::new(BOOM, orbit).unwrap()
}

/// The start of a satellite that tumbles, at the time 0.
fn tumbling(satellite: &SatelliteOnEllipse) -> Pair<SatelliteDual, Time> {
    let seen = directions(Vector3::new(0.3, -0.5, 0.4));
    Pair(satellite.momentum(seen, &Vector3::new(0.7, -0.4, 1.1), 0.0), Time(0.0))
}

#[test]
fn an_ellipse_without_eccentricity_is_a_circle() {
    let gauss = || RungeKutta::gauss(3).unwrap();
    let end = |eccentricity| {
        let satellite = satellite(eccentricity);
        on_ellipse(gauss(), satellite).after(&tumbling(&satellite), 0.05, 200).unwrap().momentum.0
    };
    let circle = on_circle(gauss(), Satellite::new(BOOM, RATE).unwrap());
    let Pair(start, _) = tumbling(&satellite(0.0));
    let expected = circle.after(&start, 0.05, 200).unwrap().momentum;
    // Rounding errors of 200 steps, which grow with the tumbling.
    assert!((end(0.0) - expected).max_abs() < 1e-11);
    assert!((end(0.01) - expected).max_abs() > 1e-3);
}

/// Returns the largest distance of a libration in an orbit of small eccentricity from 2e/(k − 1) sin n(t − t₀), k = 3
/// (I₁ − I₃)/I₂, and from the same without the resonance, over three periods of the orbit, in units of e.
fn distances(eccentricity: f64) -> [f64; 2] {
    let satellite = satellite(eccentricity);
    let orbit = satellite.orbit();
    let strength = 3.0 * (BOOM.x - BOOM.z) / BOOM.y;
    let forced = |response: f64, time: f64| {
        let (sin, cos) = (orbit.mean_motion() * (time - 0.3)).sin_cos();
        [sin, RATE * cos].map(|x| 2.0 * eccentricity * response * x)
    };
    let [angle, velocity] = forced(1.0 / (strength - 1.0), 0.0);
    let seen = directions(Vector3::y() * angle);
    let start = satellite.momentum(seen, &(Vector3::y() * velocity), 0.0);
    let gauss = on_ellipse(RungeKutta::gauss(3).unwrap(), satellite);
    let run = gauss.trajectory(&Pair(start, Time(0.0)), TAU / RATE / 40.0).unwrap();
    let mut largest = [0.0_f64; 2];
    for sample in run.take(121) {
        let Pair(mu, time) = sample.unwrap().momentum;
        for (largest, response) in largest.iter_mut().zip([1.0 / (strength - 1.0), 1.0 / strength])
        {
            let distance = (pitch(&mu) - forced(response, time.0)[0]).abs() / eccentricity;
            *largest = largest.max(distance);
        }
    }
    largest
}

#[test]
fn an_elliptic_orbit_drives_the_libration() {
    let [coarse, fine] = [2.5e-4, 1.25e-4].map(distances);
    // What is left is of the order of e², and falls in proportion to e here.
    assert!(fine[0] < 1e-3 && (coarse[0] / fine[0] - 2.0).abs() < 0.02, "{coarse:?} {fine:?}");
    // Control: the response of a spring without inertia is another one.
    assert!(fine[1] > 0.5, "{fine:?}");
}

#[test]
fn gauss_methods_have_their_orders_on_an_ellipse() {
    let satellite = satellite(0.4);
    let end = |stages: usize, count: u64| {
        let gauss = on_ellipse(RungeKutta::gauss(stages).unwrap(), satellite);
        gauss.after(&tumbling(&satellite), 3.0 / count as f64, count).unwrap().momentum.0
    };
    let reference = end(8, 60);
    for (stages, counts) in [(1, [100, 200, 400]), (2, [40, 80, 160]), (3, [30, 45, 60])] {
        let errors = counts.map(|count| {
            let error = (end(stages, count) - reference).max_abs();
            (3.0 / count as f64, error)
        });
        let order = fitted_order(&errors, 1e-13).unwrap();
        let expected = 2.0 * stages as f64;
        assert!((order - expected).abs() < 0.06 * expected, "{stages}: {order} {errors:?}");
    }
}

/// Returns the largest deviations of the Casimirs, and the largest change of the energy, over a run. The tide of this
/// orbit does not spin the body up, so that each step is a fraction of a radian.
fn deviations(steps: usize) -> [f64; 4] {
    let satellite = satellite(0.1);
    let gauss = on_ellipse(RungeKutta::gauss(2).unwrap(), satellite);
    let start = tumbling(&satellite);
    let energy = |z: &_| lie_poisson::Hamiltonian::<_, f64>::value(&satellite, z);
    let (first, run) = (energy(&start), gauss.trajectory(&start, 0.05).unwrap());
    let mut largest = [0.0_f64; 4];
    for sample in run.take(steps + 1).step_by(7) {
        let z = sample.unwrap().momentum;
        let [a, b, c] = Satellite::casimirs(&z.0);
        let found = [a - 1.0, b, c - 1.0, energy(&z) - first];
        largest = core::array::from_fn(|k| lie_poisson::larger(largest[k], found[k].abs()));
    }
    largest
}

#[test]
fn the_casimirs_are_conserved_on_an_ellipse() {
    let [casimirs @ .., energy] = deviations(1000);
    // Sums of a thousand roundings.
    assert!(casimirs.iter().all(|deviation| *deviation < 1e-12), "{casimirs:?}");
    // Control: the energy is no constant there.
    assert!(energy > 0.1, "{energy}");
}

#[test]
#[ignore = "long"]
fn the_casimirs_are_conserved_for_many_steps() {
    let [casimirs @ .., _] = deviations(30_000);
    println!("{casimirs:?}");
    assert!(casimirs.iter().all(|deviation| *deviation < 1e-12), "{casimirs:?}");
}

#[test]
fn a_tide_that_is_too_strong_at_the_pericentre_is_refused() {
    let orbit = KeplerOrbit::new(1.0, 1.0 - 1e-15, 0.0).unwrap();
    assert!(SatelliteOnEllipse::new(BOOM, orbit).is_ok());
    assert!(matches!(
        SatelliteOnEllipse::new(BOOM * 1e270, orbit),
        Err(SystemError::NotFinite { .. })
    ));
}

/// Attitudes of one boom at a step of its integrator do not depend on the point of the fibre, as for every collective
/// method.
#[test]
fn steps_on_an_ellipse_descend() {
    let satellite = satellite(0.4);
    let gauss = on_ellipse(RungeKutta::gauss(2).unwrap(), satellite);
    assert!(gauss.descends());
    let state = gauss.start(&tumbling(&satellite)).unwrap();
    let once = gauss.after(&tumbling(&satellite), 0.1, 1).unwrap();
    let again = gauss.start(&once.momentum).unwrap();
    let [one, other] = [once.state, again]
        .map(|state| gauss.trajectory_from(state, 0.1).nth(20).unwrap().unwrap().momentum.0);
    assert!((one - other).max_abs() < 1e-12);
    assert!(Integrator::<f64>::momentum(&gauss, &state).0.max_abs() > 0.1);
}
