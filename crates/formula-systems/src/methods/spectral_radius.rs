//! The spectral radius of a matrix.

/// The number of squarings; the norm of the power 2²⁰ of a matrix has forgotten the units of its rows.
const SQUARINGS: i32 = 20;

/// Returns the largest magnitude of an eigenvalue of a square matrix of this dimension, by rows: the limit of ‖Aⁿ‖^(1/n),
/// Gelfand's formula, with n = 2²⁰. It is 0 for a nilpotent matrix.
///
/// It is NaN if an entry is NaN or infinite.
pub(super) fn spectral_radius(mut power: Vec<f64>, dimension: usize) -> f64 {
    let mut logarithm = 0.0;
    for squaring in 0..=SQUARINGS {
        // A^(2^squaring) = e^(2^squaring logarithm) power, with the largest entry of `power` scaled to 1.
        let largest = power.iter().map(|x| x.abs()).fold(0.0, f64::max);
        if power.iter().any(|x| !x.is_finite()) {
            return f64::NAN;
        }
        if largest == 0.0 {
            return 0.0;
        }
        logarithm += largest.ln() / 2.0_f64.powi(squaring);
        power.iter_mut().for_each(|x| *x /= largest);
        power = square(&power, dimension);
    }
    f64::exp(logarithm)
}

fn square(matrix: &[f64], dimension: usize) -> Vec<f64> {
    let at = |i: usize, j: usize| matrix.get(i * dimension + j).copied().unwrap_or(0.0);
    let entry = |place: usize| {
        let (i, j) = (place / dimension, place % dimension);
        (0..dimension).map(|k| at(i, k) * at(k, j)).sum()
    };
    (0..matrix.len()).map(entry).collect()
}

#[cfg(test)]
mod tests {
    use super::spectral_radius;

    #[test]
    fn the_eigenvalues_decide_and_not_the_units() {
        for unit in [1e-60, 1e-30, 1.0, 1e30] {
            // A rotation by (1, 2, 2), and the same with another unit for the third coordinate.
            let turn = [0.0, -2.0, 2.0 * unit, 2.0, 0.0, -unit, -2.0 / unit, 1.0 / unit, 0.0];
            assert!((spectral_radius(turn.to_vec(), 3) / 3.0 - 1.0).abs() < 1e-3, "{unit:e}");
            let scale = [3.0 * unit, 0.0, 0.0, -5.0 * unit];
            assert!((spectral_radius(scale.to_vec(), 2) / (5.0 * unit) - 1.0).abs() < 1e-4);
        }
    }

    #[test]
    fn a_nilpotent_matrix_has_none_and_nan_is_not_lost() {
        assert_eq!(spectral_radius(vec![0.0, 7.0, 0.0, 0.0], 2), 0.0);
        assert_eq!(spectral_radius(Vec::new(), 0), 0.0);
        assert!(spectral_radius(vec![f64::NAN], 1).is_nan());
        assert!(spectral_radius(vec![f64::INFINITY], 1).is_nan());
    }
}
