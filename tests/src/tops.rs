//! Tops and starting points for tests.

use heavytop::{Body, HeavyTop, TopError};
use lie_poisson::Se3Dual;
use nalgebra::Vector3;

/// Returns the Kovalevskaya top of the paper's experiment, m = g = l = I₃ = 1. Source: Ohsawa 2019, §5.2.
///
/// # Errors
/// There is none with these parameters.
pub fn paper() -> Result<HeavyTop, TopError> {
    HeavyTop::kovalevskaya(1.0, 1.0)
}

/// Returns the paper's initial condition Π = (2, 3, 4), Γ = (1/2, 0, √3/2). Source: Ohsawa 2019, §5.2.
pub fn paper_start() -> Se3Dual {
    Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.5, 0.0, 0.75_f64.sqrt()))
}

/// Returns (Π, Γ) of the paper's experiment at t = 1, computed with 25 digits.
#[must_use]
pub fn paper_exact() -> Se3Dual {
    Se3Dual::new(
        Vector3::new(2.611_034_121_401_548, -2.670_466_863_410_764, 3.844_759_745_406_407_6),
        Vector3::new(0.871_688_137_126_708_8, -0.145_727_408_391_562_16, 0.467_892_417_160_234_5),
    )
}

/// Returns a top without any symmetry: three different moments, c in no coordinate plane.
///
/// # Errors
/// There is none with these parameters.
pub fn generic() -> Result<HeavyTop, TopError> {
    HeavyTop::new(&Body {
        inertia: Vector3::new(1.0, 1.4, 2.1),
        mass: 0.7,
        gravity: 9.81,
        length: 0.2,
        center_of_mass: Vector3::new(2.0, -3.0, 6.0) / 7.0,
    })
}

/// Returns a state of the generic top, in general position.
pub fn generic_start() -> Se3Dual {
    Se3Dual::new(Vector3::new(1.2, -0.7, 2.3), Vector3::new(2.0, 6.0, -3.0) / 7.0)
}
