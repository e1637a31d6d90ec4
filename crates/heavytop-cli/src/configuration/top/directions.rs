//! Directions as unit vectors and as angles.

use lie_poisson::euclidean_norm;
use nalgebra::Vector3;

/// Returns the vector, scaled to length 1 if it shall be.
pub(super) fn scaled(vector: [f64; 3], normalise: bool) -> [f64; 3] {
    if normalise { normalised(vector) } else { vector }
}

/// Returns the vector, scaled to length 1 if it has a direction.
pub(in crate::configuration) fn normalised(vector: [f64; 3]) -> [f64; 3] {
    let length = euclidean_norm(&Vector3::from(vector));
    if length > 0.0 && length.is_finite() { vector.map(|x| x / length) } else { vector }
}

// Uses `libm`, which gives the same bits on every machine.

/// Returns the inclination and the azimuth of a vector, rad.
pub(in crate::configuration) fn angles(&[x, y, z]: &[f64; 3]) -> [f64; 2] {
    [libm::atan2(libm::sqrt(x * x + y * y), z), libm::atan2(y, x)]
}

/// Returns the unit vector of an inclination and an azimuth, rad.
pub(in crate::configuration) fn unit_vector(inclination: f64, azimuth: f64) -> [f64; 3] {
    let ((s, c), (sin, cos)) = (libm::sincos(inclination), libm::sincos(azimuth));
    [s * cos, s * sin, c]
}
