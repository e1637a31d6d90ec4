//! Rotations about e₃ by shears: [`AxialTurn`].

use lie_poisson::Lanes;
use nalgebra::Vector3;

/// The rotation about e₃ by an angle φ, |φ| ≤ π/2, as three shears:
///
/// ```text
/// x ← x − y tan φ/2,    y ← y + x sin φ,    x ← x − y tan φ/2
/// ```
///
/// The same shears in reverse undo it, whatever their rounding. Shears conserve areas, so that many rotations by one
/// angle stay on an ellipse that is a circle to round-off. A matrix of rounded cosines and sines stretches each time by
/// the same 1e-16.
///
/// Source: Paeth, *A fast algorithm for general raster rotation*, Graphics Interface (1986).
#[derive(Clone, Copy, Default)]
pub(crate) struct AxialTurn<T> {
    /// The half tangent tan φ/2.
    pub(crate) half_tangent: T,
    /// The sine of φ.
    pub(crate) sine: T,
}

impl AxialTurn<f64> {
    /// Creates the turn of e₁ to the meridian of a vector or to the opposite one, and returns it with the components 1
    /// and 3 of the vector in the turned axes. The second is 0. For a vector without a second component the axes do not
    /// turn.
    #[inline]
    pub(crate) fn of_axes(v: &Vector3<f64>) -> (Self, [f64; 2]) {
        if v.y == 0.0 {
            return (Self { half_tangent: 0.0, sine: 0.0 }, [v.x, v.z]);
        }
        let horizontal = v.x.hypot(v.y).copysign(v.x);
        let turn = Self { half_tangent: v.y / (horizontal + v.x), sine: v.y / horizontal };
        (turn, [horizontal, v.z])
    }
}

impl<T: Lanes> AxialTurn<T> {
    /// Gathers turns into lanes: lane i is f(i).
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn from_lanes<'a>(f: impl Fn(usize) -> &'a AxialTurn<f64>) -> Self {
        Self {
            half_tangent: T::from_lanes(|i| f(i).half_tangent),
            sine: T::from_lanes(|i| f(i).sine),
        }
    }

    /// Returns v turned backwards: its components in the turned axes.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn undo(&self, [x, y, z]: [T; 3]) -> [T; 3] {
        let x = self.half_tangent.multiply_add(y, x);
        let y = self.sine.negative_multiply_add(x, y);
        [self.half_tangent.multiply_add(y, x), y, z]
    }

    /// Returns v turned: the vector with these components in the turned axes.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn apply(&self, [x, y, z]: [T; 3]) -> [T; 3] {
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
            let (turn, [first, third]) = AxialTurn::of_axes(&Vector3::from(v));
            let [x, y, z] = turn.undo(v);
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
            let (turn, force) = AxialTurn::of_axes(&Vector3::from(v));
            assert_eq!(force, [v[0], v[2]]);
            assert_eq!(turn.undo([0.1, 0.2, 0.3]), [0.1, 0.2, 0.3]);
            assert_eq!(turn.apply([0.1, 0.2, 0.3]), [0.1, 0.2, 0.3]);
        }
    }

    /// A matrix of rounded sines and cosines would stretch by 1e-16 each time.
    #[test]
    fn there_and_back_does_not_stretch() {
        for v in VECTORS {
            let (turn, _) = AxialTurn::of_axes(&Vector3::from(v));
            let mut u = [0.7, -0.4, 0.1];
            for _ in 0..100_000 {
                u = turn.apply(turn.undo(u));
            }
            // 6·10⁵ roundings of 1e-16/√12 at random: 2e-14. All one way they would be 6e-11.
            let length = Vector3::from(u).norm_squared();
            assert!((length - 0.66).abs() < 2e-13, "{:e}", length - 0.66);
        }
    }

    #[test]
    fn many_turns_by_one_angle_do_not_stretch() {
        let mut worst = 0.0_f64;
        for angle in [-1.4_f64, -0.3, 0.016, 0.5, 1.0] {
            let (cosine, sine) = (angle.cos(), angle.sin());
            let turn = AxialTurn { half_tangent: (angle / 2.0).tan(), sine };
            let (mut u, mut v) = ([0.7, -0.4, 0.1], [0.7, -0.4, 0.1]);
            for _ in 0..100_000 {
                u = turn.apply(u);
                v = [cosine * v[0] - sine * v[1], sine * v[0] + cosine * v[1], v[2]];
            }
            let stretch = |u: [f64; 3]| (Vector3::from(u).norm_squared() - 0.66).abs();
            // 3·10⁵ roundings of 1e-16/√12 at random: 1.6e-14.
            assert!(stretch(u) < 1.6e-13, "{angle}: {:e}", stretch(u));
            worst = worst.max(stretch(v));
        }
        // Negative control: matrices stretch by up to 1e-16 each time.
        assert!(worst > 1e-12, "{worst:e}");
    }
}
