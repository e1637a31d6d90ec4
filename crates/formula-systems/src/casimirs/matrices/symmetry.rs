//! Entries of matrices that determine each other: [`images`].

use super::matrix_algebra::Structure;

/// A row and a column.
pub(crate) type Place = (usize, usize);

/// Returns the places whose entries are ± the entry at a place, with the signs, in every power Xᵏ of matrices with a
/// structure and of `size` rows. The place itself is the first.
///
/// With a form Xᵀ = −ηXη, a symplectic X has Xᵀ = −ΩXΩ⁻¹, and an anti-Hermitian one Xᵀ = −X and XJ = JX, so that
/// (Xᵏ)ᵀ has the sign (−1)ᵏ. For JXᵏ the exponent counts one more.
pub(crate) fn images(
    structure: &Structure,
    size: usize,
    is_odd: bool,
    (row, column): Place,
) -> Vec<(Place, f64)> {
    let sign = if is_odd { -1.0 } else { 1.0 };
    let mut all = vec![((row, column), 1.0)];
    match structure {
        Structure::Real => {}
        Structure::Form(form) => {
            let at = |i: usize| form.get(i).copied().unwrap_or(1.0);
            all.push(((column, row), sign * at(row) * at(column)));
        }
        Structure::Symplectic => {
            let half = size / 2;
            let partner = |i: usize| if i < half { i + half } else { i - half };
            let signs = if (row < half) == (column < half) { sign } else { -sign };
            all.push(((partner(column), partner(row)), signs));
        }
        Structure::Complex => {
            let turn = if row % 2 == column % 2 { 1.0 } else { -1.0 };
            all.push(((column, row), sign));
            all.push(((row ^ 1, column ^ 1), turn));
            all.push(((column ^ 1, row ^ 1), sign * turn));
        }
    }
    all
}
