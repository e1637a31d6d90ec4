//! The Casimir of sl(n, R) ⋉ Rⁿ: [`CyclicVector`].

use super::matrix_of_momenta::MatrixOfMomenta;
use nalgebra::{DMatrix, DVector};

/// The determinant det(Γ, BΓ, …, Bⁿ⁻¹Γ), B = X(μ)ᵀ, of degree n (n + 1)/2, whose coordinates are those of X in sl(n, R) and then
/// Γ_i.
///
/// A translation by v adds v ⊗ Γ to X, up to a multiple of 1, and so a multiple of Γ to BΓ: the products Γ ∧ BΓ ∧ … stay the
/// same. It is 0 where Γ is no cyclic vector of B.
///
/// Source: M. Perroud, *The fundamental invariants of inhomogeneous classical groups*, J. Math. Phys. 24 (1983).
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct CyclicVector {
    pub(crate) matrix: MatrixOfMomenta,
    /// The number of coordinates of X.
    pub(crate) rotations: usize,
}

impl CyclicVector {
    /// Returns the degree.
    pub(crate) const fn degree(&self) -> usize {
        let n = self.matrix.size();
        n * (n + 1) / 2
    }

    /// Returns what a reader is shown, with the rows ΓXʲ of the transposed matrix.
    pub(crate) fn text(vector: &str, n: usize) -> String {
        let last = match n {
            0..3 => String::new(),
            3 => format!(", {vector} X^2"),
            _ => format!(", …, {vector} X^{}", n - 1),
        };
        format!("det({vector}, {vector} X{last})")
    }

    /// Returns the value.
    ///
    /// Powers of B lose digits. In the orthonormal basis that the vectors make one after the other B has zeros below the
    /// entries h_j under the diagonal, and the determinant is ±|Γ|ⁿ Π_j h_jⁿ⁻ʲ.
    pub(crate) fn value(&self, own: &[f64]) -> f64 {
        let (b, gamma) = self.parts(own);
        let n = gamma.len();
        let (mut basis, mut product): (Vec<DVector<f64>>, f64) = (Vec::new(), 1.0);
        let mut next = gamma;
        for j in 0..n {
            // The second round removes the rounding errors of the first.
            for q in basis.iter().chain(&basis) {
                next.axpy(-q.dot(&next), q, 1.0);
            }
            let length = next.norm();
            product *= length.powi(i32::try_from(n - j).unwrap_or(i32::MAX));
            if product == 0.0 || !length.is_finite() {
                return product;
            }
            basis.push(next / length);
            next = basis.last().map_or_else(|| DVector::zeros(n), |last| &b * last);
        }
        product * DMatrix::from_columns(&basis).determinant().signum()
    }

    /// Adds the derivatives to slopes: with the cofactors g_j of the columns k_j = BʲΓ the adjoint recurrence is
    /// λ_j = g_j + Bᵀλ_(j+1), ∂f/∂Γ = λ_0 and ∂f/∂B = Σ_j λ_(j+1) k_jᵀ.
    pub(crate) fn add_slopes(&self, own: &[f64], slopes: &mut [f64]) {
        let (b, gamma) = self.parts(own);
        let n = gamma.len();
        let columns: Vec<DVector<f64>> =
            core::iter::successors(Some(gamma), |k| Some(&b * k)).take(n).collect();
        let Some(cofactors) = cofactors(&columns) else { return slopes.fill(f64::NAN) };
        let (transposed, mut of_b) = (b.transpose(), DMatrix::zeros(n, n));
        let mut adjoint = DVector::zeros(n);
        for j in (0..n).rev() {
            if let Some(column) = columns.get(j) {
                of_b.ger(1.0, &adjoint, column, 1.0);
            }
            adjoint = cofactors.column(j) + &transposed * adjoint;
        }
        self.matrix.pull_back(&of_b.transpose(), slopes);
        let of_gamma = slopes.iter_mut().skip(self.rotations).zip(adjoint.iter());
        of_gamma.for_each(|(slope, own)| *slope += own);
    }

    /// Returns B and Γ.
    fn parts(&self, own: &[f64]) -> (DMatrix<f64>, DVector<f64>) {
        let (x, gamma) = own.split_at(self.rotations.min(own.len()));
        let n = self.matrix.size();
        let gamma = DVector::from_fn(n, |i, _| gamma.get(i).copied().unwrap_or(f64::NAN));
        (self.matrix.at(x).transpose(), gamma)
    }
}

/// Returns the cofactors of a matrix of columns, also of a singular one, or `None` if they are no numbers.
fn cofactors(columns: &[DVector<f64>]) -> Option<DMatrix<f64>> {
    let n = columns.len();
    // The columns grow with powers of B: they are compared by their directions.
    let size = |column: &DVector<f64>| Some(column.norm()).filter(|size| *size > 0.0);
    let sizes: Vec<f64> = columns.iter().map(|column| size(column).unwrap_or(1.0)).collect();
    let scaled: Vec<DVector<f64>> = columns.iter().zip(&sizes).map(|(k, s)| k / *s).collect();
    if scaled.iter().flatten().any(|x| !x.is_finite()) {
        return None;
    }
    let values = DMatrix::from_columns(&scaled).svd(true, true);
    let (u, v_t) = (values.u?, values.v_t?);
    let sign = (u.determinant() * v_t.determinant()).signum();
    let singular = values.singular_values;
    let others = |i: usize| singular.iter().enumerate().filter(move |(j, _)| *j != i);
    let rest = DVector::from_fn(n, |i, _| sign * others(i).map(|(_, s)| *s).product::<f64>());
    let directions = u * DMatrix::from_diagonal(&rest) * v_t;
    let volume = |j: usize| {
        let others = sizes.iter().enumerate().filter(move |(i, _)| *i != j);
        others.map(|(_, s)| *s).product::<f64>()
    };
    Some(DMatrix::from_fn(n, n, |i, j| directions[(i, j)] * volume(j)))
}
