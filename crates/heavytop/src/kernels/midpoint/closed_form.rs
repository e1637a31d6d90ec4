//! The midpoint rule on se(3)∗ for a given velocity at the midpoint.

use crate::attitude::step_rotation::unit;
use lie_poisson::{Covector, Pair, Quaternion, Real, Se3Dual, cross, dot};
use nalgebra::Vector3;

/// The velocity (Ωₘ, γₘ) = dh at the midpoint.
pub(super) type Velocity<T> = Pair<Vector3<T>, Vector3<T>>;

/// Returns the rotated vector R_a v, for n = 1/(1+|a|²).
#[cfg_attr(optimised, inline(always))]
fn half_turn<T: Real>(a: &Vector3<T>, n: T, v: &Vector3<T>) -> Vector3<T> {
    let turned = cross(v, a);
    v + (turned + cross(&turned, a)) * (n + n)
}

/// Returns the unit quaternion of the rotation R_a R_a of the step.
#[cfg_attr(optimised, inline(always))]
pub(super) fn whole_turn<T: Real>(a: &Vector3<T>) -> Quaternion<T> {
    // R_a is the rotation by the quaternion 1 − a.
    let half = Quaternion { scalar: T::one(), vector: -a };
    unit(half * half)
}

/// Returns a from the unit quaternion (1 − |a|² − 2a)/(1 + |a|²) of R_a R_a.
#[cfg_attr(optimised, inline(always))]
pub(super) fn half_angle<T: Real>(turn: &Quaternion<T>) -> Vector3<T> {
    turn.vector * (-T::one() / (turn.scalar + 1.0))
}

/// Returns the half angle a = (h/4) Ωₘ and the factor n = 1/(1+|a|²).
#[cfg_attr(optimised, inline(always))]
fn angle<T: Real>(omega: &Vector3<T>, step: f64) -> (Vector3<T>, T) {
    let a = omega * T::from_f64(0.25 * step);
    (a, T::one() / (dot(&a, &a) + 1.0))
}

/// Returns the midpoint (Πₘ, Γₘ) of the step.
#[cfg_attr(optimised, inline(always))]
pub(super) fn middle<T: Real>(start: &Se3Dual<T>, velocity: &Velocity<T>, step: f64) -> Se3Dual<T> {
    let (Covector(Pair(pi, gamma)), Pair(omega, force)) = (start, velocity);
    let (a, n) = angle(omega, step);
    let vertical = half_turn(&a, n, gamma) * n;
    let torque = cross(&vertical, &(force + cross(force, &a))) - vertical * dot(&a, force);
    let pi = half_turn(&a, n, pi) + torque * T::from_f64(0.5 * step);
    Se3Dual::new(pi * n, vertical)
}

/// Returns the end (Π₁, Γ₁) of the step.
#[cfg_attr(optimised, inline(always))]
pub(super) fn end<T: Real>(start: &Se3Dual<T>, velocity: &Velocity<T>, step: f64) -> Se3Dual<T> {
    let (Covector(Pair(pi, gamma)), Pair(omega, force)) = (start, velocity);
    let (a, n) = angle(omega, step);
    let half = half_turn(&a, n, gamma);
    let torque = cross(&half, force) * (n * T::from_f64(step));
    let pi = half_turn(&a, n, &(half_turn(&a, n, pi) + torque));
    Se3Dual::new(pi, half_turn(&a, n, &half))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_half_angle_of_a_whole_turn_is_found_again() {
        for a in [[0.0; 3], [1e-9, 0.0, 0.0], [0.3, -0.2, 0.9], [3.0, 4.0, -1.0]] {
            let a = Vector3::from(a);
            let found = half_angle(&whole_turn(&a));
            // For large |a| the scalar 2/(1+|a|²) of 1 + turn.scalar loses digits.
            let bound = 4.0 * f64::EPSILON * (1.0 + a.norm_squared()) * a.norm();
            assert!((found - a).norm() <= bound, "{a}: {found}");
        }
    }
}
