//! The realisation of so(3)∗ on C² by the Hopf map.

use crate::actions::action::Side;
use crate::maps::fibre::{FibreSymmetry, Lift, LiftError};
use crate::maps::poisson_map::{PoissonMap, SourcePoint, TargetPoint};
use crate::maps::quadratic_momentum_map::QuadraticMomentumMap;
use crate::maps::symplectic_representation::So3OnC2;
use crate::phase_spaces::hopf_fibration::hopf_section;
use lie_poisson::{Mask, Pair, Real, Vector, euclidean_norm};
use nalgebra::Vector2;
use num_complex::Complex;

/// The momentum map of SU(2) on C² ∋ z = q + ip with dq ∧ dp, as a map to so(3)∗ ≅ su(2)∗:
///
/// ```text
/// J(z) = ∓¼ (2 Re z₁*z₂, 2 Im z₁*z₂, |z₁|² − |z₂|²),    |J(z)| = ¼ ‖z‖²
/// dz/dt = ±(i/2)(Ω·σ) z    for Ω = dh(Π)
/// ```
///
/// The upper signs belong to the right action z ↦ U∗z and the minus bracket ([`HOPF`]), the lower signs to
/// the left action. The fibres are the circles exp(is) z, with momentum −½‖z‖².
///
/// Source: McLachlan, Modin & Verdier, *Collective Lie–Poisson integrators on R³*, IMA J. Numer.
/// Anal. 35 (2015), §2.
///
/// # Example
/// ```
/// use lie_poisson::Covector;
/// use momentum_map::{HOPF, Lift, PoissonMap};
/// use nalgebra::Vector3;
/// let pi = Covector(Vector3::new(0.3, 0.4, -1.2));
/// let z = HOPF.lift(&pi)?;
/// assert!((HOPF.apply(&z) - pi).0.norm() < 1e-15);
/// assert!((z.norm_squared() / 4.0 - 1.3).abs() < 1e-15);
/// # Ok::<(), momentum_map::LiftError>(())
/// ```
pub type HopfRealisation = QuadraticMomentumMap<So3OnC2>;

/// The Hopf realisation C² → so(3)∗ with the minus bracket.
pub const HOPF: HopfRealisation = QuadraticMomentumMap::new(So3OnC2, Side::Right);

impl Lift for HopfRealisation {
    /// Returns a point of the fibre over Π, by a section of the Hopf fibration with two charts.
    ///
    /// # Errors
    /// Returns [`LiftError`] if Π = 0, where the fibre degenerates to a point, if Π is not finite, or if it
    /// is so large that 2|Π| = ½‖z‖² overflows.
    fn lift<T: Real>(&self, mu: &TargetPoint<Self, T>) -> Result<SourcePoint<Self, T>, LiftError> {
        let quantity = "Π";
        let mu = LiftError::unless_finite(*mu, quantity, mu.max_abs(), "Π must be finite")?;
        if euclidean_norm(&mu.0).at_most(T::zero()).any() {
            return Err(LiftError { quantity, value: 0.0, reason: "Π must be different from 0" });
        }
        // The lift of 4Π is exactly twice that of Π.
        let sign = match self.side() {
            Side::Left => 1.0,
            Side::Right => -1.0,
        };
        let z = hopf_section(&(mu.0 * T::from_f64(sign))).map(|z| z.scale(T::from_f64(2.0)));
        let range = Pair(z, self.apply::<T>(&z));
        let reason = "the coordinates of Π must be below 5e307, so that 2|Π| is a number";
        Ok(LiftError::unless_finite(range, quantity, mu.max_abs(), reason)?.0)
    }
}

impl FibreSymmetry for HopfRealisation {
    const COUNT: usize = 1;

    /// Returns the flow exp(is) z along the Hopf circle.
    fn flow<T: Real>(&self, index: usize, s: T, z: &Vector2<Complex<T>>) -> Vector2<Complex<T>> {
        if index > 0 {
            return *z;
        }
        let square = s * s;
        let phase = Complex { re: square.stumpff(0), im: s * square.stumpff(1) };
        z.map(|z| z * phase)
    }

    /// Returns the momentum −½‖z‖².
    fn momentum<T: Real>(&self, index: usize, z: &Vector2<Complex<T>>) -> T {
        if index > 0 { T::zero() } else { (z.x.norm_sqr() + z.y.norm_sqr()) * -0.5 }
    }
}
