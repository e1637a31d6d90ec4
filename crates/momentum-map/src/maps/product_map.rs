//! Products and powers of Poisson maps: [`ProductMap`], [`PowerMap`].

use crate::maps::poisson_map::{PoissonMap, SourcePoint, TargetDifferential, TargetPoint};
use crate::{FibreSymmetry, Lift, LiftError, RecentringSpace};
use core::array::from_fn;
use lie_poisson::{
    Covector, LieAlgebra, LiePoisson, Pair, Power, PowerAlgebra, PowerSpace, ProductSpace, Real,
    Vector, parts,
};

/// The product (M, N): P₁ × P₂ → Q₁ × Q₂ of two Poisson maps.
///
/// With [`Identity`](crate::Identity) for N, it couples spins or vortices to canonical variables on (S²)ⁿ ×
/// T∗R^m.
///
/// Source: Bogfjellmo, *Collective symplectic integrators on S₂ⁿ × T∗R^m*, arXiv:1809.06231 (2018).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ProductMap<M, N>(pub M, pub N);

impl<M: PoissonMap, N: PoissonMap> PoissonMap for ProductMap<M, N> {
    type Source = ProductSpace<M::Source, N::Source>;
    type Target = ProductSpace<M::Target, N::Target>;

    fn source(&self) -> Self::Source {
        ProductSpace(self.0.source(), self.1.source())
    }

    fn target(&self) -> Self::Target {
        ProductSpace(self.0.target(), self.1.target())
    }

    #[inline]
    fn apply<T: Real>(&self, z: &SourcePoint<Self, T>) -> TargetPoint<Self, T> {
        Pair(self.0.apply::<T>(&z.0), self.1.apply::<T>(&z.1))
    }

    #[inline]
    fn generator<T: Real>(
        &self,
        alpha: &TargetDifferential<Self, T>,
        z: &SourcePoint<Self, T>,
    ) -> SourcePoint<Self, T> {
        let (first, second) = parts(alpha);
        Pair(self.0.generator::<T>(&first, &z.0), self.1.generator::<T>(&second, &z.1))
    }

    #[inline]
    fn gauge<T: Real>(&self, z: &SourcePoint<Self, T>) -> SourcePoint<Self, T> {
        Pair(self.0.gauge::<T>(&z.0), self.1.gauge::<T>(&z.1))
    }

    fn recentred<T: Real>(
        &self,
        z: &SourcePoint<Self, T>,
        space: &mut RecentringSpace<T>,
    ) -> SourcePoint<Self, T> {
        Pair(self.0.recentred::<T>(&z.0, space), self.1.recentred::<T>(&z.1, space))
    }
}

impl<M: Lift, N: Lift> Lift for ProductMap<M, N> {
    /// Returns the lifts of the two parts.
    fn lift<T: Real>(&self, mu: &TargetPoint<Self, T>) -> Result<SourcePoint<Self, T>, LiftError> {
        Ok(Pair(self.0.lift::<T>(&mu.0)?, self.1.lift::<T>(&mu.1)?))
    }
}

impl<M: FibreSymmetry, N: FibreSymmetry> FibreSymmetry for ProductMap<M, N> {
    const COUNT: usize = M::COUNT + N::COUNT;

    /// Returns the flow with the given index: those of the first map, then those of the second.
    fn flow<T: Real>(&self, index: usize, s: T, z: &SourcePoint<Self, T>) -> SourcePoint<Self, T> {
        if index < M::COUNT {
            Pair(self.0.flow::<T>(index, s, &z.0), z.1)
        } else {
            Pair(z.0, self.1.flow::<T>(index - M::COUNT, s, &z.1))
        }
    }

    fn momentum<T: Real>(&self, index: usize, z: &SourcePoint<Self, T>) -> T {
        if index < M::COUNT {
            self.0.momentum::<T>(index, &z.0)
        } else {
            self.1.momentum::<T>(index - M::COUNT, &z.1)
        }
    }
}

/// The power Mᴺ: Pᴺ → (𝔤ᴺ)∗ of a realisation M: P → 𝔤∗, for example for N spins or N vortices.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PowerMap<M, const N: usize>(pub M);

impl<M, A, const N: usize> PoissonMap for PowerMap<M, N>
where
    M: PoissonMap<Target = LiePoisson<A>>,
    A: LieAlgebra,
{
    type Source = PowerSpace<M::Source, N>;
    type Target = LiePoisson<PowerAlgebra<A, N>>;

    fn source(&self) -> Self::Source {
        PowerSpace(self.0.source())
    }

    fn target(&self) -> Self::Target {
        let factor = self.0.target();
        LiePoisson::new(PowerAlgebra(factor.algebra().clone()), factor.sign())
    }

    #[inline]
    fn apply<T: Real>(&self, z: &SourcePoint<Self, T>) -> TargetPoint<Self, T> {
        Covector(Power(from_fn(|n| self.0.apply::<T>(&z.0[n]).0)))
    }

    #[inline]
    fn generator<T: Real>(
        &self,
        alpha: &TargetDifferential<Self, T>,
        z: &SourcePoint<Self, T>,
    ) -> SourcePoint<Self, T> {
        Power(from_fn(|n| self.0.generator::<T>(&alpha.0[n], &z.0[n])))
    }

    #[inline]
    fn gauge<T: Real>(&self, z: &SourcePoint<Self, T>) -> SourcePoint<Self, T> {
        Power(from_fn(|n| self.0.gauge::<T>(&z.0[n])))
    }

    fn recentred<T: Real>(
        &self,
        z: &SourcePoint<Self, T>,
        space: &mut RecentringSpace<T>,
    ) -> SourcePoint<Self, T> {
        Power(from_fn(|n| self.0.recentred::<T>(&z.0[n], space)))
    }
}

impl<M, A, const N: usize> Lift for PowerMap<M, N>
where
    M: Lift<Target = LiePoisson<A>>,
    A: LieAlgebra,
{
    /// Returns the lifts of the factors.
    fn lift<T: Real>(&self, mu: &TargetPoint<Self, T>) -> Result<SourcePoint<Self, T>, LiftError> {
        let mut z: SourcePoint<Self, T> = Vector::zero();
        for (z, mu) in z.0.iter_mut().zip(&mu.0.0) {
            *z = self.0.lift::<T>(&Covector(*mu))?;
        }
        Ok(z)
    }
}

impl<M, A, const N: usize> FibreSymmetry for PowerMap<M, N>
where
    M: FibreSymmetry<Target = LiePoisson<A>>,
    A: LieAlgebra,
{
    const COUNT: usize = N * M::COUNT;

    /// Returns the flow with the given index: those of the first factor, then those of the second, and so on.
    fn flow<T: Real>(&self, index: usize, s: T, z: &SourcePoint<Self, T>) -> SourcePoint<Self, T> {
        let count = M::COUNT.max(1);
        let mut moved = *z;
        if let Some(factor) = moved.0.get_mut(index / count) {
            *factor = self.0.flow::<T>(index % count, s, factor);
        }
        moved
    }

    fn momentum<T: Real>(&self, index: usize, z: &SourcePoint<Self, T>) -> T {
        let count = M::COUNT.max(1);
        let factor = z.0.get(index / count);
        factor.map_or_else(T::zero, |z| self.0.momentum::<T>(index % count, z))
    }
}
