//! Initial tangent vectors for the indicators of chaos.

use lie_poisson::Vector;

/// Returns the initial tangent vector with the given index for a chaos indicator.
///
/// The index `number` counts from 0. The vectors have no symmetry, and those of different indices are linearly
/// independent.
///
/// It has the coordinates x_i = (n² g mod 1) − ½ with n = `number`·d + i + 1 and g = (√5 − 1)/2, for the first d =
/// `dimension` coordinates, and zeros in the coordinates that follow. A vector whose index is d or above is the basis
/// vector with this index.
///
/// The coordinates are numbers: in a space whose blocks have different units they are those in units of the scales of
/// the blocks. [`VariationalFlow::generic`](crate::VariationalFlow::generic) multiplies by these scales.
///
/// Source: the squares in Weyl's sequence; H. Weyl, *Über die Gleichverteilung von Zahlen mod. Eins*, Math. Ann. 77
/// (1916).
///
/// # Example
/// ```
/// use collective_integrators::generic_tangent;
/// use nalgebra::{Matrix3, Vector3};
/// let tangents: [Vector3<f64>; 3] = [0, 1, 2].map(|number| generic_tangent(number, 3));
/// assert!(Matrix3::from_columns(&tangents).determinant().abs() > 1e-3);
/// let first: Vector3<f64> = generic_tangent(0, 2);
/// assert!(first.x != 0.0 && first.z == 0.0);
/// ```
#[must_use]
pub fn generic_tangent<V: Vector<Scalar = f64>>(number: usize, dimension: usize) -> V {
    V::from_coordinates(|i| generic_coordinate(number, dimension, i))
}

/// Returns coordinate i of the [`generic_tangent`].
pub(super) fn generic_coordinate(number: usize, dimension: usize, i: usize) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    if number >= dimension || i >= dimension {
        return f64::from(u8::from(number == i));
    }
    let place = number.wrapping_mul(dimension).wrapping_add(i).wrapping_add(1);
    (place.wrapping_mul(place) as f64 * GOLDEN).fract() - 0.5
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix4, SVector};

    #[test]
    fn tangents_have_no_zeros_but_those_that_complete_a_space() {
        type Space = SVector<f64, 6>;
        let tangents: [Space; 4] = [0, 1, 2, 3].map(|number| generic_tangent(number, 4));
        for v in &tangents {
            assert!((0..6).all(|i| (v[i] != 0.0) == (i < 4) && v[i].abs() < 0.5), "{v}");
        }
        let square = Matrix4::from_fn(|i, j| tangents[j][i]);
        assert!(square.determinant().abs() > 1e-3);
        assert_eq!(generic_tangent::<Space>(4, 4), Space::ith(4, 1.0));
    }
}
