//! The realisation of u(N)∗ on C^N by outer products.

use crate::actions::action::Side;
use crate::maps::fibre::{FibreSymmetry, Lift, LiftError};
use crate::maps::poisson_map::{PoissonMap, SourcePoint, TargetPoint};
use crate::maps::quadratic_momentum_map::QuadraticMomentumMap;
use lie_poisson::{
    Mask, Pair, Real, UnitaryAlgebra, UnitaryOnComplexSpace, Vector, squaring_scale,
};
use nalgebra::SVector;
use num_complex::Complex;

/// The momentum map of U(N) on C^N with Ω(u, v) = Im(u∗v): up to a factor, the outer product of z with itself.
///
/// In terms of the Hermitian matrix H of a momentum ([`UnitaryAlgebra::hermitian`]),
///
/// ```text
/// J(z): H = ±½ z z*,    dz/dt = −ξz (right action, upper sign, minus bracket) or ξz (left)
/// ```
///
/// The image consists of the matrices of rank one, which are the coherent states of SU(N) and the spins of
/// generalised spin dynamics.
///
/// Source: H. Zhang & C. D. Batista, *Classical spin dynamics based on SU(N) coherent states*,
/// Phys. Rev. B 104 (2021) 104409; D. Dahlbom et al., *Geometric integration of classical spin
/// dynamics via a mean-field Schrödinger equation*, Phys. Rev. B 106 (2022) 054423.
///
/// # Example
/// ```
/// use lie_poisson::UnitaryAlgebra;
/// use momentum_map::{PoissonMap, unitary_realisation};
/// use nalgebra::Vector3;
/// use num_complex::Complex;
/// let c = Complex::new;
/// let z = Vector3::new(c(1.0, 2.0), c(0.0, -1.0), c(0.5, 0.0));
/// let h = UnitaryAlgebra.hermitian(&unitary_realisation::<3>().apply(&z));
/// assert!((h - z * z.adjoint() * c(0.5, 0.0)).norm() < 1e-15);
/// ```
pub type UnitaryRealisation<const N: usize> = QuadraticMomentumMap<UnitaryOnComplexSpace<N>>;

/// Returns the realisation C^N → u(N)∗ with the minus bracket.
#[must_use]
pub const fn unitary_realisation<const N: usize>() -> UnitaryRealisation<N> {
    QuadraticMomentumMap::new(UnitaryOnComplexSpace, Side::Right)
}

/// The greatest relative deviation of H from ±½ z z∗ that is accepted.
///
/// It is far above the round-off of a computed momentum, and far below an intended second eigenvalue.
const RANK_ONE_TOLERANCE: f64 = 1e-10;

impl<const N: usize> Lift for UnitaryRealisation<N> {
    /// Returns z, computed from the column of H with the largest diagonal entry.
    ///
    /// # Errors
    /// Returns [`LiftError`] if ±H is not positive semi-definite of rank one (H = 0 has rank 0), if it is
    /// not finite, or if it is so large that sums of N products in J(z) overflow.
    fn lift<T: Real>(&self, mu: &TargetPoint<Self, T>) -> Result<SourcePoint<Self, T>, LiftError> {
        let sign = match self.side() {
            Side::Left => -2.0,
            Side::Right => 2.0,
        };
        let mu = LiftError::unless_finite(*mu, "H", mu.max_abs(), "H must be finite")?;
        let scale = squaring_scale(&mu);
        let unit = mu.scaled(scale);
        let size = unit.max_norm();
        if size.at_most(T::zero()).any() {
            return Err(LiftError {
                quantity: "H",
                value: 0.0,
                reason: "H must be different from 0",
            });
        }
        let twice = UnitaryAlgebra.hermitian(&unit).map(|z| z.scale(T::from_f64(sign)));
        let mut column: SVector<Complex<T>, N> = Vector::zero();
        let mut largest = T::zero();
        for k in 0..N {
            let better = twice[(k, k)].re - largest;
            largest = better.select_nonnegative(twice[(k, k)].re, largest);
            column = column.zip_map(&twice.column(k), |old, new| Complex {
                re: better.select_nonnegative(new.re, old.re),
                im: better.select_nonnegative(new.im, old.im),
            });
        }
        let z = column.map(|z| z.unscale(largest.sqrt()));
        let residual = (self.apply::<T>(&z) - unit).max_norm();
        if !residual.at_most(size * RANK_ONE_TOLERANCE).all() {
            let reason = "the Hermitian matrix must be definite and of rank one";
            let value = (residual / size).max_abs();
            return Err(LiftError { quantity: "H ∓ ½zz*, relative to H", value, reason });
        }
        let back = T::one() / scale.sqrt();
        let z = z.map(|z| z.scale(back));
        let range = Pair(z, self.apply::<T>(&z));
        let reason = "the entries of H must be so small that sums of 2N of them are numbers";
        Ok(LiftError::unless_finite(range, "H", mu.max_abs(), reason)?.0)
    }
}

impl<const N: usize> FibreSymmetry for UnitaryRealisation<N> {
    const COUNT: usize = 1;

    /// Returns the flow exp(is) z along the circle of phases.
    fn flow<T: Real>(&self, index: usize, s: T, z: &SourcePoint<Self, T>) -> SourcePoint<Self, T> {
        if index > 0 {
            return *z;
        }
        let square = s * s;
        let phase = Complex { re: square.stumpff(0), im: s * square.stumpff(1) };
        z.map(|z| z * phase)
    }

    /// Returns the momentum −½‖z‖².
    fn momentum<T: Real>(&self, index: usize, z: &SourcePoint<Self, T>) -> T {
        let norm = z.iter().fold(T::zero(), |sum, z| sum + z.norm_sqr());
        if index > 0 { T::zero() } else { norm * -0.5 }
    }
}
