//! The Euler angles of an attitude: [`EulerAngles`].

use lie_poisson::Quaternion;
use nalgebra::Vector3;

/// The Euler angles of a top, in radians: R = R₃(φ) R₁(θ) R₃(ψ), the convention z–x–z of the books on mechanics.
///
/// R maps the body frame to the spatial frame, and Rᵢ(α) is the rotation by α about the i-th axis. The precession φ turns the
/// axis e₃ of the body about the vertical, the nutation θ is the angle between them, and the spin ψ turns the body about its axis:
///
/// ```text
/// R e₃ = (sin θ sin φ, −sin θ cos φ, cos θ),    Γ = Rᵀ e₃ = (sin θ sin ψ, sin θ cos ψ, cos θ)
/// ```
///
/// Source: H. Goldstein, *Classical Mechanics*, 2nd ed. (1980), §4-4, whose matrix of rotation maps the other way, Rᵀ.
///
/// # Example
/// ```
/// use heavytop::EulerAngles;
/// use nalgebra::Vector3;
/// let angles = EulerAngles { precession: 0.4, nutation: 1.1, spin: -2.0 };
/// let attitude = angles.attitude();
/// let axis = attitude.rotate(&Vector3::z());
/// let expected = 1.1_f64.sin() * Vector3::new(0.4_f64.sin(), -0.4_f64.cos(), 0.0) + Vector3::z() * 1.1_f64.cos();
/// assert!((axis - expected).norm() < 1e-15);
/// let again = EulerAngles::of(&attitude);
/// assert!((again.precession - 0.4).abs() + (again.nutation - 1.1).abs() + (again.spin + 2.0).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EulerAngles {
    /// The precession φ.
    pub precession: f64,
    /// The nutation θ, the inclination of the axis e₃ of the body.
    pub nutation: f64,
    /// The spin ψ.
    pub spin: f64,
}

impl EulerAngles {
    /// Returns the angles of an attitude, a quaternion of any length but 0: φ and ψ above −π and at most π, and θ from 0 to π.
    ///
    /// At the poles only φ + ψ (θ = 0) or φ − ψ (θ = π) has a meaning; there φ = ψ or φ = −ψ, up to a turn. Angles of a
    /// quaternion that is not finite are NaN.
    #[must_use]
    pub fn of(attitude: &Quaternion) -> Self {
        let Quaternion { scalar: w, vector } = attitude;
        if ![*w, vector.x, vector.y, vector.z].iter().all(|x| x.is_finite()) {
            return Self { precession: f64::NAN, nutation: f64::NAN, spin: f64::NAN };
        }
        let [half_sum, half_difference] = [vector.z.atan2(*w), vector.y.atan2(vector.x)];
        Self {
            precession: in_one_turn(half_sum + half_difference),
            nutation: 2.0 * vector.x.hypot(vector.y).atan2(w.hypot(vector.z)),
            spin: in_one_turn(half_sum - half_difference),
        }
    }

    /// Returns the unit quaternion of the angles.
    #[must_use]
    pub fn attitude(&self) -> Quaternion {
        let (sine, cosine) = (self.nutation / 2.0).sin_cos();
        let (sine_of_sum, cosine_of_sum) = ((self.precession + self.spin) / 2.0).sin_cos();
        let (sine_of_difference, cosine_of_difference) =
            ((self.precession - self.spin) / 2.0).sin_cos();
        Quaternion {
            scalar: cosine * cosine_of_sum,
            vector: Vector3::new(
                sine * cosine_of_difference,
                sine * sine_of_difference,
                cosine * sine_of_sum,
            ),
        }
    }
}

/// Returns an angle from −2π to 2π as one above −π and at most π.
fn in_one_turn(angle: f64) -> f64 {
    use core::f64::consts::{PI, TAU};
    if angle > PI {
        angle - TAU
    } else if angle <= -PI {
        angle + TAU
    } else {
        angle
    }
}
