//! The inertia of a rigid body in its principal axes.

use crate::error::{SystemError, require_finite, require_positive};
use lie_poisson::Real;
use nalgebra::Vector3;

/// The inverses of the principal moments I₁, I₂, I₃, kg⁻¹ m⁻².
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PrincipalMoments {
    inverse: Vector3<f64>,
}

impl PrincipalMoments {
    /// Creates the inverses from the moments I₁, I₂, I₃, kg m².
    ///
    /// # Errors
    /// Returns [`SystemError`] unless the moments are positive, obey the triangle inequality and have finite
    /// inverses.
    pub(crate) fn new(inertia: &Vector3<f64>) -> Result<Self, SystemError> {
        for (name, &value) in ["inertia[0]", "inertia[1]", "inertia[2]"].iter().zip(inertia) {
            require_positive(name, value)?;
        }
        require_triangle(inertia)?;
        let inverse = inertia.map(|moment| 1.0 / moment);
        for (name, &value) in ["1/inertia[0]", "1/inertia[1]", "1/inertia[2]"].iter().zip(&inverse)
        {
            require_finite(name, value)?;
        }
        Ok(Self { inverse })
    }

    /// Returns the angular velocity I⁻¹Π, rad/s.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn angular_velocity<T: Real>(&self, pi: &Vector3<T>) -> Vector3<T> {
        pi.zip_map(&self.inverse, |pi, inverse| pi * inverse)
    }
}

fn require_triangle(inertia: &Vector3<f64>) -> Result<(), SystemError> {
    // A flat body has I₁ + I₂ = I₃, which rounding may break by a few units.
    const SLACK: f64 = 1.0 + 1e-12;
    for i in 0..3 {
        let (largest, first, second) = (inertia[i], inertia[(i + 1) % 3], inertia[(i + 2) % 3]);
        if largest > (first + second) * SLACK {
            return Err(SystemError::Triangle { largest, first, second });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_moment_is_compared_with_the_sum_of_the_others() {
        for axis in 0..3 {
            let mut inertia = Vector3::new(1.0, 1.5, 2.0);
            assert!(require_triangle(&inertia).is_ok());
            inertia[axis] = 4.0;
            let others = [inertia[(axis + 1) % 3], inertia[(axis + 2) % 3]];
            let refused = require_triangle(&inertia);
            let named = matches!(refused, Err(SystemError::Triangle { largest, first, second })
                if largest == 4.0 && [first, second] == others);
            assert!(named, "{refused:?}");
            // A flat body, rounded.
            inertia[axis] = (others[0] + others[1]) * (1.0 + f64::EPSILON);
            assert!(require_triangle(&inertia).is_ok());
        }
    }
}
