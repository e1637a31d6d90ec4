//! The free rigid body on so(3)∗.

use crate::error::TopError;
use crate::tops::top::HeavyTop;
use lie_poisson::{Covector, Hamiltonian, LiePoisson, Real, So3};
use nalgebra::Vector3;

/// The free rigid body: h(Π) = ½ Π·(I⁻¹Π) on so(3)∗ with the minus bracket, dΠ/dt = Π × Ω.
///
/// It is the [heavy top](HeavyTop) without gravity, and has the same units.
///
/// # Example
/// The body is integrated collectively on C², by the Hopf map. The Casimir |Π|² is conserved to round-off.
/// ```
/// use collective_integrators::{Collective, RungeKutta, Start};
/// use heavytop::RigidBody;
/// use lie_poisson::Covector;
/// use momentum_map::HOPF;
/// use nalgebra::Vector3;
/// let body = RigidBody::new(Vector3::new(1.0, 2.0, 2.5))?;
/// let midpoint = Collective::new(RungeKutta::implicit_midpoint(), HOPF, body);
/// let pi = Covector(Vector3::new(0.3, 0.4, 1.2));
/// for sample in midpoint.trajectory(&pi, 0.1)?.take(1000) {
///     assert!((sample?.momentum.0.norm() - 1.3).abs() < 1e-13);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidBody(HeavyTop);

impl RigidBody {
    /// Creates the body with the principal moments I₁, I₂, I₃, kg m².
    ///
    /// # Errors
    /// Returns [`TopError`] unless the moments are positive, have finite reciprocals, and obey the triangle inequality. A
    /// thin rod, which [`HeavyTop`] has too, may have one moment that is zero.
    pub fn new(inertia: Vector3<f64>) -> Result<Self, TopError> {
        HeavyTop::free_rigid_body(inertia).map(Self)
    }

    /// Returns the principal moments I₁, I₂, I₃, kg m².
    #[must_use]
    pub fn inertia(&self) -> Vector3<f64> {
        self.0.inertia()
    }
}

impl<T: Real> Hamiltonian<LiePoisson<So3>, T> for RigidBody {
    #[inline]
    fn value(&self, Covector(pi): &Covector<Vector3<T>>) -> T {
        pi.dot(&self.0.angular_velocity(pi)) * 0.5
    }

    #[inline]
    fn differential(&self, Covector(pi): &Covector<Vector3<T>>) -> Vector3<T> {
        self.0.angular_velocity(pi)
    }

    #[inline]
    fn hessian(
        &self,
        _: &Covector<Vector3<T>>,
        Covector(v): &Covector<Vector3<T>>,
    ) -> Option<Vector3<T>> {
        Some(self.0.angular_velocity(v))
    }
}
