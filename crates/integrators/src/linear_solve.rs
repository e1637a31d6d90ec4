//! Dense linear equations over any scalar.

use lie_poisson::Real;

/// Solves A x = b in place by elimination with partial pivoting; `a` holds the rows of the n × n
/// matrix, `b` becomes x. False if a pivot is zero or not a number, in any lane.
///
/// A matrix library would ask more of its scalar than dual numbers and lanes have.
pub(crate) fn solve<T: Real>(a: &mut [T], b: &mut [T]) -> bool {
    let n = b.len();
    for k in 0..n {
        let size = |row: usize| a[row * n + k].max_abs();
        let pivot = (k..n).max_by(|&i, &j| size(i).total_cmp(&size(j))).unwrap_or(k);
        if pivot != k {
            for column in k..n {
                a.swap(pivot * n + column, k * n + column);
            }
            b.swap(pivot, k);
        }
        let inverse = T::one() / a[k * n + k];
        if !inverse.max_abs().is_finite() {
            return false;
        }
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
    true
}

#[cfg(test)]
mod tests {
    use super::solve;
    use lie_poisson::{DefaultLanes, Lanes, Real};

    #[test]
    fn equations_are_solved_and_singular_ones_refused() {
        let mut a = [0.0, 2.0, 1.0, 1.0, -1.0, 0.5, 3.0, 0.0, 1.0];
        let x = [1.0, -2.0, 0.25];
        let mut b: Vec<f64> =
            a.chunks(3).map(|row| row.iter().zip(x).map(|(a, x)| a * x).sum()).collect();
        assert!(solve(&mut a, &mut b));
        assert!(b.iter().zip(x).all(|(b, x)| (b - x).abs() < 1e-15));
        assert!(!solve(&mut [1.0, 2.0, 2.0, 4.0], &mut [1.0, 1.0]));
        assert!(!solve(&mut [f64::NAN], &mut [1.0]));
        let mut one_lane_singular = [DefaultLanes::load(&[1.0, 0.0, 1.0, 1.0])];
        assert!(!solve(&mut one_lane_singular, &mut [DefaultLanes::from_f64(1.0)]));
    }
}
