//! The schemes by name have their orders, and the coadjoint Clebsch map serves where the adjoint one has no lift.

use crate::support::{distance, end, system};
use heavytop::methods::{ComposedScheme, Formulation, Scheme};
use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra, SystemMethod};
use lie_poisson_formulas::{Coordinates, Expressions, Parameters};

#[test]
fn schemes_have_their_orders() {
    let body = system(SystemAlgebra::named("so(3)").unwrap(), "Pi1^2/2 + Pi2^2/4 + Pi3^2/8");
    let start = [1.0, 0.5, -0.3];
    let run =
        |scheme, step: f64, steps| end(&body, (Formulation::Direct, scheme), &start, (step, steps));
    let exact = run(Scheme::Gauss(6), 0.05, 80);
    for scheme in [
        Scheme::ImplicitMidpoint,
        Scheme::ExplicitMidpoint,
        Scheme::Rk4,
        Scheme::Gauss(2),
        Scheme::Composed(ComposedScheme::Yoshida4),
        Scheme::Composed(ComposedScheme::Suzuki4),
        Scheme::Composed(ComposedScheme::KahanLi6),
    ] {
        // Steps so large that the error of order 6 is above rounding, and so small that the leading term dominates.
        let [coarse, fine] =
            [(0.2, 20), (0.1, 40)].map(|(step, steps)| distance(&run(scheme, step, steps), &exact));
        let found = (coarse / fine).log2();
        assert!((found - f64::from(scheme.order())).abs() < 0.5, "{scheme}: {found}");
    }
    // Negative control: the measured order is not that of any scheme.
    let [coarse, fine] = [(0.2, 20), (0.1, 40)]
        .map(|(step, steps)| distance(&run(Scheme::Rk4, step, steps), &exact));
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
    let gauss = Scheme::Gauss(6);
    for start in [[0.4, 0.3, -0.5, 0.2, 0.6], [0.4, 0.3, 0.0, 0.2, 0.6]] {
        let run = |formulation| end(&system, (formulation, gauss), &start, (0.05, 20));
        let (direct, collective) = (run(Formulation::Direct), run(Formulation::Collective));
        assert!(distance(&direct, &start) > 0.1, "{direct:?}");
        assert!(distance(&direct, &collective) < 1e-12, "{direct:?} {collective:?}");
    }
    let collective = SystemMethod::new(system.algebra(), Formulation::Collective, gauss, 0.0);
    let direct = SystemMethod::new(system.algebra(), Formulation::Direct, gauss, 0.0).unwrap();
    let start = [0.4, 0.3, -0.5, 0.2, 0.6];
    // ad(x₄ + 2 x₅) has the eigenvalues 1 and 2, so that its cube is no multiple of it.
    assert_eq!(collective.unwrap().descends(&system, &start), Ok(false));
    assert_eq!(direct.descends(&system, &start), Ok(true));
}

#[test]
fn a_method_says_what_it_is_and_which_formulation_suits() {
    let named = |name| SystemAlgebra::named(name).unwrap();
    let method = SystemMethod::new(&named("so(3)"), Formulation::Reduced, Scheme::Gauss(3), 1e-9);
    let method = method.unwrap();
    let parts = (method.formulation(), method.scheme(), method.tolerance());
    assert_eq!(parts, (Formulation::Reduced, Scheme::Gauss(3), 1e-9));
    for (name, formulation) in [
        ("so(3)", Formulation::Collective),
        ("su(2)", Formulation::Collective),
        ("se(3)", Formulation::Collective),
        ("sl(2)", Formulation::Direct),
    ] {
        assert_eq!(SystemMethod::default_formulation(&named(name)), formulation, "{name}");
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
