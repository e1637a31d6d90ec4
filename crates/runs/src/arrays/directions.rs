//! Directions in space without a pattern, and spins on cones.

use core::f64::consts::TAU;
use nalgebra::Vector3;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// Directions that a seed determines.
pub(super) struct Directions(ChaCha8Rng);

impl Directions {
    pub(super) fn new(seed: u64) -> Self {
        Self(ChaCha8Rng::seed_from_u64(seed))
    }

    /// Returns a number between 0 and 1.
    fn fraction(&mut self) -> f64 {
        // The upper 53 bits are those of a double.
        (self.0.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Returns a unit vector, uniformly distributed among those within an angle of an axis, a unit vector.
    pub(super) fn within(&mut self, angle: f64, axis: &Vector3<f64>) -> Vector3<f64> {
        // 1 − cos of the angle is uniformly distributed on the cap; as twice a squared sine it is right for small angles.
        let versine = self.fraction() * 2.0 * (0.5 * angle).sin().powi(2);
        let phase = TAU * self.fraction();
        on_cone(axis, (versine * (2.0 - versine)).sqrt().atan2(1.0 - versine), phase)
    }
}

/// Returns the unit vector at an angle from an axis, a unit vector, and at a phase about it.
pub(super) fn on_cone(axis: &Vector3<f64>, angle: f64, phase: f64) -> Vector3<f64> {
    // The coordinate axis that is farthest from the axis; x for the axis z, so that the phase of z is the longitude.
    let farthest = if axis.x.abs() <= axis.y.abs() { Vector3::x() } else { Vector3::y() };
    let first = (farthest - axis * axis.dot(&farthest)).normalize();
    let second = axis.cross(&first);
    axis * angle.cos() + (first * phase.cos() + second * phase.sin()) * angle.sin()
}
