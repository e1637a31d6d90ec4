//! Zeitlin's model of an ideal fluid on the sphere: [`Zeitlin`].

use crate::error::{SystemError, require_finite};
use crate::matrix_hydrodynamics::quantised_laplacian::QuantisedLaplacian;
use crate::matrix_hydrodynamics::vorticity_coefficients::VorticityCoefficients;
use isospectral_flows::num_complex::Complex;
use isospectral_flows::{IsospectralField, LargeMatrix, LargeSkewHermitian, Products};

/// Euler's equations of an ideal fluid on the unit sphere, in Zeitlin's model, which has an N×N matrix W instead of the
/// vorticity ω.
///
/// ```text
/// dW/dt = [P, W]/ħ,    ΔP = W − F,    ħ = 2/√(N² − 1)
/// ```
///
/// P is the matrix of the stream function ψ, the velocity is u = x × ∇ψ, and Δ is the [`QuantisedLaplacian`]. On a
/// sphere that rotates with the angular velocity Ω about the axis x₃, W is the absolute vorticity and F the matrix of
/// 2Ω x₃. As N → ∞ the equations become ∂ω/∂t + u·∇ω = 0 for functions of bounded degree.
///
/// The model is a Lie–Poisson system on u(N)∗. It conserves the energy and the N traces tr Wᵏ, which correspond to the
/// integrals ∫ωᵏ. It also conserves the angular momentum ∫ω x: its component along the axis, and all three components
/// if the sphere does not rotate.
///
/// The matrix of a function is that of [`VorticityCoefficients::matrix`]: 1 becomes i, and x₃ becomes iħ S₃. The unit
/// of length is the radius of the sphere, and the unit of time is arbitrary.
///
/// Source: Zeitlin, *Self-consistent finite-mode approximations for the hydrodynamics of an incompressible fluid on
/// nonrotating and rotating spheres*, Phys. Rev. Lett. 93 (2004); Modin & Viviani, *A Casimir preserving scheme for
/// long-time simulation of spherical ideal hydrodynamics*, J. Fluid Mech. 884 (2020).
///
/// # Example
/// A Rossby–Haurwitz wave of degree l on a zonal flow with the relative vorticity c x₃: in the frame of the rotating
/// sphere, ω_lm(t) = exp(imσt) ω_lm(0) with σ = (c + 2Ω)/(l(l + 1)) − c/2. The pattern turns about the axis with the
/// angular velocity −σ. It is an exact solution for every N.
/// ```
/// use collective_integrators::{Integrator, Start};
/// use lie_poisson_systems::isospectral_flows::GaussMagnus;
/// use lie_poisson_systems::num_complex::Complex;
/// use lie_poisson_systems::{VorticityCoefficients, Zeitlin};
/// use std::f64::consts::PI;
/// let (size, c, rotation, l, m) = (16, 1.0, 0.5, 4, 3);
/// let fluid = Zeitlin::new(size)?.with_rotation(rotation)?;
/// let mut omega = VorticityCoefficients::zeros(size);
/// omega.set(1, 0, Complex::from((c + 2.0 * rotation) * (4.0 * PI / 3.0).sqrt()));
/// omega.set(l, m, Complex::new(0.3, 0.0));
/// let method = GaussMagnus::new(3, fluid.clone())?;
/// let end = method.after(&fluid.vorticity(&omega), 0.05, 40)?.state;
/// let sigma = (c + 2.0 * rotation) / (l * (l + 1)) as f64 - c / 2.0;
/// let exact = Complex::from_polar(0.3, m as f64 * sigma * 2.0);
/// assert!((fluid.coefficients(&end).at(l, m) - exact).norm() < 1e-11);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Zeitlin {
    laplacian: QuantisedLaplacian,
    rotation: f64,
}

impl Zeitlin {
    /// Creates the model with N×N matrices, on a sphere at rest.
    ///
    /// # Errors
    /// Returns [`SystemError::Count`] if N is below 2.
    pub fn new(size: usize) -> Result<Self, SystemError> {
        Ok(Self { laplacian: QuantisedLaplacian::new(size)?, rotation: 0.0 })
    }

    /// Returns the model on a sphere that rotates with the angular velocity Ω about x₃.
    ///
    /// # Errors
    /// Returns [`SystemError::NotFinite`] if Ω is not finite.
    pub fn with_rotation(self, rotation: f64) -> Result<Self, SystemError> {
        require_finite("the angular velocity of the sphere", rotation)?;
        Ok(Self { rotation, ..self })
    }

    /// Returns the angular velocity Ω of the sphere.
    #[must_use]
    pub fn rotation(&self) -> f64 {
        self.rotation
    }

    /// Returns whether the sphere rotates.
    #[must_use]
    pub fn rotates(&self) -> bool {
        self.rotation != 0.0
    }

    /// Returns the quantised Laplace operator.
    #[must_use]
    pub fn laplacian(&self) -> &QuantisedLaplacian {
        &self.laplacian
    }

    /// Returns ħ = 2/√(N² − 1).
    #[must_use]
    pub fn planck_constant(&self) -> f64 {
        let n = self.laplacian.size() as f64;
        2.0 / ((n - 1.0) * (n + 1.0)).sqrt()
    }

    /// Returns the matrix W = Σ ω_lm i T_lm of an absolute vorticity ω = Σ ω_lm Y_lm, in inverse units of time.
    ///
    /// Coefficients of degree N and higher have no matrix and are left out; see [`VorticityCoefficients::matrix`].
    #[must_use]
    pub fn vorticity(&self, omega: &VorticityCoefficients) -> LargeSkewHermitian {
        omega.matrix(&self.laplacian)
    }

    /// Returns the coefficients of the vorticity of a matrix, the inverse of [`vorticity`](Self::vorticity). It takes
    /// O(N³) operations. They are NaN if the matrix does not have the size N.
    #[must_use]
    pub fn coefficients(&self, w: &LargeSkewHermitian) -> VorticityCoefficients {
        VorticityCoefficients::of_matrix(&self.laplacian, w)
    }

    /// Writes the matrix P of the stream function. It is NaN if a matrix does not have the size N.
    pub fn stream_into(&self, w: &LargeSkewHermitian, p: &mut LargeSkewHermitian) {
        self.scaled_stream_into(1.0, w, p);
    }

    /// Writes the multiple s P of the stream matrix.
    fn scaled_stream_into(&self, s: f64, w: &LargeSkewHermitian, p: &mut LargeSkewHermitian) {
        self.laplacian.solve(s, w, p);
        if self.rotation != 0.0 {
            // −Δ⁻¹F = F/2, the matrix of Ω x₃
            self.add_to_diagonal(p, s * self.rotation);
        }
    }

    /// Adds the matrix of a x₃.
    fn add_to_diagonal(&self, w: &mut LargeSkewHermitian, a: f64) {
        let (n, unit) = (w.size(), a * self.planck_constant());
        w.change_upper(|_, im| {
            for j in 0..n {
                im[j + n * j] += unit * (0.5 * (n as f64 - 1.0) - j as f64);
            }
        });
    }

    /// Returns the kinetic energy ½ ∫|u|² = −½ ∫ψ(ω − f), f = 2Ω x₃, of the model: (2π/N) tr P(W − F).
    #[must_use]
    pub fn energy(&self, w: &LargeSkewHermitian) -> f64 {
        let (mut p, mut relative) = (LargeSkewHermitian::zeros(w.size()), w.clone());
        self.stream_into(w, &mut p);
        self.add_to_diagonal(&mut relative, -2.0 * self.rotation);
        -2.0 * std::f64::consts::PI / w.size() as f64 * p.scalar_product(&relative)
    }

    /// Returns the enstrophy ∫ω² of the model: −(4π/N) tr W². It is a Casimir.
    #[must_use]
    pub fn enstrophy(&self, w: &LargeSkewHermitian) -> f64 {
        4.0 * std::f64::consts::PI / w.size() as f64 * w.scalar_product(w)
    }

    /// Returns the Casimirs (4π/N) tr(−iW)ᵏ, which correspond to ∫ωᵏ, for k = 1 … `most`.
    #[must_use]
    pub fn casimirs(&self, w: &LargeSkewHermitian, most: usize) -> Vec<f64> {
        let n = w.size();
        let hermitian = LargeMatrix::from_fn(n, |j, k| -Complex::<f64>::I * w.at(j, k));
        let (mut power, mut next) = (hermitian.clone(), hermitian.clone());
        let mut products = Products::default();
        (0..most)
            .map(|k| {
                if k > 0 {
                    products.multiply_hermitian(&power, &hermitian, &mut next);
                    core::mem::swap(&mut power, &mut next);
                }
                let trace = (0..n).map(|j| power.at(j, j).re).sum::<f64>();
                4.0 * std::f64::consts::PI / n as f64 * trace
            })
            .collect()
    }

    /// Returns the angular momentum ∫ω x of the model. It is conserved if the sphere does not rotate. It
    /// is NaN if W does not have the size N.
    #[must_use]
    pub fn angular_momentum(&self, w: &LargeSkewHermitian) -> [f64; 3] {
        if w.size() != self.laplacian.size() {
            return [f64::NAN; 3];
        }
        let coefficient = |m: usize| -> Complex<f64> {
            let harmonic = self.laplacian.harmonic(1, m);
            let terms = harmonic.iter().enumerate().map(|(j, entry)| w.at(j, j + m) * *entry);
            let norm = 4.0 * std::f64::consts::PI / self.laplacian.size() as f64;
            terms.sum::<Complex<f64>>() * norm / Complex::<f64>::I
        };
        // x₁ + i x₂ = −√(8π/3) Y₁₁, so that ∫ω (x₁ + i x₂) = −√(8π/3) ω₁₁*
        let (zonal, tilted) = (coefficient(0), coefficient(1));
        let third = (4.0 * std::f64::consts::PI / 3.0).sqrt();
        let other = -third * std::f64::consts::SQRT_2;
        [other * tilted.re, -other * tilted.im, third * zonal.re]
    }
}

impl IsospectralField for Zeitlin {
    fn size(&self) -> usize {
        self.laplacian.size()
    }

    /// Writes the generator P/ħ.
    fn generator_into(&self, w: &LargeSkewHermitian, generator: &mut LargeSkewHermitian) {
        self.scaled_stream_into(1.0 / self.planck_constant(), w, generator);
    }
}
