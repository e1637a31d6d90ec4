//! Derivations of a Lie algebra: those that scale the basis vectors, [`grading`], and all, [`derivation`].

use super::generic_point::generic;
use lie_poisson::StructureTable;
use nalgebra::{DMatrix, DVector};

/// The singular value, relative to the largest, below which a direction obeys the equations. They have small whole numbers.
const ZERO: f64 = 1e-9;

/// Returns weights w of the basis vectors with w_i + w_j = w_k wherever [e_i, e_j] has a part along e_k, generic ones among all
/// that there are: D = diag(w) is a derivation. They are zero if there are no others.
pub(super) fn grading(algebra: &StructureTable) -> DVector<f64> {
    let d = algebra.dimension();
    let upper: Vec<_> = algebra.entries().iter().filter(|entry| entry.i < entry.j).collect();
    // Rows of zeros make the matrix as high as wide, so that all directions are found.
    let mut equations = DMatrix::<f64>::zeros(upper.len().max(d), d);
    for (row, entry) in upper.iter().enumerate() {
        equations[(row, entry.i)] += 1.0;
        equations[(row, entry.j)] += 1.0;
        equations[(row, entry.k)] -= 1.0;
    }
    let svd = equations.svd(false, true);
    let largest = svd.singular_values.max();
    let Some(rows) = svd.v_t else { return DVector::zeros(d) };
    let start = generic(d, 1);
    let free = svd.singular_values.iter().zip(rows.row_iter());
    let free = free.filter(|(value, _)| **value <= ZERO * largest.max(1.0));
    free.fold(DVector::zeros(d), |sum, (_, row)| {
        let direction = row.transpose();
        sum + &direction * direction.dot(&start)
    })
}

/// The largest dimension of an algebra whose derivations are computed. They have d² entries, which obey d² (d − 1)/2 equations.
const MOST_DIMENSIONS: usize = 16;

/// Returns the matrix of a generic derivation, D[e_i, e_j] = [De_i, e_j] + [e_i, De_j], among all that there are, or `None` if the
/// algebra is too large to compute them.
pub(super) fn derivation(algebra: &StructureTable) -> Option<DMatrix<f64>> {
    let d = algebra.dimension();
    if d > MOST_DIMENSIONS {
        return None;
    }
    let pairs: Vec<(usize, usize)> = (0..d).flat_map(|j| (0..j).map(move |i| (i, j))).collect();
    // The unknown D_mn has the column m d + n. Rows of zeros make the matrix as high as wide.
    let mut equations = DMatrix::<f64>::zeros((pairs.len() * d).max(d * d), d * d);
    for (pair, &(i, j)) in pairs.iter().enumerate() {
        for (k, m) in (0..d).flat_map(|k| (0..d).map(move |m| (k, m))) {
            let row = pair * d + k;
            equations[(row, k * d + m)] += algebra.constant(i, j, m);
            equations[(row, m * d + i)] -= algebra.constant(m, j, k);
            equations[(row, m * d + j)] -= algebra.constant(i, m, k);
        }
    }
    let svd = equations.svd(false, true);
    let largest = svd.singular_values.max();
    let (rows, start) = (svd.v_t?, generic(d * d, 1));
    let free = svd.singular_values.iter().zip(rows.row_iter());
    let free = free.filter(|(value, _)| **value <= ZERO * largest.max(f64::MIN_POSITIVE));
    let sum = free.fold(DVector::zeros(d * d), |sum, (_, row)| {
        let direction = row.transpose();
        sum + &direction * direction.dot(&start)
    });
    // What is round-off would be taken for an entry, since momenta have units of their own.
    let least = ZERO * sum.amax();
    let entries = sum.map(|entry| if entry.abs() <= least { 0.0 } else { entry });
    Some(DMatrix::from_row_slice(d, d, entries.as_slice()))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::algebras::system_algebra::SystemAlgebra;

    #[test]
    fn weights_add_up_and_are_zero_for_simple_algebras() {
        let of = |name: &str| {
            let algebra = SystemAlgebra::named(name).unwrap();
            let weights = grading(algebra.table());
            for entry in algebra.entries() {
                let sum = weights[entry.i] + weights[entry.j] - weights[entry.k];
                assert!(sum.abs() < 1e-14, "{name} {sum}");
            }
            weights.amax()
        };
        assert!(of("heisenberg(4)") > 0.1 && of("bargmann") > 0.1);
        assert!(of("so(5)") < 1e-14);
    }
}
