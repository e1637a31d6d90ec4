//! Pfaffians of matrices of numbers: [`pfaffian`], and their derivatives: [`pfaffian_slopes`].

use nalgebra::DMatrix;

/// Returns the Pfaffian of an antisymmetric matrix, of which the part above the diagonal is read.
///
/// Rows and columns are eliminated in pairs with the largest pivot, A = P L T Lᵀ Pᵀ with a tridiagonal T.
///
/// Source: M. Wimmer, *Efficient numerical computation of the Pfaffian for dense and banded skew-symmetric matrices*, ACM
/// Trans. Math. Softw. 38 (2012), the algorithm of B. N. Parlett & J. K. Reid.
pub(crate) fn pfaffian(matrix: &DMatrix<f64>) -> f64 {
    let n = matrix.nrows();
    if !n.is_multiple_of(2) {
        return 0.0;
    }
    let mut a = DMatrix::from_fn(n, n, |i, j| match i.cmp(&j) {
        core::cmp::Ordering::Less => matrix[(i, j)],
        core::cmp::Ordering::Equal => 0.0,
        core::cmp::Ordering::Greater => -matrix[(j, i)],
    });
    let mut product = 1.0;
    for k in (0..n).step_by(2) {
        let larger = |p: usize, i: usize| if a[(k, i)].abs() > a[(k, p)].abs() { i } else { p };
        let pivot = (k + 1..n).fold(k + 1, larger);
        if pivot != k + 1 {
            a.swap_rows(k + 1, pivot);
            a.swap_columns(k + 1, pivot);
            product = -product;
        }
        let head = a[(k, k + 1)];
        product *= head;
        if product == 0.0 || product.is_nan() {
            return product;
        }
        for i in k + 2..n {
            for j in i + 1..n {
                let change = a[(k, i)] * a[(j, k + 1)] - a[(k, j)] * a[(i, k + 1)];
                a[(i, j)] += change / head;
                a[(j, i)] = -a[(i, j)];
            }
        }
    }
    product
}

/// Returns the derivatives of the Pfaffian with respect to the entries above the diagonal, and zeros elsewhere.
///
/// They are, up to signs, Pfaffians of the matrix without two rows and columns, and need no inverse, which a singular matrix
/// has not.
pub(crate) fn pfaffian_slopes(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    let n = matrix.nrows();
    DMatrix::from_fn(n, n, |i, j| {
        if i >= j {
            return 0.0;
        }
        let minor = matrix.clone().remove_columns_at(&[i, j]).remove_rows_at(&[i, j]);
        if (j - i).is_multiple_of(2) { -pfaffian(&minor) } else { pfaffian(&minor) }
    })
}

#[cfg(test)]
mod tests {
    use super::{pfaffian, pfaffian_slopes};
    use nalgebra::DMatrix;

    /// An antisymmetric matrix of whole numbers.
    fn matrix(n: usize) -> DMatrix<f64> {
        let entry = |i: usize, j: usize| ((3 * i + 7 * j + i * j) % 11) as f64 - 4.0;
        DMatrix::from_fn(n, n, |i, j| if i < j { entry(i, j) } else { -entry(j, i) })
    }

    #[test]
    fn pfaffians_have_their_expansion_and_their_square() {
        let four = matrix(4);
        let of_four =
            four[(0, 1)] * four[(2, 3)] - four[(0, 2)] * four[(1, 3)] + four[(0, 3)] * four[(1, 2)];
        assert!((pfaffian(&four) - of_four).abs() < 1e-12 * of_four.abs(), "{of_four}");
        for n in [6, 10, 22] {
            let mut a = matrix(n);
            a.fill_diagonal(0.0);
            let (value, determinant) = (pfaffian(&a), a.determinant());
            assert!((value * value / determinant - 1.0).abs() < 1e-11, "{n} {value}");
            // one exchange of rows and columns changes the sign
            a.swap_rows(0, n - 1);
            a.swap_columns(0, n - 1);
            assert!((pfaffian(&a) / value + 1.0).abs() < 1e-11, "{n}");
        }
        assert_eq!(pfaffian(&matrix(5)), 0.0);
        assert_eq!(pfaffian(&DMatrix::zeros(4, 4)), 0.0);
    }

    /// By Euler's theorem for a polynomial of degree n/2, and where the matrix has the rank n − 2 and no inverse.
    #[test]
    fn slopes_are_those_of_a_polynomial() {
        let a = matrix(8);
        let euler: f64 = pfaffian_slopes(&a).iter().zip(a.iter()).map(|(s, x)| s * x).sum();
        assert!((euler / (4.0 * pfaffian(&a)) - 1.0).abs() < 1e-12);
        let mut singular = DMatrix::zeros(4, 4);
        singular[(0, 1)] = 3.0;
        let slopes = pfaffian_slopes(&singular);
        assert_eq!((slopes[(2, 3)], slopes[(0, 1)], pfaffian(&singular)), (3.0, 0.0, 0.0));
    }
}
