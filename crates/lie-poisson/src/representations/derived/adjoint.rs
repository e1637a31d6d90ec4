//! The adjoint representation of a group: [`Adjoint`].

use crate::algebras::algebra::LieAlgebra;
use crate::algebras::group::{AlgebraElement, GroupMomentum, LieGroup};
use crate::representations::representation::{GroupRepresentation, Representation};
use generic_scalars::Real;

/// The adjoint representation of a group on its Lie algebra: g ξ = Ad_g ξ, ad_ξ η = [ξ, η].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Adjoint<G>(pub G);

impl<G: LieGroup> Representation for Adjoint<G> {
    type Algebra = G::Algebra;
    type Space<T: Real> = AlgebraElement<G, T>;

    fn algebra(&self) -> G::Algebra {
        self.0.algebra()
    }

    #[cfg_attr(optimised, inline(always))]
    fn act<T: Real>(
        &self,
        xi: &AlgebraElement<G, T>,
        v: &AlgebraElement<G, T>,
    ) -> AlgebraElement<G, T> {
        self.0.algebra().bracket::<T>(xi, v)
    }

    /// Returns the transposed action `ξᵀ α = ad∗_ξ α`.
    #[cfg_attr(optimised, inline(always))]
    fn transpose_act<T: Real>(
        &self,
        xi: &AlgebraElement<G, T>,
        alpha: &GroupMomentum<G, T>,
    ) -> GroupMomentum<G, T> {
        self.0.algebra().coadjoint::<T>(xi, alpha)
    }

    /// Returns the diamond product `v ◇ α = −ad∗_v α`.
    #[cfg_attr(optimised, inline(always))]
    fn diamond<T: Real>(
        &self,
        v: &AlgebraElement<G, T>,
        alpha: &GroupMomentum<G, T>,
    ) -> GroupMomentum<G, T> {
        -self.0.algebra().coadjoint::<T>(v, alpha)
    }
}

impl<G: LieGroup> GroupRepresentation for Adjoint<G> {
    type Group = G;

    fn group(&self) -> G {
        self.0.clone()
    }

    #[cfg_attr(optimised, inline(always))]
    fn transform<T: Real>(
        &self,
        g: &G::Element<T>,
        v: &AlgebraElement<G, T>,
    ) -> AlgebraElement<G, T> {
        self.0.adjoint::<T>(g, v)
    }
}
