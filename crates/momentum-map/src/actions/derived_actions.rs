//! Actions made from other actions: [`Opposite`], [`ProductAction`].

use crate::actions::action::{ActingElement, ActionPoint, Generator, GroupAction, Side};
use crate::phase_spaces::cotangent::Cotangent;
use lie_poisson::{
    GroupMomentum, LieGroup, Pair, ProductGroup, ProductSpace, Real, Vector, from_parts, parts,
};

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

    #[cfg_attr(optimised, inline(always))]
    fn act<T: Real>(&self, g: &ActingElement<A, T>, q: &ActionPoint<A, T>) -> ActionPoint<A, T> {
        self.0.act::<T>(&self.0.group().inverse::<T>(g), q)
    }

    /// Returns −ξ_Q(q), since exp(sξ)⁻¹ = exp(−sξ).
    #[cfg_attr(optimised, inline(always))]
    fn infinitesimal_generator<T: Real>(
        &self,
        xi: &Generator<A, T>,
        q: &ActionPoint<A, T>,
    ) -> ActionPoint<A, T> {
        -self.0.infinitesimal_generator::<T>(xi, q)
    }

    /// Returns the momentum −J(q, p).
    #[cfg_attr(optimised, inline(always))]
    fn momentum<T: Real>(&self, z: &Cotangent<ActionPoint<A, T>>) -> GroupMomentum<A::Group, T> {
        -self.0.momentum::<T>(z)
    }

    /// Returns the generator of the lift with the opposite sign.
    #[cfg_attr(optimised, inline(always))]
    fn lifted_generator<T: Real>(
        &self,
        xi: &Generator<A, T>,
        z: &Cotangent<ActionPoint<A, T>>,
    ) -> Cotangent<ActionPoint<A, T>> {
        -self.0.lifted_generator::<T>(xi, z)
    }
}

/// A point of the cotangent bundle of a direct sum.
type PairPoint<Q, R> = Cotangent<Pair<Q, R>>;

/// Returns the points (q, p) and (r, s) of the parts of a point ((q, r), (p, s)).
#[inline]
fn split<Q, R>(z: &PairPoint<Q, R>) -> (Cotangent<Q>, Cotangent<R>)
where
    Q: Vector,
    R: Vector<Scalar = Q::Scalar>,
{
    let (p, s) = parts(&z.p);
    (Cotangent { q: z.q.0, p }, Cotangent { q: z.q.1, p: s })
}

/// Returns the point ((q, r), (p, s)) of the parts (q, p) and (r, s).
#[inline]
fn join<Q, R>(first: &Cotangent<Q>, second: &Cotangent<R>) -> PairPoint<Q, R>
where
    Q: Vector,
    R: Vector<Scalar = Q::Scalar>,
{
    Cotangent { q: Pair(first.q, second.q), p: from_parts(&first.p, &second.p) }
}

/// The action of two groups, each on its own space: Φ_(g,h)(q, r) = (Φ_g(q), Φ_h(r)).
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

    #[cfg_attr(optimised, inline(always))]
    fn act<T: Real>(
        &self,
        g: &ActingElement<Self, T>,
        q: &ActionPoint<Self, T>,
    ) -> ActionPoint<Self, T> {
        Pair(self.0.act::<T>(&g.0, &q.0), self.1.act::<T>(&g.1, &q.1))
    }

    #[cfg_attr(optimised, inline(always))]
    fn infinitesimal_generator<T: Real>(
        &self,
        xi: &Generator<Self, T>,
        q: &ActionPoint<Self, T>,
    ) -> ActionPoint<Self, T> {
        Pair(
            self.0.infinitesimal_generator::<T>(&xi.0, &q.0),
            self.1.infinitesimal_generator::<T>(&xi.1, &q.1),
        )
    }

    /// Returns the pair of the momenta of the two actions.
    #[cfg_attr(optimised, inline(always))]
    fn momentum<T: Real>(
        &self,
        z: &Cotangent<ActionPoint<Self, T>>,
    ) -> GroupMomentum<Self::Group, T> {
        let (first, second) = split(z);
        GroupMomentum::<Self::Group, T>::new(
            self.0.momentum::<T>(&first).0,
            self.1.momentum::<T>(&second).0,
        )
    }

    #[cfg_attr(optimised, inline(always))]
    fn lifted_generator<T: Real>(
        &self,
        xi: &Generator<Self, T>,
        z: &Cotangent<ActionPoint<Self, T>>,
    ) -> Cotangent<ActionPoint<Self, T>> {
        let (first, second) = split(z);
        join(
            &self.0.lifted_generator::<T>(&xi.0, &first),
            &self.1.lifted_generator::<T>(&xi.1, &second),
        )
    }
}
