//! Objects with only what their traits require.

use lie_poisson::{AlgebraElement, LieAlgebra, LieGroup, Real};
use momentum_map::{PoissonMap, SourcePoint, TargetPoint};

/// An object without its shortcuts: an algebra by its bracket alone, a group without its ad-hoc coadjoint, a Poisson
/// map by `apply` alone.
///
/// The trait's own definitions replace the shortcuts, so that a formula written by hand can be compared with its
/// definition.
#[derive(Clone, Copy, Debug)]
pub struct Derived<X>(pub X);

impl<A: LieAlgebra> LieAlgebra for Derived<A> {
    type Element<T: Real> = A::Element<T>;

    fn bracket<T: Real>(&self, xi: &A::Element<T>, eta: &A::Element<T>) -> A::Element<T> {
        self.0.bracket::<T>(xi, eta)
    }
}

impl<G: LieGroup> LieGroup for Derived<G> {
    type Algebra = G::Algebra;
    type Element<T: Real> = G::Element<T>;

    fn algebra(&self) -> G::Algebra {
        self.0.algebra()
    }

    fn identity<T: Real>(&self) -> G::Element<T> {
        self.0.identity::<T>()
    }

    fn compose<T: Real>(&self, g: &G::Element<T>, h: &G::Element<T>) -> G::Element<T> {
        self.0.compose::<T>(g, h)
    }

    fn inverse<T: Real>(&self, g: &G::Element<T>) -> G::Element<T> {
        self.0.inverse::<T>(g)
    }

    fn exp<T: Real>(&self, xi: &AlgebraElement<G, T>) -> G::Element<T> {
        self.0.exp::<T>(xi)
    }

    fn adjoint<T: Real>(
        &self,
        g: &G::Element<T>,
        xi: &AlgebraElement<G, T>,
    ) -> AlgebraElement<G, T> {
        self.0.adjoint::<T>(g, xi)
    }
}

impl<M: PoissonMap> PoissonMap for Derived<M> {
    type Source = M::Source;
    type Target = M::Target;

    fn source(&self) -> M::Source {
        self.0.source()
    }

    fn target(&self) -> M::Target {
        self.0.target()
    }

    fn apply<T: Real>(&self, z: &SourcePoint<M, T>) -> TargetPoint<M, T> {
        self.0.apply::<T>(z)
    }

    fn equivariant_maps_descend(&self) -> bool {
        self.0.equivariant_maps_descend()
    }
}
