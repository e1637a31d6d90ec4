//! The heavy gyrostat.

use crate::error::{TopError, require_finite};
use crate::{HeavyTop, HeavyTopSpace};
use lie_poisson::{Hamiltonian, Pair, Real, Se3Dual, hessian_by_dual_numbers};
use nalgebra::Vector3;

/// A heavy top with a rotor inside that spins at constant relative angular momentum ℓ:
///
/// ```text
/// h(Π, Γ) = ½ (Π − ℓ)·I⁻¹(Π − ℓ) + m g l Γ·c,    dh = (I⁻¹(Π − ℓ), m g l c)
/// ```
///
/// Π is the total angular momentum. The Casimirs are those of the top.
///
/// Source: N. E. Zhukovskii, *On the motion of a rigid body with cavities filled with a
/// homogeneous liquid* (1885); E. Leimanis, *The General Problem of the Motion of Coupled Rigid
/// Bodies about a Fixed Point* (1965), §7.
///
/// # Example
/// ```
/// use heavytop::{Gyrostat, HeavyTop};
/// use lie_poisson::{Hamiltonian, Pair, Se3Dual};
/// use nalgebra::Vector3;
/// let rotor = Vector3::new(0.0, 0.0, 5.0);
/// let gyrostat = Gyrostat::new(HeavyTop::lagrange(2.0, 1.0, 1.0)?, rotor)?;
/// // at Π = ℓ the body is at rest, and only the weight acts
/// let Pair(omega, gamma) = gyrostat.differential(&Se3Dual::new(rotor, Vector3::x()));
/// assert_eq!((omega, gamma), (Vector3::zeros(), Vector3::z()));
/// # Ok::<(), heavytop::TopError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gyrostat {
    top: HeavyTop,
    rotor: Vector3<f64>,
}

impl Gyrostat {
    /// The top `top` with the rotor's angular momentum ℓ in the body frame, kg m²/s.
    ///
    /// # Errors
    /// If ℓ is not finite.
    pub fn new(top: HeavyTop, rotor: Vector3<f64>) -> Result<Self, TopError> {
        for (name, &value) in ["rotor[0]", "rotor[1]", "rotor[2]"].iter().zip(&rotor) {
            require_finite(name, value)?;
        }
        Ok(Self { top, rotor })
    }

    /// (Π − ℓ, Γ), at which the energy of the top is that of the gyrostat.
    fn relative<T: Real>(&self, mu: &Se3Dual<T>) -> Se3Dual<T> {
        Se3Dual::new(mu.0.0 - self.rotor.map(T::from_f64), mu.0.1)
    }
}

impl<T: Real> Hamiltonian<HeavyTopSpace, T> for Gyrostat {
    #[inline]
    fn value(&self, mu: &Se3Dual<T>) -> T {
        self.top.value(&self.relative(mu))
    }

    #[inline]
    fn differential(&self, mu: &Se3Dual<T>) -> Pair<Vector3<T>, Vector3<T>> {
        self.top.differential(&self.relative(mu))
    }

    #[inline]
    fn hessian(&self, mu: &Se3Dual<T>, v: &Se3Dual<T>) -> Option<Pair<Vector3<T>, Vector3<T>>> {
        Some(hessian_by_dual_numbers::<HeavyTopSpace, T, _>(self, mu, v))
    }
}
