//! Functions on the sphere by their coefficients in spherical harmonics: [`VorticityCoefficients`].

use crate::matrix_hydrodynamics::quantised_laplacian::QuantisedLaplacian;
use crate::matrix_hydrodynamics::spherical_harmonic::associated_legendre;
use isospectral_flows::LargeSkewHermitian;
use isospectral_flows::num_complex::Complex;

/// A real function of degree below N on the unit sphere, given by its coefficients ω_lm:
///
/// ```text
/// ω(θ, φ) = Σ_lm ω_lm Y_lm(θ, φ),    ω_(l,−m) = (−1)ᵐ ω_lm*
/// ```
///
/// The harmonics Y_lm are orthonormal and have the phase of Condon and Shortley. Only coefficients with m ≥ 0 are
/// stored; those with m = 0 are real.
///
/// The matrix of the function is W = i Σ_lm ω_lm T_lm, with the matrices of [`QuantisedLaplacian::harmonic`].
///
/// # Example
/// ```
/// use lie_poisson_systems::{QuantisedLaplacian, VorticityCoefficients};
/// use lie_poisson_systems::num_complex::Complex;
/// let mut omega = VorticityCoefficients::zeros(16);
/// omega.set(3, 2, Complex::new(0.5, -1.0));
/// // the value at the north pole is zero, since m is not
/// assert_eq!(omega.value(0.0, 0.0), 0.0);
/// let laplacian = QuantisedLaplacian::new(16)?;
/// let back = VorticityCoefficients::of_matrix(&laplacian, &omega.matrix(&laplacian));
/// assert!((back.at(3, 2) - omega.at(3, 2)).norm() < 1e-14);
/// assert!(back.at(4, 2).norm() < 1e-14);
/// # Ok::<(), lie_poisson_systems::SystemError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct VorticityCoefficients {
    size: usize,
    /// The coefficient of degree l and order m has the index l(l + 1)/2 + m.
    entries: Vec<Complex<f64>>,
}

impl VorticityCoefficients {
    /// Creates the zero function, with room for degrees below N.
    #[must_use]
    pub fn zeros(size: usize) -> Self {
        Self { size, entries: vec![Complex::ZERO; size.saturating_mul(size.saturating_add(1)) / 2] }
    }

    /// Creates the function with the coefficients ω_lm = f(l, m) for 0 ≤ m ≤ l < N. For m = 0 the imaginary part is
    /// dropped.
    #[must_use]
    pub fn from_fn(size: usize, mut coefficient: impl FnMut(usize, usize) -> Complex<f64>) -> Self {
        let mut omega = Self::zeros(size);
        for (l, m) in (0..size).flat_map(|l| (0..=l).map(move |m| (l, m))) {
            omega.set(l, m, coefficient(l, m));
        }
        omega
    }

    /// Returns N. All degrees are below N.
    #[must_use]
    pub fn size(&self) -> usize {
        self.size
    }

    /// Returns the coefficient ω_lm with m ≥ 0, or 0 unless m ≤ l < N.
    #[must_use]
    pub fn at(&self, l: usize, m: usize) -> Complex<f64> {
        if m <= l && l < self.size { self.entries[l * (l + 1) / 2 + m] } else { Complex::ZERO }
    }

    /// Sets the coefficient ω_lm with m ≥ 0, and thereby ω_(l,−m). For m = 0 the imaginary part is dropped. Does
    /// nothing unless m ≤ l < N.
    pub fn set(&mut self, l: usize, m: usize, value: Complex<f64>) {
        if m <= l && l < self.size {
            let value = if m == 0 { Complex::from(value.re) } else { value };
            self.entries[l * (l + 1) / 2 + m] = value;
        }
    }

    /// Returns the matrix W of the function. Coefficients of degrees that the matrix cannot hold are dropped.
    #[must_use]
    pub fn matrix(&self, laplacian: &QuantisedLaplacian) -> LargeSkewHermitian {
        let n = laplacian.size();
        let mut w = LargeSkewHermitian::zeros(n);
        w.change_upper(|re, im| {
            for (l, m) in (0..self.size.min(n)).flat_map(|l| (0..=l).map(move |m| (l, m))) {
                let value = Complex::<f64>::I * self.at(l, m);
                if value == Complex::ZERO {
                    continue;
                }
                for (j, entry) in laplacian.harmonic(l, m).iter().enumerate() {
                    re[j + n * (j + m)] += value.re * entry;
                    im[j + n * (j + m)] += value.im * entry;
                }
            }
        });
        w
    }

    /// Returns the function of a matrix W: ω_lm = (4π/N) tr(T_lm* W)/i, since ⟨T_lm, T_lm⟩ = N/(4π).
    ///
    /// It is NaN if the size of W is not that of the operator.
    #[must_use]
    pub fn of_matrix(laplacian: &QuantisedLaplacian, w: &LargeSkewHermitian) -> Self {
        let n = laplacian.size();
        let mut omega = Self::zeros(n);
        if w.size() != n {
            omega.entries.fill(Complex::new(f64::NAN, f64::NAN));
            return omega;
        }
        let norm = 4.0 * std::f64::consts::PI / n as f64;
        for (l, m) in (0..n).flat_map(|l| (0..=l).map(move |m| (l, m))) {
            let harmonic = laplacian.harmonic(l, m);
            let terms = harmonic.iter().enumerate().map(|(j, entry)| w.at(j, j + m) * *entry);
            omega.set(l, m, terms.sum::<Complex<f64>>() * norm / Complex::<f64>::I);
        }
        omega
    }

    /// Returns the value of the function at the colatitude θ and the longitude φ, in radians.
    #[must_use]
    pub fn value(&self, colatitude: f64, longitude: f64) -> f64 {
        let most = self.size.saturating_sub(1);
        let order = |m: usize| {
            let legendre = associated_legendre(most, m, colatitude.cos());
            let sum: Complex<f64> = (m..).zip(legendre).map(|(l, p)| self.at(l, m) * p).sum();
            let wave = Complex::from_polar(1.0, m as f64 * longitude);
            (sum * wave).re * if m == 0 { 1.0 } else { 2.0 }
        };
        (0..self.size).map(order).sum()
    }

    /// Returns the values on a circle of constant colatitude, at `count` longitudes 2πn/`count` from 0 on.
    #[must_use]
    pub fn values_on_circle(&self, colatitude: f64, count: usize) -> Vec<f64> {
        let most = self.size.saturating_sub(1);
        let (mut values, waves) = (vec![0.0; count], waves(count));
        for m in 0..self.size {
            let legendre = associated_legendre(most, m, colatitude.cos());
            let sum: Complex<f64> = (m..).zip(legendre).map(|(l, p)| self.at(l, m) * p).sum();
            if sum == Complex::ZERO {
                continue;
            }
            let sum = if m == 0 { sum } else { sum * 2.0 };
            for (n, value) in values.iter_mut().enumerate() {
                *value += (sum * waves[(m * n) % count]).re;
            }
        }
        values
    }

    /// Returns the values on a grid of so many circles: at the colatitudes π(i + ½)/rows, from the north on, twice as many
    /// longitudes from 0 on each, row by row.
    #[must_use]
    pub fn on_grid(&self, rows: usize) -> Vec<f64> {
        let circle = |i| self.values_on_circle(colatitude(i, rows), 2 * rows);
        (0..rows).flat_map(circle).collect()
    }

    /// Returns the coefficients of degree below a size of a function by its values [on a grid](Self::on_grid):
    ///
    /// ```text
    /// ω_lm = ∫ ω Ȳ_lm dΩ = Σ_i w_i P_lm(cos θ_i) (π/rows) Σ_j ω(θ_i, φ_j) e^(−imφ_j)
    /// ```
    ///
    /// with the weights w_i of Fejér's first rule. They are exact if the function has no higher degrees and there are at least
    /// 2 size − 1 circles. They are NaN if the numbers are not those of a grid.
    ///
    /// Source: L. Fejér, *Mechanische Quadraturen mit positiven Cotesschen Zahlen*, Math. Z. 37 (1933).
    ///
    /// # Example
    /// ```
    /// use lie_poisson_systems::VorticityCoefficients;
    /// use lie_poisson_systems::num_complex::Complex;
    /// let mut omega = VorticityCoefficients::zeros(4);
    /// omega.set(3, 2, Complex::new(0.5, -0.25));
    /// let again = VorticityCoefficients::of_grid(4, &omega.on_grid(7));
    /// assert!((again.at(3, 2) - omega.at(3, 2)).norm() < 1e-14 && again.at(2, 2).norm() < 1e-14);
    /// ```
    #[must_use]
    pub fn of_grid(size: usize, values: &[f64]) -> Self {
        let rows = (values.len() / 2).isqrt();
        if rows == 0 || 2 * rows * rows != values.len() {
            return Self::from_fn(size, |_, _| Complex::new(f64::NAN, f64::NAN));
        }
        let columns = 2 * rows;
        let (mut omega, waves) = (Self::zeros(size), waves(columns));
        for (i, circle) in values.chunks_exact(columns).enumerate() {
            let angle = colatitude(i, rows);
            let scale = weight(angle, rows) * std::f64::consts::PI / rows as f64;
            for m in 0..size {
                let wave = |(j, value): (usize, &f64)| waves[(m * j) % columns].conj() * *value;
                let sum: Complex<f64> = circle.iter().enumerate().map(wave).sum();
                for (l, p) in (m..).zip(associated_legendre(size - 1, m, angle.cos())) {
                    omega.set(l, m, omega.at(l, m) + sum * (scale * p));
                }
            }
        }
        omega
    }
}

/// Returns e^(2πik/count) for k from 0 on. The angles are reduced before they are rounded.
fn waves(count: usize) -> Vec<Complex<f64>> {
    let turns = (0..count).map(|k| k as f64 / count as f64);
    turns.map(|turns| Complex::from_polar(1.0, std::f64::consts::TAU * turns)).collect()
}

/// Returns the colatitude of a circle of a grid.
fn colatitude(i: usize, rows: usize) -> f64 {
    std::f64::consts::PI * (i as f64 + 0.5) / rows as f64
}

/// Returns the weight of a circle in Fejér's first rule on so many circles.
fn weight(colatitude: f64, rows: usize) -> f64 {
    let term = |k: usize| {
        let k = k as f64;
        (2.0 * k * colatitude).cos() / (4.0 * k * k - 1.0)
    };
    2.0 / rows as f64 * (1.0 - 2.0 * (1..=rows / 2).map(term).sum::<f64>())
}
