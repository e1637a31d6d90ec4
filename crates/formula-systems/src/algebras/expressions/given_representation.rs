//! Representations of one's own in expressions: [`require_representation`].

use crate::error::FormulaSystemError;
use lie_poisson_formulas::{Coordinates, StructureEntry};
use nalgebra::DMatrix;

/// The largest deviation of a commutator from the matrix of the bracket, relative to the size of the products: that of
/// numbers with nine digits.
const DEVIATION: f64 = 1e-9;

/// Checks that matrices ρ_i, one for each basis vector, are a representation of an algebra: [ρ_i, ρ_j] = Σ_k c_ijk ρ_k.
///
/// # Errors
/// Returns [`FormulaSystemError::Representation`] with what is wrong.
pub(super) fn require_representation(
    name: &str,
    matrices: &[DMatrix<f64>],
    (coordinates, constants): (&Coordinates, &[StructureEntry]),
) -> Result<(), FormulaSystemError> {
    let wrong =
        |problem: String| Err(FormulaSystemError::Representation { name: name.into(), problem });
    let dimension = coordinates.dimension();
    if matrices.len() != dimension {
        let found = matrices.len();
        return wrong(format!("it has {found} matrices, and the algebra before it {dimension}"));
    }
    let n = matrices.first().map_or(0, DMatrix::nrows);
    for (i, matrix) in (1..).zip(matrices) {
        if n == 0 || matrix.shape() != (n, n) {
            let (rows, columns) = matrix.shape();
            return wrong(format!(
                "matrix {i} has {rows} rows and {columns} columns, not {n} each"
            ));
        }
        if matrix.iter().any(|x| !x.is_finite()) {
            return wrong(format!("matrix {i} has an entry that is not finite"));
        }
    }
    for j in 0..dimension {
        for i in 0..j {
            let products = [&matrices[i] * &matrices[j], &matrices[j] * &matrices[i]];
            let mut rest = &products[0] - &products[1];
            let mut size = products[0].amax().max(products[1].amax());
            for entry in constants {
                let sign = match (entry.i, entry.j) {
                    pair if pair == (i, j) => 1.0,
                    pair if pair == (j, i) => -1.0,
                    _ => continue,
                };
                let term = &matrices[entry.k] * (sign * entry.value);
                size = size.max(term.amax());
                rest -= term;
            }
            let defect = rest.amax();
            if defect > DEVIATION * size {
                let names: Vec<String> = coordinates.names().collect();
                let pair = format!("{} and {}", names[i], names[j]);
                return wrong(format!(
                    "the commutator of the matrices of {pair} differs from that of their bracket by {defect:.3e}"
                ));
            }
        }
    }
    Ok(())
}
