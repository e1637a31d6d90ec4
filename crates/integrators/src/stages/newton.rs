//! Newton's iteration for the stage equations.

use crate::iteration::block_sizes::{BlockSizes, MaskOf};
use crate::iteration::stage_scale::SweepChange;
use crate::iteration::stage_solver::set_combination;
use crate::tableaux::tableau::Tableau;
use crate::vector_field::VectorField;
use lie_poisson::{Mask, Real, State, solve_linear};

/// The storage of Newton's iteration, empty until a step first needs it.
#[derive(Clone, Debug)]
pub(crate) struct NewtonWorkspace<T> {
    matrix: Vec<T>,
    residual: Vec<T>,
}

impl<T> Default for NewtonWorkspace<T> {
    fn default() -> Self {
        Self { matrix: Vec::new(), residual: Vec::new() }
    }
}

/// The largest number of unknowns for which Newton's iteration is made. Its matrix then has 8 MiB over `f64`.
const MOST_UNKNOWNS: usize = 1024;

impl<T> NewtonWorkspace<T> {
    /// Returns whether the stage equations of points such as z have few enough unknowns for a dense matrix.
    pub(crate) fn allows<V: State>(&self, stages: usize, z: &V) -> bool {
        stages * z.dimension() <= MOST_UNKNOWNS
    }
}

/// A vector field on points V that is called through a pointer, so that what calls it is compiled once for all fields on
/// points of a type.
pub(crate) type FieldOn<'a, V> = dyn VectorField<<V as State>::Scalar, Point = V> + 'a;

/// Makes one Newton iteration k ← k − (1 − h A ⊗ DX)⁻¹ (k − X(z + h A k)) for the stage derivatives, in the lanes that
/// are not `done`.
///
/// Returns the changes, which are infinite if the matrix is singular, and the sizes of the terms whose sums are the
/// stage derivatives.
///
/// For a large step the change may be small while the residual k − X(…) is not. A residual above its own round-off,
/// which is that of X at its argument, therefore counts as a change.
///
/// The terms are those of DX·z, the round-off of X at its argument in units of ε. They are larger than X if z is far
/// along a fibre on which X does not depend. No iteration comes nearer than their round-off.
pub(crate) fn newton_step<V: State>(
    field: &FieldOn<'_, V>,
    (z, step): (&V, f64),
    tableau: &Tableau,
    done: MaskOf<V>,
    k: &mut [V],
    space: &mut NewtonWorkspace<V::Scalar>,
) -> SweepChange<V> {
    let units = units(z, step, k);
    let mut progress = assemble(field, (z, step), tableau, k, &units, space);
    let regular = solve_linear(&mut space.matrix, &mut space.residual);
    for (stage, part) in k.iter_mut().zip(space.residual.chunks_exact(z.dimension().max(1))) {
        let mut correction = units.clone();
        correction.set_coordinates(|d| part[d] * units.coordinate(d));
        progress.change.include(&correction);
        correction.subtract_from(stage);
        stage.replace_where(done.not(), &correction);
        progress.size.include(stage);
    }
    progress.change = BlockSizes::select(regular, &progress.change, &BlockSizes::infinite());
    progress
}

/// Writes the matrix 1 − h A ⊗ DX and the residual k − X(z + h A k), both in the given units.
///
/// Without units, elimination could not choose its pivots. Returns the residuals above their round-off, and the sizes
/// of the terms of X.
fn assemble<V: State>(
    field: &FieldOn<'_, V>,
    (z, step): (&V, f64),
    tableau: &Tableau,
    k: &[V],
    units: &V,
    space: &mut NewtonWorkspace<V::Scalar>,
) -> SweepChange<V> {
    let dimension = z.dimension();
    let size = k.len() * dimension;
    space.matrix.clear();
    space.matrix.resize(size * size, V::Scalar::from_f64(0.0));
    space.residual.clear();
    let mut progress = SweepChange { change: BlockSizes::zero(), size: BlockSizes::zero() };
    for (i, row) in tableau.rows().enumerate() {
        let mut point = z.zeros_like();
        set_combination(&mut point, tableau.row_low(i), k);
        point.add_combination(row, k);
        point.scale_in_place(V::Scalar::from_f64(step));
        point.add_in_place(z);
        let mut value = z.zeros_like();
        field.at_into(&point, &mut value);
        let mut residual = k[i].clone();
        residual.subtract_in_place(&value);
        let in_units = |d| residual.coordinate(d) / units.coordinate(d);
        space.residual.extend((0..dimension).map(in_units));
        let mut terms = BlockSizes::of(core::slice::from_ref(&value));
        for column in 0..dimension {
            let unit = units.coordinate(column);
            let slope = derivative(field, &point, &value, column, unit);
            let slopes = BlockSizes::of(core::slice::from_ref(&slope));
            terms.add_multiple(point.coordinate(column).magnitude(), &slopes);
            for (j, &a) in row.iter().enumerate() {
                for d in 0..dimension {
                    let at = (i * dimension + d) * size + j * dimension + column;
                    let entry = slope.coordinate(d) * (-step * a);
                    space.matrix[at] = entry * (unit / units.coordinate(d));
                }
            }
        }
        progress.include_residual(&BlockSizes::of(&[residual]), &terms);
    }
    for n in 0..size {
        space.matrix[n * size + n] += V::Scalar::from_f64(1.0);
    }
    progress
}

/// The smallest unit, as a multiple of the largest one. Blocks of physical quantities differ by less, and quotients of
/// units do not overflow.
const SMALLEST_UNIT: f64 = 1e-200;

/// Returns the unit of each coordinate: the larger of |z_b| and h |k_b| in its block b, or 1 if all are 0. Derivatives of dual
/// numbers do not count: the unit is the width, but for a factor, in which the field is nearly linear.
fn units<T: Real, V: State<Scalar = T>>(z: &V, step: f64, k: &[V]) -> V {
    let (mut start, mut stages) = (BlockSizes::zero(), BlockSizes::zero());
    start.include(&without_derivatives(z));
    k.iter().for_each(|k| stages.include(&without_derivatives(k)));
    let size = |b: usize| start.at(b).larger(stages.at(b) * step.abs());
    let largest = (1..V::BLOCKS).fold(size(0), |largest, b| size(b).larger(largest));
    let mut units = z.zeros_like();
    units.set_coordinates(|i| {
        let unit = size(z.block(i)).larger(largest * SMALLEST_UNIT);
        T::select(unit.at_most(T::zero()), T::one(), unit)
    });
    units
}

/// Returns a vector with all derivatives zero.
pub(crate) fn without_derivatives<V: State>(v: &V) -> V {
    let mut values = v.clone();
    if V::Scalar::from_f64(0.0).without_derivative().is_some() {
        values.set_coordinates(|i| {
            let x = v.coordinate(i);
            x.without_derivative().unwrap_or(x)
        });
    }
    values
}

/// Returns the derivative DX(z)·e_i.
///
/// It is a difference quotient if the field does not know its derivative. The iteration then converges a little more
/// slowly, to the same stages.
fn derivative<V: State>(field: &FieldOn<'_, V>, z: &V, value: &V, i: usize, unit: V::Scalar) -> V {
    let mut v = z.zeros_like();
    v.set_coordinate(i, V::Scalar::from_f64(1.0));
    field.derivative(z, &v).unwrap_or_else(|| {
        let width = unit * f64::EPSILON.sqrt();
        let mut moved = z.clone();
        moved.add_multiple(width, &v);
        let mut slope = z.zeros_like();
        field.at_into(&moved, &mut slope);
        slope.subtract_in_place(value);
        slope.scale_in_place(V::Scalar::from_f64(1.0) / width);
        slope
    })
}

#[cfg(test)]
mod tests {
    use super::units;
    use lie_poisson::{Pair, Vector};
    use nalgebra::{Vector1, Vector2};

    /// The unit is that of the state, of h k, or of neither.
    #[test]
    fn units_are_the_sizes_of_blocks() {
        type Two = Pair<Vector1<f64>, Vector2<f64>>;
        let z: Two = Pair(Vector1::new(0.5), Vector2::new(3.0, -4.0));
        let none: Two = Vector::zero();
        assert_eq!(units(&z, 0.1, &[none]), Pair(Vector1::new(0.5), Vector2::repeat(4.0)));
        let k: Two = Pair(Vector1::new(-80.0), Vector2::new(1.0, 20.0));
        for (step, expected) in [(0.25, [20.0, 5.0]), (-0.25, [20.0, 5.0]), (1e-3, [0.5, 4.0])] {
            let [first, second] = expected;
            let expected = Pair(Vector1::new(first), Vector2::repeat(second));
            assert_eq!(units(&z, step, &[none, k]), expected, "{step}");
        }
        assert_eq!(units(&none, 0.1, &[none]), Pair(Vector1::new(1.0), Vector2::repeat(1.0)));
    }
}
