//! The direct sum of two representations: [`Sum`].

use crate::algebras::algebra::Momentum;
use crate::algebras::group::{AlgebraElement, LieGroup};
use crate::representations::representation::{
    GroupRepresentation, Representation, RepresentedElement,
};
use generic_scalars::{Covector, Pair, Real};

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

    #[cfg_attr(optimised, inline(always))]
    fn act<T: Real>(&self, xi: &RepresentedElement<R, T>, v: &Self::Space<T>) -> Self::Space<T> {
        Pair(self.0.act::<T>(xi, &v.0), self.1.act::<T>(xi, &v.1))
    }

    #[cfg_attr(optimised, inline(always))]
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

    /// Returns the sum v ◇ α + w ◇ β.
    #[cfg_attr(optimised, inline(always))]
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

    #[cfg_attr(optimised, inline(always))]
    fn transform<T: Real>(
        &self,
        g: &<R::Group as LieGroup>::Element<T>,
        v: &Self::Space<T>,
    ) -> Self::Space<T> {
        Pair(self.0.transform::<T>(g, &v.0), self.1.transform::<T>(g, &v.1))
    }

    #[cfg_attr(optimised, inline(always))]
    fn exp_integral<T: Real>(
        &self,
        xi: &AlgebraElement<R::Group, T>,
        phi: &Self::Space<T>,
    ) -> Self::Space<T> {
        Pair(self.0.exp_integral::<T>(xi, &phi.0), self.1.exp_integral::<T>(xi, &phi.1))
    }
}
