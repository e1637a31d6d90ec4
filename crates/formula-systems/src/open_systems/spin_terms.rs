//! Gilbert's damping of spins by formula, and the noise of a temperature that goes with it.

use crate::algebras::system_algebra::SystemAlgebra;
use crate::open_system_error::OpenSystemError;
use lie_poisson::{Real, StructureEntry, euclidean_norm, gilbert_element};
use nalgebra::Vector3;

/// The rounding of structure constants that are computed, such as those of su(2).
const ROUND_OFF: f64 = 1e-14;

/// Checks that the coordinates of an algebra are those of spins, one after the other: that it is a sum of so(3), with
/// [e₁, e₂] = e₃ and so on in each triple, whatever it is called.
pub(super) fn require_spins(algebra: &SystemAlgebra) -> Result<(), OpenSystemError> {
    let (dimension, entries) = (algebra.dimension(), algebra.table().entries());
    let is_of_spins = dimension % 3 == 0 && entries.len() == 2 * dimension;
    match is_of_spins && entries.iter().all(is_of_rotations) {
        true => Ok(()),
        false => Err(OpenSystemError::NoSpins { algebra: algebra.name().into() }),
    }
}

/// Returns whether a structure constant is one of ε in its triple of coordinates.
fn is_of_rotations(&StructureEntry { i, j, k, value }: &StructureEntry) -> bool {
    let sign = if (i + 1) % 3 == j % 3 { 1.0 } else { -1.0 };
    let are_different = i != j && j != k && k != i;
    are_different
        && [j, k].map(|other| other / 3) == [i / 3; 2]
        && (value - sign).abs() <= ROUND_OFF
}

/// Damps an element ξ of the algebra, which makes the rate Λ ξ, by Gilbert's equation.
pub(super) fn damp_spins<T: Real>(damping: f64, mu: &[T], rate: &[T], xi: &mut [T]) {
    let spins = mu.as_chunks::<3>().0.iter().zip(rate.as_chunks::<3>().0);
    for (xi, (spin, rate)) in xi.as_chunks_mut::<3>().0.iter_mut().zip(spins) {
        *xi = gilbert_element(damping, [*spin, *rate, *xi]);
    }
}

/// Adds the noise of a temperature to an element of the algebra.
pub(super) fn shake_spins<T: Real>(
    damping: f64,
    temperature: f64,
    (mu, weights): (&[T], &[T]),
    xi: &mut [T],
) {
    let spins = mu.as_chunks::<3>().0.iter().zip(weights.as_chunks::<3>().0);
    for (xi, (spin, weights)) in xi.as_chunks_mut::<3>().0.iter_mut().zip(spins) {
        let strength = thermal_strength(damping, temperature, *spin);
        xi.iter_mut().zip(weights).for_each(|(xi, weight)| *xi += *weight * strength);
    }
}

/// Returns √(2bkT) with the friction b = α/((1 + α²)|s|) of a spin; 0 for a spin of length 0, which stays where it is.
pub(super) fn thermal_strength<T: Real>(damping: f64, temperature: f64, spin: [T; 3]) -> T {
    let length = euclidean_norm(&Vector3::from(spin));
    let is_zero = length.at_most(T::zero());
    let divisor = T::select(is_zero, T::one(), length);
    // Roots of each, since products may overflow.
    let friction = 2.0_f64.sqrt() * damping.sqrt() / (1.0 + damping * damping).sqrt();
    let strength = T::from_f64(friction * temperature.sqrt()) / divisor.sqrt();
    T::select(is_zero, T::zero(), strength)
}
