//! Powers of Poisson maps: [`PowerMap`].

use crate::maps::fibre::{FibreSymmetry, Lift, LiftError};
use crate::maps::poisson_map::{PoissonMap, SourcePoint, TargetDifferential, TargetPoint};
use crate::maps::recentring::RecentringWorkspace;
use lie_poisson::{
    Covector, Differential, LieAlgebra, LiePoisson, Power, PowerAlgebra, PowerSpace, Real, Vector,
    map_coordinates,
};

/// The power Mᴺ: Pᴺ → (𝔤ᴺ)∗ of a realisation M: P → 𝔤∗, for example for N spins or N vortices: Mᴺ(z)_n = M(z_n).
///
/// # Example
/// Two spins and their lift by the Hopf map:
/// ```
/// use lie_poisson::{Covector, Power};
/// use momentum_map::{HOPF, Lift, PoissonMap, PowerMap};
/// use nalgebra::Vector3;
/// let map = PowerMap::<_, 2>(HOPF);
/// let spins = Covector(Power([Vector3::x(), Vector3::new(0.0, 0.6, 0.8)]));
/// let Covector(Power(image)) = map.apply(&map.lift(&spins)?);
/// assert!(image.iter().zip(&spins.0.0).all(|(a, b)| (a - b).norm() < 1e-15));
/// # Ok::<(), momentum_map::LiftError>(())
/// ```
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

    #[cfg_attr(optimised, inline(always))]
    fn apply<T: Real>(&self, z: &SourcePoint<Self, T>) -> TargetPoint<Self, T> {
        Covector(Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| self.0.apply::<T>(&z.0[n]).0,
        ))
    }

    /// Returns the pull-backs of the N parts of α by the map.
    #[cfg_attr(optimised, inline(always))]
    fn pull_back<T: Real>(
        &self,
        alpha: &TargetDifferential<Self, T>,
        z: &SourcePoint<Self, T>,
    ) -> Differential<Self::Source, T> {
        Covector(Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| map_coordinates(&self.0.pull_back::<T>(&alpha.0[n], &z.0[n]), |x| x),
        ))
    }

    #[cfg_attr(optimised, inline(always))]
    fn generator<T: Real>(
        &self,
        alpha: &TargetDifferential<Self, T>,
        z: &SourcePoint<Self, T>,
    ) -> SourcePoint<Self, T> {
        Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| self.0.generator::<T>(&alpha.0[n], &z.0[n]),
        )
    }

    fn equivariant_maps_descend(&self) -> bool {
        self.0.equivariant_maps_descend()
    }

    #[cfg_attr(optimised, inline(always))]
    fn gauge<T: Real>(&self, z: &SourcePoint<Self, T>) -> SourcePoint<Self, T> {
        Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| self.0.gauge::<T>(&z.0[n]),
        )
    }

    fn recentred<T: Real>(
        &self,
        z: &SourcePoint<Self, T>,
        space: &mut RecentringWorkspace<T>,
    ) -> SourcePoint<Self, T> {
        Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| self.0.recentred::<T>(&z.0[n], space),
        )
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

    /// Returns the flow with the given index. The flows of the first factor come first, then those of the second, and
    /// so on.
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
