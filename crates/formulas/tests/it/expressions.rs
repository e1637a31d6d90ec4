//! Formulas that a program builds, against those of texts.

use crate::support::{formula, heavy_top, point};
use lie_poisson_formulas::{Expression, Expressions, Formula, Problem};

/// Returns the energy of a heavy top, mgl c·Γ + Σ Πᵢ²/2Iᵢ, as expressions.
fn energy(parts: &mut Expressions) -> Expression {
    let [mgl, c, gamma] = ["mgl", "c", "Γ"].map(|name| parts.name(name));
    let height = parts.dot(c, gamma);
    let mut energy = parts.multiply(mgl, height);
    let half = parts.number(0.5);
    for i in 1..=3 {
        let (pi, moment) = (parts.name("Pi"), parts.name(&format!("I{i}")));
        let component = parts.component(pi, i);
        let square = parts.multiply(component, component);
        let quotient = parts.divide(square, moment);
        let term = parts.multiply(half, quotient);
        energy = parts.add(energy, term);
    }
    energy
}

#[test]
fn expressions_say_what_a_text_says() {
    let mut parts = Expressions::new();
    let value = energy(&mut parts);
    let built = Formula::of_expressions(&parts, value, &heavy_top()).unwrap();
    let text = formula("mgl*c·Gamma + 0.5*(Pi1*Pi1/I1) + 0.5*(Pi2*Pi2/I2) + 0.5*(Pi3*Pi3/I3)");
    let (z, v) = (point([1.0, 2.0, 3.0, 0.6, 0.0, 0.8]), point([0.5, -1.0, 2.0, 0.1, 0.2, 0.3]));
    assert_eq!(built.value(&z), text.value(&z));
    assert_eq!(built.differential(&z), text.differential(&z));
    assert_eq!(built.second_derivative(&z, &v), text.second_derivative(&z, &v));
    // Control: another part of the same expressions is another formula.
    let x = parts.name("Pi1");
    let other = Formula::of_expressions(&parts, x, &heavy_top()).unwrap();
    assert_eq!((other.value(&z), other.to_string().as_str()), (1.0, "Pi1"));
    assert!(other != built);
}

#[test]
fn every_operation_is_that_of_the_language() {
    let mut parts = Expressions::new();
    let (pi, gamma) = (parts.name("Pi"), parts.name("Gamma"));
    let (across, difference) = (parts.cross(pi, gamma), parts.subtract(pi, gamma));
    let (length, half) = (parts.norm(across), parts.number(0.5));
    let power = parts.power(length, half);
    let z = parts.component(difference, 3);
    let minus = parts.negate(z);
    let sine = parts.call("sin", &[minus]).unwrap();
    let angle = parts.call("atan2", &[power, sine]).unwrap();
    let built = Formula::of_expressions(&parts, angle, &heavy_top()).unwrap();
    let text = formula("atan2(|Pi×Gamma|^0.5, sin(-(Pi - Gamma)[3]))");
    let z = point([1.0, 2.0, 3.0, 0.6, 0.1, 0.8]);
    assert_eq!((built.value(&z), built.to_string()), (text.value(&z), text.to_string()));
}

#[test]
fn a_shared_part_is_printed_once() {
    let mut parts = Expressions::new();
    let (x, y) = (parts.name("Pi1"), parts.name("Pi2"));
    let mut s = parts.add(x, y);
    for _ in 0..3 {
        s = parts.multiply(s, s);
    }
    let built = Formula::of_expressions(&parts, s, &heavy_top()).unwrap();
    assert_eq!(built.to_string(), "s1 = Pi1 + Pi2; s2 = s1*s1; s3 = s2*s2; s3*s3");
    let sum = parts.add(x, x);
    let plain = Formula::of_expressions(&parts, sum, &heavy_top()).unwrap();
    assert_eq!(plain.to_string(), "Pi1 + Pi1");
}

#[test]
fn wrong_expressions_have_the_errors_of_texts() {
    let problem = |build: fn(&mut Expressions) -> Expression| {
        let mut parts = Expressions::new();
        let value = build(&mut parts);
        Formula::of_expressions(&parts, value, &heavy_top()).unwrap_err().to_string()
    };
    let unknown = problem(|parts| parts.name("Pj1"));
    assert_eq!(unknown, "there is no `Pj1`; did you mean `Pi1`?");
    let vector = problem(|parts| parts.name("Pi"));
    assert!(vector.contains("this formula is a vector of dimension 3"), "{vector}");
    let zero = problem(|parts| {
        let (x, zero) = (parts.name("Pi1"), parts.number(0.0));
        parts.divide(x, zero)
    });
    assert_eq!(zero, "the divisor is 0");
    let none = problem(|parts| {
        let pi = parts.name("Pi");
        parts.component(pi, 0)
    });
    assert!(none.contains("there is no component 0"), "{none}");
    let nan = problem(|parts| parts.number(f64::NAN));
    assert!(nan.contains("not a finite number"), "{nan}");

    let mut parts = Expressions::new();
    let x = parts.name("Pi1");
    let sine = parts.call("sine", &[x]).unwrap_err();
    assert!(matches!(sine.problem(), Problem::UnknownFunction { .. }), "{sine}");
    let two = parts.call("sin", &[x, x]).unwrap_err();
    assert_eq!(two.to_string(), "`sin` takes 1 argument(s), not 2");
    // A part of other expressions is none of these.
    let last = parts.number(1.0);
    let foreign = Formula::of_expressions(&Expressions::new(), last, &heavy_top());
    assert!(foreign.is_err());
}

/// Each cross product adds nine results or more at a time.
#[test]
fn numbers_of_results_on_the_way_have_a_limit() {
    let products = |count: usize| {
        let mut parts = Expressions::new();
        let (pi, mut product) = (parts.name("Pi"), parts.name("Gamma"));
        for _ in 0..count {
            product = parts.cross(product, pi);
        }
        let value = parts.component(product, 1);
        Formula::of_expressions(&parts, value, &heavy_top())
    };
    assert!(products(20).is_ok());
    let error = products(30_000).unwrap_err();
    assert!(matches!(error.problem(), Problem::TooLarge { limit: 262_144, .. }), "{error}");
}

#[test]
fn values_at_coordinates_in_a_slice() {
    for text in crate::support::FORMULAS {
        let h = formula(text);
        for x in crate::support::POINTS {
            assert_eq!(h.value_at(x).to_bits(), h.value(&point(*x)).to_bits(), "{text}");
            assert!(h.value_at(&x[..5]).is_nan() && h.value_at(&[*x, *x].concat()).is_nan());
        }
    }
}
