//! Satellites by name on ellipses: Beletskii's equation, the libration that a small eccentricity drives, the limit on a circle, the
//! rates of the compiled satellite, orders, and refusals.

use crate::open_systems::support::{after, distance};
use collective_integrators::{AnyState, Driven, RungeKutta, Start, fitted_order};
use lie_poisson::{Pair, State, Time, Vector};
use lie_poisson_formula_systems::{
    FormulaSystemError, KeplerOrbit, NamedInputs, OpenNames, OpenSystem, OpenTerms, SystemKind,
};
use lie_poisson_formulas::Parameters;
use lie_poisson_systems::SatelliteOnEllipse;
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// The moments about the velocity, the normal and the radius, and the mean motion, in a unit in which it is not 1.
const BOOM: [f64; 3] = [1.0, 1.2, 0.4];
const RATE: f64 = 1.3;

/// 3 (I₁ − I₃)/I₂
const STRENGTH: f64 = 1.5;

fn given(more: &[(&str, f64)]) -> Parameters {
    let given = Parameters::new().vector("I", &BOOM).unwrap().number("n", RATE).unwrap();
    more.iter().fold(given, |all, (name, value)| all.number(name, *value).unwrap())
}

fn satellite() -> &'static SystemKind {
    SystemKind::named("satellite").unwrap()
}

fn open(parameters: Parameters, step: f64) -> Result<OpenSystem, FormulaSystemError> {
    let inputs = NamedInputs::default().with_orbit(satellite().orbit(&parameters)?);
    let (base, _, hamiltonian) = OpenNames::of_kind(satellite(), parameters, &inputs, None)?;
    Ok(OpenSystem::new(base, OpenTerms { inputs, hamiltonian, ..OpenTerms::default() }, step)?)
}

/// Returns the start with a pitch and its rate, rad and rad/s.
fn start(parameters: &Parameters, pitch: f64, rate: f64) -> Vec<f64> {
    let turned = Parameters::new().number("pitch", pitch).unwrap();
    let turned = turned.vector("relative", &[0.0, rate, 0.0]).unwrap();
    satellite().coordinates(parameters, &turned).unwrap().unwrap()
}

fn pitch(mu: &[f64]) -> f64 {
    (-mu[3]).atan2(mu[5])
}

/// Returns the mean anomaly at a true one, of which there may be several turns.
fn mean_anomaly(e: f64, anomaly: f64) -> f64 {
    let turns = (anomaly / TAU).round();
    let half = 0.5 * (anomaly - turns * TAU);
    let eccentric = 2.0 * (((1.0 - e) / (1.0 + e)).sqrt() * half.tan()).atan() + turns * TAU;
    eccentric - e * eccentric.sin()
}

/// Returns ψ at the end of (1 + e cos ν) ψ″ − 2e d sin ν ψ′ + k sin ψ cos ψ = 2e sin ν, by 4000 steps of RK4 over ν.
fn beletskii(e: f64, [from, to]: [f64; 2], start: [f64; 2], d: f64) -> f64 {
    let rate = |nu: f64, [psi, slope]: [f64; 2]| {
        let torque = 2.0 * e * nu.sin() * (1.0 + d * slope) - STRENGTH * psi.sin() * psi.cos();
        [slope, torque / (1.0 + e * nu.cos())]
    };
    let moved = |z: [f64; 2], k: [f64; 2], h: f64| [z[0] + h * k[0], z[1] + h * k[1]];
    let (steps, mut z) = (4000, start);
    let h = (to - from) / f64::from(steps);
    for i in 0..steps {
        let nu = from + h * f64::from(i);
        let a = rate(nu, z);
        let b = rate(nu + h / 2.0, moved(z, a, h / 2.0));
        let c = rate(nu + h / 2.0, moved(z, b, h / 2.0));
        let d = rate(nu + h, moved(z, c, h));
        let sum = |i: usize| h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
        z = [z[0] + sum(0), z[1] + sum(1)];
    }
    z[0]
}

#[test]
fn the_pitch_obeys_beletskiis_equation() {
    let (e, from, to) = (0.2, 0.7, 0.7 + 1.5 * TAU);
    let parameters = given(&[("eccentricity", e), ("true_anomaly", from)]);
    let orbit = satellite().orbit(&parameters).unwrap().unwrap();
    assert!((orbit.true_anomaly(0.0) - from).abs() < 1e-14);
    let (psi, slope) = (0.3, -0.2);
    let mu = start(&parameters, psi, slope * orbit.rate(0.0));
    let end = (mean_anomaly(e, to) - mean_anomaly(e, from)) / RATE;
    let system = open(parameters, end / 400.0).unwrap();
    assert!(!system.keeps_energy() && system.keeps_casimirs());
    let found = pitch(&after(&system, ("collective", "gauss-8"), &mu, end / 400.0, 400));
    let expected = beletskii(e, [from, to], [psi, slope], 1.0);
    // RK4 with steps of 2.4e-3 rad: 1e-11 in each unit of a motion that turns over once.
    let apart = |other: f64| ((found - other) / TAU - ((found - other) / TAU).round()).abs() * TAU;
    assert!(apart(expected) < 1e-9, "{found} {expected}");
    // Controls: without the term of ψ′, and from another anomaly, it is another motion.
    assert!(apart(beletskii(e, [from, to], [psi, slope], 0.0)) > 1e-2);
    assert!(apart(beletskii(e, [0.0, to - from], [psi, slope], 1.0)) > 1e-2);
}

/// Returns the largest distance of a libration from 2e/(k − 1) sin ν, in units of e, over an orbit and a half from the pericentre.
fn distance_from_linear_theory(e: f64) -> f64 {
    let parameters = given(&[("eccentricity", e)]);
    let response = 2.0 * e / (STRENGTH - 1.0);
    let orbit = satellite().orbit(&parameters).unwrap().unwrap();
    let mu = start(&parameters, 0.0, response * orbit.rate(0.0));
    let step = TAU / RATE / 30.0;
    let system = open(parameters, step).unwrap();
    let method = crate::open_systems::support::method(&system, "collective", "gauss-6");
    let gauss = system.tangent_integrator(&method, &mu).unwrap();
    let run = gauss.trajectory(&AnyState::from_slice(&mu), step).unwrap();
    run.take(46).map(Result::unwrap).fold(0.0, |largest, sample| {
        let forced = response * orbit.true_anomaly(sample.time).sin();
        f64::max(largest, (pitch(sample.momentum.as_slice()) - forced).abs() / e)
    })
}

#[test]
fn a_small_eccentricity_drives_the_pitch_of_linear_theory() {
    let [coarse, fine] = [2e-3, 1e-3].map(distance_from_linear_theory);
    // The amplitude is 4e, and what is left is of the order of e².
    assert!(fine < 0.04 && (coarse / fine - 2.0).abs() < 0.05, "{coarse} {fine}");
}

#[test]
fn a_circle_is_the_limit_and_has_the_bits_of_the_closed_system() {
    let mut mu = start(&given(&[]), 0.3, 0.1);
    mu[0] += 0.2;
    let end = |more: &[(&str, f64)]| {
        let system = open(given(more), 0.05).unwrap();
        after(&system, ("collective", "gauss-6"), &mu, 0.05, 60)
    };
    let circle = end(&[]);
    assert_eq!(circle, end(&[("eccentricity", 0.0), ("mean_anomaly", 0.4)]));
    let closed = |parameters: Parameters| satellite().system(&parameters).unwrap();
    assert_eq!(closed(given(&[])), closed(given(&[("eccentricity", 0.0)])));
    // The change is in proportion to e.
    let [coarse, fine] = [2e-6, 1e-6].map(|e| distance(&circle, &end(&[("eccentricity", e)])));
    assert!(fine > 1e-7 && fine < 1e-4 && (coarse / fine - 2.0).abs() < 1e-3, "{coarse} {fine}");
}

/// Returns (Π × Ω + 3 GM/r³ Γ₁ × IΓ₁, Γ_k × (Ω − ν′ Γ₂)).
fn rate_by_hand(mu: &[f64], rate: f64, tide: f64) -> Vec<f64> {
    let part = |i: usize| Vector3::new(mu[i], mu[i + 1], mu[i + 2]);
    let (inertia, pi, [radial, normal]) = (Vector3::from(BOOM), part(0), [part(3), part(6)]);
    let omega = pi.component_div(&inertia);
    let torque = radial.cross(&radial.component_mul(&inertia)) * (3.0 * tide);
    let relative = omega - normal * rate;
    let parts = [pi.cross(&omega) + torque, radial.cross(&relative), normal.cross(&relative)];
    parts.iter().flatten().copied().collect()
}

#[test]
fn the_rates_and_runs_are_those_of_the_compiled_satellite() {
    let (e, anomaly) = (0.4, 2.1);
    let parameters = given(&[("eccentricity", e), ("mean_anomaly", anomaly)]);
    let orbit = KeplerOrbit::new(RATE, e, -anomaly / RATE).unwrap();
    let compiled = SatelliteOnEllipse::new(BOOM.into(), orbit).unwrap();
    let mut mu = start(&parameters, 0.5, 0.2);
    (mu[0], mu[2]) = (0.3, -0.2);
    let system = open(parameters, 0.05).unwrap();
    for time in [0.0, 0.7, 3.0, -2.0] {
        let expected = rate_by_hand(&mu, orbit.rate(time), orbit.tide(time));
        // Rounding errors of a dozen operations.
        assert!(distance(&system.rate(&mu, time).unwrap(), &expected) < 1e-13);
        assert!(distance(&system.rate(&mu, time + 0.1).unwrap(), &expected) > 1e-3);
    }
    let gauss = Driven::new(
        RungeKutta::gauss(6).unwrap(),
        momentum_map::TWO_FIELDS,
        lie_poisson::TimeDependent(compiled),
    );
    let from = Pair(Vector::from_coordinates(|i| mu[i]), Time(0.0));
    let expected = gauss.after(&from, 0.05, 60).unwrap().momentum.0;
    let expected: Vec<f64> = (0..9).map(|i| expected.coordinate(i)).collect();
    let found = after(&system, ("collective", "gauss-12"), &mu, 0.05, 60);
    // Two realisations have two maps, whose errors at this step are rounding errors.
    assert!(distance(&found, &expected) < 1e-11, "{found:?} {expected:?}");
}

#[test]
fn gauss_methods_have_their_orders() {
    let parameters = given(&[("eccentricity", 0.3), ("mean_anomaly", -1.0)]);
    let mut mu = start(&parameters, 0.3, 0.1);
    mu[0] += 0.2;
    let end = |scheme: &str, steps: u64| {
        let step = 2.0 / steps as f64;
        after(&open(parameters.clone(), step).unwrap(), ("collective", scheme), &mu, step, steps)
    };
    let reference = end("gauss-12", 40);
    for (scheme, order, counts) in [
        ("implicit-midpoint", 2.0, [40, 60, 80]),
        ("gauss-4", 4.0, [20, 30, 40]),
        ("gauss-6", 6.0, [12, 18, 24]),
    ] {
        let errors = counts.map(|n| (2.0 / n as f64, distance(&end(scheme, n), &reference)));
        let found = fitted_order(&errors, 1e-13)
            .unwrap_or_else(|error| panic!("{scheme} {error} {errors:?}"));
        assert!((found - order).abs() < 0.1 * order, "{scheme} {found} {errors:?}");
    }
}

#[test]
fn impossible_orbits_are_refused_by_name() {
    for (more, message) in [
        (&[("eccentricity", -0.1)][..], "eccentricity must be at least 0 and below 1, got -0.1"),
        (&[("eccentricity", 1.0)], "eccentricity must be at least 0 and below 1, got 1"),
        (
            &[("eccentricity", 0.1), ("mean_anomaly", 1.0), ("true_anomaly", 1.0)],
            "true_anomaly must be left out where there is a mean_anomaly",
        ),
    ] {
        let error = open(given(more), 0.1).unwrap_err().to_string();
        assert!(error.contains(message), "{error}");
        assert!(satellite().system(&given(more)).is_err());
    }
    // Numbers that are none are no parameters.
    assert!(Parameters::new().number("eccentricity", f64::NAN).is_err());
    let slow = Parameters::new().vector("I", &BOOM).unwrap().number("n", 1e-200).unwrap();
    let slow = slow.number("eccentricity", 0.1).unwrap();
    let error = open(slow, 0.1).unwrap_err().to_string();
    assert!(error.contains("n must be that of an orbit, got 1e-200"), "{error}");
    // Where nothing may depend on the time, an ellipse is refused, and a circle is not.
    let error = satellite().system(&given(&[("eccentricity", 0.1)])).unwrap_err().to_string();
    assert!(error.contains("eccentricity must be 0 where nothing may depend"), "{error}");
    let circle = satellite().system(&given(&[])).unwrap();
    assert!(satellite().system_near(&circle, &given(&[("eccentricity", 0.1)])).is_err());
}
