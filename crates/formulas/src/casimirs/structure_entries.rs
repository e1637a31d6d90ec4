//! Structure constants from the non-zero entries of a table: [`structure_constants`].

use super::casimir_error::CasimirError;
use lie_poisson::{
    LieAlgebra, State, StructureConstants, StructureEntry, StructureError, StructureTable, Vector,
};
use std::collections::HashMap;
use thiserror::Error;

/// The error returned for entries that do not form a table of structure constants.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum EntryError {
    /// An index is not smaller than the dimension.
    #[error("entry {entry} has the index {index}; the indices of dimension {dimension} end at {last}", last = .dimension.saturating_sub(1))]
    IndexTooLarge {
        /// The place of the entry in the list, from 0.
        entry: usize,
        /// The index that is too large, from 0.
        index: usize,
        /// The dimension of the algebra.
        dimension: usize,
    },
    /// An entry contradicts an earlier entry for the same bracket and coordinate, or for the opposite bracket.
    #[error("entry {entry} contradicts entry {earlier}, which has the same bracket up to its sign")]
    Contradiction {
        /// The place of the entry in the list, from 0.
        entry: usize,
        /// The place of the earlier entry in the list, from 0.
        earlier: usize,
    },
    /// The bracket of a basis vector with itself is not zero.
    #[error("entry {entry} says that [e{index}, e{index}] is not zero")]
    WithItself {
        /// The place of the entry in the list, from 0.
        entry: usize,
        /// The index of the basis vector.
        index: usize,
    },
    /// The table does not define a Lie algebra.
    #[error(transparent)]
    Structure(#[from] StructureError),
}

/// Creates the algebra of dimension N with the given entries; all other entries are zero.
///
/// The opposite of an entry, with i and j exchanged and the sign changed, need not be in the list.
///
/// # Errors
/// Returns [`EntryError`] if an index is too large, if two entries contradict each other, if some [e_i, e_i] is not
/// zero, or if [`StructureConstants::new`] refuses the table, for example because the Jacobi identity fails.
///
/// # Example
/// ```
/// use lie_poisson::LieAlgebra;
/// use lie_poisson_formulas::{StructureEntry, structure_constants};
/// use nalgebra::Vector3;
/// // Heisenberg: [e₀, e₁] = e₂
/// let heisenberg = structure_constants::<3>(&[StructureEntry { i: 0, j: 1, k: 2, value: 1.0 }])?;
/// assert_eq!(heisenberg.bracket::<f64>(&Vector3::y(), &Vector3::x()), -Vector3::z());
/// # Ok::<(), lie_poisson_formulas::EntryError>(())
/// ```
pub fn structure_constants<const N: usize>(
    entries: &[StructureEntry],
) -> Result<StructureConstants<N>, EntryError> {
    let table = table_of_entries(N, entries)?;
    Ok(StructureConstants::of_table(table).unwrap_or_else(|| unreachable!("it has N dimensions")))
}

/// Creates the algebra with the given entries, of a dimension that is known only when the program runs, as
/// [`structure_constants`] does.
///
/// # Errors
/// Returns the errors of [`structure_constants`].
pub fn table_of_entries(
    dimension: usize,
    entries: &[StructureEntry],
) -> Result<StructureTable, EntryError> {
    let mut first: HashMap<[usize; 3], (usize, f64)> = HashMap::new();
    for (entry, &StructureEntry { i, j, k, value }) in entries.iter().enumerate() {
        if let Some(index) = [i, j, k].into_iter().find(|&index| index >= dimension) {
            return Err(EntryError::IndexTooLarge { entry, index, dimension });
        }
        if i == j && value != 0.0 {
            return Err(EntryError::WithItself { entry, index: i });
        }
        let (key, value) = if i < j { ([i, j, k], value) } else { ([j, i, k], -value) };
        match first.get(&key) {
            Some(&(earlier, before)) if before != value => {
                return Err(EntryError::Contradiction { entry, earlier });
            }
            Some(_) => {}
            None => drop(first.insert(key, (entry, value))),
        }
    }
    let constants = first.into_iter().flat_map(|([i, j, k], (_, value))| {
        [(i, j, value), (j, i, -value)].map(|(i, j, value)| StructureEntry { i, j, k, value })
    });
    Ok(StructureTable::new(dimension, constants)?)
}

/// Returns the structure constants of an algebra that are not zero, those with i > j too.
pub(crate) fn constants<A: LieAlgebra>(algebra: &A) -> Result<Vec<StructureEntry>, CasimirError> {
    let dimension = A::Element::<f64>::DIM;
    let mut all = Vec::new();
    for (i, j) in (0..dimension).flat_map(|i| (0..dimension).map(move |j| (i, j))) {
        let bracket = algebra.bracket::<f64>(&Vector::basis(i), &Vector::basis(j));
        for k in 0..dimension {
            let value = bracket.coordinate(k);
            if !value.is_finite() {
                return Err(CasimirError::NotFinite { i, j });
            }
            if value != 0.0 {
                all.push(StructureEntry { i, j, k, value });
            }
        }
    }
    Ok(all)
}
