//! Casimirs that are computed from matrices, since their formulas would be too long. That they are the same as the formulas
//! where there are both is a test of the library.

use crate::support::{bracket, named, random};
use lie_poisson_formula_systems::FormulaSystem;

/// Checks that none is missing, and that brackets with all coordinates vanish. Returns the number of those that are computed.
fn computed(text: &str, system: &FormulaSystem) -> usize {
    assert_eq!(system.missing_casimirs(), Some(0), "{text}");
    let mut count = 0;
    for (casimir, degree) in system.casimirs().iter().zip(system.casimir_degrees()) {
        if casimir.formula().is_some() {
            continue;
        }
        count += 1;
        let mu = random(system.algebra().dimension(), 3);
        let mut xi = casimir.differential_at(&mu);
        let size = bracket(system, &xi, &mu);
        // some thousand roundings, of a polynomial of degree 120 ten times more; the recurrence of wedge products loses half of the digits in 22 dimensions: 5e-8
        let bound = if casimir.to_string().contains('∧') { 1e-6 } else { 1e-11 };
        assert!(size < bound, "{text} {casimir}: {size:e}");
        // The polynomial is homogeneous, and its differential its own: Σ μ_i ∂C/∂μ_i = degree C.
        let (value, terms) = xi.iter().zip(&mu).fold((0.0, 0.0), |(sum, size), (slope, x)| {
            (sum + slope * x, size + (slope * x).abs())
        });
        let error = (value - f64::from(*degree) * casimir.value_at(&mu)).abs();
        assert!(error < bound * terms, "{text} {casimir}: {error:e}");
        // Negative control: a slightly changed differential is that of no Casimir.
        xi.iter_mut().step_by(2).for_each(|slope| *slope *= 1.0 + 1e4 * bound);
        assert!(bracket(system, &xi, &mu) > 10.0 * bound, "{text} {casimir}");
    }
    count
}

#[test]
fn motions_that_keep_volumes_have_a_determinant() {
    for (text, name) in [
        ("sl(4,R) ⋉ R4", "det(Gamma, Gamma X, …, Gamma X^3)"),
        ("so(3) + sl(4,R) ⋉ R4", "det(Gamma, Gamma X, …, Gamma X^3)"),
    ] {
        let system = named(text);
        assert_eq!(computed(text, &system), 1, "{text}");
        let last = system.casimirs().last().unwrap();
        assert_eq!((last.to_string().as_str(), system.casimir_degrees().last()), (name, Some(&10)));
        // homogeneous in every unit
        let mu = random(system.algebra().dimension(), 5);
        for unit in [1e-20, 1e20_f64] {
            let scaled: Vec<f64> = mu.iter().map(|x| x * unit).collect();
            let ratio = last.value_at(&scaled) / unit.powi(10) / last.value_at(&mu);
            assert!((ratio - 1.0).abs() < 1e-12, "{text} {unit:e} {ratio}");
        }
    }
    // Control: gl(n) ⋉ Rⁿ does not keep volumes, and has no Casimir.
    assert!(named("gl(3) ⋉ R3").casimirs().is_empty());
    let error = named("sl(4,R) ⋉ R4").invariants(&[1e60; 19]).unwrap_err().to_string();
    assert!(
        error.starts_with("det(Gamma, Gamma X, …, Gamma X^3) has no value at M12 = 1"),
        "{error}"
    );
}

/// The largest algebras of each kind, and some on both sides of the bound up to which all Casimirs are formulas.
#[test]
#[ignore = "long"]
fn the_largest_algebras_have_all_casimirs() {
    let mut others = Vec::new();
    for (text, count) in [
        ("so(14)", 0),
        ("so(15)", 2),
        ("so(23)", 10),
        ("so(22)", 10),
        ("so(11,11)", 10),
        ("su(9)", 0),
        ("su(10)", 2),
        ("su(16)", 14),
        ("sl(11,R)", 0),
        ("sl(16,R)", 13),
        ("gl(11)", 0),
        ("gl(16)", 13),
        ("sp(12,R)", 0),
        ("sp(14,R)", 1),
        ("sp(22,R)", 10),
        ("se(11)", 0),
        ("so(6,5) ⋉ R11", 0),
        ("se(12)", 2),
        ("se(22)", 10),
        ("so(11,10) ⋉ R21", 10),
        ("sl(15,R) ⋉ R15", 1),
        ("so(15) + sl(4,R) ⋉ R4", 3),
    ] {
        let system = named(text);
        let found = computed(text, &system);
        if found != count {
            others.push((text, found));
        }
    }
    assert!(others.is_empty(), "{others:?}");
}
