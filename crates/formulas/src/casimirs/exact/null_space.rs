//! Elimination of sparse rows modulo a prime: ranks and null spaces.

use super::residue::Residue;
use std::collections::BTreeMap;

/// A row, or a vector: columns with their entries, from left to right.
pub(crate) type Row = Vec<(usize, Residue)>;

/// Rows of an echelon form, by the column of their first entry, which is 1.
#[derive(Clone, Debug, Default)]
pub(crate) struct Echelon {
    pivots: BTreeMap<usize, Row>,
    /// The number of entries that were changed to make it.
    changes: usize,
}

impl Echelon {
    /// Adds a row unless it is a combination of the others. Returns whether it was added.
    pub(crate) fn add(&mut self, row: Row) -> bool {
        self.add_within(row, usize::MAX) == Some(true)
    }

    /// Adds a row as [`add`](Self::add) does, or returns `None` after too many changes.
    fn add_within(&mut self, row: Row, most_changes: usize) -> Option<bool> {
        let entries = row.into_iter().filter(|(_, entry)| !entry.is_zero());
        let mut left: BTreeMap<usize, Residue> = entries.collect();
        while let Some((&column, &lead)) = left.first_key_value() {
            let Some(pivot) = self.pivots.get(&column) else {
                let inverse = lead.inverse();
                let row = left.into_iter().map(|(column, entry)| (column, entry * inverse));
                self.pivots.insert(column, row.collect());
                return Some(true);
            };
            self.changes = self.changes.saturating_add(pivot.len());
            if self.changes > most_changes {
                return None;
            }
            for &(column, entry) in pivot {
                let old = left.get(&column).copied().unwrap_or_default();
                let new = old - lead * entry;
                if new.is_zero() {
                    left.remove(&column);
                } else {
                    left.insert(column, new);
                }
            }
        }
        Some(false)
    }
}

/// Returns the rows of an echelon form, by the column of their first entry; `None` after too many changes.
fn echelon(rows: Vec<Row>, most_changes: usize) -> Option<BTreeMap<usize, Row>> {
    let mut echelon = Echelon::default();
    for row in rows {
        echelon.add_within(row, most_changes)?;
    }
    Some(echelon.pivots)
}

/// Returns the rank of a matrix.
pub(crate) fn rank(rows: Vec<Row>) -> usize {
    echelon(rows, usize::MAX).map_or(0, |pivots| pivots.len())
}

/// Returns a basis of the vectors on which all rows vanish. Each basis vector has an entry 1 where the others are 0.
/// Returns `None` if the elimination needs more changes of entries.
pub(crate) fn null_space(rows: Vec<Row>, columns: usize, most_changes: usize) -> Option<Vec<Row>> {
    let pivots = echelon(rows, most_changes)?;
    let free = (0..columns).filter(|column| !pivots.contains_key(column));
    let basis = free.map(|column| {
        let mut vector = BTreeMap::from([(column, Residue::ONE)]);
        for (&pivot, row) in pivots.range(..column).rev() {
            let sum = row.iter().skip(1).fold(Residue::ZERO, |sum, (column, entry)| {
                vector.get(column).map_or(sum, |&value| sum + value * *entry)
            });
            if !sum.is_zero() {
                vector.insert(pivot, -sum);
            }
        }
        vector.into_iter().collect()
    });
    Some(basis.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns a matrix from its rows of whole numbers.
    fn matrix(rows: &[&[i64]]) -> Vec<Row> {
        let row = |row: &&[i64]| row.iter().map(|&n| Residue::new(n)).enumerate().collect();
        rows.iter().map(row).collect()
    }

    #[test]
    fn null_vectors_are_orthogonal_to_all_rows() {
        let rows = matrix(&[&[1, 2, 3, 4], &[2, 4, 6, 9], &[3, 6, 9, 13]]);
        assert_eq!(rank(rows.clone()), 2);
        let basis = null_space(rows.clone(), 4, 100).unwrap_or_default();
        assert_eq!(basis.len(), 2);
        for vector in &basis {
            for row in &rows {
                let products = vector.iter().map(|&(column, entry)| entry * row[column].1);
                assert!(products.fold(Residue::ZERO, |sum, product| sum + product).is_zero());
            }
        }
    }

    #[test]
    fn an_elimination_that_takes_too_long_is_given_up() {
        let rows = matrix(&[&[1, 2, 3], &[1, 3, 5], &[1, 4, 8]]);
        assert!(echelon(rows.clone(), 7).is_none());
        assert_eq!(echelon(rows, 100).map(|pivots| pivots.len()), Some(3));
    }
}
