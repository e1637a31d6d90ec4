//! Rotations about a principal axis by shears: [`PrincipalTurn`].

use lie_poisson::Real;
use nalgebra::Vector3;

/// The rotation about e_i by an angle θ, in the positive sense.
///
/// Three shears make up the rotation. They are applied to v or −v, whichever they turn by no more than π/2:
///
/// ```text
/// x ← x − y tan θ/2,    y ← y + x sin θ,    x ← x − y tan θ/2
/// ```
///
/// Shears with any coefficients conserve areas, so that many rotations by one angle, as those of Lagrange's top about
/// its axis, stay on an ellipse that is a circle to round-off. A matrix of rounded cosines and sines stretches each
/// time by the same 1e-16.
///
/// Source: Paeth, *A fast algorithm for general raster rotation*, Graphics Interface (1986).
#[derive(Clone, Copy, Debug)]
pub(crate) struct PrincipalTurn<T> {
    axis: usize,
    /// 1 or −1: of v and −v, the one that the shears turn by no more than π/2.
    sign: T,
    half_tangent: T,
    sine: T,
}

impl<T: Real> PrincipalTurn<T> {
    /// Creates the rotation about the axis with this index, from 0 to 2.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn new(axis: usize, angle: T) -> Self {
        let square = angle * angle;
        let (cos, sin) = (square.stumpff(0), angle * square.stumpff(1));
        let sign = T::select(T::zero().at_most(cos), T::one(), -T::one());
        let (cos, sine) = (sign * cos, sign * sin);
        Self { axis, sign, half_tangent: sine / (cos + T::one()), sine }
    }

    /// Returns the vector v rotated by this turn.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn apply(&self, v: &Vector3<T>) -> Vector3<T> {
        match self.axis {
            0 => {
                let (y, z) = self.in_plane(v.y, v.z);
                Vector3::new(v.x, y, z)
            }
            1 => {
                let (z, x) = self.in_plane(v.z, v.x);
                Vector3::new(x, v.y, z)
            }
            _ => {
                let (x, y) = self.in_plane(v.x, v.y);
                Vector3::new(x, y, v.z)
            }
        }
    }

    #[cfg_attr(optimised, inline(always))]
    fn in_plane(&self, x: T, y: T) -> (T, T) {
        let (x, y) = (self.sign * x, self.sign * y);
        let x = x - self.half_tangent * y;
        let y = y + self.sine * x;
        (x - self.half_tangent * y, y)
    }
}
