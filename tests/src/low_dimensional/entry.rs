//! One algebra of the list.

use lie_poisson::{StructureConstants, StructureError};

/// A Lie algebra by its brackets that are not zero.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// The name in the paper, such as `A5,37`.
    pub name: &'static str,
    /// The brackets (i, j, [(a, k), …]), for [e_i, e_j] = Σ a e_k with i < j, counted from 1 as in the paper.
    pub brackets: &'static [Bracket],
}

/// A bracket (i, j, [(a, k), …]).
type Bracket = (usize, usize, &'static [(f64, usize)]);

/// Returns the algebra of an entry, with all structure constants multiplied by a number.
///
/// # Errors
/// Returns [`StructureError`] if the Jacobi identity fails.
pub fn table<const N: usize>(
    entry: &Entry,
    scale: f64,
) -> Result<StructureConstants<N>, StructureError> {
    let upper = |i: usize, j: usize, k: usize| -> f64 {
        let same = entry.brackets.iter().filter(|bracket| (bracket.0, bracket.1) == (i + 1, j + 1));
        same.flat_map(|bracket| bracket.2).filter(|term| term.1 == k + 1).map(|term| term.0).sum()
    };
    StructureConstants::new(|i, j, k| scale * if i < j { upper(i, j, k) } else { -upper(j, i, k) })
}
