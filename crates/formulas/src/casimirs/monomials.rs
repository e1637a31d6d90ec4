//! The monomials of a degree, and the condition that a polynomial of that degree is a Casimir.

use super::bracket_table::{BracketTable, Number};
use std::collections::HashMap;

/// The exponents of a monomial.
pub(crate) type Exponents = Vec<u8>;

/// Returns the number of monomials of a degree, or the largest `usize` if that is too large.
pub(crate) fn count(dimension: usize, degree: u8) -> usize {
    let mut count = 1_usize;
    for step in 0..usize::from(degree) {
        count = match count.checked_mul(dimension + step) {
            Some(product) => product / (step + 1),
            None => return usize::MAX,
        };
    }
    count
}

/// Returns all monomials of a degree. Monomials with high powers of the first coordinates come first.
pub(crate) fn monomials(dimension: usize, degree: u8) -> Vec<Exponents> {
    let mut all = vec![Vec::new()];
    for coordinate in 0..dimension {
        let last = coordinate + 1 == dimension;
        all = all
            .into_iter()
            .flat_map(|monomial: Exponents| {
                let left = degree - monomial.iter().sum::<u8>();
                let exponents = if last { left..=left } else { 0..=left };
                exponents.rev().map(move |exponent| {
                    let mut extended = monomial.clone();
                    extended.push(exponent);
                    extended
                })
            })
            .collect();
    }
    all
}

/// Returns the equations Σ a_m {x_i, m} = 0 for the coefficients a_m of a Casimir, for each generator x_i.
///
/// The bracket with x_i is a derivation: {x_i, m} = Σ_j ∂m/∂x_j Σ_k c[i][j][k] x_k.
pub(crate) fn equations<T: Number>(
    table: &BracketTable<T>,
    generators: impl IntoIterator<Item = usize>,
    monomials: &[Exponents],
) -> Vec<Vec<(usize, T)>> {
    let mut rows: HashMap<(usize, Exponents), Vec<(usize, T)>> = HashMap::new();
    for i in generators {
        for (column, monomial) in monomials.iter().enumerate() {
            let factors = monomial.iter().enumerate().filter(|(_, exponent)| **exponent > 0);
            for (j, &exponent) in factors {
                for &(k, constant) in table.bracket(i, j) {
                    let mut moved = monomial.clone();
                    for (place, change) in [(j, u8::MAX), (k, 1)] {
                        if let Some(exponent) = moved.get_mut(place) {
                            *exponent = exponent.wrapping_add(change);
                        }
                    }
                    let row = rows.entry((i, moved)).or_default();
                    let term = constant * T::whole(exponent);
                    match row.last_mut() {
                        Some((last, sum)) if *last == column => *sum = *sum + term,
                        _ => row.push((column, term)),
                    }
                }
            }
        }
    }
    // The order decides how numbers are rounded, and must be the same in every run.
    let mut rows: Vec<_> = rows.into_iter().collect();
    rows.sort_by(|(one, first), (other, second)| {
        let key = |row: &[(usize, T)]| (row.len(), row.first().map(|entry| entry.0));
        key(first).cmp(&key(second)).then_with(|| one.cmp(other))
    });
    rows.into_iter().map(|(_, row)| row).collect()
}

#[cfg(test)]
mod tests {
    use super::{count, monomials};

    #[test]
    fn monomials_are_as_many_as_are_counted() {
        for (dimension, degree) in [(1, 0), (1, 7), (2, 5), (3, 1), (3, 4), (6, 3), (10, 2)] {
            let all = monomials(dimension, degree);
            assert_eq!(all.len(), count(dimension, degree), "{dimension} {degree}");
            assert!(all.iter().all(|exponents| exponents.iter().sum::<u8>() == degree));
        }
        assert_eq!(count(6, 3), 56);
        assert_eq!(count(usize::MAX / 2, 3), usize::MAX);
    }
}
