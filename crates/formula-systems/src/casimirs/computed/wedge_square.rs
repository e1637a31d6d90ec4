//! Squares of the wedge products of a vector and a 2-form: [`WedgeSquare`].

use super::pfaffian_of_numbers::{pfaffian, pfaffian_slopes};
use crate::casimirs::motions::wedge_product::WedgeProduct;
use nalgebra::{DMatrix, DVector};
use std::sync::Arc;

/// An invariant of Γ and L in so(p, q) ⋉ Rⁿ, whose coordinates are L_ij, i < j, and then Γ_i.
///
/// The components of Γ ∧ L^∧k are k! times Pfaffians of the bordered matrix B = [0 Γᵀ; −Γ L], and the squares of these are
/// principal minors of [0 Γᵀ; −ηΓ A], A = ηL, with the row 0. Their sum is a coefficient of the bordered determinant:
///
/// ```text
/// |Γ ∧ L^∧k|² = (k!)² Γᵀ A_2k ηΓ,    adj(t + A) = Σ_j t^(n−1−j) A_j,    A_j = e_j(A) − A A_(j−1)
/// ```
///
/// with the sums e_j of the principal minors of A. Those of odd j are 0. The recurrence loses digits for large k: two or three of
/// them in 12 dimensions, and up to half of them in 22.
///
/// Source: F. R. Gantmacher, *The Theory of Matrices* I (1959), ch. IV §5, for the recurrence of Faddeev.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct WedgeSquare {
    pub(crate) form: Arc<[f64]>,
    pub(crate) product: WedgeProduct,
}

impl WedgeSquare {
    /// Returns the value.
    pub(crate) fn value(&self, own: &[f64]) -> f64 {
        match self.product {
            WedgeProduct::Top(k) => factorial(k) * pfaffian(&self.bordered(own)),
            WedgeProduct::Square(k) => {
                let (gamma, a) = (self.vector(own), self.rotation(own));
                let (adjugates, _) = self.adjugates(&a, 2 * k);
                let last =
                    adjugates.last().map_or(0.0, |last| gamma.dot(&(last * self.raised(&gamma))));
                factorial(k).powi(2) * last
            }
        }
    }

    /// Adds the derivatives to slopes.
    pub(crate) fn add_slopes(&self, own: &[f64], slopes: &mut [f64]) {
        match self.product {
            WedgeProduct::Top(k) => {
                let of_bordered = pfaffian_slopes(&self.bordered(own)) * factorial(k);
                self.add(slopes, |i, j| of_bordered[(i + 1, j + 1)], |i| of_bordered[(0, i + 1)]);
            }
            WedgeProduct::Square(k) => self.add_slopes_of_square(k, own, slopes),
        }
    }

    /// With u = Γ, v = ηΓ the value is (k!)² Σ_i e_(2k−2i) uᵀA²ⁱv, where de_j = tr(A_(j−1) dA) and
    /// d(uᵀAᵐv) = Σ_s uᵀAˢ dA A^(m−1−s)v.
    fn add_slopes_of_square(&self, k: usize, own: &[f64], slopes: &mut [f64]) {
        let n = self.form.len();
        let (gamma, a) = (self.vector(own), self.rotation(own));
        let (adjugates, minors) = self.adjugates(&a, 2 * k);
        let transposed = a.transpose();
        let images = |matrix: &DMatrix<f64>, of: DVector<f64>| -> Vec<DVector<f64>> {
            core::iter::successors(Some(of), |v| Some(matrix * v)).take(2 * k + 1).collect()
        };
        let (left, right) = (images(&transposed, gamma.clone()), images(&a, self.raised(&gamma)));
        let mut of_a = DMatrix::zeros(n, n);
        for (i, image) in right.iter().step_by(2).enumerate() {
            let minor = minors.get(2 * k - 2 * i).copied().unwrap_or(0.0);
            for (s, left) in left.iter().take(2 * i).enumerate() {
                if let Some(right) = right.get(2 * i - 1 - s) {
                    of_a.ger(minor, left, right, 1.0);
                }
            }
            if let Some(before) = (2 * k - 2 * i).checked_sub(1).and_then(|j| adjugates.get(j)) {
                of_a += before.transpose() * gamma.dot(image);
            }
        }
        let factor = factorial(k).powi(2);
        let of_gamma = adjugates.last().map(|last| last * self.raised(&gamma) * (2.0 * factor));
        self.add(
            slopes,
            |i, j| factor * (self.sign(i) * of_a[(i, j)] - self.sign(j) * of_a[(j, i)]),
            |i| of_gamma.as_ref().map_or(0.0, |slopes| slopes[i]),
        );
    }

    /// Adds derivatives with respect to L_ij and to Γ_i to slopes.
    fn add(
        &self,
        slopes: &mut [f64],
        of_rotation: impl Fn(usize, usize) -> f64,
        of_vector: impl Fn(usize) -> f64,
    ) {
        let n = self.form.len();
        let rotations = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
        let all = rotations.map(|(i, j)| of_rotation(i, j)).chain((0..n).map(of_vector));
        slopes.iter_mut().zip(all).for_each(|(slope, own)| *slope += own);
    }

    /// Returns the matrices A_j up to j = `last`, and the sums e_j of principal minors.
    fn adjugates(&self, a: &DMatrix<f64>, last: usize) -> (Vec<DMatrix<f64>>, Vec<f64>) {
        let n = self.form.len();
        let (mut adjugates, mut minors) = (vec![DMatrix::identity(n, n)], vec![1.0]);
        while let Some(before) = adjugates.last().filter(|_| adjugates.len() <= last) {
            let j = adjugates.len();
            let product = a * before;
            let minor = if j.is_multiple_of(2) { product.trace() / j as f64 } else { 0.0 };
            minors.push(minor);
            adjugates.push(DMatrix::identity(n, n) * minor - product);
        }
        (adjugates, minors)
    }

    /// Returns A = ηL.
    fn rotation(&self, own: &[f64]) -> DMatrix<f64> {
        let n = self.form.len();
        let l = |i: usize, j: usize| own.get(i * (2 * n - i - 1) / 2 + j - i - 1);
        DMatrix::from_fn(n, n, |i, j| {
            let entry = match i.cmp(&j) {
                core::cmp::Ordering::Less => l(i, j).copied(),
                core::cmp::Ordering::Equal => Some(0.0),
                core::cmp::Ordering::Greater => l(j, i).map(|x| -x),
            };
            self.sign(i) * entry.unwrap_or(f64::NAN)
        })
    }

    /// Returns Γ.
    fn vector(&self, own: &[f64]) -> DVector<f64> {
        let n = self.form.len();
        let first = n * n.saturating_sub(1) / 2;
        DVector::from_fn(n, |i, _| own.get(first + i).copied().unwrap_or(f64::NAN))
    }

    /// Returns ηΓ.
    fn raised(&self, gamma: &DVector<f64>) -> DVector<f64> {
        DVector::from_fn(gamma.len(), |i, _| self.sign(i) * gamma[i])
    }

    /// Returns the bordered matrix.
    fn bordered(&self, own: &[f64]) -> DMatrix<f64> {
        let n = self.form.len();
        let (gamma, a) = (self.vector(own), self.rotation(own));
        DMatrix::from_fn(n + 1, n + 1, |i, j| match (i.checked_sub(1), j.checked_sub(1)) {
            (None, None) => 0.0,
            (None, Some(j)) => gamma[j],
            (Some(i), None) => -gamma[i],
            (Some(i), Some(j)) => self.sign(i) * a[(i, j)],
        })
    }

    fn sign(&self, place: usize) -> f64 {
        self.form.get(place).copied().unwrap_or(1.0)
    }
}

/// Returns k!.
fn factorial(k: usize) -> f64 {
    (1..=k).map(|i| i as f64).product()
}
