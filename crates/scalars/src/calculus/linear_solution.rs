//! Linear equations in matrices and vectors over any scalar: [`linear_solution`].

use crate::{Mask, Real, Vector};
use nalgebra::{SMatrix, SVector};

/// Returns the solution x of A x = b over any scalar, or `None` if A is singular.
///
/// The method is Gaussian elimination with scaled partial pivoting: rows and columns may have different units. A counts
/// as singular if a pivot is not larger than the rounding errors of its terms, or not a finite number.
///
/// In SIMD lanes (several numbers in one register) each lane has its own pivots, and its solution is bit-identical to
/// that of the same equations alone. The solution is NaN in a lane whose matrix is singular, so one lane does not spoil
/// the others. It is `None` if the matrices of all lanes are singular.
///
/// [`solve_linear`](crate::solve_linear) solves equations of a size that is known when the program runs.
///
/// Source: N. J. Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd ed. (2002), §9.
///
/// # Example
/// ```
/// use generic_scalars::{DualNumber, Real, linear_solution};
/// use nalgebra::{Matrix2, Vector2};
/// let (a, b) = (Matrix2::new(0.0, 2.0, 4.0, 1.0), Vector2::new(2.0, 9.0));
/// assert_eq!(linear_solution(&a, &b), Some(Vector2::new(2.0, 1.0)));
/// assert_eq!(linear_solution(&Matrix2::new(1.0, 2.0, 0.1, 0.2), &b), None);
/// // dx = −A⁻¹ dA x, for a change of the upper right entry
/// let mut a = a.map(DualNumber::from_f64);
/// a.m12 = DualNumber::variable(2.0);
/// let x = linear_solution(&a, &b.map(DualNumber::from_f64));
/// assert_eq!(x.map(|x| x.map(|x| x.derivative())), Some(Vector2::new(0.125, -0.5)));
/// ```
#[must_use]
pub fn linear_solution<T: Real, const N: usize>(
    a: &SMatrix<T, N, N>,
    b: &SVector<T, N>,
) -> Option<SVector<T, N>> {
    let mut rows = Rows {
        entries: *a,
        terms: a.map(Real::magnitude),
        sizes: SVector::from_fn(|i, _| {
            a.row(i).iter().fold(T::zero(), |most, x| x.magnitude().maximum(most))
        }),
        right: *b,
    };
    let mut regular = T::Mask::from_bool(true);
    for k in 0..N {
        rows.choose_pivot(k);
        regular = regular.and(rows.pivot_is_regular(k));
        rows.eliminate(k);
    }
    let unknown = SVector::from_element(T::from_f64(f64::NAN));
    regular.any().then(|| Vector::select(regular, &rows.back_substituted(), &unknown))
}

/// The equations during the elimination.
struct Rows<T, const N: usize> {
    entries: SMatrix<T, N, N>,
    /// The sums of the moduli of the terms from which each entry was computed.
    terms: SMatrix<T, N, N>,
    /// The largest modulus in each row of A, its unit.
    sizes: SVector<T, N>,
    right: SVector<T, N>,
}

impl<T: Real, const N: usize> Rows<T, N> {
    /// Moves the row whose entry in the k-th column is largest, relative to the row, to the k-th place in each lane.
    fn choose_pivot(&mut self, k: usize) {
        for row in k + 1..N {
            // A quotient neither overflows nor underflows here, since a row is not larger than its terms.
            let relative = |i: usize| self.entries[(i, k)].magnitude() / self.sizes[i];
            let larger = relative(row).at_most(relative(k)).not();
            if !larger.any() {
                continue;
            }
            for column in 0..N {
                swap_where(larger, &mut self.entries, (row, column), (k, column));
                swap_where(larger, &mut self.terms, (row, column), (k, column));
            }
            swap_where(larger, &mut self.sizes, (row, 0), (k, 0));
            swap_where(larger, &mut self.right, (row, 0), (k, 0));
        }
    }

    /// Returns whether the k-th pivot is a finite number above the rounding errors of its terms.
    fn pivot_is_regular(&self, k: usize) -> T::Mask {
        let pivot = self.entries[(k, k)].magnitude();
        let rounding = self.terms[(k, k)] * (N as f64 * f64::EPSILON);
        let largest = T::from_f64(f64::MAX);
        let nonzero = (T::one() / pivot).at_most(largest);
        rounding.at_most(pivot).and(pivot.at_most(largest)).and(nonzero)
    }

    /// Subtracts multiples of the k-th row from those below it.
    fn eliminate(&mut self, k: usize) {
        for row in k + 1..N {
            let factor = self.entries[(row, k)] / self.entries[(k, k)];
            for column in k + 1..N {
                let subtract = factor * self.entries[(k, column)];
                self.entries[(row, column)] -= subtract;
                let terms = factor.magnitude() * self.terms[(k, column)];
                self.terms[(row, column)] += terms;
            }
            let subtract = factor * self.right[k];
            self.right[row] -= subtract;
        }
    }

    /// Returns the solution of the triangular equations.
    fn back_substituted(mut self) -> SVector<T, N> {
        for k in (0..N).rev() {
            let known = (k + 1..N).map(|column| (column, self.right[column]));
            let sum =
                known.fold(self.right[k], |sum, (column, x)| sum - self.entries[(k, column)] * x);
            self.right[k] = sum / self.entries[(k, k)];
        }
        self.right
    }
}

/// Exchanges two entries in the lanes in which the mask is true.
#[inline]
fn swap_where<T: Real, const R: usize, const C: usize>(
    mask: T::Mask,
    matrix: &mut SMatrix<T, R, C>,
    i: (usize, usize),
    j: (usize, usize),
) {
    (matrix[i], matrix[j]) =
        (T::select(mask, matrix[j], matrix[i]), T::select(mask, matrix[i], matrix[j]));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{DefaultLanes, Lanes};
    use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};

    const SCALES: [f64; 3] = [1e-30, 1.0, 1e30];

    /// Also with rows and columns of different units.
    #[test]
    fn equations_are_solved_at_every_scale() {
        let a = Matrix3::new(0.0, 2.0, -1.0, 1.0, 1e-3, 0.5, 3.0, -2.0, 1.0);
        let x = Vector3::new(1.0, -2.0, 0.25);
        for row in SCALES {
            for column in SCALES {
                let left = Matrix3::from_diagonal(&Vector3::new(row, 1.0, 1.0 / row));
                let right = Matrix3::from_diagonal(&Vector3::new(1.0, column, 1.0));
                for scale in SCALES {
                    let found = linear_solution(&(left * a * right * scale), &(left * a * x));
                    let error = found.map(|found| (right * found * scale - x).norm());
                    assert!(
                        error.is_some_and(|error| error < 1e-14),
                        "{row:e} {column:e} {scale:e}"
                    );
                }
            }
        }
    }

    #[test]
    fn singular_matrices_are_refused() {
        let x = Vector3::new(1.0, -2.0, 0.25);
        let multiple = Matrix3::new(0.1, 0.2, 0.4, 0.3, 0.6, 1.2, 1.0, 1.0, 1.0);
        // The rows are 1, 2 and 3 times (1, 1, 1) plus a row.
        let counting = Matrix3::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0);
        for singular in [multiple, counting, counting.transpose(), Matrix3::zeros()] {
            for scale in SCALES {
                assert_eq!(linear_solution(&(singular * scale), &x), None, "{singular}");
            }
        }
        for bad in [f64::NAN, f64::INFINITY] {
            assert_eq!(linear_solution(&Matrix3::from_element(bad), &x), None);
        }
        // Nearly singular, but not up to rounding errors.
        let close = Matrix2::new(1.0, 1.0, 1.0, 1.0 + 1e-12);
        assert!(linear_solution(&close, &Vector2::new(1.0, 2.0)).is_some());
        let none = linear_solution(&SMatrix::<f64, 0, 0>::zeros(), &SVector::zeros());
        assert_eq!(none, Some(SVector::zeros()));
    }

    #[test]
    fn a_singular_lane_does_not_spoil_the_others() {
        let entries = [
            [0.0, 1.0, -2.0, 4.0],
            [2.0, 2.0, 1.0, 1.0],
            [3.0, 2.0, 0.1, 1.0],
            [1.0, 4.0, 0.3, 1.0],
        ];
        let [m11, m12, m21, m22] = entries.map(|lanes| DefaultLanes::load(&lanes));
        let a = Matrix2::new(m11, m12, m21, m22);
        let b =
            Vector2::new(DefaultLanes::from_f64(0.7), DefaultLanes::load(&[1.0, 1.0, 0.7, 1.0]));
        let x = linear_solution(&a, &b).unwrap_or_else(SVector::zeros);
        for lane in 0..4 {
            let alone = linear_solution(&a.map(|x| x.lane(lane)), &b.map(|x| x.lane(lane)));
            let found = x.map(|x| x.lane(lane));
            match alone {
                Some(alone) => assert_eq!(found, alone),
                None => assert!(lane == 1 && found.iter().all(|x| x.is_nan())),
            }
        }
        let same = Matrix2::from_element(DefaultLanes::from_f64(1.0));
        assert_eq!(linear_solution(&same, &b), None);
    }
}
