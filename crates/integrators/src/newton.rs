//! Newton's iteration for the stage equations.

use crate::linear_solve::solve;
use crate::stage_solver::{ROUND_OFF, stage_point};
use crate::{Tableau, VectorField};
use lie_poisson::{Real, Vector, larger};

/// Storage of the iteration, empty until a step first needs it.
#[derive(Clone, Debug)]
pub(crate) struct NewtonSpace<T> {
    matrix: Vec<T>,
    residual: Vec<T>,
}

impl<T> Default for NewtonSpace<T> {
    fn default() -> Self {
        Self { matrix: Vec::new(), residual: Vec::new() }
    }
}

/// One iteration k ← k − (1 − h A ⊗ DX)⁻¹ (k − X(z + h A k)) for the stage derivatives; returns
/// the largest change and the largest stage derivative, `None` if the matrix is singular.
///
/// For a large step the change may be small while the residual k − X(…) is not. A residual above
/// its own round-off, which is that of X at its argument, therefore counts as a change.
pub(crate) fn newton_step<T: Real, F: VectorField<T>>(
    field: &F,
    z: &F::Point,
    step: f64,
    tableau: &Tableau,
    k: &mut [F::Point],
    space: &mut NewtonSpace<T>,
) -> Option<(f64, f64)> {
    let dimension = F::Point::DIM;
    let size = k.len() * dimension;
    space.matrix.clear();
    space.matrix.resize(size * size, T::zero());
    space.residual.clear();
    let mut unexplained = 0.0;
    for (i, row) in tableau.rows().enumerate() {
        let point = stage_point(z, step, row, tableau.row_low(i), k);
        let value = field.at(&point);
        let residual = k[i] - value;
        space.residual.extend((0..dimension).map(|d| residual.coordinate(d)));
        let mut noise = value.max_abs();
        for column in 0..dimension {
            let slope = derivative(field, &point, &value, &F::Point::basis(column));
            noise += slope.max_abs() * point.coordinate(column).max_abs();
            for (j, &a) in row.iter().enumerate() {
                for d in 0..dimension {
                    let at = (i * dimension + d) * size + j * dimension + column;
                    space.matrix[at] = slope.coordinate(d) * (-step * a);
                }
            }
        }
        if residual.max_abs().is_nan() || residual.max_abs() > ROUND_OFF * noise {
            unexplained = larger(unexplained, residual.max_abs());
        }
    }
    for n in 0..size {
        space.matrix[n * size + n] += T::one();
    }
    if !solve(&mut space.matrix, &mut space.residual) {
        return None;
    }
    let (mut change, mut largest) = (unexplained, 0.0);
    for (stage, part) in k.iter_mut().zip(space.residual.chunks_exact(dimension)) {
        let correction = F::Point::from_coordinates(|d| part[d]);
        change = larger(change, correction.max_abs());
        *stage -= correction;
        largest = larger(largest, stage.max_abs());
    }
    Some((change, largest))
}

/// DX(z)·v, by a difference quotient where the field does not know it: the iteration then
/// converges a little more slowly, to the same stages.
fn derivative<T: Real, F: VectorField<T>>(
    field: &F,
    z: &F::Point,
    value: &F::Point,
    v: &F::Point,
) -> F::Point {
    field.derivative(z, v).unwrap_or_else(|| {
        let width = f64::EPSILON.sqrt() * z.max_abs().max(1.0);
        let mut moved = *z;
        moved.add_scaled(T::from_f64(width), v);
        (field.at(&moved) - *value).scaled(T::from_f64(1.0 / width))
    })
}
