//! The laws of integrators on systems that are driven, damped, noisy or forced.

use super::support::{Texts, method, open};
use collective_integrators::{AnyState, laws};
use lie_poisson::{InputTable, Interpolation};

/// The round-off of the few dozen operations in a law, relative to the sizes that enter it.
const ROUND_OFF: f64 = 1e-13;

const STEP: f64 = 0.05;

const BODY: &str = "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2";

/// Adds an input that jumps within a step, in a table until some time.
fn with_input(texts: Texts, end: f64) -> Texts {
    let (times, values) = (vec![0.0, 0.42, 0.9, end], vec![0.0, 1.5, -0.5, 0.0]);
    let pulse = InputTable::new(times, values, Interpolation::Constant).unwrap();
    Texts { inputs: vec![("u", pulse)], ..texts }
}

/// Pairs of a Hamiltonian and of what opens the system: time, an input that jumps within a step, a drive and friction, noise, a
/// torque.
fn cases() -> Vec<(String, Texts)> {
    let none = Texts::default;
    vec![
        (format!("{BODY} + cos(3*t)*Pi1/4"), none()),
        (format!("{BODY} + u*Pi2/3"), with_input(none(), 1e3)),
        (
            BODY.into(),
            Texts { drive: Some(vec!["0", "sin(t)/2", "Pi1/5"]), friction: Some(0.3), ..none() },
        ),
        (BODY.into(), Texts { friction: Some(0.2), temperature: Some(0.5), ..none() }),
        (BODY.into(), Texts { torque: Some(vec!["-0.1*Pi1", "0", "sin(t)/3"]), ..none() }),
    ]
}

#[test]
fn integrators_of_open_systems_obey_the_laws() {
    let check = |hamiltonian: &str, texts: &Texts| {
        let momenta = [[1.0, 0.4, -0.6], [-0.3, 0.8, 0.5]].map(|mu| AnyState::from_slice(&mu));
        let system = open("so(3)", hamiltonian, texts, STEP).unwrap();
        let by = method(&system, system.default_formulation().name(), "gauss-4");
        let integrator = system.tangent_integrator(&by, &[1.0, 0.4, -0.6]).unwrap();
        laws::start(&integrator, &momenta, STEP).unwrap().check(ROUND_OFF)
    };
    for (hamiltonian, texts) in cases() {
        check(&hamiltonian, &texts).unwrap_or_else(|broken| panic!("{hamiltonian}: {broken}"));
    }
    // Control: beyond the end of its table an input has no value, and steps fail.
    assert!(check(&format!("{BODY} + u*Pi2/3"), &with_input(Texts::default(), 1.0)).is_err());
}

/// An energy is a number for a momentum of the dimension, at a time at which the inputs have values, and there alone.
#[test]
fn an_energy_that_is_not_there_is_nan() {
    let system =
        open("so(3)", &format!("{BODY} + u*Pi2/3"), &with_input(Texts::default(), 1e3), STEP)
            .unwrap();
    let energy = system.energy(&[1.0, 0.4, -0.6], 0.5);
    assert!((energy - (0.5 * (1.0 + 0.08 + 0.12) + 1.5 * 0.4 / 3.0)).abs() < 1e-15, "{energy}");
    for wrong in [&[1.0, 0.4][..], &[1.0, 0.4, -0.6, 0.2], &[]] {
        assert!(system.energy(wrong, 0.5).is_nan());
    }
    for wrong in [1001.0, -1.0, f64::NAN] {
        assert!(system.energy(&[1.0, 0.4, -0.6], wrong).is_nan());
    }
}
