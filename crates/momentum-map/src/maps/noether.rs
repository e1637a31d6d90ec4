//! Conserved quantities by Noether's theorem: [`NoetherQuantity`].

use crate::maps::poisson_map::{PoissonMap, SourcePoint, TargetDifferential};
use lie_poisson::{Differential, Hamiltonian, Real, Vector, map_coordinates};

/// The component J_ξ(z) = ⟨J(z), ξ⟩ of a momentum map, as a function on P with its differential.
///
/// Its Hamiltonian vector field is the infinitesimal generator ξ_P. If a Hamiltonian H is invariant under the action,
/// then {J_ξ, H} = 0, so that J_ξ is conserved (Noether's theorem).
///
/// Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, 2nd ed., Thm. 11.4.1.
///
/// # Example
/// For a particle in a central field the angular momentum about e₃ is conserved:
/// ```
/// use lie_poisson::{Covector, Hamiltonian, PoissonSpace, SO3OnR3, from_closure};
/// use momentum_map::{
///     Cotangent, CotangentBundle, LinearAction, MomentumMap, NoetherQuantity, PoissonMap,
///     RepresentationSpace,
/// };
/// use nalgebra::Vector3;
/// type Phase = CotangentBundle<RepresentationSpace<SO3OnR3>>;
/// let h = from_closure::<Phase, _>(|z| z.p.0.dot(&z.p.0) * 0.5 + z.q.dot(&z.q) * z.q.dot(&z.q));
/// let l3 = NoetherQuantity::new(MomentumMap(LinearAction(SO3OnR3)), Vector3::z());
/// let z = Cotangent::new(Vector3::new(1.0, 2.0, 3.0), Covector(Vector3::new(0.5, 0.0, 1.0)));
/// let bracket = l3.map().source().bracket(&z, &l3.differential(&z), &h.differential(&z));
/// assert!(bracket.abs() < 1e-13);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoetherQuantity<M: PoissonMap> {
    map: M,
    xi: TargetDifferential<M>,
}

impl<M: PoissonMap> NoetherQuantity<M> {
    /// Creates the component ⟨J, ξ⟩ of a momentum map.
    pub const fn new(map: M, xi: TargetDifferential<M>) -> Self {
        Self { map, xi }
    }

    /// Returns the momentum map J.
    pub const fn map(&self) -> &M {
        &self.map
    }

    fn direction<T: Real>(&self) -> TargetDifferential<M, T> {
        map_coordinates(&self.xi, T::from_f64)
    }
}

impl<M: PoissonMap, T: Real> Hamiltonian<M::Source, T> for NoetherQuantity<M> {
    fn value(&self, z: &SourcePoint<M, T>) -> T {
        self.map.apply::<T>(z).pairing(&self.direction())
    }

    fn differential(&self, z: &SourcePoint<M, T>) -> Differential<M::Source, T> {
        self.map.pull_back::<T>(&self.direction(), z)
    }
}
