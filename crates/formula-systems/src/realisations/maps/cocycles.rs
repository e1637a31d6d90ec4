//! Cocycles of a Lie algebra: the derivations that scale its basis vectors, [`grading`], and those of any representation,
//! [`cocycle`].

use crate::realisations::generic_point::generic;
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
    solution(equations)
}

/// Returns a generic solution among those of homogeneous equations, which have at least as many rows as unknowns. What is round-off
/// in it is zero: it would be taken for an entry, since momenta have units of their own.
fn solution(equations: DMatrix<f64>) -> DVector<f64> {
    let unknowns = equations.ncols();
    let svd = equations.svd(false, true);
    let largest = svd.singular_values.max();
    let Some(rows) = svd.v_t else { return DVector::zeros(unknowns) };
    let start = generic(unknowns, 1);
    let free = svd.singular_values.iter().zip(rows.row_iter());
    let free = free.filter(|(value, _)| **value <= ZERO * largest);
    let sum = free.fold(DVector::zeros(unknowns), |sum, (_, row)| {
        let direction = row.transpose();
        sum + &direction * direction.dot(&start)
    });
    let least = ZERO * sum.amax();
    sum.map(|entry| if entry.abs() <= least { 0.0 } else { entry })
}

/// The largest dimension of an algebra whose cocycles are computed. They have d² entries, which obey d² (d − 1)/2 equations.
const MOST_DIMENSIONS: usize = 16;

/// Returns the matrix of a generic cocycle of a representation by matrices ρ_a with as many rows as the algebra has dimensions,
/// among all that there are: c([e_i, e_j]) = ρ_i c(e_j) − ρ_j c(e_i). Those of the adjoint representation are the derivations. It
/// is `None` if the algebra is too large to compute them.
pub(super) fn cocycle(algebra: &StructureTable, matrices: &[DMatrix<f64>]) -> Option<DMatrix<f64>> {
    let d = algebra.dimension();
    if d > MOST_DIMENSIONS {
        return None;
    }
    let pairs: Vec<(usize, usize)> = (0..d).flat_map(|j| (0..j).map(move |i| (i, j))).collect();
    // The unknown c_mn, the coordinate m of c(e_n), has the column m d + n. Rows of zeros make the matrix as high as wide.
    let mut equations = DMatrix::<f64>::zeros((pairs.len() * d).max(d * d), d * d);
    for (pair, &(i, j)) in pairs.iter().enumerate() {
        for (k, m) in (0..d).flat_map(|k| (0..d).map(move |m| (k, m))) {
            let row = pair * d + k;
            equations[(row, k * d + m)] += algebra.constant(i, j, m);
            equations[(row, m * d + j)] -= matrices.get(i)?[(k, m)];
            equations[(row, m * d + i)] += matrices.get(j)?[(k, m)];
        }
    }
    Some(DMatrix::from_row_slice(d, d, solution(equations).as_slice()))
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

    /// c([e_i, e_j]) = ρ_i c(e_j) − ρ_j c(e_i) for the adjoint and the coadjoint representation, and not for another matrix.
    #[test]
    fn cocycles_obey_their_equation() {
        for name in ["se(2)", "heisenberg(2)", "bargmann", "sl(2) + R2"] {
            let algebra = SystemAlgebra::named(name).unwrap();
            let (table, d) = (algebra.table(), algebra.dimension());
            let ad = |a: usize| DMatrix::from_fn(d, d, |k, j| table.constant(a, j, k));
            let adjoint: Vec<_> = (0..d).map(ad).collect();
            let coadjoint: Vec<_> = adjoint.iter().map(|ad| -ad.transpose()).collect();
            for matrices in [adjoint, coadjoint] {
                let defect = |c: &DMatrix<f64>| {
                    let pairs = (0..d).flat_map(|j| (0..j).map(move |i| (i, j)));
                    let defects = pairs.map(|(i, j)| {
                        let bracket = DVector::from_fn(d, |k, _| table.constant(i, j, k));
                        let right = &matrices[i] * c.column(j) - &matrices[j] * c.column(i);
                        (c * bracket - right).amax()
                    });
                    defects.fold(0.0, f64::max)
                };
                let found = cocycle(table, &matrices).unwrap();
                assert!(found.amax() > 0.1 && defect(&found) < 1e-14, "{name}: {found}");
                let other = DMatrix::from_column_slice(d, d, generic(d * d, 1).as_slice());
                assert!(defect(&other) > 0.1, "{name}");
            }
        }
    }
}
