//! Newton's iteration for the stage equations.

use crate::linear_solve::solve;
use crate::settling::ROUND_OFF;
use crate::stage_solver::{combination, plus_combination};
use crate::{Tableau, VectorField};
use lie_poisson::{Real, Vector};

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

/// One iteration k ← k − (1 − h A ⊗ DX)⁻¹ (k − X(z + h A k)) for the stage derivatives, in the lanes
/// that are not `done`; returns the largest change and the largest stage derivative, both infinite
/// where the matrix is singular.
///
/// For a large step the change may be small while the residual k − X(…) is not. A residual above
/// its own round-off, which is that of X at its argument, therefore counts as a change.
pub(crate) fn newton_step<T: Real, F: VectorField<T>>(
    field: &F,
    (z, step): (&F::Point, f64),
    tableau: &Tableau,
    done: T::Mask,
    k: &mut [F::Point],
    space: &mut NewtonSpace<T>,
) -> (T, T) {
    let unexplained = assemble(field, (z, step), tableau, k, space);
    let regular = solve(&mut space.matrix, &mut space.residual);
    let (mut change, mut largest) = (unexplained, T::zero());
    for (stage, part) in k.iter_mut().zip(space.residual.chunks_exact(F::Point::DIM)) {
        let correction = F::Point::from_coordinates(|d| part[d]);
        change = change.larger(correction.max_norm());
        *stage = F::Point::select(done, stage, &(*stage - correction));
        largest = largest.larger(stage.max_norm());
    }
    let infinity = T::from_f64(f64::INFINITY);
    (T::select(regular, change, infinity), T::select(regular, largest, infinity))
}

/// Writes the matrix 1 − h A ⊗ DX and the residual k − X(z + h A k); returns the largest residual
/// that is above its round-off.
fn assemble<T: Real, F: VectorField<T>>(
    field: &F,
    (z, step): (&F::Point, f64),
    tableau: &Tableau,
    k: &[F::Point],
    space: &mut NewtonSpace<T>,
) -> T {
    let dimension = F::Point::DIM;
    let size = k.len() * dimension;
    space.matrix.clear();
    space.matrix.resize(size * size, T::zero());
    space.residual.clear();
    let mut unexplained = T::zero();
    for (i, row) in tableau.rows().enumerate() {
        let small = combination(tableau.row_low(i), k);
        let point = *z + plus_combination(small, row, k).scaled(T::from_f64(step));
        let value = field.at(&point);
        let residual = k[i] - value;
        space.residual.extend((0..dimension).map(|d| residual.coordinate(d)));
        let mut noise = value.max_norm();
        for column in 0..dimension {
            let slope = derivative(field, &point, &value, &F::Point::basis(column));
            noise += slope.max_norm() * point.coordinate(column).magnitude();
            for (j, &a) in row.iter().enumerate() {
                for d in 0..dimension {
                    let at = (i * dimension + d) * size + j * dimension + column;
                    space.matrix[at] = slope.coordinate(d) * (-step * a);
                }
            }
        }
        let residual = residual.max_norm();
        let explained = residual.at_most(noise * ROUND_OFF);
        unexplained = unexplained.larger(T::select(explained, T::zero(), residual));
    }
    for n in 0..size {
        space.matrix[n * size + n] += T::one();
    }
    unexplained
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
        let width = z.max_norm().larger(T::one()) * f64::EPSILON.sqrt();
        let mut moved = *z;
        moved.add_scaled(width, v);
        (field.at(&moved) - *value).scaled(T::one() / width)
    })
}
