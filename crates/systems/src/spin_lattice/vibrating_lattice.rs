//! Spins on a vibrating lattice of one dimension: [`SpinLattice`].

use crate::error::{SystemError, require_finite, require_not_negative, require_positive};
use crate::spaces::spin_space::SpinSpace;
use lie_poisson::{Covector, Energy, Pair, Point, Power, ProductSpace, Real, RealSpace};
use momentum_map::CotangentBundle;

/// The phase space (so(3)∗)ᴺ × T∗Rᴺ of N spins s_i and N displacements q_i with momenta p_i.
pub type SpinLatticeSpace<const N: usize> =
    ProductSpace<SpinSpace<N>, CotangentBundle<RealSpace<N>>>;

/// A periodic lattice of one dimension, whose N atoms have spins s_i and displacements q_i along the lattice. The
/// exchange of neighbouring spins depends on the distance of their atoms.
///
/// ```text
/// h = Σ_i [ p_i²/2m + ½κ(qᵢ₊₁ − q_i)² − (J − a(qᵢ₊₁ − q_i)) s_i·sᵢ₊₁ ]
/// ```
///
/// The index N + 1 stands for 1, and the spins have the plus bracket. The differential is computed with dual numbers,
/// by [`Automatic`](lie_poisson::Automatic). The conserved quantities are h, every |s_i|, the total spin Σ s_i and the
/// total momentum Σ p_i.
///
/// All parameters are numbers without units. For N = 2 the single bond counts twice. Spins on atoms at rest, on
/// lattices of one to three dimensions, are a [`HeisenbergLattice`](crate::HeisenbergLattice).
///
/// Source: the model class of G. Bogfjellmo, *Collective symplectic integrators on S₂ⁿ × T∗R^m*,
/// arXiv:1809.06231 (2018).
///
/// # Example
/// ```
/// use lie_poisson::{Automatic, Covector, Hamiltonian, Pair, Power};
/// use lie_poisson_systems::SpinLattice;
/// use momentum_map::Cotangent;
/// use nalgebra::{Vector3, Vector4};
/// let lattice = Automatic(SpinLattice::<4>::new(1.0, 2.0, 1.0, 0.5)?);
/// // the ground state: four bonds of energy −J, and no force on any atom
/// let spins = Covector(Power([Vector3::z(); 4]));
/// let at_rest = Cotangent::new(Vector4::<f64>::zeros(), Covector(Vector4::zeros()));
/// let z = Pair(spins, at_rest);
/// assert_eq!(lattice.value(&z), -4.0);
/// assert_eq!(lattice.differential(&z).0.1.q, Vector4::zeros());
/// # Ok::<(), lie_poisson_systems::SystemError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpinLattice<const N: usize> {
    mass: f64,
    stiffness: f64,
    exchange: f64,
    coupling: f64,
}

impl<const N: usize> SpinLattice<N> {
    /// Creates a lattice from the mass m, the stiffness κ, the exchange J and the coupling a.
    ///
    /// # Errors
    /// Returns [`SystemError`] if m is not positive, κ is negative, or a number is not finite.
    pub fn new(
        mass: f64,
        stiffness: f64,
        exchange: f64,
        coupling: f64,
    ) -> Result<Self, SystemError> {
        require_positive("mass", mass)?;
        require_not_negative("stiffness", stiffness)?;
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
