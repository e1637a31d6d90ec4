//! Spherical harmonics, as matrices and as functions.

use crate::matrix_hydrodynamics::quantised_laplacian::QuantisedLaplacian;

/// The size above which the numbers of a recurrence are divided by it.
const LARGE: f64 = 1e100;

impl QuantisedLaplacian {
    /// Returns the entries (j, j + m), j = 0 … N − 1 − m, of the matrix T_lm of the spherical harmonic Y_lm, m ≥ 0. The
    /// other entries are zero.
    ///
    /// ```text
    /// Δ T_lm = −l(l + 1) T_lm,    [S₃, T_lm] = m T_lm,    tr(T_lm* T_lm) = N/4π
    /// ```
    ///
    /// The sign is that of Y_lm with the phase of Condon and Shortley: (−1)ᵐ at the north pole, which is the entry with
    /// j = 0. With this normalisation the function 1 becomes the identity matrix. T_(l,−m) = (−1)ᵐ T_lm*.
    ///
    /// The result is empty unless m ≤ l < N.
    ///
    /// Source: Hoppe & Yau 1998. The entries are Clebsch–Gordan coefficients.
    ///
    /// # Example
    /// The matrix of x₃ = cos θ = √(4π/3) Y₁₀ is ħ S₃ with ħ = 2/√(N² − 1):
    /// ```
    /// use lie_poisson_systems::QuantisedLaplacian;
    /// use std::f64::consts::PI;
    /// let (size, laplacian) = (9, QuantisedLaplacian::new(9)?);
    /// for (j, entry) in laplacian.harmonic(1, 0).iter().enumerate() {
    ///     let spin = 4.0 - j as f64;
    ///     assert!(((4.0 * PI / 3.0).sqrt() * entry - 2.0 / 80.0_f64.sqrt() * spin).abs() < 1e-15);
    /// }
    /// # Ok::<(), lie_poisson_systems::SystemError>(())
    /// ```
    #[must_use]
    pub fn harmonic(&self, l: usize, m: usize) -> Vec<f64> {
        if m > l || l >= self.size() {
            return Vec::new();
        }
        let (length, eigenvalue) = (self.size() - m, (l * (l + 1)) as f64);
        let half = length.div_ceil(2);
        let mut entries = vec![0.0; length];
        entries[0] = 1.0;
        // From the end the entries grow, so that the recurrence is stable up to the middle.
        for j in 0..half.min(length - 1) {
            let k = j + m;
            let before = if j > 0 { self.coupling(j, k) * entries[j - 1] } else { 0.0 };
            let here = (self.diagonal(j, k) - eigenvalue) * entries[j];
            entries[j + 1] = (here - before) / self.coupling(j + 1, k + 1);
            if entries[j + 1].abs() > LARGE {
                entries[..=j + 1].iter_mut().for_each(|x| *x /= LARGE);
            }
        }
        let parity = if (l - m).is_multiple_of(2) { 1.0 } else { -1.0 };
        for j in half..length {
            entries[j] = parity * entries[length - 1 - j];
        }
        if parity < 0.0 && !length.is_multiple_of(2) {
            entries[half - 1] = 0.0;
        }
        let square = entries.iter().map(|x| x * x).sum::<f64>();
        let norm = (self.size() as f64 / (4.0 * std::f64::consts::PI)).sqrt();
        let sign = if m.is_multiple_of(2) { 1.0 } else { -1.0 };
        let scale = sign * norm / square.sqrt();
        entries.iter_mut().for_each(|x| *x *= scale);
        entries
    }
}

/// Returns the values of the normalised associated Legendre functions of order m at x = cos θ, for degrees l = m …
/// `most`:
///
/// ```text
/// Y_lm(θ, φ) = P_lm(cos θ) exp(imφ)
/// ```
///
/// The functions Y_lm are orthonormal on the unit sphere and have the phase of Condon and Shortley. The result is empty
/// if m is above `most`, and NaN for x outside of [−1, 1]. For m above 600 and x near ±1, functions that are smaller
/// than the least positive number become zero, and so do those of higher degree.
///
/// Source: DLMF §14.10 and §14.30, with the recurrence in l, which is stable upwards.
///
/// # Example
/// ```
/// use lie_poisson_systems::associated_legendre;
/// use std::f64::consts::PI;
/// let x: f64 = 0.3;
/// let zonal = associated_legendre(2, 0, x);
/// assert!((zonal[1] - (3.0 / (4.0 * PI)).sqrt() * x).abs() < 1e-15);
/// assert!((zonal[2] - (5.0 / (16.0 * PI)).sqrt() * (3.0 * x * x - 1.0)).abs() < 1e-15);
/// ```
#[must_use]
pub fn associated_legendre(most: usize, m: usize, x: f64) -> Vec<f64> {
    if m > most {
        return Vec::new();
    }
    if !(-1.0..=1.0).contains(&x) {
        return vec![f64::NAN; most - m + 1];
    }
    let sine = ((1.0 - x) * (1.0 + x)).max(0.0).sqrt();
    let first = (1..=m).fold((0.25 / std::f64::consts::PI).sqrt(), |p, i| {
        -p * sine * ((2 * i + 1) as f64 / (2 * i) as f64).sqrt()
    });
    let mut values = vec![first];
    for l in m + 1..=most {
        let [l, order] = [l, m].map(|x| x as f64);
        let factor = ((4.0 * l * l - 1.0) / (l * l - order * order)).sqrt();
        let last = (l - 1.0) * (l - 1.0);
        let past = ((last - order * order) / (4.0 * last - 1.0)).max(0.0).sqrt();
        let at = |back: usize| values.len().checked_sub(back).map_or(0.0, |i| values[i]);
        values.push(factor * (x * at(1) - past * at(2)));
    }
    values
}
