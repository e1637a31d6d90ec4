//! Algebras by expression: against those of the library, by the number of their Casimirs, and what is refused.

use crate::support::{distance, end, system};
use heavytop::methods::{Formulation, SchemeName};
use lie_poisson::{
    ProductAlgebra, SU2OnC2, Se2, Se3, SemidirectAlgebra, Sl2, So3, State, Su2, Vector,
};
use lie_poisson_formula_systems::{FormulaSystem, FormulaSystemError, SystemAlgebra};
use lie_poisson_formulas::{NamedAlgebra, Parameters, StructureEntry};
use nalgebra::DMatrix;
use proptest::prelude::*;
use std::collections::BTreeMap;

fn named(text: &str) -> SystemAlgebra {
    SystemAlgebra::named(text).unwrap()
}

/// Checks names and structure constants against an algebra of the library.
fn is<A: NamedAlgebra>(text: &str, algebra: &A) {
    let (found, dimension) = (named(text), A::Element::<f64>::DIM);
    assert_eq!(found.coordinates(), &algebra.coordinates().unwrap(), "{text}");
    let mut entries = Vec::new();
    for (i, j) in (0..dimension).flat_map(|i| (i + 1..dimension).map(move |j| (i, j))) {
        let bracket = algebra.bracket::<f64>(&Vector::basis(i), &Vector::basis(j));
        let constants =
            (0..dimension).map(|k| StructureEntry { i, j, k, value: bracket.coordinate(k) });
        entries.extend(constants.filter(|entry| entry.value != 0.0));
    }
    assert_eq!(found.entries(), entries, "{text}");
}

#[test]
fn algebras_of_the_library_are_those_of_their_expressions() {
    is("so(3)", &So3);
    is("su(2)", &Su2);
    is("sl(2)", &Sl2);
    is("sl(2, R)", &Sl2);
    is("se(2)", &Se2::default());
    is("se(3)", &Se3::default());
    is("so(3) ⋉ R³", &Se3::default());
    is("so(3) |x R^3", &Se3::default());
    is("so(2) semidirect R2", &Se2::default());
    is("su(2) ⋉ C2", &SemidirectAlgebra(SU2OnC2));
    is("so(3) + se(2)", &ProductAlgebra(So3, Se2::default()));
    is("so(3) ⊕ (se(2))", &ProductAlgebra(So3, Se2::default()));
    // The name of the top on a movable base is no sum.
    for text in ["se(3)+R3", " se(3) + R3"] {
        assert_eq!(named(text).coordinates().names().nth(3).as_deref(), Some("P1"));
        assert!(!named(text).entries().iter().all(|entry| entry.k < 6));
    }
}

/// The number of coordinates, and the degrees of the Casimirs, which are known: those of Chevalley for semisimple algebras.
/// Those that are not searched are traces of powers, Pfaffians and squares of wedge products.
#[test]
fn every_form_has_the_casimirs_of_the_field() {
    require_casimirs(&[
        ("so(2)", 1, &[1], 0),
        ("so(4)", 6, &[2, 2], 0),
        ("so(5)", 10, &[2, 4], 0),
        ("so(2,1)", 3, &[2], 0),
        ("so(3,1)", 6, &[2, 2], 0),
        ("so(1,3)", 6, &[2, 2], 0),
        ("se(4)", 10, &[2, 4], 0),
        ("su(3)", 8, &[2, 3], 0),
        ("sl(3,R)", 8, &[2, 3], 0),
        ("gl(2)", 4, &[1, 2], 0),
        ("gl(3,R)", 9, &[1, 2, 3], 0),
        ("gl(4)", 16, &[1, 2, 3, 4], 0),
        ("sp(2,R)", 3, &[2], 0),
        ("sp(4,R)", 10, &[2, 4], 0),
        ("heisenberg(1)", 3, &[1], 0),
        ("heisenberg(3)", 7, &[1], 0),
        ("galilei", 10, &[2, 4], 0),
        ("bargmann", 11, &[1, 2, 4], 0),
        ("poincare(1,1)", 3, &[2], 0),
        ("poincare(1,2)", 6, &[2, 2], 0),
        ("poincare(1,3)", 10, &[2, 4], 0),
        ("R4", 4, &[1, 1, 1, 1], 0),
        ("so(3)^3 + R2", 11, &[1, 1, 2, 2, 2], 0),
    ]);
}

#[test]
#[ignore = "long"]
fn large_algebras_have_the_casimirs_of_the_field() {
    require_casimirs(&[
        ("so(7)", 21, &[2, 4, 6], 0),
        ("so(8)", 28, &[2, 4, 4, 6], 0),
        ("so(9)", 36, &[2, 4, 6, 8], 0),
        ("so(10)", 45, &[2, 4, 5, 6, 8], 0),
        ("so(4,3)", 21, &[2, 4, 6], 0),
        ("so(4,4)", 28, &[2, 4, 4, 6], 0),
        ("so(7,1)", 28, &[2, 4, 4, 6], 0),
        ("so(1,8)", 36, &[2, 4, 6, 8], 0),
        ("su(5)", 24, &[2, 3, 4, 5], 0),
        ("su(6)", 35, &[2, 3, 4, 5, 6], 0),
        ("sl(5,R)", 24, &[2, 3, 4, 5], 0),
        ("sl(6,R)", 35, &[2, 3, 4, 5, 6], 0),
        ("gl(5)", 25, &[1, 2, 3, 4, 5], 0),
        ("gl(6)", 36, &[1, 2, 3, 4, 5, 6], 0),
        ("sp(6,R)", 21, &[2, 4, 6], 0),
        ("sp(8,R)", 36, &[2, 4, 6, 8], 0),
        ("so(7)^2 + R1", 43, &[1, 2, 2, 4, 4, 6, 6], 0),
        ("se(3) + su(5)", 30, &[2, 2, 2, 3, 4, 5], 0),
        ("se(6)", 21, &[2, 4, 6], 0),
        // With two vectors the degrees of the others are not known.
        ("so(6) ⋉ R6^2", 27, &[2, 2, 2], 2),
    ]);
}

/// Checks the dimensions of algebras, the degrees of their Casimirs, and how many of these are missing.
fn require_casimirs(algebras: &[(&str, usize, &[u8], usize)]) {
    for &(text, dimension, degrees, missing) in algebras {
        let system = system(named(text), "1");
        assert_eq!(system.algebra().dimension(), dimension, "{text}");
        assert_eq!(
            (system.casimir_degrees(), system.missing_casimirs()),
            (degrees, Some(missing)),
            "{text}"
        );
    }
}

#[test]
fn names_of_coordinates() {
    let names = |text: &str| named(text).coordinates().names().collect::<Vec<_>>().join(" ");
    assert_eq!(names("so(4)"), "L12 L13 L14 L23 L24 L34");
    assert_eq!(names("sp(2,R)"), "Q11 R11 P11");
    assert_eq!(names("sl(3)"), "M12 M13 M21 M23 M31 M32 H1 H2");
    assert_eq!(names("so(2)^2"), "Pi_1 Pi_2");
    let groups = |text: &str| {
        named(text)
            .coordinates()
            .groups()
            .map(|(name, _)| name.to_owned())
            .collect::<Vec<_>>()
            .join(" ")
    };
    assert_eq!(groups("so(3)^3"), "Pi_1 Pi_2 Pi_3");
    assert_eq!(groups("so(3) ⋉ (R3 + R3)"), "Pi Gamma_1 Gamma_2");
    assert_eq!(groups("so(3) ⋉ R3^2"), "Pi Gamma_1 Gamma_2");
    assert_eq!(groups("bargmann"), "J K P H M");
}

/// so(4) is so(3) + so(3), with the vectors (L23 ± L14, −L13 ± L24, L12 ± L34)/2.
#[test]
fn so4_is_twice_so3() {
    let bivectors = system(named("so(4)"), "L12^2/2 + L34*L14 + L13^2/3 + L24*L23/5");
    let text = "(Pi_1_3 + Pi_2_3)^2/2 + (Pi_1_3 - Pi_2_3)*(Pi_1_1 - Pi_2_1) + (Pi_1_2 + Pi_2_2)^2/3 \
                + (Pi_1_2 - Pi_2_2)*(Pi_1_1 + Pi_2_1)/5";
    let vectors = system(named("so(3)^2"), text);
    let [a, b] = [[0.3, -0.2, 0.7], [0.5, 0.1, -0.4]];
    let l = |a: [f64; 3], b: [f64; 3]| {
        [a[2] + b[2], -(a[1] + b[1]), a[0] - b[0], a[0] + b[0], a[1] - b[1], a[2] - b[2]]
    };
    let gauss = (Formulation::Direct, SchemeName::Gauss(4));
    let of_so4 = end(&bivectors, gauss, &l(a, b), (0.1, 100));
    for formulation in [Formulation::Collective, Formulation::Reduced, Formulation::Direct] {
        let vectors =
            end(&vectors, (formulation, SchemeName::Gauss(4)), &[a, b].concat(), (0.1, 100));
        let (a, b) = ([vectors[0], vectors[1], vectors[2]], [vectors[3], vectors[4], vectors[5]]);
        // Of order 8, with the step 0.1.
        assert!(
            distance(&of_so4, &l(a, b)) < 1e-8,
            "{formulation}: {:e}",
            distance(&of_so4, &l(a, b))
        );
    }
}

/// Sixty-four spins: the collective and the reduced integrator keep every length, and agree; the direct RK4 does not.
#[test]
fn many_spins_keep_their_lengths() {
    let neighbours: Vec<String> = (1..64).map(|i| format!("Pi_{i}·Pi_{}", i + 1)).collect();
    let chain = system(named("so(3)^64"), &format!("-({}) - Pi_5_3", neighbours.join(" + ")));
    assert_eq!((chain.casimirs().len(), chain.missing_casimirs()), (64, Some(0)));
    let start: Vec<f64> = (0..192).map(|i| (f64::from(i) * 1.7).sin()).collect();
    let before = chain.invariants(&start).unwrap();
    let lengths = |formulation, scheme| {
        let state = end(&chain, (formulation, scheme), &start, (0.05, 40));
        let after = chain.invariants(&state).unwrap();
        let worst =
            before.iter().zip(after).skip(1).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        (state, worst)
    };
    let (collective, worst) = lengths(Formulation::Collective, SchemeName::Gauss(2));
    assert!(worst < 1e-13, "{worst:e}");
    let (reduced, worst) = lengths(Formulation::Reduced, SchemeName::Gauss(2));
    assert!(worst < 1e-13, "{worst:e}");
    assert!(distance(&collective, &reduced) < 1e-12, "{:e}", distance(&collective, &reduced));
    let (_, worst) = lengths(Formulation::Direct, SchemeName::Rk4);
    assert!(worst > 1e-8, "{worst:e}");
}

#[test]
fn what_is_no_algebra_says_where() {
    let message = |text: &str| SystemAlgebra::named(text).unwrap_err().to_string();
    let table = [
        ("so(3", "column 5: `)` must stand where the text ends"),
        ("so()", "column 4: a number must stand here"),
        (
            "so(3) ⋉ ",
            "column 9: a space of vectors, such as R3 or C2, must stand where the text ends",
        ),
        ("so(3) ⋉ R4", "column 9: the algebra before it acts on R3, and not on R4"),
        ("so(3) ⋉ (R3 + R2)", "column 15: R2 stands beside R3"),
        (
            "(so(3) + so(3)) ⋉ R3",
            "column 19: the algebra before it acts on no space of its own, and not on R3",
        ),
        ("so(3)^0", "column 7: a number from 1 on must stand here"),
        ("so(3) so(3)", "column 7: the end, `+`, `^` or `⋉` must stand here"),
        ("so(3) - R1", "column 7: `-` is no part of an algebra"),
        ("", "column 1: an algebra, such as so(3), must stand where the text ends"),
    ];
    for (text, expected) in table {
        assert_eq!(message(text), format!("algebra: `{text}`, {expected}"));
    }
    for (text, name) in [
        ("so(x)", "so"),
        ("soo(3)", "soo(3)"),
        ("sp(3,R)", "sp(3,R)"),
        ("galilei(2)", "galilei(2)"),
    ] {
        match SystemAlgebra::named(text) {
            Err(FormulaSystemError::NoAlgebra { name: found, .. }) => assert_eq!(found, name),
            Err(FormulaSystemError::AlgebraText { column: 4, .. }) if text == "so(x)" => {}
            other => panic!("{text}: {other:?}"),
        }
    }
    for text in [
        "so(30)",
        "gl(17)",
        "so(3)^86",
        "R257",
        "so(18446744073709551616)",
        "so(3) |x R3^200000000",
        "so(3) ⋉ (R3^18446744073709551615 + R3)",
        "so(3)^99999999999999999999",
    ] {
        assert!(
            message(text).starts_with("a system has 1 to 256 coordinates, not "),
            "{text}: {}",
            message(text)
        );
    }
}

#[test]
fn parentheses_have_a_bound() {
    let nested = |n: usize| format!("{}so(3){}", "(".repeat(n), ")".repeat(n));
    assert_eq!(named(&nested(60)).dimension(), 3);
    for text in [nested(100_000), format!("so(3) ⋉ {}R3", "(".repeat(100_000))] {
        let error = SystemAlgebra::named(&text).unwrap_err().to_string();
        assert!(error.contains("no more than 64 parentheses inside each other"), "{}", error.len());
    }
}

proptest! {
    /// Any text is an algebra or is refused.
    #[test]
    fn any_text_is_read_or_refused(parts in prop::collection::vec(prop::sample::select(vec![
        "so", "(", ")", "3", "2", ",", "+", "^", "⋉", "|x", "R3", "C2", "su", "galilei", " ", "R", "⁴", "sp", "se", "é", "0",
    ]), 0..12)) {
        if let Ok(algebra) = SystemAlgebra::named(&parts.concat()) {
            prop_assert!((1..=SystemAlgebra::MOST_DIMENSIONS).contains(&algebra.dimension()));
            let free = FormulaSystem::new(algebra, "1", &Parameters::new());
            prop_assert!(free.is_ok());
        }
    }
}

/// A semidirect product with vectors by their matrices is that with R3, and one with tensors has their invariants.
#[test]
fn representations_of_ones_own_make_semidirect_products() {
    let vectors: Vec<DMatrix<f64>> = (0..3)
        .map(|i| {
            DMatrix::from_fn(3, 3, |r, c| match (r, c) {
                _ if r == (i + 2) % 3 && c == (i + 1) % 3 => 1.0,
                _ if r == (i + 1) % 3 && c == (i + 2) % 3 => -1.0,
                _ => 0.0,
            })
        })
        .collect();
    // Symmetric tensors T with the coordinates T11, T22, T33, T23, T31, T12: ξ acts by [ξ, T].
    let places = [(0, 0), (1, 1), (2, 2), (1, 2), (2, 0), (0, 1)];
    let tensor = |k: usize| {
        let (r, c) = places[k];
        let mut t = DMatrix::zeros(3, 3);
        (t[(r, c)], t[(c, r)]) = (1.0, 1.0);
        t
    };
    let action = |xi: &DMatrix<f64>| {
        let columns = (0..6).map(|k| xi * tensor(k) - tensor(k) * xi);
        let columns: Vec<DMatrix<f64>> = columns.collect();
        DMatrix::from_fn(6, 6, |r, k| columns[k][places[r]])
    };
    let tensors: Vec<DMatrix<f64>> = vectors.iter().map(action).collect();
    let given = BTreeMap::from([("V".to_owned(), vectors), ("T".to_owned(), tensors)]);
    // Those that the text names.
    let with = |text: &str| {
        let named = given.clone().into_iter().filter(|(name, _)| text.contains(name.as_str()));
        SystemAlgebra::named_with(text, &named.collect())
    };
    let [own, named] = [with("so(3) ⋉ V").unwrap(), SystemAlgebra::named("so(3) ⋉ R3").unwrap()];
    assert_eq!(own.entries(), named.entries());
    let twice = with("so(3) ⋉ (V^2)").unwrap();
    assert_eq!(twice.entries(), SystemAlgebra::named("so(3) ⋉ R3^2").unwrap().entries());
    // Of nine dimensions, orbits have six: the tensor has three invariants, tr T, tr T² and tr T³.
    let field = FormulaSystem::new(with("so(3) ⋉ T").unwrap(), "Pi1^2 + T1", &Parameters::new());
    let field = field.unwrap().with_found_casimirs().unwrap();
    assert_eq!((field.casimir_degrees(), field.missing_casimirs()), (&[1, 2, 3][..], Some(0)));
    // What is no representation is refused: one of another algebra, and one that is scaled.
    let error = |text: &str| with(text).unwrap_err().to_string();
    assert_eq!(
        error("so(2) ⋉ V"),
        "V is no representation: it has 3 matrices, and the algebra before it 1"
    );
    assert!(
        error("sl(2) ⋉ V").starts_with(
            "V is no representation: the commutator of the matrices of alpha and beta"
        )
    );
    assert!(error("so(3) ⋉ (V + R3)").ends_with("a representation that is given must stand here"));
    assert!(error("so(3) ⋉ (V").contains("column"));
    assert!(error("so(3) ⋉ V^100").contains("1 to 256 coordinates"));
    let unused = SystemAlgebra::named_with("so(3)", &given).unwrap_err().to_string();
    assert_eq!(unused, "T is no representation: the expression of the algebra does not name it");
    let taken = BTreeMap::from([("R3".to_owned(), given["V"].clone())]);
    let taken = SystemAlgebra::named_with("so(3) ⋉ R3", &taken).unwrap_err().to_string();
    assert_eq!(taken, "R3 is no representation: this is the name of a space that there is");
}
