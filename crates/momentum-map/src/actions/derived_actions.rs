//! Actions that come from representations, and actions made from other actions.

use crate::{ActingElement, ActionPoint, GroupAction, Side};
use lie_poisson::{
    GroupRepresentation, LieGroup, Pair, ProductGroup, ProductSpace, Real, Representation,
    SemidirectGroup, VectorSpace,
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

    #[inline]
    fn act<T: Real>(&self, g: &ActingElement<Self, T>, v: &R::Space<T>) -> R::Space<T> {
        self.0.transform::<T>(g, v)
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

    #[inline]
    fn act<T: Real>(&self, g: &ActingElement<Self, T>, x: &R::Space<T>) -> R::Space<T> {
        self.0.transform::<T>(&g.0, x) + g.1
    }
}

/// The action q ↦ Φ(g⁻¹, q), which turns a left action into a right one and a right one into a left one.
///
/// ```
/// use lie_poisson::{LieGroup, Pair, SE3, SO3OnR3};
/// use momentum_map::{AffineAction, GroupAction, Opposite, Side};
/// use nalgebra::Vector3;
/// // the right action q ↦ Rᵀ(q − a) of SE(3) on R³
/// let action = Opposite(AffineAction(SO3OnR3));
/// assert_eq!(Opposite::<AffineAction<SO3OnR3>>::SIDE, Side::Right);
/// let g = SE3::default().exp(&Pair(Vector3::new(0.1, 0.2, 0.3), Vector3::new(1.0, 2.0, 3.0)));
/// let q = Vector3::new(-1.0, 0.5, 2.0);
/// assert!((action.act(&g, &q) - g.0.transpose() * (q - g.1)).norm() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Opposite<A>(pub A);

impl<A: GroupAction> GroupAction for Opposite<A> {
    type Group = A::Group;
    type Space = A::Space;
    const SIDE: Side = A::SIDE.opposite();

    fn group(&self) -> A::Group {
        self.0.group()
    }

    fn space(&self) -> A::Space {
        self.0.space()
    }

    #[inline]
    fn act<T: Real>(&self, g: &ActingElement<A, T>, q: &ActionPoint<A, T>) -> ActionPoint<A, T> {
        self.0.act::<T>(&self.0.group().inverse::<T>(g), q)
    }
}

/// The action of one group on two spaces at once: Φ_g(q, r) = (Φ_g(q), Φ_g(r)).
///
/// Both actions must be on the same side; otherwise the code does not compile.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct JointAction<A, B>(pub A, pub B);

impl<A, B> GroupAction for JointAction<A, B>
where
    A: GroupAction,
    B: GroupAction<Group = A::Group>,
{
    type Group = A::Group;
    type Space = ProductSpace<A::Space, B::Space>;
    const SIDE: Side = A::SIDE.same_as(B::SIDE);

    fn group(&self) -> A::Group {
        self.0.group()
    }

    fn space(&self) -> Self::Space {
        ProductSpace(self.0.space(), self.1.space())
    }

    #[inline]
    fn act<T: Real>(
        &self,
        g: &ActingElement<A, T>,
        q: &ActionPoint<Self, T>,
    ) -> ActionPoint<Self, T> {
        Pair(self.0.act::<T>(g, &q.0), self.1.act::<T>(g, &q.1))
    }
}

/// The action of two groups, each on a space of its own: Φ_(g,h)(q, r) = (Φ_g(q), Φ_h(r)).
///
/// Both actions must be on the same side; otherwise the code does not compile.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ProductAction<A, B>(pub A, pub B);

impl<A: GroupAction, B: GroupAction> GroupAction for ProductAction<A, B> {
    type Group = ProductGroup<A::Group, B::Group>;
    type Space = ProductSpace<A::Space, B::Space>;
    const SIDE: Side = A::SIDE.same_as(B::SIDE);

    fn group(&self) -> Self::Group {
        ProductGroup(self.0.group(), self.1.group())
    }

    fn space(&self) -> Self::Space {
        ProductSpace(self.0.space(), self.1.space())
    }

    #[inline]
    fn act<T: Real>(
        &self,
        g: &ActingElement<Self, T>,
        q: &ActionPoint<Self, T>,
    ) -> ActionPoint<Self, T> {
        Pair(self.0.act::<T>(&g.0, &q.0), self.1.act::<T>(&g.1, &q.1))
    }
}
