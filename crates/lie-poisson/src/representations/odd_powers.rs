//! A test whether the odd powers of the matrices of a representation belong to it: [`odd_power_defect`].

use crate::representations::cocycle::matrix;
use crate::representations::representation::Representation;
use generic_scalars::{Real, Vector, larger};
use nalgebra::{DMatrix, DVector};

/// The ratio of two singular values below which the smaller one is a rounding error.
const RANK_TOLERANCE: f64 = 1e-10;

/// Returns how far the cubes ρ(ξ)³ are from the space ρ(𝔤) of the matrices of a representation; 0 if all odd powers
/// belong to it.
///
/// It is the largest distance from ρ(𝔤) of a symmetric product of three matrices of basis vectors, relative to the
/// product of their norms,
///
/// ```text
/// (1/6) Σ ρ(e_a)ρ(e_b)ρ(e_c)    over the six orders (a, b, c) of i, j, k
/// ```
///
/// If it is zero, all odd powers of all ρ(ξ) belong to ρ(𝔤): if ρ(ξ)³ = ρ(η), the matrices ρ(ξ) and ρ(η) commute, and
/// ρ(ξ)⁵ = ρ(ξ)²ρ(η) is again such a symmetric product.
///
/// The defect decides whether a Runge–Kutta step descends from T∗V to 𝔤∗. The stages of the step are z ↦ R z, where R
/// is a rational function of matrices of the algebra. Since the step is symplectic, it is the exponential of a series
/// in odd symmetric powers. If these belong to ρ(𝔤), then μ moves by `Ad∗_g` with g near the identity. Otherwise the
/// image of the step depends in general on the point (q, p), and not on μ alone. This converse is measured, not
/// proved.
///
/// The defining representations of SO(n), Sp(2n, R) and U(n) have the defect 0. So have the adjoint representations
/// of so(3), sl(2, R) and se(3), of so(3) over any commutative ring, and of every nilpotent algebra of class up to 3.
/// The adjoint representations of most solvable algebras have a defect that is not 0.
///
/// The result is NaN if a matrix element is infinite or not a number. The computation takes about n³ products of
/// matrices for the dimension n of 𝔤.
///
/// # Example
/// ```
/// use lie_poisson::{InfinitesimalAdjoint, Se3, StructureConstants, odd_power_defect};
/// assert!(odd_power_defect(&InfinitesimalAdjoint(Se3::default())) < 1e-14);
/// // [e₀, e₂] = e₀, [e₁, e₂] = 2e₁: the cube of ad is diag(1, 8), not a multiple of diag(1, 2)
/// let solvable = StructureConstants::<3>::new(|i, j, k| match (i, j, k) {
///     (0, 2, 0) => 1.0,
///     (2, 0, 0) => -1.0,
///     (1, 2, 1) => 2.0,
///     (2, 1, 1) => -2.0,
///     _ => 0.0,
/// })?;
/// assert!(odd_power_defect(&InfinitesimalAdjoint(solvable)) > 0.1);
/// # Ok::<(), lie_poisson::StructureError>(())
/// ```
#[must_use]
pub fn odd_power_defect<R: Representation>(representation: &R) -> f64 {
    let n = <crate::RepresentedElement<R> as Vector>::DIM;
    odd_power_defect_of((0..n).map(|i| matrix(representation, i)).collect())
}

/// Returns the [`odd_power_defect`] of the space that is spanned by the given square matrices of equal size.
#[must_use]
pub fn odd_power_defect_of(matrices: Vec<DMatrix<f64>>) -> f64 {
    let matrices: Vec<_> = matrices.into_iter().map(normalised).collect();
    let n = matrices.len();
    let Some(span) = orthonormal(&matrices) else { return f64::NAN };
    let mut worst = 0.0;
    for i in 0..n {
        for j in i..n {
            for k in j..n {
                let product = symmetric(&matrices[i], &matrices[j], &matrices[k]);
                let mut rest = DVector::from_column_slice(product.as_slice());
                for direction in span.iter().chain(&span) {
                    rest.axpy(-direction.dot(&rest), direction, 1.0);
                }
                worst = larger(worst, rest.norm());
            }
        }
    }
    worst
}

/// Returns a matrix divided by its norm, unless it is zero.
fn normalised(mut matrix: DMatrix<f64>) -> DMatrix<f64> {
    let size = matrix.iter().fold(0.0, |most, x| larger(most, x.max_abs()));
    if size > 0.0 {
        matrix /= size;
        matrix /= matrix.norm();
    }
    matrix
}

/// Returns an orthonormal basis of the span of matrices, or `None` if an entry is not finite.
fn orthonormal(matrices: &[DMatrix<f64>]) -> Option<Vec<DVector<f64>>> {
    let vectors: Vec<_> =
        matrices.iter().map(|m| DVector::from_column_slice(m.as_slice())).collect();
    if vectors.iter().any(|v| v.iter().any(|x| !x.is_finite())) {
        return None;
    }
    if vectors.iter().all(|v| v.is_empty()) {
        return Some(Vec::new());
    }
    let singular = DMatrix::from_columns(&vectors).svd(true, false);
    let largest = singular.singular_values.iter().fold(0.0, |m, s| larger(m, *s));
    let columns = singular.u.iter().flat_map(|u| u.column_iter());
    let values = singular.singular_values.iter();
    let kept = columns.zip(values).filter(|(_, value)| **value > largest * RANK_TOLERANCE);
    Some(kept.map(|(column, _)| column.into_owned()).collect())
}

/// Returns the mean of the products of three matrices in all orders.
fn symmetric(a: &DMatrix<f64>, b: &DMatrix<f64>, c: &DMatrix<f64>) -> DMatrix<f64> {
    let pair = |x: &DMatrix<f64>, y: &DMatrix<f64>| x * y + y * x;
    (a * pair(b, c) + b * pair(a, c) + c * pair(a, b)) / 6.0
}
