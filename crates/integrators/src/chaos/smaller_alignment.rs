//! SALI: the smaller alignment index.

use lie_poisson::State;

/// Returns SALI, the smaller alignment index of two tangent vectors of length 1, between 0 and √2:
///
/// ```text
/// SALI = min(‖v + w‖, ‖v − w‖)
/// ```
///
/// The norm is the Euclidean norm of coordinates. Vectors of several blocks, such as (Π, Γ), are given in units of the
/// scales of the blocks, as [`VariationalFlow::directions`](crate::VariationalFlow::directions) returns them. Along a chaotic trajectory any two tangent vectors turn towards the
/// most unstable direction. The index then falls as exp(−(λ₁ − λ₂)t) down to round-off, where λ₁ ≥ λ₂ are the largest
/// Lyapunov exponents. On a torus of dimension 2 or more it stays away from 0. On a closed curve it falls as a power of
/// t.
///
/// Source: Ch. Skokos, *Alignment indices: a new, simple method for determining the ordered or chaotic
/// nature of orbits*, J. Phys. A 34 (2001).
///
/// # Example
/// A saddle with λ = ±1, and a rotation, along which tangent vectors do not align:
/// ```
/// use collective_integrators::{
///     Direct, RungeKutta, VariationalFlow, VectorField, smaller_alignment_index,
/// };
/// use lie_poisson::Real;
/// use nalgebra::Vector2;
/// struct Linear(f64);
/// impl<T: Real> VectorField<T> for Linear {
///     type Point = Vector2<T>;
///     fn at(&self, z: &Vector2<T>) -> Vector2<T> {
///         Vector2::new(z.y, z.x * self.0)
///     }
/// }
/// let sali = |sign: f64| {
///     let gauss = Direct::new(RungeKutta::gauss(2)?, Linear(sign));
///     let tangents = [Vector2::x(), Vector2::y()];
///     let mut flow = VariationalFlow::new(&gauss, Vector2::zeros(), tangents, 0.1);
///     for _ in 0..50 {
///         flow.advance()?;
///         flow.normalise()?;
///     }
///     Ok::<_, Box<dyn std::error::Error>>(smaller_alignment_index(&flow.directions()?))
/// };
/// // the angle between (cosh t, sinh t) and (sinh t, cosh t) at t = 5 is 2 exp(−2t)
/// assert!((sali(1.0)? / (2.0 * (-10.0_f64).exp()) - 1.0).abs() < 1e-5);
/// assert!((sali(-1.0)? - 2.0_f64.sqrt()).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn smaller_alignment_index<V: State<Scalar = f64>>([v, w]: &[V; 2]) -> f64 {
    let norm = |sign: f64| {
        let square = |i| (v.coordinate(i) + sign * w.coordinate(i)).powi(2);
        (0..v.dimension()).map(square).sum::<f64>().sqrt()
    };
    let (sum, difference) = (norm(1.0), norm(-1.0));
    // The comparison returns a NaN if there is one.
    if sum < difference { sum } else { difference }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    #[test]
    fn parallel_and_antiparallel_are_aligned_and_nan_is_nan() {
        let v = Vector3::new(0.6, 0.0, 0.8);
        let index = |w| smaller_alignment_index(&[v, w]);
        assert_eq!((index(v), index(-v)), (0.0, 0.0));
        assert!((index(Vector3::y()) - 2.0_f64.sqrt()).abs() < 1e-15);
        assert!(index(v * f64::NAN).is_nan());
    }
}
