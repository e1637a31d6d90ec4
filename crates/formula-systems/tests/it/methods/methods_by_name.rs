//! Methods: which algebra has which, and that all of them integrate the same equations.

use crate::support::{distance, end, system};
use heavytop::methods::{Formulation, MethodError, PartitionedScheme, SchemeName};
use lie_poisson_formula_systems::{FormulaSystem, FormulaSystemError, SystemAlgebra};
use lie_poisson_formulas::{Coordinates, Parameters, StructureEntry};

/// Gauss–Legendre with six stages: over 40 steps of 0.05 its error is far below rounding.
const GAUSS: SchemeName = SchemeName::Gauss(6);

/// A bound on the rounding errors of 40 steps, each a few units in the last place of numbers of size 1.
const ROUNDING: f64 = 1e-12;

#[test]
fn all_formulations_integrate_the_same_equations() {
    for (name, hamiltonian, start) in [
        ("so(3)", "(Pi1^2 + Pi2^2/2 + Pi3^2/4)/2 + Pi1^4/8", &[1.0, 0.5, -0.3][..]),
        ("su(2)", "(mu1^2 + mu2^2/2 + mu3^2/4)/2", &[1.0, 0.5, -0.3]),
        ("sl(2)", "(alpha^2 + beta^2 + gamma^2)/2", &[1.0, 0.5, -0.3]),
        ("se(2)", "Pi^2/2 + Gamma1", &[0.5, 0.6, 0.8]),
        ("se(3)", "Pi·Pi/2 + Gamma3 - Pi3^2/4", &[1.0, 0.5, -0.3, 0.0, 0.6, 0.8]),
    ] {
        let system = system(SystemAlgebra::named(name).unwrap(), hamiltonian);
        let run = |formulation| end(&system, (formulation, GAUSS), start, (0.05, 40));
        let direct = run(Formulation::Direct);
        assert!(distance(&direct, start) > 0.1, "{name} does not move");
        for formulation in system.algebra().formulations() {
            let error = distance(&run(formulation), &direct);
            assert!(error < ROUNDING, "{name}, {formulation}: {error:e}");
        }
        // Negative control: another scheme ends elsewhere.
        let other = end(&system, (Formulation::Direct, SchemeName::Rk4), start, (0.05, 40));
        assert!(distance(&other, &direct) > ROUNDING, "{name}");
    }
}

/// The free rigid body on so(4), whose 6 coordinates are those of its two factors so(3), with the brackets
/// [a_i, a_j] = ε_ijk a_k and [b_i, b_j] = ε_ijk b_k. The factors do not interact: the run is that of two bodies.
#[test]
fn a_product_by_its_brackets_runs_as_its_factors_do() {
    let names = ["a1", "a2", "a3", "b1", "b2", "b3"];
    let brackets =
        ["a1, a2 = a3", "a2, a3 = a1", "a3, a1 = a2", "b1, b2 = b3", "b2, b3 = b1", "b3, b1 = b2"];
    let brackets = brackets.map(|text| text.split_once(" = ").unwrap());
    let product = SystemAlgebra::of_brackets(
        Coordinates::scalars(names).unwrap(),
        brackets,
        &Parameters::new(),
    )
    .unwrap();
    let both = system(product, "a1^2/2 + a2^2/4 + a3^2/8 + b1^2/2 + b2^2/3 + b3^2/4");
    assert_eq!(both.casimirs().len(), 2);
    let so3 = |h: &str| system(SystemAlgebra::named("so(3)").unwrap(), h);
    let (a, b) = (so3("Pi1^2/2 + Pi2^2/4 + Pi3^2/8"), so3("Pi1^2/2 + Pi2^2/3 + Pi3^2/4"));
    let start = [1.0, 0.5, -0.3, -0.4, 0.7, 0.2];
    let method = (Formulation::Direct, GAUSS);
    let whole = end(&both, method, &start, (0.05, 40));
    let parts =
        [end(&a, method, &start[..3], (0.05, 40)), end(&b, method, &start[3..], (0.05, 40))];
    assert!(distance(&whole, &parts.concat()) < ROUNDING);
    // Negative control: the factors are not interchangeable.
    assert!(distance(&whole[..3], &whole[3..]) > 0.1);
}

#[test]
fn dimensions_between_the_compiled_widths_run() {
    for dimension in [1, 2, 4, 5, 7, 9, 12, 15] {
        // h = x₁²/2 on the algebra [x₁, x₂] = x₂
        let names: Vec<String> = (1..=dimension).map(|i| format!("x{i}")).collect();
        let entries = match dimension {
            1 => Vec::new(),
            _ => vec![StructureEntry { i: 0, j: 1, k: 1, value: 1.0 }],
        };
        let names = names.iter().map(String::as_str);
        let algebra =
            SystemAlgebra::of_entries(Coordinates::scalars(names).unwrap(), entries).unwrap();
        let system = system(algebra, "x1^2/2");
        let start = vec![0.5; dimension];
        let last = end(&system, (Formulation::Direct, GAUSS), &start, (0.05, 40));
        assert!((last[0] - 0.5).abs() < ROUNDING);
        if let Some(x2) = last.get(1) {
            // dx₂/dt = x₁ x₂ with x₁ = ½, until t = 2
            assert!((x2 - 0.5 * f64::exp(1.0)).abs() < ROUNDING, "{x2}");
        }
        assert!(last.iter().skip(2).all(|x| *x == 0.5));
    }
}

/// Algebras of dimension 2, 4, 5 and 6: the affine group of the line, the oscillator algebra [a, b] = c, [d, a] = b,
/// [d, b] = −a, the Heisenberg algebra of two pairs, and two of so(3).
#[test]
fn clebsch_maps_of_other_dimensions_integrate_the_same_equations() {
    for (names, brackets, hamiltonian) in [
        (&["x", "y"][..], &[("x, y", "y")][..], "x^2/2 + y^2"),
        (
            &["a", "b", "c", "d"],
            &[("a, b", "c"), ("d, a", "b"), ("d, b", "-a")],
            "a^2/2 + b^2 + c*d + d^2/4",
        ),
        (&["p", "q", "r", "s", "z"], &[("p, q", "z"), ("r, s", "z")], "p^2/2 + q^2 + r*s + z^2/2"),
        (
            &["a", "b", "c", "p", "q", "r"],
            &[
                ("a, b", "c"),
                ("b, c", "a"),
                ("c, a", "b"),
                ("p, q", "r"),
                ("q, r", "p"),
                ("r, p", "q"),
            ],
            "a^2/2 + b^2 + c*p + q^2/4 + r^2",
        ),
    ] {
        let coordinates = Coordinates::scalars(names.iter().copied()).unwrap();
        let brackets = brackets.iter().copied();
        let none = Parameters::new();
        let algebra = SystemAlgebra::of_brackets(coordinates, brackets, &none).unwrap();
        let system = system(algebra, hamiltonian);
        let start = &[0.4, 0.3, -0.5, 0.2, 0.6, -0.7][..names.len()];
        let run = |formulation| end(&system, (formulation, GAUSS), start, (0.05, 40));
        let (direct, collective) = (run(Formulation::Direct), run(Formulation::Collective));
        assert!(distance(&direct, start) > 0.1, "{names:?} does not move");
        assert!(distance(&direct, &collective) < ROUNDING, "{direct:?} {collective:?}");
    }
}

#[test]
fn methods_that_an_algebra_does_not_have_are_refused() {
    let refused = |name: &str, formulation, scheme| {
        let algebra = SystemAlgebra::named(name).unwrap();
        algebra.method(formulation, scheme, 0.0).unwrap_err().to_string()
    };
    let message = refused("R1", Formulation::Collective, GAUSS);
    assert_eq!(message, "R1 has no collective gauss-12; it has direct");
    let message = refused("se(3)", Formulation::Splitting, GAUSS);
    assert_eq!(message, "se(3) has no splitting gauss-12; it has collective, reduced and direct");
    let verlet = SchemeName::Partitioned(PartitionedScheme::StormerVerlet);
    let message = refused("so(3)", Formulation::Collective, verlet);
    assert!(message.starts_with("so(3) has no collective stormer-verlet; collective has"));
    assert!(!message.ends_with("stormer-verlet"));
    assert!(refused("so(3)", Formulation::Reduced, SchemeName::Rk4).contains("reduced has"));
}

#[test]
fn wrong_tolerances_states_and_algebras_are_refused() {
    let so3 = SystemAlgebra::named("so(3)").unwrap();
    for value in [-1.0, f64::NAN, f64::INFINITY] {
        let error = so3.method(Formulation::Direct, GAUSS, value).unwrap_err();
        assert!(matches!(error, FormulaSystemError::Method(MethodError::Tolerance { .. })));
    }
    let method = so3.method(Formulation::Reduced, GAUSS, 0.0).unwrap();
    let start = [1.0, 0.0, 0.0, 0.0];
    let run = |system: &FormulaSystem, start: &[f64]| {
        system.tangent_integrator(&method, start).map(|_| ())
    };
    let body = system(so3, "Pi1^2 + 2*Pi2^2");
    let error = run(&body, &start).unwrap_err();
    assert_eq!(error, FormulaSystemError::StateLength { expected: 3, found: 4 });
    // A method of one algebra with a system on another.
    let other = system(SystemAlgebra::named("sl(2)").unwrap(), "alpha^2");
    assert!(matches!(run(&other, &start[..3]), Err(FormulaSystemError::NoMethod { .. })));
    assert!(run(&body, &start[..3]).is_ok());
}
