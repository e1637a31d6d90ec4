//! Products of algebras of multipliers: [`ProductMultipliers`].

use crate::multipliers::multiplier::{InvertibleMultipliers, Multipliers};
use lie_poisson::{Differential, Pair, Point, ProductSpace, Real, parts};

/// The product 𝔄 × 𝔅 of two algebras of multipliers: (Q, R)(B, C) = (QB, RC), and each factor acts on its own part of μ.
///
/// # Example
/// A spin and a heavy top side by side; the unit moves neither:
/// ```
/// use lie_poisson::{Covector, Pair, Se3Dual};
/// use momentum_map::{DualQuaternions, Multipliers, ProductMultipliers, Quaternions};
/// use nalgebra::Vector3;
/// let algebra = ProductMultipliers(Quaternions, DualQuaternions);
/// let top = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::z());
/// let mu = Pair(Covector(Vector3::x()), top);
/// assert_eq!(algebra.transport(&algebra.one(), &mu), mu);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ProductMultipliers<M, N>(pub M, pub N);

impl<M: InvertibleMultipliers, N: InvertibleMultipliers> InvertibleMultipliers
    for ProductMultipliers<M, N>
{
}

impl<M: Multipliers, N: Multipliers> Multipliers for ProductMultipliers<M, N> {
    type Space = ProductSpace<M::Space, N::Space>;
    type Multiplier<T: Real> = Pair<M::Multiplier<T>, N::Multiplier<T>>;

    fn space(&self) -> Self::Space {
        ProductSpace(self.0.space(), self.1.space())
    }

    #[cfg_attr(optimised, inline(always))]
    fn one<T: Real>(&self) -> Self::Multiplier<T> {
        Pair(self.0.one::<T>(), self.1.one::<T>())
    }

    #[cfg_attr(optimised, inline(always))]
    fn generate<T: Real>(
        &self,
        xi: &Differential<Self::Space, T>,
        q: &Self::Multiplier<T>,
    ) -> Self::Multiplier<T> {
        let (first, second) = parts(xi);
        Pair(self.0.generate::<T>(&first, &q.0), self.1.generate::<T>(&second, &q.1))
    }

    #[cfg_attr(optimised, inline(always))]
    fn transport<T: Real>(
        &self,
        q: &Self::Multiplier<T>,
        mu: &Point<Self::Space, T>,
    ) -> Point<Self::Space, T> {
        Pair(self.0.transport::<T>(&q.0, &mu.0), self.1.transport::<T>(&q.1, &mu.1))
    }

    #[cfg_attr(optimised, inline(always))]
    fn coadjoint_change<T: Real>(
        &self,
        q: &Self::Multiplier<T>,
        mu: &Point<Self::Space, T>,
    ) -> Point<Self::Space, T> {
        Pair(self.0.coadjoint_change::<T>(&q.0, &mu.0), self.1.coadjoint_change::<T>(&q.1, &mu.1))
    }

    #[cfg_attr(optimised, inline(always))]
    fn product<T: Real>(
        &self,
        q: &Self::Multiplier<T>,
        b: &Self::Multiplier<T>,
    ) -> Self::Multiplier<T> {
        Pair(self.0.product::<T>(&q.0, &b.0), self.1.product::<T>(&q.1, &b.1))
    }

    #[cfg_attr(optimised, inline(always))]
    fn inverse<T: Real>(&self, b: &Self::Multiplier<T>) -> Self::Multiplier<T> {
        Pair(self.0.inverse::<T>(&b.0), self.1.inverse::<T>(&b.1))
    }
}
