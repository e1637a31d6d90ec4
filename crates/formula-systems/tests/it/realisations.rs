//! Realisations of one's own, and Clebsch maps of algebras of any dimension.

use crate::support::{distance, end, system};
use collective_integrators::{AnyState, Integrator, Start};
use heavytop::methods::{Formulation, SchemeName};
use lie_poisson_formula_systems::{FormulaSystem, QuadraticMomenta, SystemAlgebra, Verdict};
use lie_poisson_formulas::{Coordinates, Parameters};
use nalgebra::DMatrix;

fn named(text: &str) -> SystemAlgebra {
    SystemAlgebra::named(text).unwrap()
}

/// Returns the matrices of so(n) on Rⁿ in the order of the coordinates L12, L13, ….
fn rotations(n: usize) -> Vec<DMatrix<f64>> {
    let pairs = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
    let matrix = |(i, j)| {
        let mut matrix = DMatrix::zeros(n, n);
        (matrix[(j, i)], matrix[(i, j)]) = (1.0, -1.0);
        matrix
    };
    pairs.map(matrix).collect()
}

/// Returns the forms S of the quadratic functions q_i q_j, q_i p_j, p_i p_j in the order of sp(2n, R).
fn quadratics(n: usize) -> Vec<DMatrix<f64>> {
    let form = |i: usize, j: usize| {
        let mut form = DMatrix::zeros(2 * n, 2 * n);
        form[(i, j)] += 1.0;
        form[(j, i)] += 1.0;
        form
    };
    let upper =
        |first: usize| (0..n).flat_map(move |i| (i..n).map(move |j| (first + i, first + j)));
    let all = (0..n).flat_map(|i| (0..n).map(move |j| (i, n + j)));
    upper(0).chain(all).chain(upper(n)).map(|(i, j)| form(i, j)).collect()
}

fn verdict(algebra: &SystemAlgebra, momenta: &QuadraticMomenta) -> Verdict {
    momenta.verdict(algebra.table(), algebra.coordinates()).unwrap()
}

#[test]
fn representations_and_quadratic_functions_are_poisson_maps() {
    for n in [4, 5] {
        let algebra = named(&format!("so({n})"));
        let momenta = QuadraticMomenta::of_representation(&rotations(n)).unwrap();
        let found = verdict(&algebra, &momenta);
        assert!(found.is_plus && found.defect < 1e-15 && found.descends(), "{found:?}");
        // One vector and its momentum reach the planes alone.
        assert_eq!(found.rank, 2 * n - 3, "{found:?}");
    }
    for n in [1, 2] {
        let algebra = named(&format!("sp({},R)", 2 * n));
        let found = verdict(&algebra, &QuadraticMomenta::new(quadratics(n)).unwrap());
        assert!(found.is_plus && found.defect < 1e-15 && found.descends(), "{found:?}");
        assert_eq!(found.rank, 2 * n);
    }
}

/// The other sign of the matrices is the other bracket, and a motion goes on as it did.
#[test]
fn both_signs_make_one_motion() {
    let so3 = named("so(3)");
    let hat = |sign: f64| {
        let places = [(1, 2), (2, 0), (0, 1)];
        let matrix = places.map(|(i, j)| {
            let mut matrix = DMatrix::zeros(3, 3);
            (matrix[(j, i)], matrix[(i, j)]) = (sign, -sign);
            matrix
        });
        QuadraticMomenta::of_representation(&matrix).unwrap()
    };
    assert!(verdict(&so3, &hat(1.0)).is_plus && !verdict(&so3, &hat(-1.0)).is_plus);
    let gauss = (Formulation::Collective, SchemeName::Gauss(4));
    let start = [1.0, 2.0, 0.5];
    let run =
        |algebra| end(&system(algebra, "(Pi1^2 + Pi2^2/2 + Pi3^2/4)/2"), gauss, &start, (0.1, 100));
    let hopf = run(so3.clone());
    for sign in [1.0, -1.0] {
        let own = run(so3.clone().with_realisation(hat(sign)).unwrap());
        assert!(distance(&own, &hopf) < 1e-7, "{sign}: {:e}", distance(&own, &hopf));
    }
    // Control: the plus bracket is another motion.
    let other =
        FormulaSystem::new(so3, "(Pi1^2 + Pi2^2/2 + Pi3^2/4)/2", &Parameters::new()).unwrap();
    let other = end(&other.with_plus_bracket().unwrap(), gauss, &start, (0.1, 100));
    assert!(distance(&other, &hopf) > 0.1);
}

/// Along three vectors, and along the Clebsch map, Gauss's methods keep the Casimirs of so(5) to round-off and have their
/// order; the direct method keeps those of degree 2 alone.
#[test]
fn collective_methods_on_so5_keep_the_casimirs() {
    let text = "L12^2/2 + L13^2/3 + L23^2/5 + L14^2/4 + L25*L34/7 + L45^2";
    let start = [0.5, -0.3, 0.2, 0.7, 0.4, 0.1, -0.6, 0.3, 0.2, 0.8];
    let three: Vec<DMatrix<f64>> = rotations(5)
        .iter()
        .map(|rho| {
            let mut sum = DMatrix::zeros(15, 15);
            (0..3).for_each(|i| sum.view_mut((5 * i, 5 * i), (5, 5)).copy_from(rho));
            sum
        })
        .collect();
    let momenta = QuadraticMomenta::of_representation(&three).unwrap();
    assert_eq!(verdict(&named("so(5)"), &momenta).rank, 10);
    let own = named("so(5)").with_realisation(momenta).unwrap();
    assert_eq!(own.default_formulation(), Formulation::Collective);
    // Without momenta of one's own, so(5) by name has those of its matrices, and by its brackets those of a Clebsch map.
    let by_name = named("so(5)");
    let entries = by_name.entries().to_vec();
    let by_brackets = SystemAlgebra::of_entries(by_name.coordinates().clone(), entries).unwrap();
    assert_eq!(by_brackets.default_formulation(), Formulation::Direct);
    for (name, algebra) in [("own", own), ("name", by_name), ("Clebsch", by_brackets)] {
        let body = system(algebra, text);
        assert_eq!(body.casimir_degrees(), [2, 4]);
        let before = body.invariants(&start).unwrap();
        let run = |formulation, (step, steps)| {
            let state = end(&body, (formulation, SchemeName::Gauss(2)), &start, (step, steps));
            let after = body.invariants(&state).unwrap();
            let lost = before
                .iter()
                .zip(&after)
                .skip(1)
                .map(|(a, b)| (a - b).abs() / a.abs())
                .collect::<Vec<_>>();
            (state, lost)
        };
        let (coarse, lost) = run(Formulation::Collective, (0.1, 40));
        let (fine, _) = run(Formulation::Collective, (0.05, 80));
        let (finest, _) = run(Formulation::Collective, (0.025, 160));
        let descends = {
            let method =
                body.algebra().method(Formulation::Collective, SchemeName::Gauss(2), 0.0).unwrap();
            body.descends(&method, &start).unwrap()
        };
        if name != "Clebsch" {
            assert!(descends && lost.iter().all(|lost| *lost < 1e-12), "{lost:?}");
        }
        let order = (distance(&coarse, &fine) / distance(&fine, &finest)).log2();
        assert!((order - 4.0).abs() < 0.3, "{name}: {order}");
        let (_, lost) = run(Formulation::Direct, (0.1, 40));
        assert!(lost[0] < 1e-12 && lost[1] > 1e-9, "{lost:?}");
    }
}

#[test]
fn what_is_no_realisation_is_taught() {
    let so3 = named("so(3)");
    let message = |momenta: &QuadraticMomenta| {
        momenta.verdict(so3.table(), so3.coordinates()).unwrap_err().to_string()
    };
    let mut matrices: Vec<DMatrix<f64>> = {
        let places = [(1, 2), (2, 0), (0, 1)];
        places
            .map(|(i, j)| {
                let mut matrix = DMatrix::zeros(3, 3);
                (matrix[(j, i)], matrix[(i, j)]) = (1.0, -1.0);
                matrix
            })
            .into()
    };
    let two = QuadraticMomenta::of_representation(&matrices[..2]).unwrap();
    assert_eq!(message(&two), "realisation: there are 2 matrices for an algebra of dimension 3");
    // Twice the matrices: all brackets are twice too large.
    let double: Vec<_> = matrices.iter().map(|matrix| matrix * 2.0).collect();
    let said = message(&QuadraticMomenta::of_representation(&double).unwrap());
    assert!(
        said.ends_with("2.000000 times what they should be: divide the matrices by 2.000000"),
        "{said}"
    );
    // One of another length.
    matrices[1] *= 3.0;
    let said = message(&QuadraticMomenta::of_representation(&matrices).unwrap());
    assert!(
        said.starts_with("realisation: the momenta are no Poisson map: {Pi")
            && !said.contains("divide"),
        "{said}"
    );
    let refused = |forms: Vec<DMatrix<f64>>| QuadraticMomenta::new(forms).unwrap_err().to_string();
    assert!(refused(vec![]).contains("there is no matrix"));
    assert!(refused(vec![DMatrix::zeros(3, 3)]).contains("an odd number"));
    assert!(refused(vec![DMatrix::zeros(2, 3)]).contains("the shape 2 × 3"));
    assert!(refused(vec![DMatrix::from_element(2, 2, f64::NAN)]).contains("NaN"));
    assert!(
        refused(vec![DMatrix::from_row_slice(2, 2, &[0.0, 1.0, 2.0, 0.0])])
            .contains("not symmetric")
    );
    // One vector does not reach a generic momentum of so(4).
    let own = named("so(4)")
        .with_realisation(QuadraticMomenta::of_representation(&rotations(4)).unwrap())
        .unwrap();
    let body = FormulaSystem::new(own, "L12^2", &Parameters::new()).unwrap();
    let method = body.algebra().method(Formulation::Collective, SchemeName::Gauss(2), 0.0).unwrap();
    let error =
        body.tangent_integrator(&method, &[1.0, 0.2, 0.3, 0.4, 0.5, 2.0]).unwrap_err().to_string();
    assert!(error.contains("not in the image of the realisation"), "{error}");
}

/// Lifts and motions do not depend on the unit of the momenta.
#[test]
fn units_of_momenta_do_not_matter() {
    let momenta = QuadraticMomenta::of_representation(&rotations(4)).unwrap();
    let two: Vec<DMatrix<f64>> = rotations(4)
        .iter()
        .map(|rho| {
            let mut sum = DMatrix::zeros(8, 8);
            (0..2).for_each(|i| sum.view_mut((4 * i, 4 * i), (4, 4)).copy_from(rho));
            sum
        })
        .collect();
    assert_eq!(momenta.size(), 8);
    let own = named("so(4)")
        .with_realisation(QuadraticMomenta::of_representation(&two).unwrap())
        .unwrap();
    let run = |unit: f64| {
        let text = format!("(L12^2/2 + L13^2/3 + L24^2 + L14*L23/4)/{unit:e}");
        let body = FormulaSystem::new(own.clone(), &text, &Parameters::new()).unwrap();
        let start = [0.5, -0.3, 0.2, 0.7, 0.4, 0.1].map(|x| x * unit);
        let state = end(&body, (Formulation::Collective, SchemeName::Gauss(3)), &start, (0.1, 20));
        state.iter().map(|x| x / unit).collect::<Vec<_>>()
    };
    let plain = run(1.0);
    for unit in [1e-30, 1e-9, 1e12, 1e30] {
        assert!(distance(&run(unit), &plain) < 1e-12, "{unit:e}");
    }
}

/// Starts with zeros, at which Casimirs have no terms, are followed as by the direct method.
#[test]
fn starts_with_zeros_are_followed() {
    for (text, values) in [
        ("so(4)", &[1.0, 0.5, 0.0, 1.0, 0.0, 0.0][..]),
        ("so(4)", &[0.0, 1.0, 0.0, 0.0, 0.0, 0.0]),
        ("so(2,2)", &[0.0, 1.0, 0.3, 0.0, 0.0, 0.0]),
        ("gl(2)", &[0.0, 0.0, 0.0, 1.0]),
        ("sl(2)", &[0.0, 0.0, 0.5]),
        ("se(2)", &[1.0, 0.0, 0.0]),
        ("so(3) ⋉ (R3 + R3)", &[1.0, 0.5, 0.2, 0.0, 0.0, 0.0, 0.3, 0.0, 0.4]),
        ("se(3)+R3", &[1.0, 0.5, 0.2, 0.0, 0.0, 0.0, 0.3, 0.0, 0.4]),
        ("so(4)", &[0.0; 6]),
    ] {
        let algebra = named(text);
        let names: Vec<String> = algebra.coordinates().names().collect();
        let squares = names.iter().enumerate().map(|(i, name)| format!("{name}^2/{}", i + 2));
        let body = system(algebra, &squares.collect::<Vec<_>>().join(" + "));
        let run = |formulation| end(&body, (formulation, SchemeName::Gauss(6)), values, (0.1, 20));
        let (collective, direct) = (run(Formulation::Collective), run(Formulation::Direct));
        assert!(
            distance(&collective, &direct) < 1e-10,
            "{text} {values:?}: {collective:?} {direct:?}"
        );
    }
}

/// Along a motion z grows while J(z) keeps its size, unless it is moved back along its fibre: on an algebra whose adjoint
/// representation does not see the centre and whose momenta grow, and on one of eight dimensions.
#[test]
fn points_stay_near_the_origins_of_their_fibres() {
    let nilpotent_and_scaled = {
        let names = Coordinates::scalars(["a", "b", "c", "d", "s"]).unwrap();
        let brackets = [("a, s", "a"), ("b, s", "a + b"), ("c, s", "b + c"), ("d, s", "c + d")];
        SystemAlgebra::of_brackets(names, brackets, &Parameters::new()).unwrap()
    };
    for algebra in [nilpotent_and_scaled, named("sl(3,R)")] {
        let names: Vec<String> = algebra.coordinates().names().collect();
        let squares = names.iter().enumerate().map(|(i, name)| format!("{name}^2/{}", i + 2));
        let body = system(algebra, &squares.collect::<Vec<_>>().join(" + "));
        let start: Vec<f64> = (0..names.len()).map(|i| 0.5 - 0.1 * i as f64).collect();
        let method = body.algebra().method(Formulation::Collective, SchemeName::Gauss(4), 0.0);
        let integrator = body.integrator(&method.unwrap(), &start).unwrap();
        let length = |z: &AnyState| z.as_slice().iter().map(|x| x * x).sum::<f64>().sqrt();
        let growth = |is_pinned: bool| {
            let first = integrator.start(&AnyState::from_slice(&start)).unwrap();
            let mut workspace = Integrator::<f64>::workspace(&integrator);
            if is_pinned {
                Integrator::<f64>::pin(&integrator, &mut workspace);
            }
            let (mut z, mut longest) = (first.clone(), 0.0_f64);
            for _ in 0..500 {
                match integrator.step(&z, 0.1, &mut workspace) {
                    Ok(step) => z = step.point,
                    // J(z) has lost its digits.
                    Err(error) => {
                        assert!(is_pinned, "{names:?}: {error}");
                        break;
                    }
                }
                longest = longest.max(length(&z));
            }
            longest / length(&first)
        };
        let (moved, pinned) = (growth(false), growth(true));
        // A point is moved when it has grown by a half; the shortest one itself varies with the momentum.
        assert!(moved < 4.0 && pinned > 20.0, "{names:?}: {moved} {pinned}");
    }
}

/// β decays as γ grows, by a factor of 10¹⁶⁶ in all: a point that is moved back has the digits of both.
#[test]
fn momenta_that_grow_and_decay_keep_their_digits() {
    let body = system(named("sl(2)"), "alpha^2/2 + 0.3*beta*gamma + 0.1*beta^2");
    let run = |formulation| {
        end(&body, (formulation, SchemeName::Gauss(4)), &[0.3, 0.5, -0.2], (0.25, 1200))
    };
    let (collective, direct) = (run(Formulation::Collective), run(Formulation::Direct));
    assert!(direct[1] < 1e-82 && direct[2] < -1e82, "{direct:?}");
    // Roundings of 1200 steps.
    for (x, y) in collective.iter().zip(&direct) {
        assert!((x / y - 1.0).abs() < 1e-9, "{collective:?} {direct:?}");
    }
}

/// Momenta whose squares underflow or overflow.
#[test]
fn momenta_of_all_sizes_have_lifts() {
    for unit in [1e-200, 1e-170, 1e150] {
        let body = system(named("so(4)"), &format!("(L12^2 + L13^2/2 + L34^2/3)*{:e}", 1.0 / unit));
        let start = [1.0, 2.0, 0.0, 1.0, 0.0, 1.0].map(|x| x * unit);
        let method =
            body.algebra().method(Formulation::Collective, SchemeName::Gauss(2), 0.0).unwrap();
        let integrator = body.tangent_integrator(&method, &start).unwrap();
        let z = integrator.start(&AnyState::from_slice(&start)).unwrap();
        let mu = Integrator::<f64>::momentum(&integrator, &z);
        assert!(distance(mu.as_slice(), &start) < 1e-14 * unit, "{unit:e}: {mu:?}");
    }
}

/// so(3) ⋉ R³ in units in which Γ is 10⁻²⁰ or 10²⁰ times as large: the matrices of the translations scale with it.
#[test]
fn units_of_one_vector_do_not_matter() {
    let affine = |unit: f64| {
        let mut matrices = Vec::new();
        for (i, j) in [(1, 2), (2, 0), (0, 1)] {
            let mut turn = DMatrix::zeros(4, 4);
            (turn[(j, i)], turn[(i, j)]) = (1.0, -1.0);
            matrices.push(turn);
        }
        for i in 0..3 {
            let mut shift = DMatrix::zeros(4, 4);
            shift[(i, 3)] = unit;
            matrices.push(shift);
        }
        let pair = |m: &DMatrix<f64>| {
            let mut twice = DMatrix::zeros(8, 8);
            twice.view_mut((0, 0), (4, 4)).copy_from(m);
            twice.view_mut((4, 4), (4, 4)).copy_from(m);
            twice
        };
        QuadraticMomenta::of_representation(&matrices.iter().map(pair).collect::<Vec<_>>()).unwrap()
    };
    let se3 = named("se(3)");
    let run = |unit: f64| {
        let own = se3.clone().with_realisation(affine(unit)).unwrap();
        let found = own.verdict().unwrap();
        assert!(found.is_plus && found.defect < 1e-15 && found.rank == 6, "{unit:e}: {found:?}");
        let text = format!("(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2 + Gamma1*{:e}", 1.0 / unit);
        let start = [0.5, -0.2, 0.7, 0.6 * unit, 0.0, 0.8 * unit];
        let top = FormulaSystem::new(own, &text, &Parameters::new()).unwrap();
        let mut state =
            end(&top, (Formulation::Collective, SchemeName::Gauss(3)), &start, (0.05, 20));
        state[3..].iter_mut().for_each(|x| *x /= unit);
        state
    };
    let plain = run(1.0);
    for unit in [1e-20, 1e20] {
        assert!(
            distance(&run(unit), &plain) < 1e-9,
            "{unit:e}: {:e}",
            distance(&run(unit), &plain)
        );
    }
    // A wrong bracket of a small vector is not hidden by large ones.
    let mut forms = affine(1e-20);
    assert!(forms.verdict(se3.table(), se3.coordinates()).is_ok());
    let wrong: Vec<DMatrix<f64>> = (0..6)
        .map(|i| {
            let mut matrix = DMatrix::zeros(4, 4);
            match i {
                0..3 => {
                    let (a, b) = [(1, 2), (2, 0), (0, 1)][i];
                    (matrix[(b, a)], matrix[(a, b)]) = (1.0, -1.0);
                }
                _ => matrix[(i - 3, 3)] = if i == 4 { 2e-20 } else { 1e-20 },
            }
            matrix
        })
        .collect();
    forms = QuadraticMomenta::of_representation(&wrong).unwrap();
    assert!(forms.verdict(se3.table(), se3.coordinates()).is_err());
    // Matrices whose products overflow are refused.
    let huge: Vec<_> = rotations(3).iter().map(|matrix| matrix * 1e200).collect();
    let huge = QuadraticMomenta::of_representation(&huge).unwrap();
    let so3 = named("so(3)");
    assert!(huge.verdict(so3.table(), so3.coordinates()).is_err());
}
