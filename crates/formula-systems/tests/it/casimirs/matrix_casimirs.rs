//! Casimirs of algebras of matrices: their values, their brackets, and what a reader sees. Their degrees are among those of
//! all expressions.

use crate::support::{bracket, named, random, system};
use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
use nalgebra::{Complex, DMatrix, DVector};

/// Returns the Casimirs that are given by matrices, with their degrees.
fn by_matrices(system: &FormulaSystem) -> impl Iterator<Item = (String, u8, usize)> {
    let texts = system.casimirs().iter().map(ToString::to_string).zip(system.casimir_degrees());
    let all = texts.enumerate().map(|(place, (text, degree))| (text, *degree, place));
    all.filter(|(text, ..)| text.starts_with("tr") || text.starts_with("Pf"))
}

#[test]
fn brackets_with_all_coordinates_vanish() {
    require_vanishing_brackets(&[("so(7)", 2), ("su(5)", 2)]);
}

#[test]
#[ignore = "long"]
fn brackets_on_large_algebras_vanish() {
    require_vanishing_brackets(&[
        ("so(8)", 3),
        ("so(3,7)", 4),
        ("so(1,7)", 3),
        ("su(6)", 4),
        ("sl(5,R)", 2),
        ("gl(6)", 4),
        ("sp(8,R)", 3),
        ("so(3) + su(5)^2 + R2", 4),
    ]);
}

/// Checks that the Casimirs by matrices, of which there are so many, commute with all coordinates.
fn require_vanishing_brackets(algebras: &[(&str, usize)]) {
    for &(text, count) in algebras {
        let system = named(text);
        let plus = system.clone().with_plus_bracket().unwrap().with_found_casimirs().unwrap();
        assert_eq!(plus.casimirs(), system.casimirs(), "{text}");
        assert_eq!(by_matrices(&system).count(), count, "{text}");
        for (name, _, place) in by_matrices(&system) {
            for seed in 1..4 {
                let mu = random(system.algebra().dimension(), seed);
                let mut xi = system.casimirs()[place].differential_at(&mu);
                let size = bracket(&system, &xi, &mu);
                // some hundred roundings
                assert!(size < 1e-13, "{text} {name}: {size:e}");
                // Negative control: a slightly changed differential is that of no Casimir.
                xi.iter_mut().step_by(2).for_each(|slope| *slope *= 1.0 + 1e-8);
                assert!(bracket(&system, &xi, &mu) > 1e-10, "{text} {name}");
            }
        }
    }
}

/// Returns the matrix with some entries.
fn matrix(size: usize, entries: &[(usize, usize, f64)]) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(size, size);
    entries.iter().for_each(|(row, column, x)| matrix[(*row, *column)] += x);
    matrix
}

/// Returns the pairs of indices for which a condition holds.
fn pairs(n: usize, holds: fn(usize, usize) -> bool) -> Vec<(usize, usize)> {
    (0..n).flat_map(|i| (0..n).map(move |j| (i, j))).filter(|(i, j)| holds(*i, *j)).collect()
}

fn rotations(p: usize, q: usize) -> Vec<DMatrix<f64>> {
    let sign = |i: usize| if i < p { 1.0 } else { -1.0 };
    let pairs = pairs(p + q, |i, j| i < j).into_iter();
    pairs.map(|(i, j)| matrix(p + q, &[(j, i, sign(i)), (i, j, -sign(j))])).collect()
}

fn all_matrices(n: usize) -> Vec<DMatrix<f64>> {
    pairs(n, |_, _| true).into_iter().map(|(i, j)| matrix(n, &[(i, j, 1.0)])).collect()
}

fn without_trace(n: usize) -> Vec<DMatrix<f64>> {
    let apart = pairs(n, |i, j| i != j).into_iter().map(|(i, j)| matrix(n, &[(i, j, 1.0)]));
    let diagonal = (1..n).map(|i| matrix(n, &[(i - 1, i - 1, 1.0), (i, i, -1.0)]));
    apart.chain(diagonal).collect()
}

/// The matrices of the Hamiltonian vectors (∂f/∂p, −∂f/∂q) of q_i q_j, q_i p_j and p_i p_j.
fn hamiltonian(n: usize) -> Vec<DMatrix<f64>> {
    let of = |i: usize, j: usize| {
        let hessian = matrix(2 * n, &[(i, j, 1.0), (j, i, 1.0)]);
        let omega = DMatrix::from_fn(2 * n, 2 * n, |r, c| {
            if c == r + n {
                1.0
            } else if r == c + n {
                -1.0
            } else {
                0.0
            }
        });
        omega * hessian
    };
    let upper = pairs(n, |i, j| i <= j);
    let all = pairs(n, |_, _| true);
    let q = upper.iter().map(|(i, j)| of(*i, *j));
    let r = all.iter().map(|(i, j)| of(*i, n + *j));
    q.chain(r).chain(upper.iter().map(|(i, j)| of(n + *i, n + *j))).collect()
}

/// Returns the matrix X in the span of others with tr(X E_a) = μ_a.
fn dual_matrix(basis: &[DMatrix<f64>], mu: &[f64]) -> DMatrix<f64> {
    let form = DMatrix::from_fn(mu.len(), mu.len(), |a, b| (&basis[a] * &basis[b]).trace());
    let weights = form.lu().solve(&DVector::from_column_slice(mu)).unwrap();
    let zero = DMatrix::zeros(basis[0].nrows(), basis[0].ncols());
    basis.iter().zip(weights.iter()).fold(zero, |sum, (of, weight)| sum + of * *weight)
}

#[test]
fn values_are_those_of_powers_of_matrices() {
    require_powers(vec![("so(7)", rotations(7, 0)), ("sp(6,R)", hamiltonian(3))]);
}

#[test]
#[ignore = "long"]
fn values_on_large_algebras_are_those_of_powers_of_matrices() {
    require_powers(vec![
        ("so(4,4)", rotations(4, 4)),
        ("so(3,7)", rotations(3, 7)),
        ("sl(5,R)", without_trace(5)),
        ("gl(6)", all_matrices(6)),
    ]);
}

/// Checks the Casimirs of algebras against powers of their matrices.
fn require_powers(algebras: Vec<(&str, Vec<DMatrix<f64>>)>) {
    for (text, basis) in algebras {
        let system = named(text);
        let mu = random(system.algebra().dimension(), 7);
        let x = dual_matrix(&basis, &mu);
        for (name, degree, place) in by_matrices(&system) {
            let value = system.casimirs()[place].value_at(&mu);
            let (value, expected) = match name.as_str() {
                // Pf² = det ηX
                "Pf X" if text == "so(3,7)" => (value * value, -x.determinant()),
                "Pf X" => (value * value, x.determinant()),
                _ => (value, x.pow(degree.into()).trace()),
            };
            let size = x.norm().powi(degree.into());
            assert!((value - expected).abs() < 1e-13 * size.max(size * size), "{text} {name}");
            assert!(value.abs() > 1e-6 * size.min(1.0), "{text} {name}: {value:e} {size:e}");
        }
    }
}

/// The sign of a Pfaffian, and its factor: X₁₂ = L₁₂/2.
#[test]
fn the_pfaffian_of_planes_is_a_product() {
    let body = named("so(8)");
    let names: Vec<String> = body.algebra().coordinates().names().collect();
    let planes = [("L12", 2.0), ("L34", 3.0), ("L56", 5.0), ("L78", 7.0)];
    let value = |name: &String| planes.iter().find(|(own, _)| own == name).map_or(0.0, |own| own.1);
    let mu: Vec<f64> = names.iter().map(value).collect();
    let place = by_matrices(&body).find(|(name, ..)| name == "Pf X").unwrap().2;
    assert_eq!(body.casimirs()[place].value_at(&mu), 210.0 / 16.0);
}

/// Of X = (i/2) Σ μ_a λ_a on Cⁿ the real traces are 2 Re tr Xᵏ and −2 Im tr Xᵏ.
#[test]
fn values_of_su_n_are_complex_traces() {
    for n in [5, 6] {
        let system = named(&format!("su({n})"));
        let mu = random(n * n - 1, 3);
        let x = gell_mann(n, &mu).map(|entry| entry * Complex::new(0.0, 0.5));
        for (name, degree, place) in by_matrices(&system) {
            let value = system.casimirs()[place].value_at(&mu);
            let trace = x.pow(degree.into()).trace();
            let expected = if degree % 2 == 0 { 2.0 * trace.re } else { -2.0 * trace.im };
            assert!((value - expected).abs() < 1e-13 * expected.abs().max(1.0), "{name}");
            assert!(value.abs() > 1e-2, "{name}: {value:e}");
        }
    }
}

/// Returns Σ μ_a λ_a.
fn gell_mann(n: usize, mu: &[f64]) -> DMatrix<Complex<f64>> {
    let mut sum = DMatrix::from_element(n, n, Complex::new(0.0, 0.0));
    let mut next = mu.iter().copied();
    let mut next = || next.next().unwrap();
    for k in 1..n {
        for j in 0..k {
            let entry = Complex::new(next(), -next());
            sum[(j, k)] = entry;
            sum[(k, j)] = entry.conj();
        }
        let weight = next() * (2.0 / (k * (k + 1)) as f64).sqrt();
        (0..k).for_each(|j| sum[(j, j)] += weight);
        sum[(k, k)] -= weight * k as f64;
    }
    sum
}

/// Casimirs are homogeneous, also where states are very large or small, and what overflows is named by its short text.
#[test]
#[ignore = "long"]
fn units_do_not_matter() {
    for text in ["so(8)", "su(5)", "sp(8,R)"] {
        let system = named(text);
        let mu = random(system.algebra().dimension(), 5);
        for (name, degree, place) in by_matrices(&system) {
            let casimir = &system.casimirs()[place];
            for unit in [1e-30, 1e30_f64] {
                let scaled: Vec<f64> = mu.iter().map(|x| x * unit).collect();
                let ratio = casimir.value_at(&scaled) / unit.powi(degree.into());
                assert!(
                    (ratio / casimir.value_at(&mu) - 1.0).abs() < 1e-12,
                    "{text} {name} {unit:e}"
                );
            }
        }
    }
    let error = named("so(7)").invariants(&[1e60; 21]).unwrap_err().to_string();
    assert!(
        error.starts_with("tr X^6 has no value at L12 = 1e60")
            && error.ends_with("tr X^6 is infinite"),
        "{error}"
    );
}

#[test]
#[ignore = "long"]
fn texts_are_short_and_name_the_summand() {
    let texts = |algebra: SystemAlgebra| {
        let system = system(algebra, "1");
        by_matrices(&system).map(|(text, ..)| text).collect::<Vec<_>>()
    };
    let named = |text: &str| SystemAlgebra::named(text).unwrap();
    assert_eq!(texts(named("so(8)")), ["tr X^4", "Pf X", "tr X^6"]);
    assert_eq!(texts(named("su(5)")), ["tr X^4", "tr J X^5"]);
    let sum = named("so(7) + su(5)^2");
    let expected = [
        "tr X(L12, …)^4",
        "tr X(mu_1)^4",
        "tr X(mu_2)^4",
        "tr J X(mu_1)^5",
        "tr J X(mu_2)^5",
        "tr X(L12, …)^6",
    ];
    assert_eq!(texts(sum), expected);
    let spins = named("su(5)^2").with_symbols(&["S"]).unwrap();
    assert_eq!(texts(spins)[..2], ["tr X(S_1)^4", "tr X(S_2)^4"]);
}
