//! Products of complex matrices of any size: [`Products`].

use crate::matrices::large_matrix::LargeMatrix;
use crate::matrices::skew_hermitian::LargeSkewHermitian;
use faer::linalg::matmul::{matmul, triangular};
use faer::{Accum, MatMut, MatRef, Par};
use lie_poisson::State;

/// Products of complex matrices, with their temporary storage.
///
/// A complex product is computed by three real ones:
///
/// ```text
/// T₁ = Re A Re B,   T₂ = Im A Im B,   T₃ = (Re A + Im A)(Re B + Im B)
/// Re AB = T₁ − T₂,   Im AB = T₃ − T₁ − T₂
/// ```
///
/// Its error is of the size of round-off relative to |A| |B|, although not relative to each part by itself. If the
/// sizes of A and B differ, the product is NaN of the size of A, so that a step fails.
///
/// Source: Higham, *Stability of a method for multiplying complex matrices with three real matrix multiplications*,
/// SIAM J. Matrix Anal. Appl. 13 (1992).
///
/// # Example
/// ```
/// use isospectral_flows::{LargeMatrix, Products};
/// use num_complex::Complex;
/// let a = LargeMatrix::from_fn(2, |j, k| Complex::new(j as f64, k as f64));
/// let mut square = LargeMatrix::zeros(2);
/// Products::default().multiply(&a, &a, &mut square);
/// assert_eq!(square.at(1, 0), a.at(1, 0) * a.at(0, 0) + a.at(1, 1) * a.at(1, 0));
/// ```
#[derive(Clone, Debug, Default)]
pub struct Products {
    /// Re A + Im A, Re B + Im B, and one of the three products.
    left: Vec<f64>,
    right: Vec<f64>,
    third: Vec<f64>,
    /// Temporary matrices.
    pool: Vec<LargeMatrix>,
}

impl Products {
    /// Writes A B.
    pub fn multiply(&mut self, a: &LargeMatrix, b: &LargeMatrix, product: &mut LargeMatrix) {
        self.multiply_by(a, b, product, |left, right, sum, n| {
            let [left, right] = [left, right].map(|x| MatRef::from_column_major_slice(x, n, n));
            let sum = MatMut::from_column_major_slice_mut(sum, n, n);
            matmul(sum, Accum::Replace, left, right, 1.0, Par::Seq);
        });
    }

    /// Writes A B for matrices whose product is Hermitian, such as commuting Hermitian matrices, or two powers of one
    /// skew-Hermitian matrix with an even sum of exponents.
    ///
    /// Only the lower half is computed.
    pub fn multiply_hermitian(
        &mut self,
        a: &LargeMatrix,
        b: &LargeMatrix,
        product: &mut LargeMatrix,
    ) {
        self.multiply_by(a, b, product, |left, right, sum, n| {
            use triangular::BlockStructure::{Rectangular, TriangularLower};
            let [left, right] = [left, right].map(|x| MatRef::from_column_major_slice(x, n, n));
            let sum = MatMut::from_column_major_slice_mut(sum, n, n);
            triangular::matmul(
                sum,
                TriangularLower,
                Accum::Replace,
                left,
                Rectangular,
                right,
                Rectangular,
                1.0,
                Par::Seq,
            );
        });
        let n = product.size();
        let (re, im) = product.parts_mut();
        for k in 0..n {
            im[k + n * k] = 0.0;
        }
        mirror_lower(re, 1.0, n);
        mirror_lower(im, -1.0, n);
    }

    /// Writes the commutator [A, B] = A B − B A of skew-Hermitian matrices, by one product: B A = (A B)*.
    pub fn commutator(
        &mut self,
        a: &LargeSkewHermitian,
        b: &LargeSkewHermitian,
        commutator: &mut LargeSkewHermitian,
    ) {
        let mut whole = self.take(a.matrix());
        self.multiply(a.matrix(), b.matrix(), &mut whole);
        commutator.set_difference_of(&whole);
        self.give(whole);
    }

    /// Writes W₁ = (1 + Z) W (1 + Z)*, which has the spectrum of W if 1 + Z is unitary.
    ///
    /// It is computed as W + X − X* + X Z* with X = Z W, so that a small Z adds small rounding errors.
    pub fn conjugate(
        &mut self,
        z: &LargeMatrix,
        w: &LargeSkewHermitian,
        conjugated: &mut LargeSkewHermitian,
    ) {
        self.change_of_conjugate(z, w, conjugated);
        conjugated.add_in_place(w);
    }

    /// Writes the change (1 + Z) W (1 + Z)* − W.
    pub fn change_of_conjugate(
        &mut self,
        z: &LargeMatrix,
        w: &LargeSkewHermitian,
        change: &mut LargeSkewHermitian,
    ) {
        let [mut x, mut adjoint, mut second] = [(); 3].map(|()| self.take(z));
        self.multiply(z, w.matrix(), &mut x);
        adjoint.set_zero();
        adjoint.add_adjoint(1.0, z);
        self.multiply(&x, &adjoint, &mut second);
        // X Z* is skew-Hermitian: the difference contains it twice.
        x.add_multiple(0.5, &second);
        change.set_difference_of(&x);
        [x, adjoint, second].into_iter().for_each(|temporary| self.give(temporary));
    }

    /// Takes a matrix of the size of `like` from the temporary storage. Its entries are arbitrary.
    pub(crate) fn take(&mut self, like: &LargeMatrix) -> LargeMatrix {
        LargeMatrix::take(&mut self.pool, like)
    }

    /// Gives a matrix back to the temporary storage.
    pub(crate) fn give(&mut self, matrix: LargeMatrix) {
        self.pool.push(matrix);
    }

    /// Computes a product by three real ones, for which `multiply`(left, right, product, N) writes left·right.
    fn multiply_by(
        &mut self,
        a: &LargeMatrix,
        b: &LargeMatrix,
        product: &mut LargeMatrix,
        multiply: impl Fn(&[f64], &[f64], &mut [f64], usize),
    ) {
        let n = a.size();
        if !product.same_shape(a) {
            *product = a.zeros_like();
        }
        let (re, im) = product.parts_mut();
        if b.size() != n {
            re.fill(f64::NAN);
            return im.fill(f64::NAN);
        }
        set_sum(&mut self.left, a.real(), a.imaginary());
        set_sum(&mut self.right, b.real(), b.imaginary());
        self.third.resize(n * n, 0.0);
        multiply(&self.left, &self.right, im, n);
        multiply(a.real(), b.real(), re, n);
        multiply(a.imaginary(), b.imaginary(), &mut self.third, n);
        for ((re, im), third) in re.iter_mut().zip(im.iter_mut()).zip(&self.third) {
            *im -= *re + third;
            *re -= third;
        }
    }
}

/// Writes x + y.
fn set_sum(sum: &mut Vec<f64>, x: &[f64], y: &[f64]) {
    sum.clear();
    sum.extend(x.iter().zip(y).map(|(x, y)| x + y));
}

/// Sets the entries above the diagonal of a real matrix to `sign` times those below.
fn mirror_lower(x: &mut [f64], sign: f64, n: usize) {
    for k in 0..n {
        for j in 0..k {
            x[j + n * k] = sign * x[k + n * j];
        }
    }
}
