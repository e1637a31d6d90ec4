//! Dense linear equations over any scalar.

use crate::numbers::mask::Mask;
use crate::numbers::real::Real;

/// Solves A x = b in place by Gaussian elimination with partial pivoting, over any scalar.
///
/// `a` holds the rows of the n × n matrix, and `b` is replaced by x. The returned mask is true in the lanes in which
/// the equations have been solved. It is false in SIMD lanes (several numbers in one register) in which a pivot is zero
/// or not a number, and in every lane if `a` does not have n² numbers. In a lane in which it is false, x has no
/// meaning.
///
/// The pivots of dual numbers are chosen by their values: such a matrix is regular if and only if that of the values is.
///
/// Each lane chooses its own pivots, so that its x is bit-identical to the solution of the same equations alone.
/// (Matrix libraries require more of a scalar than dual numbers and lanes offer.) Pivots are compared with each
/// other, so all rows should have the same unit.
///
/// # Example
/// ```
/// use generic_scalars::solve_linear;
/// // 2x + y = 4, x + 3y = 7
/// let (mut a, mut b) = ([2.0, 1.0, 1.0, 3.0], [4.0, 7.0]);
/// assert!(solve_linear(&mut a, &mut b));
/// assert!((b[0] - 1.0_f64).abs() < 1e-15 && (b[1] - 2.0_f64).abs() < 1e-15);
/// assert!(!solve_linear(&mut [1.0, 2.0, 2.0, 4.0], &mut [1.0, 1.0]));
/// ```
pub fn solve_linear<T: Real>(a: &mut [T], b: &mut [T]) -> T::Mask {
    let n = b.len();
    if a.len() != n * n {
        return T::Mask::from_bool(false);
    }
    let mut regular = T::Mask::from_bool(true);
    for k in 0..n {
        for row in k + 1..n {
            let larger = absolute(a[row * n + k]).at_most(absolute(a[k * n + k])).not();
            if larger.any() {
                for column in k..n {
                    swap_where(larger, a, row * n + column, k * n + column);
                }
                swap_where(larger, b, row, k);
            }
        }
        let inverse = T::one() / a[k * n + k];
        regular = regular.and(inverse.magnitude().at_most(T::from_f64(f64::MAX)));
        for row in k + 1..n {
            let factor = a[row * n + k] * inverse;
            for column in k..n {
                let subtract = factor * a[k * n + column];
                a[row * n + column] -= subtract;
            }
            let subtract = factor * b[k];
            b[row] -= subtract;
        }
    }
    for k in (0..n).rev() {
        let mut sum = b[k];
        for column in k + 1..n {
            sum -= a[k * n + column] * b[column];
        }
        b[k] = sum / a[k * n + k];
    }
    regular
}

/// Returns |x|, whose value is that of the value of a dual number.
fn absolute<T: Real>(x: T) -> T {
    x.select_nonnegative(x, -x)
}

/// Exchanges two numbers in the lanes in which the mask is true.
#[inline]
fn swap_where<T: Real>(mask: T::Mask, x: &mut [T], i: usize, j: usize) {
    (x[i], x[j]) = (T::select(mask, x[j], x[i]), T::select(mask, x[i], x[j]));
}

#[cfg(test)]
mod tests {
    use super::solve_linear;
    use crate::lanes::{DefaultLanes, Lanes};
    use crate::numbers::dual_number::DualNumber;
    use crate::numbers::mask::Mask;
    use crate::numbers::real::Real;

    #[test]
    fn equations_are_solved_and_singular_ones_refused() {
        let mut a = [0.0, 2.0, 1.0, 1.0, -1.0, 0.5, 3.0, 0.0, 1.0];
        let x = [1.0, -2.0, 0.25];
        let mut b: Vec<f64> =
            a.chunks(3).map(|row| row.iter().zip(x).map(|(a, x)| a * x).sum()).collect();
        assert!(solve_linear(&mut a, &mut b));
        assert!(b.iter().zip(x).all(|(b, x)| (b - x).abs() < 1e-15));
        assert!(!solve_linear(&mut [1.0, 2.0, 2.0, 4.0], &mut [1.0, 1.0]));
        assert!(!solve_linear(&mut [f64::NAN], &mut [1.0]));
        assert!(!solve_linear(&mut [1.0], &mut [1.0, 1.0]), "the wrong size");
    }

    /// The largest number of row k of the matrix is not in column k. Each step of the elimination must exchange rows:
    /// without the exchange the pivots are about 1e-17, and lose all digits.
    #[test]
    fn every_pivot_is_the_largest_of_its_column() {
        for n in 2..=6 {
            let entry = |i: usize, j: usize| {
                let (i, j) = (i as f64, j as f64);
                if i == j { 1e-17 } else { (1.3 * i + 2.9 * j * j + i * j).sin() }
            };
            let mut a: Vec<f64> = (0..n * n).map(|m| entry(m / n, m % n)).collect();
            let x: Vec<f64> = (0..n).map(|i| 1.0 - 0.4 * i as f64).collect();
            let mut b: Vec<f64> =
                a.chunks(n).map(|row| row.iter().zip(&x).map(|(a, x)| a * x).sum()).collect();
            assert!(solve_linear(&mut a, &mut b));
            // The bound is the rounding error times the condition number of these matrices, which is at most 36.
            let error = b.iter().zip(&x).map(|(b, x)| (b - x).abs()).fold(0.0, f64::max);
            assert!(error < 36.0 * 10.0 * f64::EPSILON, "{n}: {error:e}");
        }
    }

    /// A number with a small value and a large derivative is no pivot: the values have the digits of a solution of their own.
    #[test]
    fn derivatives_choose_no_pivots() {
        let dual = DualNumber::new;
        let mut a = [dual(1e-17, 1e9), dual(1.0, 0.0), dual(1.0, 0.0), dual(1.0, 0.0)];
        let mut b = [dual(1.0, 0.0), dual(2.0, 0.0)];
        let mut values =
            (a.map(|x| x.value_without_derivative()), b.map(|x| x.value_without_derivative()));
        assert!(solve_linear(&mut a, &mut b) && solve_linear(&mut values.0, &mut values.1));
        // x = y = 1 to round-off, and x′ = −y′ = 1e9 x by the first equation
        for (x, (value, slope)) in b.iter().zip([(1.0, 1e9), (1.0, -1e9)]) {
            assert!((x.value_without_derivative() - value).abs() < 1e-15, "{x:?}");
            assert!((x.derivative() / slope - 1.0).abs() < 1e-15, "{x:?}");
        }
        assert_eq!(b.map(|x| x.value_without_derivative()), values.1);
    }

    #[test]
    fn each_lane_is_solved_as_if_alone() {
        // The lanes need different pivots; the second is singular, the last is not a number.
        let columns = [
            [0.0, 1.0, -2.0, f64::NAN],
            [2.0, 2.0, 1.0, 1.0],
            [3.0, 2.0, 0.1, 1.0],
            [1.0, 4.0, 0.3, 1.0],
        ];
        let mut a = columns.map(|lanes| DefaultLanes::load(&lanes));
        let mut b = [DefaultLanes::load(&[1.0, 1.0, 0.7, 1.0]), DefaultLanes::from_f64(0.3)];
        let before = (a, b);
        let regular = solve_linear(&mut a, &mut b);
        for lane in 0..4 {
            let mut b_alone = before.1.map(|x| x.lane(lane));
            let possible = solve_linear(&mut before.0.map(|x| x.lane(lane)), &mut b_alone);
            assert_eq!((regular.lane(lane), possible), (lane % 2 == 0, lane % 2 == 0));
            if possible {
                assert_eq!(b.map(|x| x.lane(lane)), b_alone);
            }
        }
    }
}
