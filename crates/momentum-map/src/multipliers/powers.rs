//! Powers of an algebra of multipliers: [`PowerMultipliers`].

use crate::Multipliers;
use lie_poisson::{Covector, LieAlgebra, LiePoisson, Point, Power, PowerAlgebra, Real};

/// The N-th power of an algebra of multipliers, factor by factor, for example for N spins.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PowerMultipliers<M, const N: usize>(pub M);

impl<M, A, const N: usize> Multipliers for PowerMultipliers<M, N>
where
    M: Multipliers<Space = LiePoisson<A>>,
    A: LieAlgebra,
{
    type Space = LiePoisson<PowerAlgebra<A, N>>;
    type Multiplier<T: Real> = Power<M::Multiplier<T>, N>;

    fn space(&self) -> Self::Space {
        let factor = self.0.space();
        LiePoisson::new(PowerAlgebra(factor.algebra().clone()), factor.sign())
    }

    #[inline]
    fn one<T: Real>(&self) -> Self::Multiplier<T> {
        Power([self.0.one::<T>(); N])
    }

    #[inline]
    fn generate<T: Real>(
        &self,
        xi: &Power<A::Element<T>, N>,
        q: &Self::Multiplier<T>,
    ) -> Self::Multiplier<T> {
        Power::from_factors(|n| self.0.generate::<T>(&xi.0[n], &q.0[n]))
    }

    #[inline]
    fn transport<T: Real>(
        &self,
        q: &Self::Multiplier<T>,
        mu: &Point<Self::Space, T>,
    ) -> Point<Self::Space, T> {
        let factor = |n: usize| self.0.transport::<T>(&q.0[n], &Covector(mu.0.0[n])).0;
        Covector(Power::from_factors(factor))
    }

    #[inline]
    fn coadjoint_change<T: Real>(
        &self,
        q: &Self::Multiplier<T>,
        mu: &Point<Self::Space, T>,
    ) -> Point<Self::Space, T> {
        let factor = |n: usize| self.0.coadjoint_change::<T>(&q.0[n], &Covector(mu.0.0[n])).0;
        Covector(Power::from_factors(factor))
    }

    #[inline]
    fn product<T: Real>(
        &self,
        q: &Self::Multiplier<T>,
        b: &Self::Multiplier<T>,
    ) -> Self::Multiplier<T> {
        Power::from_factors(|n| self.0.product::<T>(&q.0[n], &b.0[n]))
    }

    #[inline]
    fn inverse<T: Real>(&self, b: &Self::Multiplier<T>) -> Option<Self::Multiplier<T>> {
        let mut inverse = *b;
        for b in &mut inverse.0 {
            *b = self.0.inverse::<T>(b)?;
        }
        Some(inverse)
    }
}
