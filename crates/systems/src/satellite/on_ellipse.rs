//! A satellite on an elliptic orbit: [`SatelliteOnEllipse`].

use crate::error::SystemError;
use crate::satellite::gravity_gradient::{GravityGradient, SatelliteAlgebra, SatelliteDual};
use crate::satellite::kepler_orbit::KeplerOrbit;
use lie_poisson::{
    Covector, Differential, Hamiltonian, InTime, LiePoisson, Pair, Point, Real, Time, from_parts,
    hessian_by_dual_numbers,
};
use nalgebra::Vector3;

/// The space of (μ, t) with μ in (so(3) ⋉ (R³ ⊕ R³))∗.
type Space = InTime<LiePoisson<SatelliteAlgebra>>;

/// A rigid satellite on an elliptic orbit, whose attitude is turned by the gradient of gravity.
///
/// It is a Hamiltonian on (so(3) ⋉ (R³ ⊕ R³))∗ that depends on time, with the minus bracket and the coordinates of
/// [`Satellite`](crate::Satellite). The angular velocity dν/dt of the orbit and the tide GM/r³ are those of a
/// [`KeplerOrbit`]:
///
/// ```text
/// h(μ, t) = ½ Π·I⁻¹Π − ν′(t) Π·Γ₂ + (3/2) GM/r(t)³ Γ₁·IΓ₁,    Ω = I⁻¹Π
/// dΠ/dt = Π × Ω + 3 GM/r(t)³ Γ₁ × IΓ₁,    dΓᵢ/dt = Γᵢ × (Ω − ν′(t) Γ₂)
/// ```
///
/// The Casimirs |Γ₁|², Γ₁·Γ₂ and |Γ₂|² are conserved, but h is not, and no attitude is at rest: the frame of the orbit
/// turns unevenly. For small e the libration in the plane of the orbit is driven by 2e n² sin n(t − t₀), with the
/// response 2e/(k − 1) sin n(t − t₀) for k = 3 (`I_t` − `I_r`)/`I_n`. It is resonant at k = 1.
///
/// Source: V. V. Beletskii, *Motion of an Artificial Satellite about its Center of Mass* (1966), ch. 2.
///
/// # Example
/// ```
/// use lie_poisson_systems::lie_poisson::{Time, TimeDependent};
/// use lie_poisson_systems::collective_integrators::Driven;
/// use lie_poisson_systems::prelude::*;
/// let orbit = KeplerOrbit::new(1e-3, 0.02, 0.0)?;
/// let satellite = SatelliteOnEllipse::new(Vector3::new(1.0, 1.1, 0.2), orbit)?;
/// let start = satellite.momentum([Vector3::z(), Vector3::y()], &Vector3::zeros(), 0.0);
/// let gauss = Driven::new(RungeKutta::gauss(2)?, TWO_FIELDS, TimeDependent(satellite));
/// let Pair(end, _) = gauss.after(&Pair(start, Time(0.0)), 100.0, 60)?.momentum;
/// let [radial, angle, normal] = Satellite::casimirs(&end);
/// assert!((radial - 1.0).abs() < 1e-13 && angle.abs() < 1e-13 && (normal - 1.0).abs() < 1e-13);
/// // the boom does not stay along the vertical
/// assert!((end.0.1.0[0] - Vector3::z()).norm() > 0.01);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SatelliteOnEllipse {
    body: GravityGradient,
    orbit: KeplerOrbit,
}

impl SatelliteOnEllipse {
    /// Creates a satellite from its principal moments I₁, I₂, I₃ (kg m²) and its orbit.
    ///
    /// # Errors
    /// Returns [`SystemError`] unless the moments are positive and obey the triangle inequality, and every number is
    /// finite, including the inverses of the moments and 3 GM/r³ I at the pericentre.
    pub fn new(inertia: Vector3<f64>, orbit: KeplerOrbit) -> Result<Self, SystemError> {
        Ok(Self { body: GravityGradient::new(inertia, orbit.strongest_tide())?, orbit })
    }

    /// Returns the orbit.
    #[must_use]
    pub const fn orbit(&self) -> &KeplerOrbit {
        &self.orbit
    }

    /// Returns the point (I(w + ν′ Γ₂), Γ₁, Γ₂) of a satellite that sees the directions Γ₁ and Γ₂ at a time (s), and
    /// turns at the angular velocity w relative to the directions of the orbit (rad/s).
    pub fn momentum<T: Real>(
        &self,
        directions: [Vector3<T>; 2],
        relative: &Vector3<T>,
        time: T,
    ) -> SatelliteDual<T> {
        self.body.momentum(directions, relative, self.orbit.rate(time))
    }
}

impl<T: Real> Hamiltonian<Space, T> for SatelliteOnEllipse {
    fn value(&self, Pair(mu, time): &Point<Space, T>) -> T {
        let [[rate, _], [tide, _]] = self.orbit.rate_and_tide(time.0);
        self.body.energy(mu, rate, tide)
    }

    fn differential(&self, Pair(mu, time): &Point<Space, T>) -> Differential<Space, T> {
        let [[rate, rate_change], [tide, tide_change]] = self.orbit.rate_and_tide(time.0);
        let change = self.body.potential(mu, rate_change, tide_change);
        let element = self.body.differential(mu, rate, tide);
        from_parts::<SatelliteDual<T>, Time<T>>(&element, &Covector(Time(change)))
    }

    fn hessian(&self, z: &Point<Space, T>, v: &Point<Space, T>) -> Option<Differential<Space, T>> {
        Some(hessian_by_dual_numbers::<Space, T, _>(self, z, v))
    }
}
