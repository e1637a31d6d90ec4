//! The free rigid body on so(3)*.

use crate::{HeavyTop, TopError};
use lie_poisson::{Covector, Hamiltonian, LiePoisson, Real, So3};
use nalgebra::Vector3;

/// The free rigid body: h(Π) = ½ Π·(I⁻¹Π) on so(3)* with the minus bracket, Π̇ = Π × Ω.
///
/// Units as for the [heavy top](HeavyTop), of which it is the case without gravity.
///
/// # Example
/// ```
/// use heavytop::RigidBody;
/// use lie_poisson::{Covector, Hamiltonian};
/// use nalgebra::Vector3;
/// let body = RigidBody::new(Vector3::new(1.0, 2.0, 2.5))?;
/// assert_eq!(body.value(&Covector(Vector3::new(1.0, 2.0, 0.0))), 1.5);
/// # Ok::<(), heavytop::TopError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidBody(HeavyTop);

impl RigidBody {
    /// The body with principal moments I₁, I₂, I₃, kg m².
    ///
    /// # Errors
    /// Unless they are positive and obey the triangle inequality.
    pub fn new(inertia: Vector3<f64>) -> Result<Self, TopError> {
        HeavyTop::free_rigid_body(inertia).map(Self)
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
}
