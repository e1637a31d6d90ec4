//! Products of Poisson maps: [`ProductMap`].

use crate::maps::fibre::{FibreSymmetry, Lift, LiftError};
use crate::maps::poisson_map::{PoissonMap, SourcePoint, TargetDifferential, TargetPoint};
use crate::maps::recentring::RecentringWorkspace;
use lie_poisson::{Differential, Pair, ProductSpace, Real, from_parts, parts};

/// The product (M, N): P₁ × P₂ → Q₁ × Q₂ of two Poisson maps.
///
/// If both targets are duals of Lie algebras, [`ProductAlgebraMap`](crate::ProductAlgebraMap) has the dual of the
/// product algebra as its target.
///
/// With [`Identity`](crate::Identity) for N, the product serves spins or vortices that are coupled to canonical
/// variables, on (S²)ⁿ × T∗R^m.
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

    #[cfg_attr(optimised, inline(always))]
    fn apply<T: Real>(&self, z: &SourcePoint<Self, T>) -> TargetPoint<Self, T> {
        Pair(self.0.apply::<T>(&z.0), self.1.apply::<T>(&z.1))
    }

    /// Returns the pull-backs of the two parts of α by the two maps, each of which may have a closed form.
    #[cfg_attr(optimised, inline(always))]
    fn pull_back<T: Real>(
        &self,
        alpha: &TargetDifferential<Self, T>,
        z: &SourcePoint<Self, T>,
    ) -> Differential<Self::Source, T> {
        let (first, second) = parts(alpha);
        from_parts(&self.0.pull_back::<T>(&first, &z.0), &self.1.pull_back::<T>(&second, &z.1))
    }

    #[cfg_attr(optimised, inline(always))]
    fn generator<T: Real>(
        &self,
        alpha: &TargetDifferential<Self, T>,
        z: &SourcePoint<Self, T>,
    ) -> SourcePoint<Self, T> {
        let (first, second) = parts(alpha);
        Pair(self.0.generator::<T>(&first, &z.0), self.1.generator::<T>(&second, &z.1))
    }

    fn equivariant_maps_descend(&self) -> bool {
        self.0.equivariant_maps_descend() && self.1.equivariant_maps_descend()
    }

    #[cfg_attr(optimised, inline(always))]
    fn gauge<T: Real>(&self, z: &SourcePoint<Self, T>) -> SourcePoint<Self, T> {
        Pair(self.0.gauge::<T>(&z.0), self.1.gauge::<T>(&z.1))
    }

    fn recentred<T: Real>(
        &self,
        z: &SourcePoint<Self, T>,
        space: &mut RecentringWorkspace<T>,
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

    /// Returns the flow with the given index. The flows of the first map come first, then those of the second.
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
