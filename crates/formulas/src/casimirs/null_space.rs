//! Elimination of sparse rows modulo a prime: ranks and null spaces.

use super::residue::Residue;
use std::collections::BTreeMap;

/// A row, or a vector: columns with their entries, from left to right.
pub(crate) type Row = Vec<(usize, Residue)>;

/// The rows of an echelon form, by the column of their first entry, which is 1.
fn echelon(rows: Vec<Row>) -> BTreeMap<usize, Row> {
    let mut pivots: BTreeMap<usize, Row> = BTreeMap::new();
    for row in rows {
        let mut left: BTreeMap<usize, Residue> = BTreeMap::new();
        for (column, entry) in row.into_iter().filter(|(_, entry)| !entry.is_zero()) {
            left.insert(column, entry);
        }
        while let Some((&column, &lead)) = left.first_key_value() {
            let Some(pivot) = pivots.get(&column) else {
                let inverse = lead.inverse();
                let row = left.into_iter().map(|(column, entry)| (column, entry * inverse));
                pivots.insert(column, row.collect());
                break;
            };
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
    }
    pivots
}

/// Returns the rank of a matrix.
pub(crate) fn rank(rows: Vec<Row>) -> usize {
    echelon(rows).len()
}

/// Returns a basis of the vectors on which all rows vanish, each with an entry 1 where the others are 0.
pub(crate) fn null_space(rows: Vec<Row>, columns: usize) -> Vec<Row> {
    let pivots = echelon(rows);
    let free = (0..columns).filter(|column| !pivots.contains_key(column));
    free.map(|column| {
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
    })
    .collect()
}
