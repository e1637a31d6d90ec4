//! Tangent vectors made orthonormal: the Gram–Schmidt process, whatever the sizes of the vectors.

use crate::chaos::tangent_integrator::VariationalError;
use lie_poisson::{State, euclidean_norm, squaring_scale};

/// The relative size of the remainder of a vector that is a combination of others.
const ROUND_OFF: f64 = 64.0 * f64::EPSILON;

/// Makes vectors orthonormal in the Euclidean product of their coordinates, and writes the lengths of what each has at
/// right angles to those before it to `lengths`. `spare` has temporary vectors, and `time` is that of an error. It is
/// compiled once for any number of vectors.
///
/// # Errors
/// Returns [`VariationalError::Dependent`] for the first vector that is a combination of those before it to round-off, or
/// whose length is zero or not finite. The vectors before it are orthonormal then.
#[inline(never)]
pub(super) fn orthonormalise<V: State<Scalar = f64>>(
    vectors: &mut [V],
    spare: &mut [V],
    lengths: &mut [f64],
    time: f64,
) -> Result<(), VariationalError> {
    for (index, (stretch, rest)) in lengths.iter_mut().zip(spare).enumerate() {
        let (before, others) = vectors.split_at_mut(index);
        let Some(v) = others.first_mut() else { break };
        let scale = squaring_scale(v);
        rest.assign(v);
        rest.scale_in_place(scale);
        let size = euclidean_norm(rest);
        for e in before.iter() {
            rest.add_multiple(-dot(e, rest), e);
        }
        let rest_size = euclidean_norm(rest);
        let length = rest_size / scale;
        // The condition is false for a NaN, which is then an error.
        let independent = rest_size > ROUND_OFF * size && length > 0.0 && length.is_finite();
        if !independent {
            return Err(VariationalError::Dependent { index, length, time });
        }
        v.move_from(rest);
        v.scale_in_place(rest_size.recip());
        *stretch = length;
    }
    Ok(())
}

/// Returns the Euclidean product Σ u_i v_i of coordinates.
fn dot<V: State<Scalar = f64>>(u: &V, v: &V) -> f64 {
    (0..u.dimension()).map(|i| u.coordinate(i) * v.coordinate(i)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector2;

    #[test]
    fn lengths_are_those_at_right_angles() {
        for size in [1e-200, 1.0, 1e200] {
            let mut vectors = [Vector2::new(3.0, 4.0), Vector2::new(3.0 - 8.0, 4.0 + 6.0)];
            vectors.iter_mut().for_each(|v| *v *= size);
            let mut lengths = [0.0; 2];
            let made = orthonormalise(&mut vectors, &mut [Vector2::zeros(); 2], &mut lengths, 0.0);
            let [r, s] = lengths.map(|length| length / size);
            assert!(made.is_ok() && (r - 5.0).abs() < 1e-14 && (s - 10.0).abs() < 1e-14);
            let [u, v] = vectors;
            assert!((u - Vector2::new(0.6, 0.8)).norm() < 1e-15);
            assert!((v - Vector2::new(-0.8, 0.6)).norm() < 1e-15);
        }
    }

    #[test]
    fn a_dependent_vector_is_named_with_its_time() {
        let mut vectors = [Vector2::x(), Vector2::x() * 2.0];
        let found = orthonormalise(&mut vectors, &mut [Vector2::zeros(); 2], &mut [0.0; 2], 1.5);
        let expected = VariationalError::Dependent { index: 1, length: 0.0, time: 1.5 };
        assert_eq!(found, Err(expected));
    }
}
