//! The state of a top with its attitude, at one moment.

use lie_poisson::{Quaternion, Se3Dual};

/// The state of a top at one moment, whatever method computes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Snapshot {
    /// The state (Π, Γ) in the body frame, Π in kg m²/s.
    pub momentum: Se3Dual,
    /// The quaternion of the rotation R from the body frame to the spatial frame, of length 1.
    pub attitude: Quaternion,
}

impl Snapshot {
    /// Creates the snapshot, with the quaternion scaled to the length 1. If it has that length up to rounding, as those of
    /// all methods but the explicit ones, it keeps its bits.
    pub(crate) fn new(momentum: Se3Dual, attitude: Quaternion) -> Self {
        let square = attitude.norm_squared();
        if (square - 1.0).abs() < 1e-12 {
            return Self { momentum, attitude };
        }
        let scale = 1.0 / square.sqrt();
        let Quaternion { scalar, vector } = attitude;
        let attitude = Quaternion { scalar: scalar * scale, vector: vector * scale };
        Self { momentum, attitude }
    }
}
