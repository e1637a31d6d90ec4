//! The check that a state and its momentum are finite.

use lie_poisson::{Mask, Real, Vector};
use momentum_map::{PoissonMap, SourcePoint};

/// A size of a state below which its momentum is finite: products of three coordinates do not overflow.
const SAFE: f64 = 1e100;

/// The largest momentum, a little below an overflow, so that rounding errors of z do not matter.
const LARGEST: f64 = f64::MAX / 16.0;

/// Returns whether z and M(z) are finite, in all SIMD lanes.
///
/// A method that is unstable for a step leads to states that are still finite, and whose momentum is not.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn has_finite_momentum<M: PoissonMap, T: Real>(map: &M, z: &SourcePoint<M, T>) -> bool {
    z.max_norm().at_most(T::from_f64(SAFE)).all() || both_finite(map, z)
}

#[cold]
fn both_finite<M: PoissonMap, T: Real>(map: &M, z: &SourcePoint<M, T>) -> bool {
    let momentum = map.apply::<T>(z).max_norm();
    z.is_finite() && momentum.at_most(T::from_f64(LARGEST)).all()
}
