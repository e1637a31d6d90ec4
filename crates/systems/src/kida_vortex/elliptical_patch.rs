//! Kida's elliptical vortex as a Hamiltonian on so(2, 1)∗: [`KidaVortex`].

use crate::error::{SystemError, require_finite, require_positive, require_within};
use crate::kida_vortex::lorentz_algebra::So21;
use lie_poisson::{Casimirs, Covector, Hamiltonian, LiePoisson, Real, hessian_by_dual_numbers};
use nalgebra::Vector3;

/// An elliptical patch of uniform vorticity in a plane flow with uniform strain and rotation.
///
/// The patch stays an ellipse. The point μ ∈ so(2, 1)∗ represents its semi-axes a, b and its angle φ by the symmetric
/// matrix
///
/// ```text
/// [μ₃+μ₁ μ₂; μ₂ μ₃−μ₁] = R_φ diag(a², b²) R_φᵀ,    μ₃ = ½(a²+b²),  (μ₁, μ₂) = ½(a²−b²)(cos 2φ, sin 2φ)
/// ```
///
/// in m². The Casimir is a²b², since the area is conserved. With the plus bracket the equations follow from
///
/// ```text
/// h(μ) = k ln(a + b)² + 2γ μ₃ − 2e μ₂,    (a + b)² = 2μ₃ + 2ab
/// ```
///
/// where k = ω ab is the strength (m²/s) for the vorticity ω, the flow (x, y) ↦ e (x, −y) is the strain (1/s) and γ is
/// the angular velocity of the rotation (1/s). The differential is ∂h/∂(μ₁, μ₂) = −2k (μ₁, μ₂)/(ab(a+b)²) + (0, −2e)
/// and ∂h/∂μ₃ = k/(ab) + 2γ. Without strain, an ellipse turns at Kirchhoff's rate ω ab/(a+b)² + γ.
///
/// Source: S. Kida, *Motion of an elliptic vortex in a uniform shear flow*, J. Phys. Soc. Japan 50 (1981); S. P.
/// Meacham, P. J. Morrison & G. R. Flierl, *Hamiltonian moment reduction for describing vortices in shear*, Phys.
/// Fluids 9 (1997); Jayawardana, Morrison & Ohsawa, *Clebsch canonization of Lie–Poisson systems*, J. Geom. Mech. 14
/// (2022), for the collective form.
///
/// # Example
/// Structure constants alone give the collective integrator, by the Clebsch map T∗so(2, 1) → so(2, 1)∗:
/// ```
/// use collective_integrators::{Collective, RungeKutta, Start};
/// use lie_poisson::{Casimirs, InfinitesimalAdjoint};
/// use lie_poisson_systems::{KidaVortex, So21};
/// use momentum_map::{Side, clebsch_realisation};
/// let vortex = KidaVortex::new(1.0, 0.1, 0.05)?;
/// let start = KidaVortex::momentum(1.5, 0.5, 0.3)?;
/// let map = clebsch_realisation(InfinitesimalAdjoint(So21), Side::Left)?;
/// let gauss = Collective::new(RungeKutta::gauss(2)?, map, vortex);
/// for sample in gauss.trajectory(&start, 0.1)?.take(100) {
///     let area = So21.casimir(0, &sample?.momentum);
///     assert!((area - So21.casimir(0, &start)).abs() < 1e-13);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KidaVortex {
    strength: f64,
    strain: f64,
    rotation: f64,
}

/// The least and the largest semi-axis (m), such that the fourth powers neither overflow nor underflow.
const AXES: [f64; 2] = [1e-76, 1e76];

/// The least and the largest ratio of the semi-axes, such that a²b² is known to a relative rounding error of 10⁻⁴.
const RATIOS: [f64; 2] = [1e-6, 1e6];

impl KidaVortex {
    /// Creates a vortex from its strength k = ω ab (m²/s), the rate e of the strain and the angular velocity γ of the
    /// flow around it (1/s).
    ///
    /// # Errors
    /// Returns [`SystemError`] if a number is not finite.
    pub fn new(strength: f64, strain: f64, rotation: f64) -> Result<Self, SystemError> {
        require_finite("strength", strength)?;
        require_finite("strain", strain)?;
        require_finite("rotation", rotation)?;
        Ok(Self { strength, strain, rotation })
    }

    /// Returns the point of so(2, 1)∗ of an ellipse with semi-axes a and b (m), the first at the angle φ from the
    /// x-axis.
    ///
    /// The point represents the shorter axis by the difference μ₃² − μ₁² − μ₂² = a²b² of numbers of size a⁴. The
    /// Casimir therefore has a relative rounding error of about 10⁻¹⁶ (a/b)², for a > b, and the squares must neither
    /// overflow nor underflow.
    ///
    /// # Errors
    /// Returns [`SystemError`] unless the angle is finite, the axes are between 10⁻⁷⁶ and 10⁷⁶, and their ratio is
    /// between 10⁻⁶ and 10⁶.
    pub fn momentum(a: f64, b: f64, angle: f64) -> Result<Covector<Vector3<f64>>, SystemError> {
        require_positive("a", a)?;
        require_positive("b", b)?;
        require_finite("angle", angle)?;
        require_within("a", a, AXES)?;
        require_within("b", b, AXES)?;
        require_within("a/b", a / b, RATIOS)?;
        let (sin, cos) = (2.0 * angle).sin_cos();
        // a² − b², without the cancellation of nearly equal squares
        let half_difference = 0.5 * (a - b) * (a + b);
        let half_sum = 0.5 * (a * a + b * b);
        Ok(Covector(Vector3::new(half_difference * cos, half_difference * sin, half_sum)))
    }

    /// Returns the semi-axes (a, b) of the ellipse (m), the longer one first.
    pub fn semi_axes<T: Real>(mu: &Covector<Vector3<T>>) -> (T, T) {
        let radius = (mu.0.x * mu.0.x + mu.0.y * mu.0.y).sqrt();
        let longer = (mu.0.z + radius).sqrt();
        (longer, product_of_axes(mu) / longer)
    }

    /// Returns the angle from the x-axis to the longer axis, in (−π/2, π/2], in radians.
    pub fn angle<T: Real>(mu: &Covector<Vector3<T>>) -> T {
        mu.0.y.atan2(mu.0.x) * 0.5
    }
}

/// Returns ab, the square root of the Casimir.
#[cfg_attr(optimised, inline(always))]
fn product_of_axes<T: Real>(mu: &Covector<Vector3<T>>) -> T {
    So21.casimir(0, mu).sqrt()
}

impl<T: Real> Hamiltonian<LiePoisson<So21>, T> for KidaVortex {
    fn value(&self, mu: &Covector<Vector3<T>>) -> T {
        let own = ((mu.0.z + product_of_axes(mu)) * 2.0).ln() * self.strength;
        own + mu.0.z * (2.0 * self.rotation) - mu.0.y * (2.0 * self.strain)
    }

    #[inline]
    fn differential(&self, mu: &Covector<Vector3<T>>) -> Vector3<T> {
        let area = product_of_axes(mu);
        let along = T::from_f64(self.strength) / area;
        let across = -along / (mu.0.z + area);
        Vector3::new(
            across * mu.0.x,
            across * mu.0.y - 2.0 * self.strain,
            along + 2.0 * self.rotation,
        )
    }

    #[inline]
    fn hessian(&self, mu: &Covector<Vector3<T>>, v: &Covector<Vector3<T>>) -> Option<Vector3<T>> {
        Some(hessian_by_dual_numbers::<LiePoisson<So21>, T, _>(self, mu, v))
    }
}
