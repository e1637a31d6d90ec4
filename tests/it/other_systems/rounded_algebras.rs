//! The Casimirs of all small algebras whose structure constants are rounded, scaled, or in another basis.

use lie_poisson::{StructureConstants, StructureError};
use lie_poisson_formulas::{NamedAlgebra, PolynomialCasimirs, find_casimirs};
use nalgebra::SMatrix;
use std::collections::BTreeMap;
use workspace_tests::low_dimensional::{Check, Entry, every_algebra, table};

/// Returns numbers in (−1, 1) that behave like random ones.
fn noise(seed: usize) -> impl FnMut() -> f64 {
    let mut state = 16_807.0 * (seed as f64 + 1.0);
    move || {
        state = (state * 16_807.0) % 2_147_483_647.0;
        2.0 * state / 2_147_483_647.0 - 1.0
    }
}

/// Returns the algebra with other constants c_ijk, i < j; the function gets the indices and the constant.
fn changed<const N: usize>(
    algebra: &StructureConstants<N>,
    mut change: impl FnMut(usize, usize, usize, f64) -> f64,
) -> Result<StructureConstants<N>, StructureError> {
    let mut upper = BTreeMap::new();
    for (i, j, k) in triples::<N>().filter(|(i, j, _)| i < j) {
        upper.insert((i, j, k), change(i, j, k, algebra.constant(i, j, k)));
    }
    let at = |i, j, k| upper.get(&(i, j, k)).copied().unwrap_or(0.0);
    StructureConstants::new(|i, j, k| if i < j { at(i, j, k) } else { -at(j, i, k) })
}

fn triples<const N: usize>() -> impl Iterator<Item = (usize, usize, usize)> {
    (0..N * N * N).map(|n| (n / (N * N), n / N % N, n % N))
}

/// Returns the algebra in units of its basis vectors.
fn in_units<const N: usize>(
    algebra: &StructureConstants<N>,
    unit: impl Fn(usize) -> f64,
) -> Result<StructureConstants<N>, StructureError> {
    changed(algebra, |i, j, k, c| c * unit(i) * unit(j) / unit(k))
}

/// Returns the algebra in a generic basis, with the rounding errors of the change.
fn in_generic_basis<const N: usize>(
    algebra: &StructureConstants<N>,
    seed: usize,
) -> Result<StructureConstants<N>, StructureError> {
    let mut next = noise(seed);
    let basis = SMatrix::<f64, N, N>::identity() + SMatrix::from_fn(|_, _| 0.5 * next());
    let inverse = basis.try_inverse().unwrap();
    changed(algebra, |i, j, k, _| {
        let terms = triples::<N>().map(|(a, b, d)| {
            basis[(a, i)] * basis[(b, j)] * algebra.constant(a, b, d) * inverse[(k, d)]
        });
        terms.sum()
    })
}

/// What does not depend on the basis: the number of Casimirs, and the degrees of those found. Above 4 they are found only where
/// the constants are fractions or roots.
fn kinds(found: &PolynomialCasimirs) -> (usize, Vec<u8>) {
    let low = found.degrees().iter().copied().filter(|degree| *degree <= 4);
    (found.independent(), low.collect())
}

/// The check, with the numbers of rounding errors beside the constants that change the Casimirs, and that do not.
struct Rounded {
    noisy: [usize; 2],
}

impl Check for Rounded {
    fn check<const N: usize>(&mut self, entry: &Entry) {
        let algebra: StructureConstants<N> = table(entry, 1.0).unwrap();
        let names = algebra.coordinates().unwrap();
        let plain = find_casimirs(&algebra, &names).unwrap();
        assert_eq!(plain.gap(), None, "{} is exact", entry.name);
        let texts = |found: &PolynomialCasimirs| -> Vec<String> {
            found.formulas().iter().map(ToString::to_string).collect()
        };
        let check = |what: &str, changed: StructureConstants<N>| {
            let found = find_casimirs(&changed, &names).unwrap();
            assert_eq!(kinds(&found), kinds(&plain), "{} {what}", entry.name);
            found
        };
        // Roundings of the constants, and of zeros.
        for seed in 0..3 {
            let mut next = noise(seed);
            let rounded = changed(&algebra, |_, _, _, c| c * (1.0 + 2e-16 * next())).unwrap();
            assert_eq!(texts(&check("rounded", rounded)), texts(&plain), "{}", entry.name);
        }
        for place in triples::<N>() {
            let error = |i, j, k| if (i, j, k) == place { 1e-16 } else { 0.0 };
            // The Jacobi identity is not always indifferent to a number beside zeros.
            let Ok(noisy) = changed(&algebra, |i, j, k, c| c + error(i, j, k)) else { continue };
            let found = find_casimirs(&noisy, &names).unwrap();
            // In other units, some algebras with a small number are others. The number makes no orbit smaller.
            let what = format!("{} {place:?}", entry.name);
            assert!(found.formulas().len() <= found.independent(), "{what}");
            assert!(found.independent() <= plain.independent(), "{what}");
            let is_same = texts(&found) == texts(&plain) && kinds(&found) == kinds(&plain);
            self.noisy[usize::from(is_same)] += 1;
        }
        // The unit of all constants, whole, decimal, and neither.
        for scale in [1e9, 1e-9, 1.2345, 299_792_458.0, 0.123_456_789_123, 1e30] {
            let scaled = check("scaled", changed(&algebra, |_, _, _, c| scale * c).unwrap());
            assert_eq!(texts(&scaled), texts(&plain), "{} times {scale:e}", entry.name);
        }
        // Units of their own, which the names of the coordinates have.
        for units in [[1e9, 1.0, 1e-9], [1.2345, 299_792_458.0, 0.1], [0.123_456_789_1, 7.3, 1e4]] {
            let unit = |i: usize| units[i % 3] * (1.0 + (i / 3) as f64);
            check("in units", in_units(&algebra, unit).unwrap());
        }
        // A generic basis, in which no constant is a fraction, alone and in units of its own.
        for seed in 0..2 {
            let generic = in_generic_basis(&algebra, seed).unwrap();
            let found = check("generic", generic.clone());
            let [zero, other] = found.gap().unwrap_or([0.0, 1.0]);
            // Six digits lie between what is zero and what is not; of A4,11 it is 8e-5.
            assert!(zero < 1e-13 && other > 1e-7, "{}: {zero:e} {other:e}", entry.name);
            let in_units = in_units(&generic, |i| [1e9, 1.0, 1e-9][i % 3]).unwrap();
            check("generic, in units", in_units);
        }
    }
}

/// Rounding errors, units and the basis do not matter for the Casimirs of every algebra of the list.
#[test]
#[ignore = "long"]
fn casimirs_survive_roundings_units_and_changes_of_basis() {
    let mut rounded = Rounded { noisy: [0; 2] };
    assert_eq!(every_algebra(&mut rounded), 62);
    let [others, same] = rounded.noisy;
    assert!(same > 10 * others && same > 500, "{others} {same}");
}

/// Negative control: a change that is no rounding is seen. [e₁, e₃] = −2 e₁ and [e₂, e₃] = e₂ has the Casimir
/// x y², which other rates do not have.
#[test]
fn what_is_no_rounding_is_a_difference() {
    let found = |rate: f64| {
        let squeeze = StructureConstants::<3>::new(|i, j, k| match (i, j, k) {
            (0, 2, 0) => -rate,
            (2, 0, 0) => rate,
            (1, 2, 1) => 1.0,
            (2, 1, 1) => -1.0,
            _ => 0.0,
        });
        let squeeze = squeeze.unwrap();
        find_casimirs(&squeeze, &squeeze.coordinates().unwrap()).unwrap()
    };
    for (rate, expected) in
        [(2.0, 1), (2.0 + 1e-15, 1), (2.0 + 1e-9, 0), (2.0 + 1e-7, 0), (2.55, 0)]
    {
        let casimirs = found(rate);
        assert_eq!((casimirs.formulas().len(), casimirs.independent()), (expected, 1), "{rate}");
    }
}
