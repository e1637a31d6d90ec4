//! Underdetermined linear equations, for the lifts of Clebsch maps.

use lie_poisson::{Real, larger, solve_linear};
use nalgebra::DMatrix;

/// The ratio of two singular values below which the smaller one is a rounding error.
const RANK_TOLERANCE: f64 = 1e-10;

/// The number added to the diagonal of the normal equations, whose entries there are 1.
///
/// A map may reach only a part of its target. Then the matrix is singular without the damping. The next iteration
/// restores what the damping removes in the present one.
const DAMPING: f64 = 1e-12;

/// The Moore–Penrose inverse of a matrix A whose rows may have different units.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PseudoInverse {
    /// The Moore–Penrose inverse A⁺.
    pub(crate) matrix: DMatrix<f64>,
    /// The number of independent equations.
    pub(crate) rank: usize,
    /// The ratio of the least and the largest singular value of the independent equations.
    pub(crate) condition: f64,
}

impl PseudoInverse {
    /// Computes the inverse from singular values, after each row of A has been divided by its length.
    pub(crate) fn of(mut a: DMatrix<f64>) -> Self {
        let none = Self { matrix: DMatrix::zeros(a.ncols(), a.nrows()), rank: 0, condition: 0.0 };
        if a.is_empty() || a.iter().any(|x| !x.is_finite()) {
            return none;
        }
        let lengths: Vec<f64> = a.row_iter().map(|row| row.norm()).collect();
        let units = lengths.iter().map(|&length| if length > 0.0 { length.recip() } else { 0.0 });
        let units: Vec<f64> = units.collect();
        a.row_iter_mut().zip(&units).for_each(|(mut row, unit)| row *= *unit);
        let singular = a.svd(true, true);
        let (Some(u), Some(v_t)) = (&singular.u, &singular.v_t) else { return none };
        let largest = singular.singular_values.iter().fold(0.0, |m, s| larger(m, *s));
        let (mut rank, mut least, mut matrix) = (0, largest, none.matrix);
        for (i, &value) in singular.singular_values.iter().enumerate() {
            if value > largest * RANK_TOLERANCE {
                (rank, least) = (rank + 1, least.min(value));
                matrix += v_t.row(i).transpose() * u.column(i).transpose() / value;
            }
        }
        matrix.column_iter_mut().zip(&units).for_each(|(mut column, unit)| column *= *unit);
        let condition = if rank > 0 { least / largest } else { 0.0 };
        Self { matrix, rank, condition }
    }

    /// Returns the i-th coordinate of the solution of A x = y of least norm.
    pub(crate) fn coordinate<T: Real>(&self, i: usize, y: impl Fn(usize) -> T) -> T {
        (0..self.matrix.ncols()).fold(T::zero(), |sum, j| sum + y(j) * self.matrix[(i, j)])
    }
}

/// Returns the x of least norm with A x = y for rows of A over any scalar, damped where the rows depend on each
/// other.
///
/// The second result is the mask of the SIMD lanes in which the equations have a solution.
pub(crate) fn least_solution<T: Real>(mut rows: Vec<Vec<T>>, mut y: Vec<T>) -> (Vec<T>, T::Mask) {
    let unknowns = rows.first().map_or(0, Vec::len);
    for (row, y) in rows.iter_mut().zip(&mut y) {
        let length = row.iter().fold(T::zero(), |sum, x| sum + *x * *x).sqrt();
        let length = T::select(length.at_most(T::zero()), T::one(), length);
        row.iter_mut().for_each(|x| *x /= length);
        *y /= length;
    }
    let mut gram = Vec::with_capacity(rows.len() * rows.len());
    for (i, first) in rows.iter().enumerate() {
        for (j, second) in rows.iter().enumerate() {
            let damping = T::from_f64(if i == j { DAMPING } else { 0.0 });
            gram.push(first.iter().zip(second).fold(damping, |sum, (x, y)| sum + *x * *y));
        }
    }
    let regular = solve_linear(&mut gram, &mut y);
    let sum = |d: usize| rows.iter().zip(&y).fold(T::zero(), |sum, (row, m)| sum + row[d] * *m);
    ((0..unknowns).map(sum).collect(), regular)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::DVector;

    /// A A⁺ y = y for independent rows, whatever their units, and A⁺ y is orthogonal to the kernel of A.
    #[test]
    fn the_inverse_gives_the_least_solution() {
        for unit in [1e-100, 1.0, 1e100] {
            let a = DMatrix::from_row_slice(2, 3, &[1.0, 2.0, -1.0, 3.0 * unit, 0.0, unit]);
            let (y, kernel) = ([0.7, -1.9 * unit], [2.0, -4.0, -6.0]);
            let inverse = PseudoInverse::of(a.clone());
            assert_eq!(inverse.rank, 2);
            let x = DVector::from_fn(3, |i, _| inverse.coordinate(i, |j| y[j]));
            let back = a * &x;
            assert!((back[0] / y[0] - 1.0).abs() < 1e-14 && (back[1] / y[1] - 1.0).abs() < 1e-14);
            assert!(x.iter().zip(kernel).map(|(x, k)| x * k).sum::<f64>().abs() < 1e-14);
        }
    }

    /// The singular values of two unit rows at the angle φ are √(1 ± cos φ), with the ratio tan(φ/2).
    #[test]
    fn the_condition_is_that_of_the_directions_of_the_rows() {
        for angle in [0.1_f64, 1.0, 1.5] {
            for unit in [1e-100, 1.0, 1e100] {
                let rows = [2.0, 0.0, unit * angle.cos(), unit * angle.sin()];
                let inverse = PseudoInverse::of(DMatrix::from_row_slice(2, 2, &rows));
                assert!((inverse.condition / (angle / 2.0).tan() - 1.0).abs() < 1e-14);
            }
        }
        let parallel = PseudoInverse::of(DMatrix::from_row_slice(2, 2, &[1.0, 2.0, -3.0, -6.0]));
        assert!(parallel.rank == 1 && (parallel.condition - 1.0).abs() < 1e-15);
        let nothing = PseudoInverse::of(DMatrix::zeros(2, 2));
        assert_eq!((nothing.rank, nothing.condition), (0, 0.0));
    }
    /// The damping is relative to each row: for rows of any lengths, the solution is accurate to at least half of the
    /// digits and has the least norm.
    #[test]
    fn rows_of_unequal_length_have_their_least_solution() {
        for unit in [1e-100, 1e-9, 1.0, 1e9, 1e100] {
            let rows = vec![vec![1.0, 2.0, -1.0], vec![3.0 * unit, 0.0, unit]];
            let y = [0.7, -1.9 * unit];
            let (x, regular) = least_solution(rows.clone(), y.to_vec());
            let (product, kernel) =
                (|v: &[f64]| v.iter().zip(&x).map(|(a, b)| a * b).sum::<f64>(), [2.0, -4.0, -6.0]);
            for (row, y) in rows.iter().zip(y) {
                // The error comes from the damping of unit rows, at an angle whose sine is near 1.
                assert!((product(row) / y - 1.0).abs() < 4.0 * DAMPING, "{unit:e}: {x:?}");
            }
            assert!(regular && product(&kernel).abs() < 1e-14, "{unit:e}: {x:?}");
        }
    }
}
