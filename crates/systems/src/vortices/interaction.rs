//! The interaction of every two vortices on the sphere.

use crate::error::{SystemError, require_finite};
use core::f64::consts::PI;
use core::ops::Range;
use lie_poisson::{Real, State};
use nalgebra::Vector3;

/// Refuses a strength that is not finite, or is so near zero that its reciprocal is not finite.
pub(crate) fn require_strength(value: f64) -> Result<(), SystemError> {
    require_finite("strength", value)?;
    let regular = value.recip().is_finite();
    if regular { Ok(()) } else { Err(SystemError::Zero { name: "strength" }) }
}

/// Returns h = (1/4π) Σ_ij k_i k_j ln(2 − 2 x_i·x_j), i < j, for the strengths k and the positions x.
pub(crate) fn energy<T: Real>(strengths: &[f64], x: impl Fn(usize) -> Vector3<T>) -> T {
    pairs(strengths, x, 0..strengths.len()) / (4.0 * PI)
}

/// Returns Σ_ij k_i k_j ln(2 − 2 x_i·x_j), j < i, for the numbers i of a range.
pub(crate) fn pairs<T: Real>(
    strengths: &[f64],
    x: impl Fn(usize) -> Vector3<T>,
    range: Range<usize>,
) -> T {
    let mut sum = T::zero();
    for i in range {
        let (x_i, k_i) = (x(i), strengths[i]);
        for (j, k_j) in strengths[..i].iter().enumerate() {
            sum += (-x_i.dot(&x(j)) * 2.0 + 2.0).ln() * (k_i * k_j);
        }
    }
    sum
}

/// Adds dh/dm_i = −(1/4π) Σ_j k_j x_j/(1 − x_i·x_j), j ≠ i, to the i-th vector, by one evaluation for each pair.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn add_differential<T: Real>(
    strengths: &[f64],
    x: impl Fn(usize) -> Vector3<T>,
    velocity: &mut [Vector3<T>],
) {
    for i in 0..strengths.len().min(velocity.len()) {
        let x_i = x(i);
        for j in 0..i {
            let x_j = x(j);
            let inverse = T::from_f64(-0.25 / PI) / (-x_i.dot(&x_j) + 1.0);
            velocity[i].add_multiple(inverse * strengths[j], &x_j);
            velocity[j].add_multiple(inverse * strengths[i], &x_i);
        }
    }
}
