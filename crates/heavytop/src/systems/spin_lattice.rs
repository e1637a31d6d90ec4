//! Spins on a vibrating lattice.

use crate::SpinSpace;
use crate::error::{TopError, require_finite, require_positive};
use lie_poisson::{Covector, Energy, Pair, Point, Power, ProductSpace, Real, RealSpace};
use momentum_map::CotangentBundle;

/// (so(3)∗)ᴺ × T∗Rᴺ: spins s_i and displacements q_i with momenta p_i.
pub type SpinLatticeSpace<const N: usize> =
    ProductSpace<SpinSpace<N>, CotangentBundle<RealSpace<N>>>;

/// A periodic chain of N spins whose exchange depends on their distance,
///
/// ```text
/// h = Σ_i [ p_i²/2m + ½κ(q_{i+1} − q_i)² − (J − a(q_{i+1} − q_i)) s_i·s_{i+1} ]
/// ```
///
/// The differential is taken by dual numbers ([`lie_poisson::Automatic`]). Conserved: h, |s_i|,
/// the total spin Σ s_i and the total momentum Σ p_i.
///
/// In units in which all parameters are numbers; for N = 2 the one bond counts twice.
///
/// Source: the model class of G. Bogfjellmo, *Collective symplectic integrators on S₂ⁿ × T∗R^m*,
/// arXiv:1809.06231 (2018).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpinLattice<const N: usize> {
    mass: f64,
    stiffness: f64,
    exchange: f64,
    coupling: f64,
}

impl<const N: usize> SpinLattice<N> {
    /// From the mass m, the stiffness κ, the exchange J and the coupling a.
    ///
    /// # Errors
    /// If m is not positive, κ is negative, or a number is not finite.
    pub fn new(mass: f64, stiffness: f64, exchange: f64, coupling: f64) -> Result<Self, TopError> {
        require_positive("mass", mass)?;
        crate::error::require_not_negative("stiffness", stiffness)?;
        require_finite("exchange", exchange)?;
        require_finite("coupling", coupling)?;
        Ok(Self { mass, stiffness, exchange, coupling })
    }
}

impl<const N: usize> Energy for SpinLattice<N> {
    type Space = SpinLatticeSpace<N>;

    fn energy<T: Real>(&self, z: &Point<Self::Space, T>) -> T {
        let Pair(Covector(Power(spins)), lattice) = z;
        (0..N).fold(T::zero(), |sum, i| {
            let next = (i + 1) % N;
            let (stretch, p) = (lattice.q[next] - lattice.q[i], lattice.p.0[i]);
            let exchange = -stretch * self.coupling + self.exchange;
            sum + p * p / (2.0 * self.mass) + stretch * stretch * (0.5 * self.stiffness)
                - exchange * spins[i].dot(&spins[next])
        })
    }
}
