//! Point vortices on the sphere.

use crate::error::SystemError;
use crate::spaces::spin_space::{SpinSpace, Spins};
use crate::vortices::interaction::{add_differential, energy, require_strength};
use core::array::from_fn;
use lie_poisson::{Covector, Hamiltonian, Power, Real, Vector, hessian_by_dual_numbers};
use nalgebra::Vector3;

/// N point vortices of strengths k_i at the points x_i of the unit sphere.
///
/// ```text
/// dx_i/dt = (1/4π) Σ_j k_j (x_j × x_i)/(1 − x_i·x_j),    j ≠ i
/// ```
///
/// This is a Lie–Poisson system on (so(3)∗)ᴺ with the minus bracket, in the variables m_i = k_i x_i:
///
/// ```text
/// h(m) = (1/4π) Σ_ij k_i k_j ln(2 − 2 x_i·x_j),    i < j
/// ```
///
/// h is the negative of the usual energy, because of the sign of the bracket. The conserved quantities are h, every
/// |m_i|, and the moment of vorticity Σ m_i = Σ k_i x_i. The strengths are in m²/s on a sphere of radius 1 m.
///
/// Source: V. A. Bogomolov, *Dynamics of vorticity at a sphere*, Fluid Dyn. 12 (1977); P. K.
/// Newton, *The N-Vortex Problem* (2001), §4.2.
///
/// # Example
/// ```
/// use lie_poisson::{Hamiltonian, LiePoisson, PoissonSpace, PowerAlgebra, So3};
/// use lie_poisson_systems::PointVortices;
/// use nalgebra::Vector3;
/// // two equal vortices turn about the point between them
/// let vortices = PointVortices::new([1.0, 1.0])?;
/// let m = vortices.momentum(&[Vector3::x(), Vector3::y()]);
/// let space = LiePoisson::minus(PowerAlgebra::<_, 2>(So3));
/// let rate = space.hamiltonian_vector(&m, &vortices.differential(&m)).0.0;
/// assert!((rate[0] + rate[1]).norm() < 1e-15); // Σ k_i x_i is conserved
/// assert!((rate[0] + Vector3::z() / (4.0 * std::f64::consts::PI)).norm() < 1e-15);
/// # Ok::<(), lie_poisson_systems::SystemError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointVortices<const N: usize> {
    strengths: [f64; N],
}

impl<const N: usize> PointVortices<N> {
    /// Creates vortices of the given strengths k_i, in m²/s.
    ///
    /// The strengths need not add up to 0. The total vorticity of a sphere does, through a uniform background of −Σ
    /// k_i/(4πR²), which moves no vortex.
    ///
    /// # Errors
    /// Returns [`SystemError`] if a strength is not finite, or is so near zero that its reciprocal is not finite.
    pub fn new(strengths: [f64; N]) -> Result<Self, SystemError> {
        strengths.iter().try_for_each(|&strength| require_strength(strength))?;
        Ok(Self { strengths })
    }

    /// Returns the point m_i = k_i x_i of (so(3)∗)ᴺ for vortices at the given positions.
    #[must_use]
    pub fn momentum(&self, positions: &[Vector3<f64>; N]) -> Spins<N> {
        Covector(Power::from_factors(|i| positions[i] * self.strengths[i]))
    }

    /// Returns the positions x_i = m_i/k_i of the vortices.
    #[must_use]
    pub fn positions<T: Real>(&self, m: &Spins<N, T>) -> [Vector3<T>; N] {
        from_fn(|i| m.0.0[i].scaled(T::from_f64(1.0 / self.strengths[i])))
    }
}

impl<const N: usize, T: Real> Hamiltonian<SpinSpace<N>, T> for PointVortices<N> {
    fn value(&self, m: &Spins<N, T>) -> T {
        let x = self.positions(m);
        energy(&self.strengths, |i| x[i])
    }

    /// Returns the differential dh/dm_i = −(1/4π) Σ_j k_j x_j/(1 − x_i·x_j), with j ≠ i.
    fn differential(&self, m: &Spins<N, T>) -> Power<Vector3<T>, N> {
        let x = self.positions(m);
        let mut velocity = [Vector3::zeros(); N];
        add_differential(&self.strengths, |i| x[i], &mut velocity);
        Power(velocity)
    }

    fn hessian(&self, m: &Spins<N, T>, v: &Spins<N, T>) -> Option<Power<Vector3<T>, N>> {
        Some(hessian_by_dual_numbers::<SpinSpace<N>, T, _>(self, m, v))
    }
}
