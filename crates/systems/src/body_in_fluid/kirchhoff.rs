//! Kirchhoff's rigid body in an ideal fluid.

use super::inverse_inertia::InverseInertia;
use crate::error::SystemError;
use lie_poisson::{
    Covector, Hamiltonian, LiePoisson, Pair, Real, Se3, Se3Dual, hessian_by_dual_numbers,
};
use nalgebra::{Matrix3, Vector3};

/// Kirchhoff's body: a rigid body in an ideal fluid at rest at infinity.
///
/// It is a Hamiltonian on se(3)∗ with the minus bracket. The variables are the impulsive couple Π (kg m²/s)
/// and the impulse P (kg m/s):
///
/// ```text
/// h(Π, P) = ½ Π·AΠ + Π·BP + ½ P·CP,    dh = (Ω, v) = (AΠ + BP, BᵀΠ + CP)
/// dΠ/dt = Π × Ω + P × v,    dP/dt = P × Ω
/// ```
///
/// Ω (rad/s) and v (m/s) are the angular and the linear velocity of the body. The Casimirs are |P|² and Π·P.
/// Examples are a torpedo, an underwater vehicle without a righting moment and a falling card without lift.
///
/// Source: G. Kirchhoff, *Vorlesungen über mathematische Physik* (1876), 19th lecture; H. Lamb,
/// *Hydrodynamics*, 6th ed., §124; N. E. Leonard, *Stability of a bottom-heavy underwater
/// vehicle*, Automatica 33 (1997).
///
/// # Example
/// ```
/// use lie_poisson::{Hamiltonian, Pair, Se3Dual};
/// use lie_poisson_systems::Kirchhoff;
/// use nalgebra::{Matrix3, Vector3};
/// let a = Matrix3::from_diagonal(&Vector3::new(1.0, 0.5, 0.25));
/// let body = Kirchhoff::new(a, Matrix3::zeros(), a)?;
/// let Pair(omega, v) = body.differential(&Se3Dual::new(Vector3::x(), Vector3::y()));
/// assert_eq!((omega, v), (Vector3::x(), Vector3::new(0.0, 0.5, 0.0)));
/// # Ok::<(), lie_poisson_systems::SystemError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kirchhoff {
    inverse_inertia: InverseInertia,
}

impl Kirchhoff {
    /// Creates a body from the blocks A (kg⁻¹ m⁻²), B (kg⁻¹ m⁻¹) and C (kg⁻¹) of the inverse of the inertia of
    /// body and fluid, in the body frame.
    ///
    /// # Errors
    /// Returns [`SystemError`] if an entry is not finite, A or C is not symmetric, or h is not positive
    /// definite.
    pub fn new(a: Matrix3<f64>, b: Matrix3<f64>, c: Matrix3<f64>) -> Result<Self, SystemError> {
        Ok(Self { inverse_inertia: InverseInertia::new(a, b, c)? })
    }
}

impl<T: Real> Hamiltonian<LiePoisson<Se3>, T> for Kirchhoff {
    #[inline]
    fn value(&self, mu: &Se3Dual<T>) -> T {
        let (Covector(Pair(pi, p)), Pair(omega, v)) = (mu, self.differential(mu));
        (pi.dot(&omega) + p.dot(&v)) * 0.5
    }

    #[inline]
    fn differential(&self, Covector(Pair(pi, p)): &Se3Dual<T>) -> Pair<Vector3<T>, Vector3<T>> {
        self.inverse_inertia.velocity(pi, p)
    }

    #[inline]
    fn hessian(&self, mu: &Se3Dual<T>, v: &Se3Dual<T>) -> Option<Pair<Vector3<T>, Vector3<T>>> {
        Some(hessian_by_dual_numbers::<LiePoisson<Se3>, T, _>(self, mu, v))
    }
}
