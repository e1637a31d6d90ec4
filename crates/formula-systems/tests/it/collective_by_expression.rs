//! The algebras by expression that have collective methods: along their own matrices, and along Clebsch maps that see their
//! centre.

use crate::support::{distance, end, system};
use collective_integrators::{AnyState, Integrator, Start};
use heavytop::methods::{Formulation, SchemeName};
use lie_poisson_formula_systems::{FormulaSystem, QuadraticMomenta, SystemAlgebra};
use lie_poisson_formulas::{Coordinates, Parameters, StructureEntry};
use nalgebra::DMatrix;

fn named(text: &str) -> SystemAlgebra {
    SystemAlgebra::named(text).unwrap()
}

/// Which algebras by expression are realised by their own matrices: those that contain the cubes of their matrices.
#[test]
fn algebras_by_expression_have_collective_methods() {
    for (text, collective) in [
        ("so(4)", true),
        ("so(6)", true),
        ("so(2,2)", true),
        ("so(1,3)", true),
        ("sp(4,R)", true),
        ("gl(2)", true),
        ("gl(3)", true),
        ("sl(3,R)", false),
        ("su(3)", false),
        ("se(4)", false),
        ("galilei", false),
        ("so(12)", false),
    ] {
        let algebra = named(text);
        let is_default = algebra.default_formulation() == Formulation::Collective;
        assert_eq!(is_default, collective, "{text}");
        assert_eq!(algebra.verdict().is_some(), collective, "{text}");
        if let Some(verdict) = algebra.verdict() {
            assert_eq!(verdict.rank, algebra.dimension());
            assert!(verdict.is_plus && verdict.descends());
        }
    }
    // A run on each keeps the Casimirs, also those of degree 4.
    for text in ["so(4)", "so(1,3)", "sp(4,R)", "gl(2)"] {
        let algebra = named(text);
        let squares: Vec<String> = algebra
            .coordinates()
            .names()
            .enumerate()
            .map(|(i, name)| format!("{name}^2/{}", i + 2))
            .collect();
        let start: Vec<f64> =
            (0..algebra.dimension()).map(|i| 0.3 * (f64::from(i as u32) * 1.9).cos()).collect();
        let body = system(algebra, &squares.join(" + "));
        let before = body.invariants(&start).unwrap();
        let state = end(&body, (Formulation::Collective, SchemeName::Gauss(4)), &start, (0.1, 50));
        let after = body.invariants(&state).unwrap();
        assert!(distance(&state, &start) > 0.01, "{text} does not move");
        assert!(body.casimirs().len() > 1);
        for (before, after) in before.iter().zip(&after).skip(1) {
            assert!((before - after).abs() < 1e-12, "{text}: {before} {after}");
        }
    }
}

#[test]
fn algebras_have_a_collective_method_if_a_derivation_sees_their_centre() {
    // so(3) + so(3) + R in a basis in which the centre c is no multiple of brackets, and no grading scales it.
    let names = Coordinates::scalars(["x", "y", "z", "u", "v", "w", "c"]).unwrap();
    let skewed = [
        ("x, y", "z + c"),
        ("y, z", "x"),
        ("z, x", "y"),
        ("u, v", "w"),
        ("v, w", "u"),
        ("w, u", "v"),
    ];
    let skewed = SystemAlgebra::of_brackets(names, skewed, &Parameters::new()).unwrap();
    assert!(skewed.formulations().any(|own| own == Formulation::Collective));
    for text in ["R7", "R65", "so(2)^8", "heisenberg(3)", "bargmann", "so(3) + R4"] {
        assert!(named(text).formulations().any(|own| own == Formulation::Collective), "{text}");
    }
    // Momenta that are all zero reach nothing, and end.
    let zero = QuadraticMomenta::new(vec![DMatrix::zeros(2, 2); 2]).unwrap();
    let plane = named("R2").with_realisation(zero).unwrap();
    assert_eq!(plane.verdict().unwrap().rank, 0);
    let body = FormulaSystem::new(plane, "p1^2", &Parameters::new()).unwrap();
    let method = body.algebra().method(Formulation::Collective, SchemeName::Gauss(2), 0.0).unwrap();
    assert!(body.tangent_integrator(&method, &[1.0, 2.0]).is_err());
    assert!(body.tangent_integrator(&method, &[0.0, 0.0]).is_ok());
}

/// Every symmetric form is the momentum of some point, whatever its signature.
#[test]
fn collective_steps_on_symplectic_algebras_start_everywhere() {
    for (name, count) in [("sp(2,R)", 3), ("sp(4,R)", 10)] {
        let algebra = named(name);
        let symbols: Vec<String> = algebra.coordinates().names().collect();
        let system = system(algebra, &format!("{}^2", symbols[0]));
        let method =
            system.algebra().method(Formulation::Collective, SchemeName::Gauss(4), 0.0).unwrap();
        for seed in 0..40 {
            let mu: Vec<f64> =
                (0..count).map(|i| (7.3 * (seed * count + i) as f64 + 1.0).sin()).collect();
            let integrator = system.tangent_integrator(&method, &mu).unwrap();
            let lifted = integrator.start(&AnyState::from_slice(&mu)).unwrap();
            let back = integrator.momentum(&lifted);
            assert!(distance(back.as_slice(), &mu) < 1e-12, "{name} {seed}");
        }
    }
}

/// Algebras with a centre have a Clebsch map of an extension by a scaling: the momenta are reached, the centre with them, the
/// steps have their order, and the linear Casimir of the centre does not move.
#[test]
fn algebras_with_a_centre_have_a_clebsch_map() {
    for (name, hamiltonian) in [
        ("heisenberg(3)", "(q1^2 + p1^2 + q2*p2 + q3^2 + 2*p3^2)/2 + 0.1*q1^2*p2*z"),
        ("heisenberg(4)", "|q|^2/2 + |p|^2/2 + 0.2*q1*p2*z"),
        ("bargmann", "|P|^2/2 + |J|^2/3 + 0.3*K1*P2 + 0.1*K3^2 + 0.2*H*M"),
        ("heisenberg(2) + so(3)", "q1^2 + p2^2 + q2*Pi1 + z*Pi2^2"),
    ] {
        let system = system(named(name), hamiltonian);
        let d = system.algebra().dimension();
        let mu: Vec<f64> = (0..d).map(|i| 0.4 * (2.7 * i as f64 + 0.3).sin() + 0.1).collect();
        let at = |formulation, scheme, (step, steps)| {
            end(&system, (formulation, scheme), &mu, (step, steps))
        };
        let reference = at(Formulation::Direct, SchemeName::Gauss(8), (0.01, 100));
        let collective =
            |step, steps| at(Formulation::Collective, SchemeName::Gauss(4), (step, steps));
        let errors = [(0.1, 10), (0.05, 20)]
            .map(|(step, steps)| distance(&collective(step, steps), &reference));
        assert!(errors[1] < 1e-4, "{name} {errors:?}");
        assert!(errors[0] > 10.0 * errors[1] || errors[0] < 1e-9, "{name} {errors:?}");
        // The motion goes somewhere, and the centre stays.
        assert!(distance(&reference, &mu) > 1e-2, "{name}");
        let names: Vec<String> = system.algebra().coordinates().names().collect();
        let centre = names.iter().position(|own| own == "z" || own == "M").unwrap();
        assert!((collective(0.05, 20)[centre] - mu[centre]).abs() < 1e-12, "{name}");
    }
}

/// Returns an algebra of scalars by its brackets [e_i, e_j] = c e_k, whose indices count from 1.
fn of_brackets(dimension: usize, brackets: &[(usize, usize, usize, f64)]) -> SystemAlgebra {
    let names: Vec<String> = (1..=dimension).map(|i| format!("x{i}")).collect();
    let names = Coordinates::scalars(names.iter().map(String::as_str)).unwrap();
    let entries = brackets.iter().map(|&(i, j, k, value)| StructureEntry {
        i: i - 1,
        j: j - 1,
        k: k - 1,
        value,
    });
    SystemAlgebra::of_entries(names, entries.collect()).unwrap()
}

/// heisenberg(3) in the basis q_1, q_2, q_3, p_1, p_2, p_3 and z + q_1 + p_1 has no scaling of this basis that scales z. Another
/// derivation makes a Clebsch map that sees the centre. On that of the algebra of Dixmier and Lister all derivations are
/// nilpotent.
///
/// Source: J. Dixmier & W. G. Lister, *Derivations of nilpotent Lie algebras*, Proc. Amer. Math. Soc. 8 (1957).
#[test]
fn a_centre_is_seen_by_any_derivation_that_does_not_vanish_there() {
    let pairs = [(1, 4, 1.0), (2, 5, 1.0), (3, 6, 1.0), (1, 7, 1.0), (4, 7, -1.0)];
    let z = [(7, 1.0), (1, -1.0), (4, -1.0)];
    let brackets = pairs.iter().flat_map(|(i, j, c)| z.map(|(k, value)| (*i, *j, k, c * value)));
    let mixed = of_brackets(7, &brackets.collect::<Vec<_>>());
    assert!(mixed.formulations().any(|formulation| formulation == Formulation::Collective));
    let body = FormulaSystem::new(
        mixed,
        "x1^2 + x2^2/2 + x3^2/3 + x4^2 + x5^2/3 + x6^2/2 + x7^2/4",
        &Parameters::new(),
    );
    let (body, start) = (body.unwrap(), [0.3, -0.2, 0.5, 0.4, 0.1, -0.6, 1.9]);
    let ends = [Formulation::Collective, Formulation::Direct]
        .map(|formulation| end(&body, (formulation, SchemeName::Gauss(4)), &start, (0.05, 20)));
    // two methods of order 8, whose errors are round-off in such steps
    assert!(distance(&ends[0], &ends[1]) < 1e-11 && distance(&ends[0], &start) > 0.1, "{ends:?}");
    let dixmier_lister = of_brackets(
        8,
        &[
            (1, 2, 5, 1.0),
            (1, 3, 6, 1.0),
            (1, 4, 7, 1.0),
            (1, 5, 8, -1.0),
            (2, 3, 8, 1.0),
            (2, 4, 6, 1.0),
            (2, 6, 7, -1.0),
            (3, 4, 5, -1.0),
            (3, 5, 7, -1.0),
            (4, 6, 8, -1.0),
        ],
    );
    assert!(
        !dixmier_lister.formulations().any(|formulation| formulation == Formulation::Collective)
    );
    let error = dixmier_lister.method(Formulation::Collective, SchemeName::Gauss(2), 0.0);
    let error = error.unwrap_err().to_string();
    assert!(error.contains("it has direct: no derivation"), "{error}");
}
