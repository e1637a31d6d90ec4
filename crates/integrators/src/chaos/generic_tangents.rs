//! Initial tangent vectors for the indicators of chaos.

use lie_poisson::Vector;

/// Returns initial tangent vectors for a chaos indicator, one after the other: they have no symmetry and are linearly
/// independent.
///
/// Vector n, counted from 0, has the coordinates x_i = (m² g mod 1) − ½ with m = n·d + i + 1 and g = (√5 − 1)/2, for the
/// first d = `dimension` coordinates, and zeros in the coordinates that follow. For n ≥ d it is the basis vector e_n.
///
/// The coordinates are numbers: in a space whose blocks have different units they are those in units of the scales of
/// the blocks. [`VariationalFlow::generic`](crate::VariationalFlow::generic) multiplies by these scales.
///
/// Source: the squares in Weyl's sequence; H. Weyl, *Über die Gleichverteilung von Zahlen mod. Eins*, Math. Ann. 77
/// (1916).
///
/// # Example
/// ```
/// use collective_integrators::generic_tangents;
/// use nalgebra::{Matrix3, Vector3};
/// let tangents: Vec<Vector3<f64>> = generic_tangents(3).take(3).collect();
/// assert!(Matrix3::from_columns(&tangents).determinant().abs() > 1e-3);
/// let first: Option<Vector3<f64>> = generic_tangents(2).next();
/// assert!(first.is_some_and(|v| v.x != 0.0 && v.z == 0.0));
/// ```
pub fn generic_tangents<V: Vector<Scalar = f64>>(dimension: usize) -> impl Iterator<Item = V> {
    (0..).map(move |number| V::from_coordinates(|i| generic_coordinate(number, dimension, i)))
}

/// Returns coordinate i of one of the [`generic_tangents`].
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
        let tangents: Vec<Space> = generic_tangents(4).take(5).collect();
        let (tangents, fifth) = (&tangents[..4], tangents[4]);
        for v in tangents {
            assert!((0..6).all(|i| (v[i] != 0.0) == (i < 4) && v[i].abs() < 0.5), "{v}");
        }
        let square = Matrix4::from_fn(|i, j| tangents[j][i]);
        assert!(square.determinant().abs() > 1e-3);
        assert_eq!(fifth, Space::ith(4, 1.0));
    }
}
