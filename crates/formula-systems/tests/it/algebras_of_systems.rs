//! Algebras by name and by brackets, their states, and what is refused.

use lie_poisson_formula_systems::{
    FormulaSystem, FormulaSystemError, SystemAlgebra, structure_table,
};
use lie_poisson_formulas::{Coordinates, EntryError, Parameters, StructureEntry};

/// Returns coordinates that are numbers.
fn scalars(names: &[&str]) -> Coordinates {
    Coordinates::scalars(names.iter().copied()).unwrap()
}

#[test]
fn brackets_with_parameters_are_structure_constants() {
    let parameters = Parameters::new().number("c", 3.0).unwrap();
    let brackets = [("x, y", "c*z"), ("y, z", "x - x + x")];
    let algebra =
        SystemAlgebra::of_brackets(scalars(&["x", "y", "z"]), brackets, &parameters).unwrap();
    let expected = [
        StructureEntry { i: 0, j: 1, k: 2, value: 3.0 },
        StructureEntry { i: 1, j: 2, k: 0, value: 1.0 },
    ];
    assert_eq!(algebra.entries(), expected);
    let same = SystemAlgebra::of_entries(scalars(&["x", "y", "z"]), expected.to_vec()).unwrap();
    assert_eq!(algebra, same);
}

/// dΠ/dt = Π×Ω with Ω = (Π₁, Π₂/2, Π₃/4) = (1, −1, 1).
#[test]
fn rates_are_those_of_euler() {
    let (text, so3) = ("(Pi1^2 + Pi2^2/2 + Pi3^2/4)/2", SystemAlgebra::named("so(3)").unwrap());
    let body = FormulaSystem::new(so3, text, &Parameters::new()).unwrap();
    assert_eq!(body.rate(&[1.0, -2.0, 4.0]).unwrap(), [2.0, 3.0, 1.0]);
    assert!(body.rate(&[1.0, 2.0]).is_err());
}

#[test]
fn what_is_no_algebra_is_refused() {
    let refused = |names: &[&str], brackets: &[(&str, &str)]| {
        let brackets = brackets.iter().copied();
        SystemAlgebra::of_brackets(scalars(names), brackets, &Parameters::new()).unwrap_err()
    };
    type E = FormulaSystemError;
    assert_eq!(refused(&[], &[]), E::Dimension { count: 0, most: 256 });
    assert_eq!(refused(&["x", "y"], &[("x", "y")]), E::NoPair { key: "x".into() });
    assert!(matches!(refused(&["x", "y"], &[("x, y", "z")]), E::Bracket { .. }));
    for text in
        ["x*y", "|x|", "x + 1", "if(x >= 5, x, 2*x)", "if(x > -1, y, 2*y)", "if(x >= 0, 0, 1)"]
    {
        assert_eq!(refused(&["x", "y"], &[("x, y", text)]), E::NotLinear { key: "x, y".into() });
    }
    let jacobi = refused(&["K", "H", "P"], &[("K, H", "P"), ("K, P", "H"), ("H, P", "H")]);
    let [k, h, p] = ["K", "H", "P"].map(String::from);
    // [K, [H, P]] + [H, [P, K]] + [P, [K, H]] = [K, H] − [H, H] + [P, P] = P, one of three terms
    assert!(
        matches!(jacobi, E::Jacobi { names, residual, .. } if names == [k, h, p] && residual > 0.1)
    );
    let twice = refused(&["x", "y", "z"], &[("x, y", "z"), ("y, x", "z")]);
    assert!(matches!(twice, E::Brackets(EntryError::Contradiction { entry: 1, earlier: 0 })));
    let entries = vec![StructureEntry { i: 0, j: 3, k: 0, value: 1.0 }];
    let large = SystemAlgebra::of_entries(scalars(&["x", "y", "z"]), entries).unwrap_err();
    assert!(matches!(large, E::Structure(EntryError::IndexTooLarge { index: 3, .. })));
}

#[test]
fn a_state_has_every_coordinate_once() {
    let se3 = SystemAlgebra::named("se(3)").unwrap();
    let refused = |values: &[(&str, &[f64])]| se3.state(values.iter().copied()).unwrap_err();
    let all: [(&str, &[f64]); 2] = [("Pi", &[1.0; 3]), ("Gamma", &[0.0, 0.0, 1.0])];
    assert_eq!(se3.state(all).unwrap(), [1.0, 1.0, 1.0, 0.0, 0.0, 1.0]);
    let message = |values: &[(&str, &[f64])]| refused(values).to_string();
    assert_eq!(message(&all[..1]), "initial has no value for Gamma1, Gamma2, Gamma3");
    assert!(message(&[("P", &[1.0])]).starts_with("initial.P is not a coordinate; there are Pi1"));
    assert_eq!(message(&[("Pi", &[1.0])]), "initial.Pi needs an array of 3 numbers");
    assert_eq!(message(&[("Pi1", &[1.0, 2.0])]), "initial.Pi1 needs one number");
    assert_eq!(message(&[("Pi1", &[f64::NAN])]), "initial.Pi1 needs finite numbers");
}

#[test]
fn invariants_need_as_many_numbers_as_there_are_dimensions() {
    let so3 = SystemAlgebra::named("so(3)").unwrap();
    let body = FormulaSystem::new(so3, "Pi1^2", &Parameters::new()).unwrap();
    assert_eq!((body.casimirs().len(), body.missing_casimirs()), (0, None));
    assert_eq!(body.invariants(&[3.0, 0.0, 0.0]), Ok(vec![9.0]));
    let error = body.invariants(&[3.0, 0.0]).unwrap_err();
    assert_eq!(error, FormulaSystemError::StateLength { expected: 3, found: 2 });
}

#[test]
fn a_table_of_structure_constants_has_a_line_for_each() {
    let so3 = "i, j, k, value\n1,2,3, 1 # [e1, e2] = e3\n\n2,3,1, 1.0\n3,1,2, 1e0\n";
    let entries = structure_table(so3).unwrap();
    let algebra = SystemAlgebra::of_entries(scalars(&["x", "y", "z"]), entries).unwrap();
    assert_eq!(algebra.entries(), SystemAlgebra::named("so(3)").unwrap().entries());
    let refused = |text: &str| structure_table(text).unwrap_err().to_string();
    for (text, message) in [
        ("1, 2, 3", "line 1 has 3 fields; it needs four: i, j, k, value"),
        ("\n1, 2, 3, 1, 5", "line 2 has 5 fields; it needs four: i, j, k, value"),
        (
            "1, 2\u{200b}, 3, 1",
            "line 1: the index `2<U+200B zero width space>` is not a whole number from 1 to 256",
        ),
        ("1, 2.5, 3, 1", "line 1: the index `2.5` is not a whole number from 1 to 256"),
        ("1, -2, 3, 1", "line 1: the index `-2` is not a whole number from 1 to 256"),
        ("1, 2, 257, 1", "line 1: the index `257` is not a whole number from 1 to 256"),
        ("1, 2, 3, 1\n1, 3, 2, one", "line 2: the value `one` is not a finite number"),
        ("1, 2, 3, nan", "line 1: the value `nan` is not a finite number"),
        ("1, 1, 3, 1", "line 1 says that [e1, e1] is not zero"),
        (
            "1, 2, 3, 1\n\n2, 1, 3, 1",
            "line 3 contradicts line 1, which has the same bracket up to its sign",
        ),
    ] {
        assert_eq!(refused(text), message);
    }
    // [e1, e2] = e3, [e1, e3] = e2, [e2, e3] = e2: [e1, [e2, e3]] = e3 does not cancel, and three constants are summed.
    let message = refused("1, 2, 3, 1\n1, 3, 2, 1\n2, 3, 2, 1");
    assert!(message.starts_with("the Jacobi identity fails for e1, e2, e3 by 3.3"), "{message}");
    // The defect is relative to the constants.
    let small = 0.5_f64.powi(100);
    let scaled = refused(&format!("1, 2, 3, {small:e}\n1, 3, 2, {small:e}\n2, 3, 2, {small:e}"));
    assert_eq!(scaled, message);
}
