//! Structure constants from the non-zero entries of a table: [`structure_constants`].

use lie_poisson::{StructureConstants, StructureError};
use thiserror::Error;

/// An entry of a table: the coordinate `value` of [e_i, e_j] at e_k. Indices count from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StructureEntry {
    /// The first index of the bracket.
    pub i: usize,
    /// The second index of the bracket.
    pub j: usize,
    /// The index of the coordinate.
    pub k: usize,
    /// The coordinate of [e_i, e_j] at e_k.
    pub value: f64,
}

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
    let table = dense(N, entries)?;
    let at = |i: usize, j: usize, k: usize| table.get((i * N + j) * N + k).copied();
    Ok(StructureConstants::new(|i, j, k| at(i, j, k).unwrap_or(0.0))?)
}

/// Returns the whole table, with `c[i][j][k]` at (i N + j) N + k. The dimension is no parameter of a type, so that the checks
/// are compiled once.
fn dense(dimension: usize, entries: &[StructureEntry]) -> Result<Vec<f64>, EntryError> {
    for (entry, &StructureEntry { i, j, k, value }) in entries.iter().enumerate() {
        if let Some(index) = [i, j, k].into_iter().find(|&index| index >= dimension) {
            return Err(EntryError::IndexTooLarge { entry, index, dimension });
        }
        if i == j && value != 0.0 {
            return Err(EntryError::WithItself { entry, index: i });
        }
        let contradicts = |other: &&StructureEntry| {
            other.k == k
                && ((other.i, other.j) == (i, j) && other.value != value
                    || (other.j, other.i) == (i, j) && other.value != -value)
        };
        let before = entries.get(..entry).unwrap_or_default();
        if let Some(earlier) = before.iter().position(|other| contradicts(&other)) {
            return Err(EntryError::Contradiction { entry, earlier });
        }
    }
    let mut table = vec![0.0; dimension.pow(3)];
    for &StructureEntry { i, j, k, value } in entries {
        for (i, j, value) in [(i, j, value), (j, i, -value)] {
            if let Some(constant) = table.get_mut((i * dimension + j) * dimension + k) {
                *constant = value;
            }
        }
    }
    Ok(table)
}
