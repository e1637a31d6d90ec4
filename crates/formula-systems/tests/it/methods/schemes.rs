//! The schemes by name have their orders, and the coadjoint Clebsch map serves where the adjoint one has no lift.

use crate::support::{distance, end, system};
use heavytop::methods::{ComposedScheme, Formulation, SchemeName};
use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
use lie_poisson_formulas::{Coordinates, Expressions, Parameters};

#[test]
fn schemes_have_their_orders() {
    let body = system(SystemAlgebra::named("so(3)").unwrap(), "Pi1^2/2 + Pi2^2/4 + Pi3^2/8");
    let start = [1.0, 0.5, -0.3];
    let run =
        |scheme, step: f64, steps| end(&body, (Formulation::Direct, scheme), &start, (step, steps));
    let exact = run(SchemeName::Gauss(6), 0.05, 80);
    for scheme in [
        SchemeName::ImplicitMidpoint,
        SchemeName::ExplicitMidpoint,
        SchemeName::Rk4,
        SchemeName::Gauss(2),
        SchemeName::Composed(ComposedScheme::Yoshida4),
        SchemeName::Composed(ComposedScheme::Suzuki4),
        SchemeName::Composed(ComposedScheme::KahanLi6),
    ] {
        // Steps so large that the error of order 6 is above rounding, and so small that the leading term dominates.
        let [coarse, fine] =
            [(0.2, 20), (0.1, 40)].map(|(step, steps)| distance(&run(scheme, step, steps), &exact));
        let found = (coarse / fine).log2();
        assert!((found - f64::from(scheme.order())).abs() < 0.5, "{scheme}: {found}");
    }
    // Negative control: the measured order is not that of any scheme.
    let [coarse, fine] = [(0.2, 20), (0.1, 40)]
        .map(|(step, steps)| distance(&run(SchemeName::Rk4, step, steps), &exact));
    assert!(((coarse / fine).log2() - 6.0).abs() > 0.5);
}

/// On [x₁, x₄] = x₁, [x₂, x₅] = x₂, [x₄, x₅] = x₃ all derivations vanish on the centre x₃: the adjoint map, extended by
/// one, does not reach μ₃ ≠ 0, and the coadjoint one does.
#[test]
fn the_coadjoint_clebsch_map_reaches_what_the_adjoint_one_does_not() {
    let names = Coordinates::scalars(["x1", "x2", "x3", "x4", "x5"]).unwrap();
    let brackets = [("x1, x4", "x1"), ("x2, x5", "x2"), ("x4, x5", "x3")];
    let algebra = SystemAlgebra::of_brackets(names, brackets, &Parameters::new()).unwrap();
    let system = system(algebra, "x1^2/2 + x2^2/3 + x3*x4 + x4^2/2 + x5^2/4");
    let gauss = SchemeName::Gauss(6);
    for start in [[0.4, 0.3, -0.5, 0.2, 0.6], [0.4, 0.3, 0.0, 0.2, 0.6]] {
        let run = |formulation| end(&system, (formulation, gauss), &start, (0.05, 20));
        let (direct, collective) = (run(Formulation::Direct), run(Formulation::Collective));
        assert!(distance(&direct, &start) > 0.1, "{direct:?}");
        assert!(distance(&direct, &collective) < 1e-12, "{direct:?} {collective:?}");
    }
    let collective = system.algebra().method(Formulation::Collective, gauss, 0.0);
    let direct = system.algebra().method(Formulation::Direct, gauss, 0.0).unwrap();
    let start = [0.4, 0.3, -0.5, 0.2, 0.6];
    // ad(x₄ + 2 x₅) has the eigenvalues 1 and 2, so that its cube is no multiple of it.
    assert_eq!(system.descends(&collective.unwrap(), &start), Ok(false));
    assert_eq!(system.descends(&direct, &start), Ok(true));
}

/// Steps descend where the cubes of the matrices ad ξ are such matrices: for the affine group of the line, on sl(2) and
/// on two of so(3), and not where z has the eigenvalues 1 and 2. There alone the midpoint rule, of order 2, loses the
/// Casimir x²/y.
#[test]
fn casimirs_are_lost_where_steps_do_not_descend() {
    let of_brackets = |names: &str, brackets: &[&str]| {
        let names = Coordinates::scalars(names.split_whitespace()).unwrap();
        let brackets = brackets.iter().map(|text| text.split_once(" = ").unwrap());
        SystemAlgebra::of_brackets(names, brackets, &Parameters::new()).unwrap()
    };
    let both = ["a, b = c", "b, c = a", "c, a = b", "p, q = r", "q, r = p", "r, p = q"];
    let two_rates = ["a, b = c", "b, c = a", "c, a = b", "x, z = x", "y, z = 2*y"];
    let line = of_brackets("x y", &["x, y = y"]);
    let sl2 = SystemAlgebra::named("sl(2)").unwrap();
    let so3_twice = of_brackets("a b c p q r", &both);
    let rates = of_brackets("x y z", &two_rates[3..]);
    let so3_and_rates = of_brackets("a b c x y z", &two_rates);
    for (algebra, hamiltonian, casimir, descends) in [
        (line, "x^2/2 + y^2", "1", true),
        (sl2, "alpha^2 + beta^2/2 + gamma^2/3", "alpha^2 + 4*beta*gamma", true),
        (so3_twice, "a^2 + b^2/2 + c*p + q^2/3", "p^2 + q^2 + r^2", true),
        (rates, "x^2/2 + y^2 + z^2/2", "x^2/y", false),
        (so3_and_rates, "a^2 + b^2/2 + c*z + x^2/2 + y^2 + z^2/2", "x^2/y", false),
    ] {
        let casimir = system(algebra.clone(), casimir);
        let system = system(algebra, hamiltonian);
        let start = &[0.4, 0.3, -0.5, 0.2, 0.6, -0.7][..system.algebra().dimension()];
        let scheme = SchemeName::ImplicitMidpoint;
        let method = system.algebra().method(Formulation::Collective, scheme, 0.0);
        assert_eq!(system.descends(&method.unwrap(), start), Ok(descends), "{hamiltonian}");
        let last = end(&system, (Formulation::Collective, scheme), start, (0.1, 20));
        assert!(distance(&last, start) > 0.01, "{hamiltonian} does not move");
        let value = |state: &[f64]| casimir.invariants(state).unwrap()[0];
        let change = (value(&last) - value(start)).abs();
        // 20 steps, each with rounding errors of some dozen operations on numbers below 1.
        let round_off = 20.0 * 32.0 * f64::EPSILON;
        assert!(if descends { change < round_off } else { change > 1e-6 }, "{change:e}");
    }
}

#[test]
fn a_method_says_what_it_is_and_which_formulation_suits() {
    let named = |name| SystemAlgebra::named(name).unwrap();
    let method = named("so(3)").method(Formulation::Reduced, SchemeName::Gauss(3), 1e-9);
    let method = method.unwrap();
    let parts = (method.formulation(), method.scheme(), method.tolerance());
    assert_eq!(parts, (Formulation::Reduced, SchemeName::Gauss(3), 1e-9));
    for (name, formulation) in [
        ("so(3)", Formulation::Collective),
        ("su(2)", Formulation::Collective),
        ("se(3)", Formulation::Collective),
        ("sl(2)", Formulation::Direct),
    ] {
        assert_eq!(named(name).default_formulation(), formulation, "{name}");
    }
}

/// A Hamiltonian that a program builds is that of the text, and the Casimirs stay with another Hamiltonian.
#[test]
fn systems_from_expressions_and_with_another_hamiltonian() {
    let so3 = || SystemAlgebra::named("so(3)").unwrap();
    let mut parts = Expressions::new();
    let pi = parts.name("Pi");
    let square = parts.dot(pi, pi);
    let none = Parameters::new();
    let built = FormulaSystem::of_expressions(so3(), &parts, square, &none).unwrap();
    let written = FormulaSystem::new(so3(), "Pi·Pi", &none).unwrap();
    let state = [1.0, -2.0, 0.5];
    assert_eq!(built.invariants(&state), written.invariants(&state));
    assert_eq!(built.rate(&state), written.rate(&state));
    let body = written.with_found_casimirs().unwrap();
    let other = body.with_hamiltonian("Pi1^2", &none).unwrap();
    assert_eq!(other.invariants(&state).unwrap(), [1.0, 5.25]);
    assert_eq!((other.casimirs(), other.missing_casimirs()), (body.casimirs(), Some(0)));
    // Negative control: the Hamiltonian is the other one, and one in other names is refused.
    assert_ne!(other.rate(&state), body.rate(&state));
    assert!(body.with_hamiltonian("Gamma1", &none).is_err());
    let gamma = parts.name("Gamma");
    assert!(FormulaSystem::of_expressions(so3(), &parts, gamma, &none).is_err());
}
