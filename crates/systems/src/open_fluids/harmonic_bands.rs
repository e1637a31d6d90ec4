//! Changes of a matrix that act on each spherical harmonic by itself: [`HarmonicBands`].

use crate::matrix_hydrodynamics::quantised_laplacian::QuantisedLaplacian;
use isospectral_flows::LargeSkewHermitian;
use isospectral_flows::num_complex::Complex;
use std::f64::consts::PI;
use std::sync::Arc;

/// The matrices T_lm of all spherical harmonics, for changes of the coefficients ω_lm of a matrix.
///
/// T_lm fills the diagonal number m, and its entries are symmetric about the middle of the diagonal for even l − m, and
/// antisymmetric for odd l − m. So the first half of them is stored, about N³/6 numbers in all, which clones share.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct HarmonicBands {
    size: usize,
    /// For each m the first halves of T_lm, one l after the other.
    halves: Arc<Vec<Vec<f64>>>,
}

impl HarmonicBands {
    /// Computes the harmonics.
    pub(crate) fn new(laplacian: &QuantisedLaplacian) -> Self {
        let size = laplacian.size();
        let band = |m: usize| {
            let half = (size - m).div_ceil(2);
            (m..size).flat_map(|l| laplacian.harmonic(l, m).into_iter().take(half)).collect()
        };
        Self { size, halves: Arc::new((0..size).map(band).collect()) }
    }

    /// Returns the matrix with the coefficients f(l, m, ω_lm), m ≥ 0, where ω_lm are those of W. It is NaN if W has
    /// another size.
    pub(crate) fn change(
        &self,
        w: &LargeSkewHermitian,
        f: impl Fn(usize, usize, Complex<f64>) -> Complex<f64>,
    ) -> LargeSkewHermitian {
        let n = self.size;
        let mut change = LargeSkewHermitian::zeros(w.size());
        let fits = w.size() == n;
        change.change_upper(|re, im| {
            if !fits {
                return re.fill(f64::NAN);
            }
            let mut fold = Fold::default();
            for (m, halves) in self.halves.iter().enumerate() {
                fold.set(n - m, |j| w.at(j, j + m));
                for (l, harmonic) in (m..).zip(halves.chunks_exact((n - m).div_ceil(2))) {
                    let is_odd = (l - m) % 2;
                    // ω_lm = (4π/N) tr(T_lm* W)/i
                    let sum = fold.product(is_odd, harmonic) * (4.0 * PI / n as f64);
                    let changed = f(l, m, Complex::new(sum.im, -sum.re));
                    fold.add(is_odd, Complex::new(-changed.im, changed.re), harmonic);
                }
                fold.read(n - m, |j, value| {
                    let place = j + n * (j + m);
                    (re[place], im[place]) = (value.re, value.im);
                });
            }
        });
        change
    }
}

/// A diagonal of a matrix, folded at its middle, and a change of it: each the even and the odd part, real and
/// imaginary.
#[derive(Default)]
struct Fold {
    given: [[Vec<f64>; 2]; 2],
    change: [[Vec<f64>; 2]; 2],
}

impl Fold {
    /// Folds a diagonal of so many entries, and clears the change.
    fn set(&mut self, length: usize, entry: impl Fn(usize) -> Complex<f64>) {
        let half = length.div_ceil(2);
        self.change.iter_mut().flatten().for_each(|part| {
            part.clear();
            part.resize(half, 0.0);
        });
        self.given.iter_mut().flatten().for_each(Vec::clear);
        for j in 0..half {
            let (first, last) = (entry(j), entry(length - 1 - j));
            // The entry in the middle is its own mirror image.
            let sum = if 2 * j + 1 == length { first } else { first + last };
            for ([re, im], part) in self.given.iter_mut().zip([sum, first - last]) {
                re.push(part.re);
                im.push(part.im);
            }
        }
    }

    /// Returns the scalar product of the diagonal with a harmonic.
    fn product(&self, is_odd: usize, harmonic: &[f64]) -> Complex<f64> {
        let [re, im] = &self.given[is_odd];
        Complex::new(dot(re, harmonic), dot(im, harmonic))
    }

    /// Adds a multiple of a harmonic to the change.
    fn add(&mut self, is_odd: usize, s: Complex<f64>, harmonic: &[f64]) {
        for (part, s) in self.change[is_odd].iter_mut().zip([s.re, s.im]) {
            part.iter_mut().zip(harmonic).for_each(|(x, t)| *x += s * t);
        }
    }

    /// Writes the entries of the change.
    fn read(&self, length: usize, mut write: impl FnMut(usize, Complex<f64>)) {
        let [[even_re, even_im], [odd_re, odd_im]] = &self.change;
        let even = even_re.iter().zip(even_im).map(|(re, im)| Complex::new(*re, *im));
        let odd = odd_re.iter().zip(odd_im).map(|(re, im)| Complex::new(*re, *im));
        for (j, (even, odd)) in even.zip(odd).enumerate() {
            write(length - 1 - j, even - odd);
            // An odd harmonic is zero in the middle.
            write(j, even + odd);
        }
    }
}

/// Returns Σ_j x_j y_j, in eight sums, which the processor forms at once.
fn dot(x: &[f64], y: &[f64]) -> f64 {
    let ((x, x_rest), (y, y_rest)) = (x.as_chunks::<8>(), y.as_chunks::<8>());
    let mut sums = [0.0; 8];
    for (x, y) in x.iter().zip(y) {
        sums.iter_mut().zip(x.iter().zip(y)).for_each(|(sum, (x, y))| *sum += x * y);
    }
    let rest: f64 = x_rest.iter().zip(y_rest).map(|(x, y)| x * y).sum();
    sums.iter().sum::<f64>() + rest
}
