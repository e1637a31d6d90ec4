//! Rounded structure constants as exact numbers: [`recognised`].

use super::residue::Residue;
use super::roots::residue;
use crate::casimirs::bracket_table::BracketTable;
use crate::casimirs::numeric::balance::Scales;
use crate::casimirs::surd::{Surd, rounding};
use lie_poisson::StructureEntry;

/// The rounding error of constants that were computed, relative to the natural size of their place.
const COMPUTED: f64 = 64.0 * f64::EPSILON;

/// Returns the exact table whose rounded constants are these, if there is one that is a Lie algebra.
///
/// Each constant is a fraction times a square root in one common unit: 1, or the largest constant. It differs from the
/// given one by a few roundings of itself, or by those of the larger constants from which it was computed; then numbers
/// that are as small as these roundings are zero. The Jacobi identity, which must hold exactly, tells whether the
/// numbers were recognised rightly. Casimirs do not depend on the unit.
pub(crate) fn recognised(
    dimension: usize,
    constants: &[StructureEntry],
    scales: &Scales,
) -> Option<BracketTable<Residue>> {
    let largest = constants.iter().fold(0.0_f64, |size, constant| size.max(constant.value.abs()));
    let units = [1.0, largest];
    let exact = |scales: Option<&Scales>, unit: f64| {
        let is_rounding =
            |constant: &StructureEntry| scales.is_some_and(|s| s.is_rounding(constant));
        let kept = constants.iter().filter(|constant| !is_rounding(constant));
        let entries = kept.map(|constant| {
            let own = rounding(constant.value);
            let error = scales.map_or(own, |scales| (COMPUTED * scales.natural(constant)).max(own));
            let surd = Surd::recognise(constant.value / unit, error / unit)?;
            Some((constant.i, constant.j, constant.k, residue(surd)))
        });
        let table = BracketTable::new(dimension, entries.collect::<Option<Vec<_>>>()?);
        is_lie_algebra(&table).then_some(table)
    };
    [None, Some(scales)]
        .into_iter()
        .find_map(|scales| units.iter().find_map(|&unit| exact(scales, unit)))
}

/// Returns whether [x, y] = −[y, x] and the Jacobi identity hold.
fn is_lie_algebra(table: &BracketTable<Residue>) -> bool {
    let n = table.dimension();
    let dense = |i: usize, j: usize| table.bracket_with(i, &[(j, Residue::ONE)]);
    let zero = |vectors: [Vec<Residue>; 3]| {
        let [x, y, z] = vectors;
        x.iter().zip(y).zip(z).all(|((&x, y), z)| (x + y + z).is_zero())
    };
    let twice = |i: usize, j: usize, k: usize| table.bracket_with(i, table.bracket(j, k));
    let none = vec![Residue::ZERO; n];
    // Whether [e_i, [e_j, e_k]] has a term. In a large algebra few of these brackets have.
    let has_terms = |i: usize, j: usize, k: usize| {
        table.bracket(j, k).iter().any(|(l, _)| !table.bracket(i, *l).is_empty())
    };
    (0..n).all(|i| {
        (0..=i).all(|j| {
            zero([dense(i, j), dense(j, i), none.clone()])
                && (0..j).all(|k| {
                    let any = has_terms(i, j, k) || has_terms(j, k, i) || has_terms(k, i, j);
                    !any || zero([twice(i, j, k), twice(j, k, i), twice(k, i, j)])
                })
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(constants: &[(usize, usize, usize, f64)]) -> Vec<StructureEntry> {
        let both = constants.iter().flat_map(|&(i, j, k, value)| {
            [StructureEntry { i, j, k, value }, StructureEntry { i: j, j: i, k, value: -value }]
        });
        both.collect()
    }

    fn is_recognised(constants: &[(usize, usize, usize, f64)]) -> bool {
        let constants = table(constants);
        recognised(3, &constants, &Scales::of(3, &constants)).is_some()
    }

    #[test]
    fn constants_are_fractions_in_their_own_unit_or_in_that_of_the_largest() {
        let pi = core::f64::consts::PI;
        for (c, expected) in [
            ([1.0, 1.0, 1.0], true),
            ([pi, -2.0 * pi, pi / 3.0], true),
            ([2.0_f64.sqrt(), 0.5, 1.0], true),
            ([1.2345, 299_792_458.0, 1e-9], true),
            ([1.0 + 1e-15, 1.0, 1.0 / 3.0 - 1e-16], true),
            ([pi, 1.0, 1.0], false),
            ([1.234_567_891_234, 1.0, 1.0], false),
        ] {
            let constants = [(0, 1, 2, c[0]), (1, 2, 0, c[1]), (2, 0, 1, c[2])];
            assert_eq!(is_recognised(&constants), expected, "{c:?}");
        }
        let noisy = [(0, 1, 2, 1.0), (1, 2, 0, 1.0), (2, 0, 1, 1.0), (0, 1, 0, 1e-16)];
        assert!(is_recognised(&noisy));
    }

    /// [e₀, e₁] = a e₁, [e₀, e₂] = b e₂, [e₁, e₂] = e₁ is an algebra for b = 0 only.
    #[test]
    fn what_is_no_lie_algebra_is_not_recognised() {
        let of = |b: f64| is_recognised(&[(0, 1, 1, 1.0), (0, 2, 2, b), (1, 2, 1, 1.0)]);
        assert!(of(1e-16) && !of(1e-5));
    }
}
