//! The splitting of a symmetric top into the free symmetric top and its weight.

use crate::attitude::step_rotation::TurningFlows;
use crate::error::TopError;
use crate::splittings::principal_turn::PrincipalTurn;
use crate::splittings::rotors::{axial_turn, kick, rotated};
use crate::tops::top::HeavyTop;
use collective_integrators::ExactFlows;
use lie_poisson::{Covector, LieGroup, Pair, Quaternion, Real, SP1, Se3Dual};
use nalgebra::Vector3;

/// The splitting of a top with I₁ = I₂ into the free symmetric top, solved exactly, and the weight.
///
/// Their Hamiltonians and flows are
///
/// ```text
/// h = [ |Π|²/2I₁ + ½(1/I₃ − 1/I₁) Π₃² ] + m g l Γ·c
/// φ_1^t: Γ turns about Π by the angle −t|Π|/I₁,
///        then Π and Γ turn about e₃ by the angle −t(1/I₃ − 1/I₁)Π₃
/// φ_2^t: Π ← Π + t m g l Γ×c
/// ```
///
/// The two rotations of φ_1 commute. Free motion is exact, and the error is proportional to the weight. The splitting
/// therefore suits fast tops. The centre of mass may lie in any direction: along e₃ as for Lagrange's top, along e₁ as
/// for Kovalevskaya's, or along another.
///
/// Source: Touma & Wisdom, *Lie–Poisson integrators for rigid body dynamics in the solar system*,
/// Astron. J. 107 (1994).
///
/// # Example
/// ```
/// use collective_integrators::{Splitting, Start};
/// use heavytop::{HeavyTop, SymmetricTopSplitting};
/// use lie_poisson::Se3Dual;
/// use nalgebra::Vector3;
/// let flows = SymmetricTopSplitting::new(HeavyTop::lagrange(2.0, 1.0, 1.0)?)?;
/// let start = Se3Dual::new(Vector3::new(0.1, 0.3, 4.0), Vector3::new(0.6, 0.0, 0.8));
/// for sample in Splitting::strang(flows).trajectory(&start, 0.1)?.take(500) {
///     // Π₃ is conserved by Lagrange's top, and by each of the two flows
///     assert!((sample?.momentum.0.0.z - 4.0).abs() < 1e-13);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SymmetricTopSplitting {
    top: HeavyTop,
}

impl SymmetricTopSplitting {
    /// Creates the two flows of a top that is symmetric about e₃.
    ///
    /// # Errors
    /// Returns [`TopError::NotSymmetricTop`] unless I₁ = I₂ exactly.
    pub fn new(top: HeavyTop) -> Result<Self, TopError> {
        let (first, second) = (top.inertia().x, top.inertia().y);
        if first == second {
            Ok(Self { top })
        } else {
            Err(TopError::NotSymmetricTop { first, second })
        }
    }

    /// Returns the top that is split.
    #[must_use]
    pub fn top(&self) -> &HeavyTop {
        &self.top
    }

    /// Returns the rotation vector −tΠ/I₁ and the angle −t(1/I₃ − 1/I₁)Π₃ about e₃.
    #[inline]
    fn free_turns<T: Real>(&self, time: f64, pi: &Vector3<T>) -> (Vector3<T>, T) {
        let inertia = self.top.inertia();
        // A thin rod does not turn about itself.
        let about_axis = match inertia.z == 0.0 {
            true => 0.0,
            false => -time * (1.0 / inertia.z - 1.0 / inertia.x),
        };
        (pi * T::from_f64(-time / inertia.x), pi.z * about_axis)
    }
}

impl<T: Real> ExactFlows<T> for SymmetricTopSplitting {
    type Point = Se3Dual<T>;
    const COUNT: usize = 2;

    #[inline]
    fn flow(&self, index: usize, time: f64, mu: &Se3Dual<T>) -> Se3Dual<T> {
        let Covector(Pair(pi, gamma)) = mu;
        match index {
            0 => {
                let (about_pi, angle) = self.free_turns(time, pi);
                let about_axis = PrincipalTurn::new(2, angle);
                Se3Dual::new(about_axis.apply(pi), about_axis.apply(&rotated(&about_pi, gamma)))
            }
            1 => kick(&self.top, time, mu),
            _ => *mu,
        }
    }
}

impl<T: Real> TurningFlows<T> for SymmetricTopSplitting {
    #[inline]
    fn flow_turn(&self, index: usize, time: f64, mu: &Se3Dual<T>) -> Quaternion<T> {
        if index > 0 {
            return Quaternion::one();
        }
        let (about_pi, angle) = self.free_turns(time, &mu.0.0);
        axial_turn(2, angle) * SP1.exp(&about_pi)
    }
}
