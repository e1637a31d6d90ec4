//! Collective Hamiltonians: [`CollectiveHamiltonian`].

use crate::maps::poisson_map::{PoissonMap, SourcePoint};
use lie_poisson::{Differential, Hamiltonian, Real};

/// The collective Hamiltonian H = h ∘ M: P → R, with its exact differential dH(z) = (T_z M)ᵀ dh(M(z)).
///
/// Source: Ohsawa 2019, §1.3 and §4.1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CollectiveHamiltonian<M, H> {
    /// The Poisson map M.
    pub map: M,
    /// The Hamiltonian h on the target of M.
    pub hamiltonian: H,
}

impl<M, H> CollectiveHamiltonian<M, H> {
    /// Creates the collective Hamiltonian h ∘ M.
    pub const fn new(map: M, hamiltonian: H) -> Self {
        Self { map, hamiltonian }
    }
}

impl<M, H, T> Hamiltonian<M::Source, T> for CollectiveHamiltonian<M, H>
where
    M: PoissonMap,
    H: Hamiltonian<M::Target, T>,
    T: Real,
{
    #[inline]
    fn value(&self, z: &SourcePoint<M, T>) -> T {
        self.hamiltonian.value(&self.map.apply::<T>(z))
    }

    #[inline]
    fn differential(&self, z: &SourcePoint<M, T>) -> Differential<M::Source, T> {
        self.map.pull_back::<T>(&self.hamiltonian.differential(&self.map.apply::<T>(z)), z)
    }
}
