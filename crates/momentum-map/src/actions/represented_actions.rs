//! Actions that come from representations: [`LinearAction`], [`AffineAction`].

use crate::actions::action::{ActingElement, Generator, GroupAction, Side};
use crate::phase_spaces::cotangent::Cotangent;
use lie_poisson::{
    Covector, GroupMomentum, GroupRepresentation, Pair, Real, Representation, SemidirectGroup,
    VectorSpace,
};

/// The vector space V of a representation, as a [`VectorSpace`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RepresentationSpace<R>(pub R);

impl<R: Representation> VectorSpace for RepresentationSpace<R> {
    type Point<T: Real> = R::Space<T>;
}

/// The linear left action v ↦ g v of a group on V, real, complex or quaternionic.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LinearAction<R>(pub R);

impl<R: GroupRepresentation> GroupAction for LinearAction<R> {
    type Group = R::Group;
    type Space = RepresentationSpace<R>;
    const SIDE: Side = Side::Left;

    fn group(&self) -> R::Group {
        self.0.group()
    }

    fn space(&self) -> RepresentationSpace<R> {
        RepresentationSpace(self.0.clone())
    }

    #[cfg_attr(optimised, inline(always))]
    fn act<T: Real>(&self, g: &ActingElement<Self, T>, v: &R::Space<T>) -> R::Space<T> {
        self.0.transform::<T>(g, v)
    }

    /// Returns the generator ξ v.
    #[cfg_attr(optimised, inline(always))]
    fn infinitesimal_generator<T: Real>(
        &self,
        xi: &Generator<Self, T>,
        v: &R::Space<T>,
    ) -> R::Space<T> {
        self.0.act::<T>(xi, v)
    }

    /// Returns the diamond product v ◇ α.
    #[cfg_attr(optimised, inline(always))]
    fn momentum<T: Real>(&self, z: &Cotangent<R::Space<T>>) -> GroupMomentum<R::Group, T> {
        self.0.diamond::<T>(&z.q, &z.p)
    }

    /// Returns the lifted generator (ξv, −ξᵀα).
    #[cfg_attr(optimised, inline(always))]
    fn lifted_generator<T: Real>(
        &self,
        xi: &Generator<Self, T>,
        z: &Cotangent<R::Space<T>>,
    ) -> Cotangent<R::Space<T>> {
        Cotangent { q: self.0.act::<T>(xi, &z.q), p: -self.0.transpose_act::<T>(xi, &z.p) }
    }
}

/// The affine left action x ↦ g x + v of the semidirect product G ⋉ V on V.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct AffineAction<R>(pub R);

impl<R: GroupRepresentation> GroupAction for AffineAction<R> {
    type Group = SemidirectGroup<R>;
    type Space = RepresentationSpace<R>;
    const SIDE: Side = Side::Left;

    fn group(&self) -> SemidirectGroup<R> {
        SemidirectGroup(self.0.clone())
    }

    fn space(&self) -> RepresentationSpace<R> {
        RepresentationSpace(self.0.clone())
    }

    #[cfg_attr(optimised, inline(always))]
    fn act<T: Real>(&self, g: &ActingElement<Self, T>, x: &R::Space<T>) -> R::Space<T> {
        self.0.transform::<T>(&g.0, x) + g.1
    }

    /// Returns ξx + φ for (ξ, φ) ∈ 𝔤 ⋉ V.
    #[cfg_attr(optimised, inline(always))]
    fn infinitesimal_generator<T: Real>(
        &self,
        xi: &Generator<Self, T>,
        x: &R::Space<T>,
    ) -> R::Space<T> {
        self.0.act::<T>(&xi.0, x) + xi.1
    }

    /// Returns (x ◇ α, α).
    #[cfg_attr(optimised, inline(always))]
    fn momentum<T: Real>(&self, z: &Cotangent<R::Space<T>>) -> GroupMomentum<Self::Group, T> {
        Covector(Pair(self.0.diamond::<T>(&z.q, &z.p).0, z.p.0))
    }

    /// Returns (ξx + φ, −ξᵀα) for (ξ, φ) ∈ 𝔤 ⋉ V.
    #[cfg_attr(optimised, inline(always))]
    fn lifted_generator<T: Real>(
        &self,
        xi: &Generator<Self, T>,
        z: &Cotangent<R::Space<T>>,
    ) -> Cotangent<R::Space<T>> {
        let p = -self.0.transpose_act::<T>(&xi.0, &z.p);
        Cotangent { q: self.infinitesimal_generator::<T>(xi, &z.q), p }
    }
}
