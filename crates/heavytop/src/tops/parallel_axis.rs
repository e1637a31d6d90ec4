//! Moments about the support and about the centre of mass.

use crate::error::TopError;
use crate::tops::principal_axes::{PrincipalAxes, symmetric};
use nalgebra::{Matrix3, Vector3};

/// The tolerance of [`require_possible_body`], relative to the largest entry of the inertia matrix about the support. It allows
/// for moments with nine digits.
const TOLERANCE: f64 = 1e-9;

/// Returns the inertia matrix m(|r|² − rrᵀ) of a mass m (kg) at the position r (m), kg m².
///
/// By the parallel-axis theorem, also named after Huygens and Steiner, it is the difference between the inertia matrix of
/// a body about the support and that about its centre of mass. With r = lc,
///
/// ```text
/// I_support = I_cm + m l² (1 − ccᵀ)
/// ```
///
/// Source: H. Goldstein, C. Poole & J. Safko, *Classical Mechanics*, §5.3.
///
/// # Example
/// ```
/// use heavytop::{PrincipalAxes, point_inertia};
/// use nalgebra::{Matrix3, Vector3};
/// // a disc of 0.2 kg, 3 cm above the support: the moments about its centre of mass, and about the support
/// let central = Matrix3::from_diagonal(&Vector3::new(1.0e-4, 1.0e-4, 1.8e-4));
/// let about_support = central + point_inertia(0.2, &Vector3::new(0.0, 0.0, 0.03));
/// let moments = PrincipalAxes::of(&about_support)?.moments();
/// assert!((moments - Vector3::new(2.8e-4, 2.8e-4, 1.8e-4)).norm() < 1e-18);
/// # Ok::<(), heavytop::TopError>(())
/// ```
#[must_use]
pub fn point_inertia(mass: f64, position: &Vector3<f64>) -> Matrix3<f64> {
    (Matrix3::from_diagonal_element(position.norm_squared()) - position * position.transpose())
        * mass
}

/// Checks that a body can have this inertia matrix (kg m²) about the support, with this mass (kg) and the centre of mass at
/// this position (m).
///
/// The moments about the centre of mass, I − m(|r|² − rrᵀ), must not be negative, and none may be larger than the sum of the
/// other two, to within 1e-9 of the largest entry of I. The motion depends on I and m g l alone: a top that fails this
/// check can be integrated, but is no body.
///
/// # Errors
/// Returns [`TopError::ImpossibleBody`] with these moments if there is no such body, and the errors of
/// [`PrincipalAxes::of`].
///
/// # Example
/// ```
/// use heavytop::require_possible_body;
/// use nalgebra::{Matrix3, Vector3};
/// let sphere = Matrix3::from_diagonal_element(1.4); // about a point of its surface, and of a diameter
/// let position = Vector3::new(0.6, 0.0, 0.8);
/// assert!(require_possible_body(&sphere, 1.0, &position).is_err()); // 0.4, 0.4, 1.4 about the centre
/// assert!(require_possible_body(&sphere, 0.1, &position).is_ok());
/// ```
pub fn require_possible_body(
    inertia: &Matrix3<f64>,
    mass: f64,
    position: &Vector3<f64>,
) -> Result<(), TopError> {
    // The difference of a small body is a rounding error, whose own asymmetry says nothing.
    let central = symmetric(inertia)? - point_inertia(mass, position);
    let central = PrincipalAxes::of(&central)?;
    let mut moments: [f64; 3] = central.moments().into();
    moments.sort_by(f64::total_cmp);
    let ([least, middle, greatest], slack) = (moments, TOLERANCE * inertia.amax());
    if least >= -slack && greatest <= least + middle + slack {
        return Ok(());
    }
    let point = mass * position.norm_squared();
    Err(TopError::ImpossibleBody { point, least, middle, greatest })
}
