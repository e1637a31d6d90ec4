//! The check that a state and its momentum are finite.

use lie_poisson::{Mask, Real, State, Vector};
use momentum_map::{PoissonMap, SourcePoint};

/// A size of a state below which its momentum is finite: products of three coordinates do not overflow.
const SAFE: f64 = 1e100;

/// The largest momentum, a little below an overflow, so that rounding errors of z do not matter.
const LARGEST: f64 = f64::MAX / 16.0;

/// Returns whether z and M(z) are finite, in all SIMD lanes.
///
/// A method that is unstable at some step size may reach a state that is still finite but whose momentum is not.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn has_finite_momentum<M: PoissonMap, T: Real>(map: &M, z: &SourcePoint<M, T>) -> bool {
    z.max_norm().at_most(T::from_f64(SAFE)).all() || both_finite(map, z)
}

#[cold]
fn both_finite<M: PoissonMap, T: Real>(map: &M, z: &SourcePoint<M, T>) -> bool {
    let momentum = map.apply::<T>(z).max_norm();
    z.is_finite() && momentum.at_most(T::from_f64(LARGEST)).all()
}

#[cfg(test)]
mod tests {
    use super::*;
    use momentum_map::HOPF;
    use nalgebra::Vector2;
    use num_complex::Complex;

    /// Products of the coordinates of a large state need not overflow.
    #[test]
    fn large_states_have_finite_momenta_up_to_an_overflow() {
        let finite = |x: f64, y: f64| {
            let z = Vector2::new(Complex::new(x, 0.0), Complex::new(0.0, y));
            has_finite_momentum::<_, f64>(&HOPF, &z)
        };
        assert!(finite(1.0, -1.0) && finite(1e120, 1e-120) && finite(1e150, 1e150));
        assert!(!finite(1e160, 1e160) && !finite(f64::NAN, 1.0) && !finite(f64::INFINITY, 0.0));
    }
}
