//! Direct products 𝔤 × 𝔥 and G × H, and powers 𝔤ᴺ and Gᴺ.

use crate::algebras::algebra::{LieAlgebra, Momentum};
use crate::algebras::group::{AlgebraElement, LieGroup};
use generic_scalars::{Covector, Pair, Power, Real};

/// The direct product 𝔤 × 𝔥 of Lie algebras: [(ξ,η), (ξ′,η′)] = ([ξ,ξ′], [η,η′]).
///
/// ```
/// use lie_poisson::{LieAlgebra, Pair, ProductAlgebra, RealSpace, So3};
/// use nalgebra::{Vector2, Vector3};
/// let algebra = ProductAlgebra(So3, RealSpace::<2>);
/// let bracket = algebra.bracket(
///     &Pair(Vector3::x(), Vector2::new(1.0, 2.0)),
///     &Pair(Vector3::y(), Vector2::new(3.0, 4.0)),
/// );
/// assert_eq!(bracket, Pair(Vector3::z(), Vector2::zeros()));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ProductAlgebra<A, B>(pub A, pub B);

impl<A: LieAlgebra, B: LieAlgebra> LieAlgebra for ProductAlgebra<A, B> {
    type Element<T: Real> = Pair<A::Element<T>, B::Element<T>>;

    #[cfg_attr(optimised, inline(always))]
    fn bracket<T: Real>(&self, xi: &Self::Element<T>, eta: &Self::Element<T>) -> Self::Element<T> {
        Pair(self.0.bracket::<T>(&xi.0, &eta.0), self.1.bracket::<T>(&xi.1, &eta.1))
    }

    #[cfg_attr(optimised, inline(always))]
    fn coadjoint<T: Real>(
        &self,
        xi: &Self::Element<T>,
        mu: &Momentum<Self, T>,
    ) -> Momentum<Self, T> {
        let Covector(Pair(first, second)) = *mu;
        Covector(Pair(
            self.0.coadjoint::<T>(&xi.0, &Covector(first)).0,
            self.1.coadjoint::<T>(&xi.1, &Covector(second)).0,
        ))
    }
}

/// The direct product G × H of Lie groups: (g, h)(g′, h′) = (gg′, hh′).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ProductGroup<G, H>(pub G, pub H);

impl<G: LieGroup, H: LieGroup> LieGroup for ProductGroup<G, H> {
    type Algebra = ProductAlgebra<G::Algebra, H::Algebra>;
    type Element<T: Real> = Pair<G::Element<T>, H::Element<T>>;

    fn algebra(&self) -> Self::Algebra {
        ProductAlgebra(self.0.algebra(), self.1.algebra())
    }

    fn identity<T: Real>(&self) -> Self::Element<T> {
        Pair(self.0.identity::<T>(), self.1.identity::<T>())
    }

    fn compose<T: Real>(&self, g: &Self::Element<T>, h: &Self::Element<T>) -> Self::Element<T> {
        Pair(self.0.compose::<T>(&g.0, &h.0), self.1.compose::<T>(&g.1, &h.1))
    }

    fn inverse<T: Real>(&self, g: &Self::Element<T>) -> Self::Element<T> {
        Pair(self.0.inverse::<T>(&g.0), self.1.inverse::<T>(&g.1))
    }

    fn exp<T: Real>(&self, xi: &AlgebraElement<Self, T>) -> Self::Element<T> {
        Pair(self.0.exp::<T>(&xi.0), self.1.exp::<T>(&xi.1))
    }

    fn adjoint<T: Real>(
        &self,
        g: &Self::Element<T>,
        xi: &AlgebraElement<Self, T>,
    ) -> AlgebraElement<Self, T> {
        Pair(self.0.adjoint::<T>(&g.0, &xi.0), self.1.adjoint::<T>(&g.1, &xi.1))
    }
}

/// The direct power 𝔤ᴺ of a Lie algebra: [ξ, η]_n = [ξ_n, η_n] for n = 1, …, N.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PowerAlgebra<A, const N: usize>(pub A);

impl<A: LieAlgebra, const N: usize> LieAlgebra for PowerAlgebra<A, N> {
    type Element<T: Real> = Power<A::Element<T>, N>;

    #[cfg_attr(optimised, inline(always))]
    fn bracket<T: Real>(&self, xi: &Self::Element<T>, eta: &Self::Element<T>) -> Self::Element<T> {
        Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| self.0.bracket::<T>(&xi.0[n], &eta.0[n]),
        )
    }

    #[cfg_attr(optimised, inline(always))]
    fn coadjoint<T: Real>(
        &self,
        xi: &Self::Element<T>,
        mu: &Momentum<Self, T>,
    ) -> Momentum<Self, T> {
        Covector(Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| self.0.coadjoint::<T>(&xi.0[n], &Covector(mu.0.0[n])).0,
        ))
    }
}

/// The direct power Gᴺ of a Lie group: (gh)_n = g_n h_n for n = 1, …, N.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PowerGroup<G, const N: usize>(pub G);

impl<G: LieGroup, const N: usize> LieGroup for PowerGroup<G, N> {
    type Algebra = PowerAlgebra<G::Algebra, N>;
    type Element<T: Real> = Power<G::Element<T>, N>;

    fn algebra(&self) -> Self::Algebra {
        PowerAlgebra(self.0.algebra())
    }

    fn identity<T: Real>(&self) -> Self::Element<T> {
        Power([self.0.identity::<T>(); N])
    }

    fn compose<T: Real>(&self, g: &Self::Element<T>, h: &Self::Element<T>) -> Self::Element<T> {
        Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| self.0.compose::<T>(&g.0[n], &h.0[n]),
        )
    }

    fn inverse<T: Real>(&self, g: &Self::Element<T>) -> Self::Element<T> {
        Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| self.0.inverse::<T>(&g.0[n]),
        )
    }

    fn exp<T: Real>(&self, xi: &AlgebraElement<Self, T>) -> Self::Element<T> {
        Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| self.0.exp::<T>(&xi.0[n]),
        )
    }

    fn adjoint<T: Real>(
        &self,
        g: &Self::Element<T>,
        xi: &AlgebraElement<Self, T>,
    ) -> AlgebraElement<Self, T> {
        Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| self.0.adjoint::<T>(&g.0[n], &xi.0[n]),
        )
    }
}
