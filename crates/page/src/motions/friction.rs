//! The friction of the air: [`Friction`].

use crate::error::PageError;
use heavytop::HeavyTop;
use lie_poisson::{Covector, Pair, Se3Dual};
use nalgebra::Vector3;

/// Viscous friction, the torque −c Ω with Ω = I⁻¹Π in the body frame. Alone it makes
///
/// ```text
/// dΠ_i/dt = −(c/I_i) Π_i,    dΓ/dt = 0
/// ```
///
/// so that the components of Π decay exponentially, |Γ|² stays, and the power is −c |Ω|².
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Friction {
    /// c/I₁, c/I₂ and c/I₃, 1/s.
    rates: Vector3<f64>,
}

impl Friction {
    /// Creates the friction of a top from its coefficient c, N m s; `None` if that is 0.
    ///
    /// # Errors
    /// Returns [`PageError::Friction`] if c is negative, or if c/I is not finite.
    pub(crate) fn new(top: &HeavyTop, coefficient: f64) -> Result<Option<Self>, PageError> {
        let rates = top.angular_velocity(&Vector3::repeat(coefficient));
        match coefficient >= 0.0 && rates.iter().all(|rate| rate.is_finite()) {
            true => Ok((coefficient > 0.0).then_some(Self { rates })),
            false => Err(PageError::Friction { coefficient }),
        }
    }

    /// Returns (Π, Γ) after the friction has acted alone for a time in s.
    pub(crate) fn flow(&self, Covector(Pair(pi, gamma)): &Se3Dual, time: f64) -> Se3Dual {
        Se3Dual::new(pi.zip_map(&self.rates, |pi, rate| pi * (-rate * time).exp()), *gamma)
    }
}
