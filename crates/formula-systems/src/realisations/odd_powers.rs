//! Whether the cubes of matrices are combinations of them: [`descends`].

use super::generic_point::generic;
use nalgebra::allocator::Allocator;
use nalgebra::{DMatrix, DVector, DefaultAllocator, Dim, OMatrix};

/// The largest relative defect that counts as rounding.
pub(super) const ROUNDING: f64 = 1e-10;

/// Returns whether the cube of each matrix of a representation is one of its matrices, so that steps along the momenta of
/// copies of it descend to 𝔤∗.
pub(super) fn descends(matrices: &[DMatrix<f64>]) -> bool {
    odd_powers(matrices) < ROUNDING
}

/// Returns the largest distance of the cube of a generic combination of matrices from their combinations, relative to its
/// size.
pub(super) fn odd_powers(matrices: &[DMatrix<f64>]) -> f64 {
    let basis: Vec<DMatrix<f64>> = matrices.iter().map(|matrix| unit(matrix.clone())).collect();
    let columns: Vec<_> = basis.iter().map(|b| DVector::from_column_slice(b.as_slice())).collect();
    let span = DMatrix::from_columns(&columns).svd(true, false);
    let kept = span.rank(1e-12);
    let Some(directions) = span.u.map(|u| u.columns(0, kept).into_owned()) else {
        return f64::NAN;
    };
    (0..3)
        .map(|sample| {
            let xi = generic(basis.len(), sample);
            let terms = basis.iter().zip(&xi).map(|(b, x)| b * *x);
            let Some(matrix) = terms.reduce(|sum, term| sum + term) else { return 0.0 };
            let cube = &matrix * &matrix * &matrix;
            let cube = DVector::from_column_slice(cube.as_slice());
            let rest = &cube - &directions * (directions.transpose() * &cube);
            let size = cube.norm();
            if size > 0.0 { rest.norm() / size } else { 0.0 }
        })
        .fold(0.0, f64::max)
}

/// Returns a matrix of the length 1 in the same direction, or zero.
pub(super) fn unit<R: Dim, C: Dim>(matrix: OMatrix<f64, R, C>) -> OMatrix<f64, R, C>
where
    DefaultAllocator: Allocator<R, C>,
{
    // The largest entry first, whose square may overflow.
    let largest = matrix.amax();
    if largest == 0.0 {
        return matrix;
    }
    let matrix = matrix / largest;
    let length = matrix.norm();
    matrix / length
}
