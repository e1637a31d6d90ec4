//! Casimirs of so(p, q) ⋉ Rⁿ, squares of wedge products: their number and degrees, their brackets, their values, and what a
//! reader sees.

use crate::support::{bracket, named, random, system};
use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
use nalgebra::DMatrix;

/// Returns the Casimirs that are given by wedge products, with their places.
fn wedge_products(system: &FormulaSystem) -> Vec<(String, usize)> {
    let texts = system.casimirs().iter().map(ToString::to_string).enumerate();
    texts.filter(|(_, text)| text.contains('∧')).map(|(place, text)| (text, place)).collect()
}

/// There are ⌊(n + 1)/2⌋, of degree 2 + 2k, and for n = 2m + 1 one of degree m + 1 instead of 2m + 2.
#[test]
fn no_casimir_is_missing() {
    require_degrees(&[
        ("se(3)", &[2, 2]),
        ("se(4)", &[2, 4]),
        ("se(5)", &[2, 3, 4]),
        ("so(3,1) ⋉ R4", &[2, 4]),
    ]);
}

#[test]
#[ignore = "long"]
fn no_casimir_of_large_algebras_is_missing() {
    require_degrees(&[
        ("se(6)", &[2, 4, 6]),
        ("se(7)", &[2, 4, 4, 6]),
        ("se(8)", &[2, 4, 6, 8]),
        ("se(9)", &[2, 4, 5, 6, 8]),
        ("so(4,2) ⋉ R6", &[2, 4, 6]),
        ("so(5,1) ⋉ R6", &[2, 4, 6]),
        ("so(4,3) ⋉ R7", &[2, 4, 4, 6]),
        ("se(6) + so(3)", &[2, 2, 4, 6]),
        ("se(6)^2", &[2, 2, 4, 4, 6, 6]),
        ("so(7) + so(1,5) ⋉ R6", &[2, 2, 4, 4, 6, 6]),
    ]);
}

/// Checks the degrees of the Casimirs, which are all that there are.
fn require_degrees(algebras: &[(&str, &[u8])]) {
    for &(text, degrees) in algebras {
        let system = named(text);
        assert_eq!((system.casimir_degrees(), system.missing_casimirs()), (degrees, Some(0)));
    }
}

#[test]
fn brackets_with_all_coordinates_vanish() {
    require_vanishing_brackets(&[("se(3)", 0), ("se(4)", 0), ("so(3,1) ⋉ R4", 0), ("se(6)", 2)]);
}

#[test]
#[ignore = "long"]
fn brackets_on_large_algebras_vanish() {
    require_vanishing_brackets(&[
        ("se(7)", 3),
        ("se(8)", 3),
        ("so(5,1) ⋉ R6", 2),
        ("so(4,2) ⋉ R6", 2),
        ("so(2,5) ⋉ R7", 3),
        ("so(3) + se(6)", 2),
        ("so(1,5) ⋉ R6 + se(6)", 4),
    ]);
}

/// Checks that all Casimirs commute with all coordinates, and that so many are wedge products.
fn require_vanishing_brackets(algebras: &[(&str, usize)]) {
    for &(text, count) in algebras {
        let system = named(text);
        let plus = system.clone().with_plus_bracket().unwrap().with_found_casimirs().unwrap();
        assert_eq!(plus.casimirs(), system.casimirs(), "{text}");
        assert_eq!(wedge_products(&system).len(), count, "{text}");
        for casimir in system.casimirs() {
            for seed in 1..4 {
                let mu = random(system.algebra().dimension(), seed);
                let mut xi = casimir.differential_at(&mu);
                let size = bracket(&system, &xi, &mu);
                // some hundred roundings
                assert!(size < 1e-13, "{text} {casimir}: {size:e}");
                // Negative control: a slightly changed differential is that of no Casimir.
                xi.iter_mut().step_by(2).for_each(|slope| *slope *= 1.0 + 1e-8);
                assert!(bracket(&system, &xi, &mu) > 1e-10, "{text} {casimir}");
            }
        }
    }
}

/// Returns the permutations of indices with their signs.
fn permutations(of: &[usize]) -> Vec<(Vec<usize>, f64)> {
    if of.is_empty() {
        return vec![(Vec::new(), 1.0)];
    }
    let with_first = |place: usize| {
        let rest = [&of[..place], &of[place + 1..]].concat();
        let sign = if place.is_multiple_of(2) { 1.0 } else { -1.0 };
        let all = permutations(&rest).into_iter();
        all.map(move |(others, other)| ([&[of[place]], &others[..]].concat(), sign * other))
    };
    (0..of.len()).flat_map(with_first).collect()
}

/// Returns the component of Γ ∧ L^∧k at 2k + 1 indices: of L = ½ Σ_ij L_ij eⁱ∧eʲ, the sum over all permutations.
fn component(gamma: &[f64], l: &DMatrix<f64>, indices: &[usize]) -> f64 {
    let term = |(order, sign): (Vec<usize>, f64)| {
        let pairs = order[1..].chunks(2).map(|pair| l[(pair[0], pair[1])] / 2.0);
        sign * gamma[order[0]] * pairs.product::<f64>()
    };
    permutations(indices).into_iter().map(term).sum()
}

#[test]
fn values_are_those_of_antisymmetrised_sums() {
    for (text, n, q) in
        [("se(6)", 6, 0), ("se(7)", 7, 0), ("so(4,2) ⋉ R6", 6, 2), ("so(2,5) ⋉ R7", 7, 5)]
    {
        let system = named(text);
        let mu = random(system.algebra().dimension(), 11);
        let (rotations, gamma) = mu.split_at(n * (n - 1) / 2);
        let mut l = DMatrix::zeros(n, n);
        let pairs = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
        for ((i, j), x) in pairs.zip(rotations) {
            (l[(i, j)], l[(j, i)]) = (*x, -x);
        }
        let square = |k: usize| -> f64 {
            let sets = (0..1_usize << n).filter(|set| set.count_ones() as usize == 2 * k + 1);
            sets.map(|set| {
                let indices: Vec<usize> = (0..n).filter(|i| set >> i & 1 == 1).collect();
                let negative = indices.iter().filter(|i| **i >= n - q).count();
                (-1.0_f64).powi(negative as i32) * component(gamma, &l, &indices).powi(2)
            })
            .sum()
        };
        let all = wedge_products(&system);
        assert_eq!(all.len(), n.div_ceil(2) - 1, "{text}");
        for (name, place) in all {
            let value = system.casimirs()[place].value_at(&mu);
            let expected = match name.as_str() {
                "|Gamma ∧ L|^2" => square(1),
                "|Gamma ∧ L^2|^2" => square(2),
                "Gamma ∧ L^3" => component(gamma, &l, &[0, 1, 2, 3, 4, 5, 6]),
                other => panic!("{text}: {other}"),
            };
            let error = (value / expected - 1.0).abs();
            assert!(error < 1e-12 && expected.abs() > 1e-2, "{text} {name}: {value} {expected}");
        }
    }
}

/// In planes the product is one of numbers: L = 2 e¹∧e² + 3 e³∧e⁴ and Γ = 5 e⁵, whose square is negative in so(4,2).
#[test]
fn products_of_planes_are_those_of_numbers() {
    for (text, sign) in [("se(6)", 1.0), ("so(4,2) ⋉ R6", -1.0)] {
        let system = named(text);
        let planes = [("L12", 2.0), ("L34", 3.0), ("Gamma5", 5.0)];
        let value =
            |name: &str| planes.iter().find(|(own, _)| *own == name).map_or(0.0, |own| own.1);
        let mu: Vec<f64> =
            system.algebra().coordinates().names().map(|name| value(&name)).collect();
        let values: Vec<f64> = wedge_products(&system)
            .iter()
            .map(|(_, place)| system.casimirs()[*place].value_at(&mu))
            .collect();
        // 5² (2² + 3²) and (2·2·3·5)²
        assert_eq!(values, [325.0 * sign, 3600.0 * sign], "{text}");
    }
}

#[test]
fn texts_are_short_and_name_the_vector() {
    let texts = |algebra: SystemAlgebra| -> Vec<String> {
        wedge_products(&system(algebra, "1")).into_iter().map(|(text, _)| text).collect()
    };
    let named = |text: &str| SystemAlgebra::named(text).unwrap();
    assert_eq!(texts(named("se(6) + so(3)")), ["|Gamma ∧ L|^2", "|Gamma ∧ L^2|^2"]);
    assert_eq!(texts(named("se(7)")), ["|Gamma ∧ L|^2", "Gamma ∧ L^3", "|Gamma ∧ L^2|^2"]);
    let twice = ["|Gamma_1 ∧ L|^2", "|Gamma_2 ∧ L|^2", "|Gamma_1 ∧ L^2|^2", "|Gamma_2 ∧ L^2|^2"];
    assert_eq!(texts(named("se(6)^2")), twice);
    let pairs = (1..6).flat_map(|i| (i + 1..7).map(move |j| format!("J{i}{j}")));
    let symbols: Vec<String> = pairs.chain(["P".into()]).collect();
    let symbols: Vec<&str> = symbols.iter().map(String::as_str).collect();
    let renamed = named("se(6)").with_symbols(&symbols).unwrap();
    assert_eq!(texts(renamed), ["|P ∧ J|^2", "|P ∧ J^2|^2"]);
}

/// The matrices of so(6) may come as a representation of one's own; with other matrices or two vectors the Casimirs are
/// others.
#[test]
fn only_one_vector_has_wedge_products() {
    let unit = |row: usize, column: usize| {
        DMatrix::from_fn(6, 6, |r, c| if (r, c) == (row, column) { 1.0 } else { 0.0 })
    };
    let pairs = || (0..6).flat_map(|i| (i + 1..6).map(move |j| (i, j)));
    let own: Vec<DMatrix<f64>> = pairs().map(|(i, j)| unit(j, i) - unit(i, j)).collect();
    let trivial = vec![DMatrix::zeros(1, 1); 15];
    let given = [("V", own), ("W", trivial)];
    let with = |text: &str| {
        let named = given.iter().filter(|(name, _)| text.contains(name));
        let named = named.map(|(name, matrices)| ((*name).to_owned(), matrices.clone()));
        system(SystemAlgebra::named_with(text, &named.collect()).unwrap(), "1")
    };
    let texts: Vec<String> =
        wedge_products(&with("so(6) ⋉ V")).into_iter().map(|(text, _)| text).collect();
    assert_eq!(texts, ["|V ∧ L|^2", "|V ∧ L^2|^2"]);
    for text in ["so(6) ⋉ V^2", "so(6) ⋉ R6 ⋉ R6", "so(6) ⋉ R6^2", "so(6) ⋉ W", "so(6) ⋉ (V + W)"]
    {
        assert!(wedge_products(&with(text)).is_empty(), "{text}");
    }
}
