//! The elements of u(N), with N known when the program runs: [`LargeSkewHermitian`].

use crate::matrices::large_matrix::LargeMatrix;
use crate::matrices::tiles::{for_pairs, mirror};
use lie_poisson::State;
use num_complex::Complex;

/// An element W of u(N), a complex N×N matrix with W* = −W, with a number N that is known only when the program runs.
///
/// Its coordinates are the real parts below the diagonal and the imaginary parts on and above it: N² numbers. The
/// condition W* = −W holds exactly, whatever the integrator.
///
/// # Example
/// ```
/// use isospectral_flows::LargeSkewHermitian;
/// use num_complex::Complex;
/// // The entries on and above the diagonal determine the others.
/// let w = LargeSkewHermitian::from_upper(3, |j, k| Complex::new((k - j) as f64, 1.0));
/// assert_eq!(w.at(0, 2), Complex::new(2.0, 1.0));
/// assert_eq!(w.at(2, 0), -w.at(0, 2).conj());
/// assert_eq!(w.trace(), 3.0);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LargeSkewHermitian(LargeMatrix);

impl LargeSkewHermitian {
    /// Creates the zero matrix of size N.
    #[must_use]
    pub fn zeros(size: usize) -> Self {
        Self(LargeMatrix::zeros(size))
    }

    /// Creates the matrix with the entry f(j, k) in row j and column k, for j ≤ k. On the diagonal the real part of f
    /// is dropped.
    #[must_use]
    pub fn from_upper(size: usize, f: impl Fn(usize, usize) -> Complex<f64>) -> Self {
        Self(LargeMatrix::from_fn(size, |j, k| match j.cmp(&k) {
            core::cmp::Ordering::Less => f(j, k),
            core::cmp::Ordering::Equal => Complex::new(0.0, f(j, j).im),
            core::cmp::Ordering::Greater => -f(k, j).conj(),
        }))
    }

    /// Returns the part (Z − Z*)/2 of a matrix.
    #[must_use]
    pub fn part_of(z: &LargeMatrix) -> Self {
        let mut part = Self::zeros(z.size());
        part.set_part_of(z);
        part
    }

    /// Replaces the matrix by (Z − Z*)/2, with the size of Z.
    pub fn set_part_of(&mut self, z: &LargeMatrix) {
        self.set_difference_of(z);
        self.0.scale_in_place(0.5);
    }

    /// Replaces the matrix by Z − Z*, with the size of Z.
    pub fn set_difference_of(&mut self, z: &LargeMatrix) {
        let n = z.size();
        if self.size() != n {
            self.0 = LargeMatrix::zeros(n);
        }
        let (re, im) = self.0.parts_mut();
        for_pairs(n, [z.real(), z.imaginary()], [re, im], |[a, b], [c, d]| {
            ([a - c, b + d], [c - a, b + d])
        });
    }

    /// Returns the real and the imaginary parts, column by column, to be changed by functions that keep W* = −W.
    pub(crate) fn parts_mut(&mut self) -> (&mut [f64], &mut [f64]) {
        self.0.parts_mut()
    }

    /// Returns the entries as a complex matrix.
    #[must_use]
    pub fn matrix(&self) -> &LargeMatrix {
        &self.0
    }

    /// Changes the entries on and above the diagonal, which determine the others.
    ///
    /// The function receives the real and the imaginary parts, column by column: the entry in row j and column k has
    /// the index j + N k. Whatever the function writes below the diagonal, and to the real parts on it, is replaced.
    ///
    /// # Example
    /// ```
    /// use isospectral_flows::LargeSkewHermitian;
    /// let mut w = LargeSkewHermitian::zeros(2);
    /// w.change_upper(|re, im| (re[2], im[0]) = (3.0, 1.0));
    /// assert_eq!((w.at(0, 1).re, w.at(1, 0).re, w.at(0, 0).im), (3.0, -3.0, 1.0));
    /// ```
    pub fn change_upper(&mut self, f: impl FnOnce(&mut [f64], &mut [f64])) {
        let n = self.size();
        let (re, im) = self.0.parts_mut();
        f(re, im);
        mirror(re, -1.0, n);
        mirror(im, 1.0, n);
        (0..n).for_each(|j| re[j + n * j] = 0.0);
    }

    /// Returns the size N.
    #[must_use]
    pub fn size(&self) -> usize {
        self.0.size()
    }

    /// Returns the entry in row j and column k, or 0 outside of the matrix.
    #[must_use]
    pub fn at(&self, j: usize, k: usize) -> Complex<f64> {
        self.0.at(j, k)
    }

    /// Returns the imaginary part of the trace. The real part is zero.
    #[must_use]
    pub fn trace(&self) -> f64 {
        (0..self.size()).map(|j| self.at(j, j).im).sum()
    }

    /// Returns the scalar product −tr(V W) = Σ_jk Re(v_jk* w_jk), or NaN if the sizes differ.
    ///
    /// # Example
    /// ```
    /// use isospectral_flows::LargeSkewHermitian;
    /// use num_complex::Complex;
    /// let v = LargeSkewHermitian::from_upper(2, |_, _| Complex::I);
    /// assert_eq!(v.scalar_product(&v), 4.0);
    /// ```
    #[must_use]
    pub fn scalar_product(&self, other: &Self) -> f64 {
        if self.size() != other.size() {
            return f64::NAN;
        }
        let sum = |v: &[f64], w: &[f64]| v.iter().zip(w).map(|(v, w)| v * w).sum::<f64>();
        sum(self.0.real(), other.0.real()) + sum(self.0.imaginary(), other.0.imaginary())
    }

    /// Returns the Frobenius norm √(Σ |W_jk|²) = √(−tr W²).
    #[must_use]
    pub fn norm(&self) -> f64 {
        self.0.norm()
    }

    /// Returns the row and the column of a coordinate.
    fn place(&self, i: usize) -> (usize, usize) {
        let n = self.size().max(1);
        (i % n, i / n)
    }
}

impl State for LargeSkewHermitian {
    type Scalar = f64;
    type Blocks = (f64,);
    /// The size N of the matrix.
    type Shape = usize;
    type Pool = Vec<Self>;

    fn dimension(&self) -> usize {
        self.size() * self.size()
    }

    fn shape(&self) -> usize {
        self.size()
    }

    fn zeros_of(size: &usize) -> Self {
        Self::zeros(*size)
    }

    fn take(pool: &mut Vec<Self>, like: &Self) -> Self {
        pool.pop().filter(|last| last.same_shape(like)).unwrap_or_else(|| like.zeros_like())
    }

    fn give(self, pool: &mut Vec<Self>) {
        pool.push(self);
    }

    fn assign(&mut self, x: &Self) {
        self.0.assign(&x.0);
    }

    fn coordinate(&self, i: usize) -> f64 {
        let (j, k) = self.place(i);
        let entry = self.at(j, k);
        if j > k { entry.re } else { entry.im }
    }

    fn set_coordinate(&mut self, i: usize, x: f64) {
        let (j, k) = self.place(i);
        let old = self.at(j, k);
        let new = if j > k { Complex::new(x, old.im) } else { Complex::new(old.re, x) };
        self.0.set(j, k, new);
        if j != k {
            self.0.set(k, j, -new.conj());
        }
    }

    fn set_zero(&mut self) {
        self.0.set_zero();
    }

    fn subtract_from(&mut self, x: &Self) {
        self.0.subtract_from(&x.0);
    }

    fn scale_in_place(&mut self, s: f64) {
        self.0.scale_in_place(s);
    }

    fn add_multiple(&mut self, s: f64, x: &Self) {
        self.0.add_multiple(s, &x.0);
    }

    fn add_combination(&mut self, a: &[f64], k: &[Self]) {
        self.0.add_terms(a.iter().copied().zip(k.iter().map(Self::matrix)));
    }

    fn measure(&self, largest: &mut (f64,), sum: &mut f64) {
        self.0.measure(largest, sum);
    }

    fn measure_difference(&self, x: &Self, largest: &mut (f64,), sum: &mut f64) {
        self.0.measure_difference(&x.0, largest, sum);
    }
}
