//! Representations that G ⋉ V inherits from G: [`Inherited`].

use crate::algebras::algebra::Momentum;
use crate::algebras::group::LieGroup;
use crate::representations::representation::{
    GroupRepresentation, Representation, RepresentedElement,
};
use crate::representations::semidirect::{SemidirectAlgebra, SemidirectGroup};
use generic_scalars::{Covector, Pair, Real, Vector};

/// The representation of G ⋉ V on V, or on any other space on which G acts, through the quotient G: (g, v) w = g w.
///
/// With this representation, semidirect products can be nested. An example is se(3) ⋉ R³, whose dual is the phase
/// space of a heavy top on a movable base:
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
    /// The representation of G that is inherited.
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

    #[cfg_attr(optimised, inline(always))]
    fn act<T: Real>(&self, xi: &RepresentedElement<Self, T>, v: &R::Space<T>) -> R::Space<T> {
        self.representation.act::<T>(&xi.0, v)
    }

    #[cfg_attr(optimised, inline(always))]
    fn transpose_act<T: Real>(
        &self,
        xi: &RepresentedElement<Self, T>,
        alpha: &Covector<R::Space<T>>,
    ) -> Covector<R::Space<T>> {
        self.representation.transpose_act::<T>(&xi.0, alpha)
    }

    /// Returns (v ◇ α, 0), since V ⊂ G ⋉ V acts trivially.
    #[cfg_attr(optimised, inline(always))]
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

    #[cfg_attr(optimised, inline(always))]
    fn transform<T: Real>(
        &self,
        g: &<SemidirectGroup<Q> as LieGroup>::Element<T>,
        v: &R::Space<T>,
    ) -> R::Space<T> {
        self.representation.transform::<T>(&g.0, v)
    }

    #[cfg_attr(optimised, inline(always))]
    fn exp_integral<T: Real>(
        &self,
        xi: &RepresentedElement<Self, T>,
        phi: &R::Space<T>,
    ) -> R::Space<T> {
        self.representation.exp_integral::<T>(&xi.0, phi)
    }
}
