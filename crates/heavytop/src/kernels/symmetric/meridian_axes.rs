//! Axes in which a vector has no second component: [`MeridianAxes`].

use lie_poisson::Lanes;
use nalgebra::Vector3;

/// The axes turned about e₃ by the angle φ, |φ| ≤ π/2, from e₁ to the meridian of a vector or to the opposite
/// one.
///
/// Three shears make the rotation, and the same shears in reverse undo it. The round trip is the identity
/// whatever the rounding of the shears, so that no error grows with the number of rotations. Axes of a vector
/// without a second component change nothing.
///
/// Source: Paeth, *A fast algorithm for general raster rotation*, Graphics Interface (1986).
#[derive(Clone, Copy, Default)]
pub(crate) struct MeridianAxes<T> {
    /// The half tangent tan φ/2.
    half_tangent: T,
    /// The sine of φ.
    sine: T,
}

impl MeridianAxes<f64> {
    /// Creates the axes of a vector, and returns them with its components 1 and 3.
    #[inline]
    pub(crate) fn new(v: &Vector3<f64>) -> (Self, [f64; 2]) {
        if v.y == 0.0 {
            return (Self { half_tangent: 0.0, sine: 0.0 }, [v.x, v.z]);
        }
        let horizontal = v.x.hypot(v.y).copysign(v.x);
        let axes = Self { half_tangent: v.y / (horizontal + v.x), sine: v.y / horizontal };
        (axes, [horizontal, v.z])
    }
}

impl<T: Lanes> MeridianAxes<T> {
    /// Gathers axes into lanes: lane i is f(i).
    #[inline(always)]
    pub(crate) fn from_lanes<'a>(f: impl Fn(usize) -> &'a MeridianAxes<f64>) -> Self {
        Self {
            half_tangent: T::from_lanes(|i| f(i).half_tangent),
            sine: T::from_lanes(|i| f(i).sine),
        }
    }

    /// Returns the components of v in these axes.
    #[inline(always)]
    pub(crate) fn components(&self, [x, y, z]: [T; 3]) -> [T; 3] {
        let x = self.half_tangent.multiply_add(y, x);
        let y = self.sine.negative_multiply_add(x, y);
        [self.half_tangent.multiply_add(y, x), y, z]
    }

    /// Returns the vector with these components.
    #[inline(always)]
    pub(crate) fn vector(&self, [x, y, z]: [T; 3]) -> [T; 3] {
        let x = self.half_tangent.negative_multiply_add(y, x);
        let y = self.sine.multiply_add(x, y);
        [self.half_tangent.negative_multiply_add(y, x), y, z]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const VECTORS: [[f64; 3]; 5] = [
        [0.6, 0.48, 0.64],
        [-0.6, 0.48, 0.64],
        [-2.0, -1e-9, 1.0],
        [0.0, -3.0, 0.0],
        [1e-9, 2.0, 0.0],
    ];

    #[test]
    fn second_component_vanishes() {
        for v in VECTORS {
            let (axes, [first, third]) = MeridianAxes::new(&Vector3::from(v));
            let [x, y, z] = axes.components(v);
            // Three shears round three times.
            let tolerance = 4.0 * f64::EPSILON * first.abs();
            assert!((x - first).abs() <= tolerance && y.abs() <= tolerance && z == third, "{v:?}");
            // Negative control: in the axes given there is a second component.
            assert!(v[1].abs() > tolerance);
        }
    }

    #[test]
    fn axes_of_a_vector_without_second_component_change_nothing() {
        for v in [[1.0, 0.0, 2.0], [-1.0, -0.0, 2.0], [0.0; 3]] {
            let (axes, force) = MeridianAxes::new(&Vector3::from(v));
            assert_eq!(force, [v[0], v[2]]);
            assert_eq!(axes.components([0.1, 0.2, 0.3]), [0.1, 0.2, 0.3]);
            assert_eq!(axes.vector([0.1, 0.2, 0.3]), [0.1, 0.2, 0.3]);
        }
    }

    /// A matrix of rounded sines and cosines would stretch by 1e-16 each time.
    #[test]
    fn there_and_back_does_not_stretch() {
        for v in VECTORS {
            let (axes, _) = MeridianAxes::new(&Vector3::from(v));
            let mut u = [0.7, -0.4, 0.1];
            for _ in 0..100_000 {
                u = axes.vector(axes.components(u));
            }
            // 6·10⁵ roundings of 1e-16/√12 at random: 2e-14. All one way they would be 6e-11.
            let length = Vector3::from(u).norm_squared();
            assert!((length - 0.66).abs() < 2e-13, "{:e}", length - 0.66);
        }
    }
}
