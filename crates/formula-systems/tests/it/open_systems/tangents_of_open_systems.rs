//! Tangent vectors of motions that are driven, damped, noisy or forced.

use super::support::{Texts, distance, method, open};
use collective_integrators::{
    AnyIntegrator, AnyState, AnyTangents, Start, TangentFrame, VariationalFlow,
};
use lie_poisson::State;
use lie_poisson_formula_systems::OpenSystem;

const BODY: &str = "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2";

fn integrator(
    system: &OpenSystem,
    names: (&str, &str),
    start: &[f64],
) -> AnyIntegrator<dyn AnyTangents> {
    system.tangent_integrator(&method(system, names.0, names.1), start).unwrap()
}

/// Returns the sums of ln r_ii over a run of so many steps, per unit of time.
fn exponents(system: &OpenSystem, start: &[f64], step: f64, steps: u64) -> Vec<f64> {
    let direct = integrator(system, ("direct", "gauss-8"), start);
    assert!(direct.states_are_momenta());
    let state = direct.start(&AnyState::from_slice(start)).unwrap();
    let mut frame = TangentFrame::generic(&direct, state, (start.len(), start.len()), step);
    frame.orthonormalise().unwrap();
    let mut sums = vec![0.0; start.len()];
    while frame.steps() < steps {
        frame.advance().unwrap();
        let lengths = frame.orthonormalise().unwrap();
        sums.iter_mut().zip(lengths).for_each(|(sum, length)| *sum += length.ln());
    }
    sums.iter().map(|sum| sum / frame.time()).collect()
}

/// At the pole Π = ℓ e₃ of a damped spin, h = −B Π₃, the field is linear in small vectors: those across turn at the rate B and shrink
/// at θBℓ, and those along Π stay, since |Π|² is a Casimir.
#[test]
fn exponents_at_the_pole_of_a_damped_spin_are_those_of_the_friction() {
    for (length, friction, units) in [(1.0, 0.3, 1.0), (2.0, 0.1, 1.0), (1.0, 0.3, 1e20)] {
        let h = format!("-{:e}*Pi3", 1.5 / units);
        let texts = Texts { friction: Some(friction), ..Texts::default() };
        let spin = open("so(3)", &h, &texts, 0.1 * units).unwrap();
        let found = exponents(&spin, &[0.0, 0.0, length], 0.1 * units, 1000);
        let rate = friction * 1.5 * length;
        let found: Vec<f64> = found.iter().map(|exponent| exponent * units).collect();
        // The first vector finds the direction that stays within a stretch of about 1, in 100 units of time.
        assert!(found[0].abs() < 0.03 && (found[1] + rate).abs() < 0.03, "{found:?}");
        // The volume shrinks at 2θBℓ whatever the frame is, with 1000 steps of a few rounding errors.
        assert!((found.iter().sum::<f64>() + 2.0 * rate).abs() < 1e-12, "{found:?}");
        // Control: backward in time, which is the other pole, the volume grows.
        let other = exponents(&spin, &[0.0, 0.0, -length], 0.1 * units, 10);
        assert!(other.iter().sum::<f64>() * units > rate);
    }
}

/// A torque −kΠ on a spin at rest: every vector shrinks at the rate k.
#[test]
fn a_viscous_torque_shrinks_every_vector_at_its_rate() {
    let texts =
        Texts { torque: Some(vec!["-0.2*Pi1", "-0.2*Pi2", "-0.2*Pi3"]), ..Texts::default() };
    let spin = open("so(3)", "0.7*Pi3 + cos(t)*Pi1", &texts, 0.1).unwrap();
    let found = exponents(&spin, &[0.3, 0.5, 0.8], 0.1, 200);
    assert!(found.iter().all(|exponent| (exponent + 0.2).abs() < 1e-12), "{found:?}");
}

/// Motions that are forced in every way, with tolerances of central differences of size 1e-5: their error is ε² and 1e-16/ε.
#[test]
fn images_of_tangent_vectors_are_differences_of_runs() {
    let driven = || Texts { drive: Some(vec!["0", "0.3*sin(2*t)", "0"]), ..Texts::default() };
    let fields = vec![vec!["0.2", "0", "0.1*Pi1"]];
    for (name, texts, by) in [
        ("drive", driven(), "collective"),
        ("friction", Texts { friction: Some(0.2), ..driven() }, "collective"),
        ("noise", Texts { noise: Some(fields), friction: Some(0.2), ..driven() }, "collective"),
        (
            "temperature",
            Texts { friction: Some(0.1), temperature: Some(0.2), ..driven() },
            "direct",
        ),
        ("torque", Texts { torque: Some(vec!["-0.1*Pi1", "sin(t)", "0"]), ..driven() }, "direct"),
    ] {
        let system = open("so(3)", &format!("{BODY} + 0.2*cos(t)*Pi3"), &texts, 0.1).unwrap();
        let system = if texts.drive.is_some() { system.on_path(5) } else { system };
        let difference = differs_from_runs(&system, by, (40, 1e-5));
        assert!(difference < 1e-8, "{name}: {difference:e}");
    }
}

/// Lifts are moved along their fibres after 1024 intervals, and those with tangent vectors are not. Over 110 units of time vectors
/// grow a hundredfold, and so do the errors of the differences.
#[test]
fn tangent_vectors_outlive_the_moves_of_lifts() {
    let texts = Texts { friction: Some(0.01), ..Texts::default() };
    let system = open("so(3)", "Pi1^2/4 + Pi3 + 0.1*cos(t)*Pi2", &texts, 0.1).unwrap();
    let difference = differs_from_runs(&system, "collective", (1100, 1e-6));
    assert!(difference < 1e-5, "{difference:e}");
}

/// Returns the distance of the image of a tangent vector after some steps from the central difference of two runs, whose starts are a
/// small number apart.
fn differs_from_runs(system: &OpenSystem, by: &str, (steps, small): (u64, f64)) -> f64 {
    let (start, step) = ([0.6, -0.5, 1.2], 0.1);
    let method = (by, "gauss-8");
    let moved = integrator(system, method, &start);
    let state = moved.start(&AnyState::from_slice(&start)).unwrap();
    let dimension = moved.tangent_dimension();
    let mut flow = VariationalFlow::<_, 1>::generic(&moved, state, dimension, step);
    let image = |flow: &VariationalFlow<'_, AnyIntegrator<dyn AnyTangents>, 1>| {
        flow.directions().unwrap()[0].clone()
    };
    let first = image(&flow);
    for _ in 0..steps {
        flow.advance().unwrap();
    }
    let end = |sign: f64| {
        let from: Vec<f64> =
            start.iter().enumerate().map(|(i, x)| x + sign * small * first.coordinate(i)).collect();
        let state = AnyState::from_slice(&from);
        integrator(system, method, &from).after(&state, step, steps).unwrap().momentum
    };
    let (after, before) = (end(1.0), end(-1.0));
    let slopes: Vec<f64> =
        (0..3).map(|i| (after.coordinate(i) - before.coordinate(i)) / (2.0 * small)).collect();
    distance(image(&flow).as_slice(), &slopes)
}

/// Π and Γ of a body that is driven are measured in units of their own: exponents of finite times do not depend on the unit of mass.
#[test]
fn exponents_of_a_body_have_no_unit_of_mass() {
    let of = |mass: f64| {
        let h = format!(
            "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/{:e} + {mass:e}*(1 + 0.3*cos(t))*Gamma1",
            2.0 * mass
        );
        let body = open("se(3)", &h, &Texts::default(), 0.1).unwrap();
        let start = [0.6 * mass, -0.5 * mass, 1.2 * mass, 0.6, 0.0, 0.8];
        exponents(&body, &start, 0.1, 200)
    };
    let (one, other) = (of(1.0), of(1e-9));
    assert!(distance(&one, &other) < 1e-8 && one[0] > 0.01, "{one:?} {other:?}");
}
