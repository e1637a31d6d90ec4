//! Equations and matrices for the tests.

use isospectral_flows::{IsospectralField, LargeSkewHermitian};
use num_complex::Complex;

/// A quadratic Hamiltonian without a symmetry: B_jk = W_jk/(1 + jk + 3(j + k)/10).
#[derive(Clone, Debug)]
pub struct Quadratic(pub usize);

impl Quadratic {
    /// Returns the positive factor of an entry, symmetric in j and k.
    pub fn factor(j: usize, k: usize) -> f64 {
        1.0 / (1.0 + j as f64 * k as f64 + 0.3 * (j + k) as f64)
    }
}

impl IsospectralField for Quadratic {
    fn size(&self) -> usize {
        self.0
    }

    fn generator_into(&self, w: &LargeSkewHermitian, b: &mut LargeSkewHermitian) {
        b.change_upper(|re, im| {
            for i in 0..self.0 * self.0 {
                let (j, k) = (i % self.0, i / self.0);
                let value = w.at(j, k) * Self::factor(j, k);
                (re[i], im[i]) = (value.re, value.im);
            }
        });
    }
}

/// Returns a skew-Hermitian matrix whose entries look random.
pub fn generic(size: usize, seed: f64) -> LargeSkewHermitian {
    let entry = |x: f64| (12.9898 * x + seed).sin();
    LargeSkewHermitian::from_upper(size, |j, k| {
        let x = (j * size + k) as f64 + 1.0;
        Complex::new(entry(x), entry(2.7 * x + 0.3))
    })
}

/// Returns tr (iW)^k for k = 1 … N, divided by the powers of a scale, such as |W| at the start of a path.
pub fn casimirs(w: &LargeSkewHermitian, scale: f64) -> Vec<f64> {
    use isospectral_flows::{LargeMatrix, Products};
    let size = w.size();
    let hermitian = LargeMatrix::from_fn(size, |j, k| Complex::<f64>::I * w.at(j, k) / scale);
    let (mut power, mut products) = (hermitian.clone(), Products::default());
    let mut traces = Vec::new();
    for _ in 0..size {
        traces.push((0..size).map(|j| power.at(j, j).re).sum());
        let mut next = LargeMatrix::zeros(size);
        products.multiply(&power, &hermitian, &mut next);
        power = next;
    }
    traces
}

/// Returns the largest magnitude of a coordinate of the difference.
pub fn distance(a: &LargeSkewHermitian, b: &LargeSkewHermitian) -> f64 {
    use isospectral_flows::lie_poisson::{State, larger};
    (0..a.dimension()).map(|i| (a.coordinate(i) - b.coordinate(i)).abs()).fold(0.0, larger)
}
