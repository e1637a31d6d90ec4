//! Complex matrices of a size that is known when the program runs: [`LargeMatrix`].

use lie_poisson::{State, larger};
use num_complex::Complex;

/// A complex N×N matrix, with a number N that is known only when the program runs.
///
/// The real and the imaginary parts are stored one after the other, column by column. Entries outside the matrix read
/// as zero, and setting them has no effect.
///
/// # Example
/// ```
/// use isospectral_flows::LargeMatrix;
/// use num_complex::Complex;
/// let mut z = LargeMatrix::from_fn(3, |j, k| Complex::new(j as f64, k as f64));
/// assert_eq!(z.at(2, 1), Complex::new(2.0, 1.0));
/// z.set(2, 1, Complex::new(5.0, 0.0));
/// assert_eq!(z.real()[2 + 3], 5.0);
/// assert_eq!(z.at(3, 0), Complex::ZERO);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LargeMatrix {
    size: usize,
    entries: Vec<f64>,
}

impl LargeMatrix {
    /// Creates the zero matrix of size N.
    ///
    /// # Panics
    /// Panics, as a vector does, if the matrix is larger than any memory can be.
    #[must_use]
    pub fn zeros(size: usize) -> Self {
        // A size beyond the memory fails as that of any vector does.
        Self { size, entries: vec![0.0; size.saturating_mul(size).saturating_mul(2)] }
    }

    /// Creates the matrix of size N with the entry f(j, k) in row j and column k.
    #[must_use]
    pub fn from_fn(size: usize, f: impl Fn(usize, usize) -> Complex<f64>) -> Self {
        let mut matrix = Self::zeros(size);
        for (k, j) in (0..size).flat_map(|k| (0..size).map(move |j| (k, j))) {
            matrix.set(j, k, f(j, k));
        }
        matrix
    }

    /// Returns the size N.
    #[must_use]
    pub fn size(&self) -> usize {
        self.size
    }

    /// Returns the entry in row j and column k, or 0 outside of the matrix.
    #[must_use]
    pub fn at(&self, j: usize, k: usize) -> Complex<f64> {
        let n = self.size;
        if j >= n || k >= n {
            return Complex::ZERO;
        }
        Complex::new(self.entries[j + n * k], self.entries[n * n + j + n * k])
    }

    /// Sets the entry in row j and column k. Does nothing outside of the matrix.
    pub fn set(&mut self, j: usize, k: usize, z: Complex<f64>) {
        let n = self.size;
        if j < n && k < n {
            self.entries[j + n * k] = z.re;
            self.entries[n * n + j + n * k] = z.im;
        }
    }

    /// Returns the real parts, column by column.
    #[must_use]
    pub fn real(&self) -> &[f64] {
        &self.entries[..self.size * self.size]
    }

    /// Returns the imaginary parts, column by column.
    #[must_use]
    pub fn imaginary(&self) -> &[f64] {
        &self.entries[self.size * self.size..]
    }

    /// Returns the real and the imaginary parts, column by column, for changes.
    pub fn parts_mut(&mut self) -> (&mut [f64], &mut [f64]) {
        self.entries.split_at_mut(self.size * self.size)
    }

    /// Returns the Frobenius norm (Σ |z_jk|²)^½, without overflow or underflow of the squares.
    #[must_use]
    pub fn norm(&self) -> f64 {
        let largest = self.entries.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        if largest == 0.0 || !largest.is_finite() {
            // The sum keeps a NaN, which the maximum loses.
            return self.entries.iter().map(|x| x.abs()).sum();
        }
        largest * self.entries.iter().map(|x| (x / largest).powi(2)).sum::<f64>().sqrt()
    }

    /// Returns the largest sum of |Re z_jk| + |Im z_jk| over a column, a bound on the spectral radius. It is NaN if an
    /// entry is NaN.
    #[must_use]
    pub fn column_norm(&self) -> f64 {
        let n = self.size.max(1);
        let sum = |column: &[f64]| column.iter().map(|x| x.abs()).sum::<f64>();
        let columns = self.real().chunks_exact(n).zip(self.imaginary().chunks_exact(n));
        columns.map(|(re, im)| sum(re) + sum(im)).fold(0.0, larger)
    }

    /// Returns the conjugate transpose Z*.
    #[must_use]
    pub fn adjoint(&self) -> Self {
        Self::from_fn(self.size, |j, k| self.at(k, j).conj())
    }
}

impl State for LargeMatrix {
    type Scalar = f64;
    type Blocks = (f64,);
    /// The size N of the matrix.
    type Shape = usize;
    type Pool = Vec<Self>;

    fn dimension(&self) -> usize {
        self.entries.len()
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
        self.size = x.size;
        self.entries.clone_from(&x.entries);
    }

    fn coordinate(&self, i: usize) -> f64 {
        self.entries.get(i).copied().unwrap_or(0.0)
    }

    fn set_coordinate(&mut self, i: usize, x: f64) {
        if let Some(entry) = self.entries.get_mut(i) {
            *entry = x;
        }
    }

    fn set_zero(&mut self) {
        self.entries.fill(0.0);
    }

    fn subtract_from(&mut self, x: &Self) {
        self.entries.iter_mut().zip(&x.entries).for_each(|(v, x)| *v = x - *v);
    }

    fn scale_in_place(&mut self, s: f64) {
        self.entries.iter_mut().for_each(|v| *v *= s);
    }

    fn add_multiple(&mut self, s: f64, x: &Self) {
        self.entries.iter_mut().zip(&x.entries).for_each(|(v, x)| *v += s * x);
    }

    /// Adds all terms to one part of the matrix before it goes to the next, so that the sum passes through memory once.
    fn add_combination(&mut self, a: &[f64], k: &[Self]) {
        self.add_terms(a.iter().copied().zip(k));
    }

    fn measure(&self, largest: &mut (f64,), sum: &mut f64) {
        for x in &self.entries {
            include(x.abs(), largest, sum);
        }
    }

    fn measure_difference(&self, x: &Self, largest: &mut (f64,), sum: &mut f64) {
        for (v, x) in self.entries.iter().zip(&x.entries) {
            include((v - x).abs(), largest, sum);
        }
    }
}

impl LargeMatrix {
    /// Adds a linear combination, part by part.
    pub(crate) fn add_terms<'a>(&mut self, terms: impl Iterator<Item = (f64, &'a Self)> + Clone) {
        for (part, sum) in self.entries.chunks_mut(PART).enumerate() {
            for (a, k) in terms.clone().filter(|(a, _)| *a != 0.0) {
                let entries = k.entries.get(part * PART..).unwrap_or_default();
                sum.iter_mut().zip(entries).for_each(|(v, x)| *v += a * x);
            }
        }
    }
}

/// The number of entries that are summed at a time, which fit into the first cache.
const PART: usize = 1024;

#[cfg_attr(optimised, inline(always))]
fn include(size: f64, largest: &mut (f64,), sum: &mut f64) {
    largest.0 = if size > largest.0 { size } else { largest.0 };
    *sum += size;
}
