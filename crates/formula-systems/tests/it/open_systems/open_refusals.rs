//! What no open system is.

use super::support::{Texts, method, open};
use collective_integrators::NoiseRule;
use lie_poisson::{InnerProduct, InputTable, Interpolation, IsotropicNoise};
use lie_poisson_formula_systems::{
    NamedInputs, NoiseFields, NoiseTerms, OpenNames, OpenSystem, OpenTerms, SystemAlgebra,
};
use lie_poisson_formulas::Parameters;

const BODY: &str = "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2";

/// Returns the message of an error with those of its sources.
fn refusal(algebra: &str, texts: Texts) -> String {
    let error = open(algebra, BODY, &texts, 0.1).unwrap_err();
    let mut message = error.to_string();
    let mut source = std::error::Error::source(&error);
    while let Some(error) = source {
        message += &format!(": {error}");
        source = error.source();
    }
    message
}

#[test]
fn what_does_not_fit_is_refused_with_its_value() {
    let table = || InputTable::new(vec![0.0, 1.0], vec![0.0, 1.0], Interpolation::Linear).unwrap();
    let none = Texts::default;
    for (texts, part) in [
        (Texts { friction: Some(-0.1), ..none() }, "-0.1"),
        (Texts { friction: Some(f64::NAN), ..none() }, "NaN"),
        (Texts { friction: Some(0.1), temperature: Some(-2.0), ..none() }, "-2"),
        (Texts { temperature: Some(2.0), ..none() }, "a temperature needs a friction"),
        (Texts { torque: Some(vec!["0", "1"]), ..none() }, "3 formulas"),
        (Texts { torque: Some(vec!["0", "1", "Pi4"]), ..none() }, "Pi4"),
        (Texts { drive: Some(vec!["1"]), ..none() }, "the drive needs 3"),
        (Texts { noise: Some(vec![vec!["1"]]), ..none() }, "field 1 of the noise needs 3"),
        (Texts { inputs: vec![("t", table())], ..none() }, "is that of the time"),
        (Texts { inputs: vec![("Pi1", table())], ..none() }, "the input Pi1"),
        (Texts { inputs: vec![("u v", table())], ..none() }, "u v"),
        (
            Texts { friction: Some(0.1), product: Some(vec![1.0, 0.0, 0.0, 1.0]), ..none() },
            "2 rows",
        ),
        (
            Texts { friction: Some(0.1), product: Some(vec![1.0; 9]), ..none() },
            "not positive definite",
        ),
    ] {
        let message = refusal("so(3)", texts);
        assert!(message.contains(part), "{message}");
    }
    // Π and Γ have different units.
    let names = OpenNames::new(
        SystemAlgebra::named("se(3)").unwrap(),
        &NamedInputs::default(),
        Parameters::new(),
    );
    let message = names.unwrap().inner_product(None).unwrap_err().to_string();
    assert!(message.contains("6 rows") && message.contains("Pi, Gamma"), "{message}");
}

#[test]
fn a_strength_a_bound_and_a_step_must_make_sense() {
    let base = open("so(3)", BODY, &Texts::default(), 0.1).unwrap().base().clone();
    let made = |strength: f64, bound: Option<f64>, step: f64| {
        let fields = NoiseFields::Isotropic(IsotropicNoise {
            inner_product: InnerProduct::euclidean(),
            strength,
        });
        let noise = Some(NoiseTerms {
            fields,
            seed: 1,
            path: 0,
            rule: NoiseRule::Together,
            interval: None,
            bound,
        });
        OpenSystem::new(base.clone(), OpenTerms { noise, ..OpenTerms::default() }, step)
    };
    assert!(made(0.1, Some(4.0), 0.1).is_ok() && made(0.1, None, -0.1).is_ok());
    for (refused, part) in [
        (made(-0.1, None, 0.1), "-0.1"),
        (made(0.1, Some(0.5), 0.1), "0.5"),
        (made(0.1, None, 0.0), "0"),
        (made(0.1, None, f64::NAN), "NaN"),
    ] {
        let message = refused.unwrap_err().to_string();
        assert!(message.contains(part), "{message}");
    }
}

#[test]
fn methods_that_there_are_not_name_those_that_there_are() {
    let torque = Texts { torque: Some(vec!["1", "0", "0"]), ..Texts::default() };
    let forced = open("so(3)", BODY, &torque, 0.1).unwrap();
    let name = |formulation: &str| {
        let refused = forced.method(formulation.parse().unwrap(), "gauss-4".parse().unwrap(), 0.0);
        refused.unwrap_err().to_string()
    };
    assert!(
        name("collective").contains("it has direct") && name("reduced").contains("it has direct")
    );
    assert_eq!(method(&forced, "direct", "rk4").scheme().name(), "rk4");
    let damped =
        open("so(3)", BODY, &Texts { friction: Some(0.1), ..Texts::default() }, 0.1).unwrap();
    let refused = damped.method("reduced".parse().unwrap(), "gauss-4".parse().unwrap(), 0.0);
    assert!(refused.unwrap_err().to_string().contains("collective and direct"));
}

/// Where a formula has no value, a step fails; NaN goes nowhere.
#[test]
fn a_formula_without_a_value_fails_a_step() {
    use collective_integrators::{AnyState, Start};
    let texts = Texts { drive: Some(vec!["log(0.35 - t)", "0", "0"]), ..Texts::default() };
    let body = open("so(3)", BODY, &texts, 0.1).unwrap();
    let start = AnyState::from_slice(&[0.6, -0.5, 1.2]);
    let integrator =
        body.tangent_integrator(&method(&body, "collective", "gauss-4"), start.as_slice()).unwrap();
    assert!(integrator.after(&start, 0.1, 3).is_ok());
    let failed = integrator.after(&start, 0.1, 5).unwrap_err().to_string();
    assert!(failed.contains("step 4"), "{failed}");
}
