//! Representations made from others.

use crate::{
    AlgebraElement, Covector, GroupMomentum, GroupRepresentation, LieAlgebra, LieGroup, Momentum,
    Pair, Power, Real, Representation, RepresentedElement, SemidirectAlgebra, SemidirectGroup,
    Vector,
};
use core::array::from_fn;

/// G ⋉ V on V (or any space of G) through its quotient G: (g, v) w = g w.
///
/// It nests semidirect products, as in se(3) ⋉ R³, whose dual is the phase space of a heavy top
/// on a movable base:
///
/// ```
/// use lie_poisson::{Inherited, LieAlgebra, Pair, SO3OnR3, SemidirectAlgebra};
/// use nalgebra::Vector3;
/// let nested = SemidirectAlgebra(Inherited { quotient: SO3OnR3, representation: SO3OnR3 });
/// let element = |a, b, c| Pair(Pair(a, b), c);
/// let (x, y, z) = (Vector3::x(), Vector3::y(), Vector3::z());
/// // [((x,0),0), ((0,y),y)] = ((0, x×y), x×y)
/// let zero = Vector3::zeros();
/// assert_eq!(
///     nested.bracket::<f64>(&element(x, zero, zero), &element(zero, y, y)),
///     element(zero, z, z),
/// );
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Inherited<Q, R> {
    /// The representation that defines G ⋉ V.
    pub quotient: Q,
    /// The representation of G to be inherited.
    pub representation: R,
}

impl<Q, R> Representation for Inherited<Q, R>
where
    Q: Representation,
    R: Representation<Algebra = Q::Algebra>,
{
    type Algebra = SemidirectAlgebra<Q>;
    type Space<T: Real> = R::Space<T>;

    fn algebra(&self) -> SemidirectAlgebra<Q> {
        SemidirectAlgebra(self.quotient.clone())
    }

    #[inline]
    fn act<T: Real>(&self, xi: &RepresentedElement<Self, T>, v: &R::Space<T>) -> R::Space<T> {
        self.representation.act::<T>(&xi.0, v)
    }

    #[inline]
    fn transpose_act<T: Real>(
        &self,
        xi: &RepresentedElement<Self, T>,
        alpha: &Covector<R::Space<T>>,
    ) -> Covector<R::Space<T>> {
        self.representation.transpose_act::<T>(&xi.0, alpha)
    }

    /// (v ◇ α, 0): V of G ⋉ V acts trivially.
    #[inline]
    fn diamond<T: Real>(
        &self,
        v: &R::Space<T>,
        alpha: &Covector<R::Space<T>>,
    ) -> Momentum<SemidirectAlgebra<Q>, T> {
        Covector(Pair(self.representation.diamond::<T>(v, alpha).0, Vector::zero()))
    }
}

impl<Q, R> GroupRepresentation for Inherited<Q, R>
where
    Q: GroupRepresentation,
    R: GroupRepresentation<Algebra = Q::Algebra, Group = Q::Group>,
{
    type Group = SemidirectGroup<Q>;

    fn group(&self) -> SemidirectGroup<Q> {
        SemidirectGroup(self.quotient.clone())
    }

    #[inline]
    fn transform<T: Real>(
        &self,
        g: &<SemidirectGroup<Q> as LieGroup>::Element<T>,
        v: &R::Space<T>,
    ) -> R::Space<T> {
        self.representation.transform::<T>(&g.0, v)
    }

    #[inline]
    fn exp_integral<T: Real>(
        &self,
        xi: &RepresentedElement<Self, T>,
        phi: &R::Space<T>,
    ) -> R::Space<T> {
        self.representation.exp_integral::<T>(&xi.0, phi)
    }
}

/// The diagonal representation on Vᴺ: ξ (v₁, …, v_N) = (ξv₁, …, ξv_N).
///
/// so(3) ⋉ (R³)ᴺ, for example, is the algebra of a body in N constant fields.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Diagonal<R, const N: usize>(pub R);

impl<R: Representation, const N: usize> Representation for Diagonal<R, N> {
    type Algebra = R::Algebra;
    type Space<T: Real> = Power<R::Space<T>, N>;

    fn algebra(&self) -> R::Algebra {
        self.0.algebra()
    }

    #[inline]
    fn act<T: Real>(&self, xi: &RepresentedElement<R, T>, v: &Self::Space<T>) -> Self::Space<T> {
        Power(from_fn(|n| self.0.act::<T>(xi, &v.0[n])))
    }

    #[inline]
    fn transpose_act<T: Real>(
        &self,
        xi: &RepresentedElement<R, T>,
        alpha: &Covector<Self::Space<T>>,
    ) -> Covector<Self::Space<T>> {
        let part = |n: usize| self.0.transpose_act::<T>(xi, &Covector(alpha.0.0[n])).0;
        Covector(Power(from_fn(part)))
    }

    /// Σ vₙ ◇ αₙ
    #[inline]
    fn diamond<T: Real>(
        &self,
        v: &Self::Space<T>,
        alpha: &Covector<Self::Space<T>>,
    ) -> Momentum<R::Algebra, T> {
        v.0.iter().zip(&alpha.0.0).fold(Vector::zero(), |sum: Momentum<R::Algebra, T>, (v, a)| {
            sum + self.0.diamond::<T>(v, &Covector(*a))
        })
    }
}

impl<R: GroupRepresentation, const N: usize> GroupRepresentation for Diagonal<R, N> {
    type Group = R::Group;

    fn group(&self) -> R::Group {
        self.0.group()
    }

    #[inline]
    fn transform<T: Real>(
        &self,
        g: &<R::Group as LieGroup>::Element<T>,
        v: &Self::Space<T>,
    ) -> Self::Space<T> {
        Power(from_fn(|n| self.0.transform::<T>(g, &v.0[n])))
    }

    #[inline]
    fn exp_integral<T: Real>(
        &self,
        xi: &AlgebraElement<R::Group, T>,
        phi: &Self::Space<T>,
    ) -> Self::Space<T> {
        Power(from_fn(|n| self.0.exp_integral::<T>(xi, &phi.0[n])))
    }
}

/// The adjoint representation of a group on its Lie algebra: g ξ = Ad_g ξ, ad_ξ η = [ξ, η].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Adjoint<G>(pub G);

impl<G: LieGroup> Representation for Adjoint<G> {
    type Algebra = G::Algebra;
    type Space<T: Real> = AlgebraElement<G, T>;

    fn algebra(&self) -> G::Algebra {
        self.0.algebra()
    }

    #[inline]
    fn act<T: Real>(
        &self,
        xi: &AlgebraElement<G, T>,
        v: &AlgebraElement<G, T>,
    ) -> AlgebraElement<G, T> {
        self.0.algebra().bracket::<T>(xi, v)
    }

    /// `ξᵀ α = ad*_ξ α`
    #[inline]
    fn transpose_act<T: Real>(
        &self,
        xi: &AlgebraElement<G, T>,
        alpha: &GroupMomentum<G, T>,
    ) -> GroupMomentum<G, T> {
        self.0.algebra().coadjoint::<T>(xi, alpha)
    }

    /// `v ◇ α = −ad*_v α`
    #[inline]
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

    #[inline]
    fn transform<T: Real>(
        &self,
        g: &G::Element<T>,
        v: &AlgebraElement<G, T>,
    ) -> AlgebraElement<G, T> {
        self.0.adjoint::<T>(g, v)
    }
}

/// The direct sum of two representations of one algebra: ξ (v, w) = (ξv, ξw).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sum<R, S>(pub R, pub S);

impl<R, S> Representation for Sum<R, S>
where
    R: Representation,
    S: Representation<Algebra = R::Algebra>,
{
    type Algebra = R::Algebra;
    type Space<T: Real> = Pair<R::Space<T>, S::Space<T>>;

    fn algebra(&self) -> R::Algebra {
        self.0.algebra()
    }

    #[inline]
    fn act<T: Real>(&self, xi: &RepresentedElement<R, T>, v: &Self::Space<T>) -> Self::Space<T> {
        Pair(self.0.act::<T>(xi, &v.0), self.1.act::<T>(xi, &v.1))
    }

    #[inline]
    fn transpose_act<T: Real>(
        &self,
        xi: &RepresentedElement<R, T>,
        alpha: &Covector<Self::Space<T>>,
    ) -> Covector<Self::Space<T>> {
        let Covector(Pair(first, second)) = *alpha;
        Covector(Pair(
            self.0.transpose_act::<T>(xi, &Covector(first)).0,
            self.1.transpose_act::<T>(xi, &Covector(second)).0,
        ))
    }

    /// v ◇ α + w ◇ β
    #[inline]
    fn diamond<T: Real>(
        &self,
        v: &Self::Space<T>,
        alpha: &Covector<Self::Space<T>>,
    ) -> Momentum<R::Algebra, T> {
        let Covector(Pair(first, second)) = *alpha;
        self.0.diamond::<T>(&v.0, &Covector(first)) + self.1.diamond::<T>(&v.1, &Covector(second))
    }
}

impl<R, S> GroupRepresentation for Sum<R, S>
where
    R: GroupRepresentation,
    S: GroupRepresentation<Algebra = R::Algebra, Group = R::Group>,
{
    type Group = R::Group;

    fn group(&self) -> R::Group {
        self.0.group()
    }

    #[inline]
    fn transform<T: Real>(
        &self,
        g: &<R::Group as LieGroup>::Element<T>,
        v: &Self::Space<T>,
    ) -> Self::Space<T> {
        Pair(self.0.transform::<T>(g, &v.0), self.1.transform::<T>(g, &v.1))
    }

    #[inline]
    fn exp_integral<T: Real>(
        &self,
        xi: &AlgebraElement<R::Group, T>,
        phi: &Self::Space<T>,
    ) -> Self::Space<T> {
        Pair(self.0.exp_integral::<T>(xi, &phi.0), self.1.exp_integral::<T>(xi, &phi.1))
    }
}
