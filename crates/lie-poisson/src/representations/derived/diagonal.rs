//! Several copies of one representation: [`Diagonal`].

use crate::algebras::algebra::Momentum;
use crate::algebras::group::{AlgebraElement, LieGroup};
use crate::representations::representation::{
    GroupRepresentation, Representation, RepresentedElement,
};
use generic_scalars::{Covector, Power, Real, Vector};

/// The diagonal representation on N copies of V: ξ (v₁, …, v_N) = (ξv₁, …, ξv_N).
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

    #[cfg_attr(optimised, inline(always))]
    fn act<T: Real>(&self, xi: &RepresentedElement<R, T>, v: &Self::Space<T>) -> Self::Space<T> {
        Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| self.0.act::<T>(xi, &v.0[n]),
        )
    }

    #[cfg_attr(optimised, inline(always))]
    fn transpose_act<T: Real>(
        &self,
        xi: &RepresentedElement<R, T>,
        alpha: &Covector<Self::Space<T>>,
    ) -> Covector<Self::Space<T>> {
        Covector(Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| self.0.transpose_act::<T>(xi, &Covector(alpha.0.0[n])).0,
        ))
    }

    /// Returns the sum Σ vₙ ◇ αₙ.
    #[cfg_attr(optimised, inline(always))]
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

    #[cfg_attr(optimised, inline(always))]
    fn transform<T: Real>(
        &self,
        g: &<R::Group as LieGroup>::Element<T>,
        v: &Self::Space<T>,
    ) -> Self::Space<T> {
        Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| self.0.transform::<T>(g, &v.0[n]),
        )
    }

    #[cfg_attr(optimised, inline(always))]
    fn exp_integral<T: Real>(
        &self,
        xi: &AlgebraElement<R::Group, T>,
        phi: &Self::Space<T>,
    ) -> Self::Space<T> {
        Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| self.0.exp_integral::<T>(xi, &phi.0[n]),
        )
    }
}
