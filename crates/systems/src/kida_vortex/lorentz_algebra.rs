//! The Lie algebra so(2, 1).

use lie_poisson::{Casimirs, Covector, LieAlgebra, Real};
use nalgebra::Vector3;

/// The Lie algebra so(2, 1) ≅ sl(2, R) of Lorentz transformations of R^(2,1), with the basis
///
/// ```text
/// [e₁, e₂] = −e₃,   [e₂, e₃] = e₁,   [e₃, e₁] = e₂
/// ```
///
/// The Casimir μ₃² − μ₁² − μ₂² is the determinant of the symmetric matrix [μ₃+μ₁ μ₂; μ₂ μ₃−μ₁]. Its level sets are
/// hyperboloids.
///
/// # Example
/// ```
/// use lie_poisson::{Casimirs, Covector, LieAlgebra};
/// use lie_poisson_systems::So21;
/// use nalgebra::Vector3;
/// assert_eq!(So21.bracket::<f64>(&Vector3::x(), &Vector3::y()), -Vector3::z());
/// assert_eq!(So21.casimir(0, &Covector(Vector3::new(1.0, 2.0, 3.0))), 4.0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct So21;

impl LieAlgebra for So21 {
    type Element<T: Real> = Vector3<T>;

    #[cfg_attr(optimised, inline(always))]
    fn bracket<T: Real>(&self, xi: &Vector3<T>, eta: &Vector3<T>) -> Vector3<T> {
        let cross = xi.cross(eta);
        Vector3::new(cross.x, cross.y, -cross.z)
    }

    /// Returns `ad∗_ξ μ` = (μ₁, μ₂, −μ₃) × ξ.
    #[cfg_attr(optimised, inline(always))]
    fn coadjoint<T: Real>(
        &self,
        xi: &Vector3<T>,
        mu: &Covector<Vector3<T>>,
    ) -> Covector<Vector3<T>> {
        Covector(Vector3::new(mu.0.x, mu.0.y, -mu.0.z).cross(xi))
    }
}

impl Casimirs for So21 {
    const COUNT: usize = 1;

    /// Returns the Casimir μ₃² − μ₁² − μ₂².
    #[cfg_attr(optimised, inline(always))]
    fn casimir<T: Real>(&self, index: usize, mu: &Covector<Vector3<T>>) -> T {
        let across = mu.0.x * mu.0.x + mu.0.y * mu.0.y;
        if index == 0 { mu.0.z * mu.0.z - across } else { T::zero() }
    }
}
