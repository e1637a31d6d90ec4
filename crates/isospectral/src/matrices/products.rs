//! Products of complex matrices of any size: [`Products`].

use crate::matrices::large_matrix::LargeMatrix;
use crate::matrices::real_product::{Right, real_product};
use crate::matrices::skew_hermitian::LargeSkewHermitian;
use crate::matrices::tiles::{for_pairs, mirror};
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
/// sizes of A and B differ, the product has the size of A and is NaN, so that a step fails.
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
    /// The size of the last product.
    size: usize,
    /// Re A + Im A and Re B + Im B.
    left: Vec<f64>,
    right: Vec<f64>,
    /// The three real products.
    first: Vec<f64>,
    second: Vec<f64>,
    third: Vec<f64>,
    /// The temporary matrices that can be used again.
    pool: Vec<LargeMatrix>,
}

impl Products {
    /// Writes the product A B of two matrices of one size. If the sizes differ, the product is NaN.
    pub fn multiply(&mut self, a: &LargeMatrix, b: &LargeMatrix, product: &mut LargeMatrix) {
        let n = a.size();
        self.real_products(a, b, 1.0, |left, right, product, alpha| {
            real_product(n, (n, 0..n), product, (alpha, left, Right::Plain(right)));
        });
        self.write(product);
    }

    /// Writes the product A B* of two matrices of one size. If the sizes differ, the product is NaN.
    pub fn multiply_adjoint(
        &mut self,
        a: &LargeMatrix,
        b: &LargeMatrix,
        product: &mut LargeMatrix,
    ) {
        let n = a.size();
        self.real_products(a, b, -1.0, |left, right, product, alpha| {
            real_product(n, (n, 0..n), product, (alpha, left, Right::Transposed(right)));
        });
        self.write(product);
    }

    /// Writes A B for matrices whose product is Hermitian, such as commuting Hermitian matrices, or two powers of one
    /// skew-Hermitian matrix with an even sum of exponents.
    ///
    /// Only the upper half and a little more are computed, in panels of several columns.
    pub fn multiply_hermitian(
        &mut self,
        a: &LargeMatrix,
        b: &LargeMatrix,
        product: &mut LargeMatrix,
    ) {
        let n = a.size();
        self.real_products(a, b, 1.0, |left, right, product, alpha| {
            for first in (0..n).step_by(n.div_ceil(PANELS).max(LEAST_PANEL)) {
                let end = (first + n.div_ceil(PANELS).max(LEAST_PANEL)).min(n);
                let panel = (end, first..end);
                real_product(n, panel, product, (alpha, left, Right::Plain(right)));
            }
        });
        let n = self.write(product);
        let (re, im) = product.parts_mut();
        (0..n).for_each(|k| im[k + n * k] = 0.0);
        mirror(re, 1.0, n);
        mirror(im, -1.0, n);
    }

    /// Writes the commutator [A, B] = A B − B A of skew-Hermitian matrices, by one product: B A = (A B)*.
    pub fn commutator(
        &mut self,
        a: &LargeSkewHermitian,
        b: &LargeSkewHermitian,
        commutator: &mut LargeSkewHermitian,
    ) {
        let n = a.size();
        self.real_products(a.matrix(), b.matrix(), 1.0, |left, right, product, alpha| {
            real_product(n, (n, 0..n), product, (alpha, left, Right::Plain(right)));
        });
        if commutator.size() != n {
            *commutator = LargeSkewHermitian::zeros(n);
        }
        let (re, im) = commutator.parts_mut();
        let parts = [self.first.as_slice(), &self.second, &self.third];
        for_pairs(n, parts, [re, im], |[a, b, c], [d, e, f]| {
            let (re, im) = ((a - b) - (d - e), (c - (a + b)) + (f - (d + e)));
            ([re, im], [-re, im])
        });
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
        let [mut x, mut second] = [(); 2].map(|()| self.take(z));
        self.multiply(z, w.matrix(), &mut x);
        self.multiply_adjoint(&x, z, &mut second);
        // X Z* is skew-Hermitian: the difference contains it twice.
        x.add_multiple(0.5, &second);
        conjugated.set_difference_of(&x);
        conjugated.add_in_place(w);
        self.give(x);
        self.give(second);
    }

    /// Takes a matrix of the size of `like` from the temporary storage. Its entries are arbitrary.
    pub(crate) fn take(&mut self, like: &LargeMatrix) -> LargeMatrix {
        LargeMatrix::take(&mut self.pool, like)
    }

    /// Gives a matrix back to the temporary storage.
    pub(crate) fn give(&mut self, matrix: LargeMatrix) {
        self.pool.push(matrix);
    }

    /// Computes the three real products of A and B, or of A and the complex conjugate of B for the sign −1.
    ///
    /// The closure writes α left·right, or α left·rightᵀ.
    fn real_products(
        &mut self,
        a: &LargeMatrix,
        b: &LargeMatrix,
        sign: f64,
        multiply: impl Fn(&[f64], &[f64], &mut [f64], f64),
    ) {
        let n = a.size();
        self.size = n;
        for storage in [&mut self.first, &mut self.second, &mut self.third] {
            storage.resize(n * n, 0.0);
        }
        if b.size() != n {
            return self.first.fill(f64::NAN);
        }
        set_sum(&mut self.left, a.real(), 1.0, a.imaginary());
        set_sum(&mut self.right, b.real(), sign, b.imaginary());
        for (left, right, product, alpha) in [
            (a.real(), b.real(), &mut self.first, 1.0),
            (a.imaginary(), b.imaginary(), &mut self.second, sign),
            (&self.left, &self.right, &mut self.third, 1.0),
        ] {
            multiply(left, right, product, alpha);
        }
    }

    /// Writes the complex product of the three real ones. Returns its size.
    fn write(&self, product: &mut LargeMatrix) -> usize {
        if product.size() != self.size {
            *product = LargeMatrix::zeros(self.size);
        }
        let (re, im) = product.parts_mut();
        let terms = self.first.iter().zip(&self.second).zip(&self.third);
        for ((re, im), ((first, second), third)) in re.iter_mut().zip(im).zip(terms) {
            *re = first - second;
            *im = third - (first + second);
        }
        self.size
    }
}

/// The number of panels of a Hermitian product, and the least number of columns of a panel.
const PANELS: usize = 8;
const LEAST_PANEL: usize = 24;

/// Writes x + s y.
fn set_sum(sum: &mut Vec<f64>, x: &[f64], s: f64, y: &[f64]) {
    sum.clear();
    sum.extend(x.iter().zip(y).map(|(x, y)| x + s * y));
}
