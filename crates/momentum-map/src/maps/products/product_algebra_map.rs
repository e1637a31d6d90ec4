//! Products of maps to duals of Lie algebras: [`ProductAlgebraMap`].

use crate::maps::fibre::{FibreSymmetry, Lift, LiftError};
use crate::maps::poisson_map::{PoissonMap, SourcePoint, TargetDifferential, TargetPoint};
use crate::maps::products::ProductMap;
use crate::maps::recentring::RecentringWorkspace;
use lie_poisson::{
    Covector, Differential, LieAlgebra, LiePoisson, Pair, ProductAlgebra, ProductSpace, Real, Sign,
    from_parts,
};
use thiserror::Error;

/// The error returned for two factors whose Lie–Poisson brackets have different signs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("the brackets of the two factors have different signs, {first:?} and {second:?}")]
pub struct DifferentSigns {
    /// The sign of the bracket of the first factor.
    pub first: Sign,
    /// The sign of the bracket of the second factor.
    pub second: Sign,
}

/// The product (M, N): P₁ × P₂ → (𝔤 × 𝔥)∗ of maps to 𝔤∗ and to 𝔥∗ whose brackets have the same sign.
///
/// It is a [`ProductMap`] whose target is the dual of the product algebra, so that the
/// [Casimirs](lie_poisson::Casimirs) of this algebra and Hamiltonians on its dual are available.
///
/// # Example
/// A spin and a particle, with the Casimirs |s|², |Γ|² and Π·Γ of so(3) × se(3):
/// ```
/// use lie_poisson::{Casimirs, Covector, Pair};
/// use momentum_map::{Cotangent, HOPF, Lift, PARTICLE, PoissonMap, ProductAlgebraMap};
/// use nalgebra::Vector3;
/// let map = ProductAlgebraMap::new(HOPF, PARTICLE)?;
/// let spin = Covector(Vector3::new(0.6, 0.0, 0.8));
/// let (q, p) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(0.0, 3.0, 4.0));
/// let mu = map.apply(&Pair(HOPF.lift(&spin)?, Cotangent::new(q, Covector(p))));
/// let algebra = *map.target().algebra();
/// let casimirs = [0, 1, 2].map(|index| algebra.casimir(index, &mu));
/// assert!((casimirs[0] - 1.0).abs() < 1e-15 && casimirs[1..] == [25.0, 0.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ProductAlgebraMap<M, N> {
    factors: ProductMap<M, N>,
}

impl<M, N> ProductAlgebraMap<M, N> {
    /// Creates the product of two maps.
    ///
    /// # Errors
    /// Returns [`DifferentSigns`] if one target has the plus bracket and the other the minus bracket.
    pub fn new<A, B>(first: M, second: N) -> Result<Self, DifferentSigns>
    where
        M: PoissonMap<Target = LiePoisson<A>>,
        N: PoissonMap<Target = LiePoisson<B>>,
        A: LieAlgebra,
        B: LieAlgebra,
    {
        let signs = DifferentSigns { first: first.target().sign(), second: second.target().sign() };
        if signs.first == signs.second {
            Ok(Self { factors: ProductMap(first, second) })
        } else {
            Err(signs)
        }
    }

    /// Returns the two factors, as a map to the product of the two duals.
    pub const fn factors(&self) -> &ProductMap<M, N> {
        &self.factors
    }
}

impl<M, N, A, B> PoissonMap for ProductAlgebraMap<M, N>
where
    M: PoissonMap<Target = LiePoisson<A>>,
    N: PoissonMap<Target = LiePoisson<B>>,
    A: LieAlgebra,
    B: LieAlgebra,
{
    type Source = ProductSpace<M::Source, N::Source>;
    type Target = LiePoisson<ProductAlgebra<A, B>>;

    fn source(&self) -> Self::Source {
        self.factors.source()
    }

    fn target(&self) -> Self::Target {
        let ProductSpace(first, second) = self.factors.target();
        let algebra = ProductAlgebra(first.algebra().clone(), second.algebra().clone());
        LiePoisson::new(algebra, first.sign())
    }

    #[cfg_attr(optimised, inline(always))]
    fn apply<T: Real>(&self, z: &SourcePoint<Self, T>) -> TargetPoint<Self, T> {
        let Pair(first, second) = self.factors.apply::<T>(z);
        Covector(Pair(first.0, second.0))
    }

    /// Returns the pull-backs of the two parts of α by the two maps.
    #[cfg_attr(optimised, inline(always))]
    fn pull_back<T: Real>(
        &self,
        alpha: &TargetDifferential<Self, T>,
        z: &SourcePoint<Self, T>,
    ) -> Differential<Self::Source, T> {
        let ProductMap(first, second) = &self.factors;
        from_parts(&first.pull_back::<T>(&alpha.0, &z.0), &second.pull_back::<T>(&alpha.1, &z.1))
    }

    #[cfg_attr(optimised, inline(always))]
    fn generator<T: Real>(
        &self,
        alpha: &TargetDifferential<Self, T>,
        z: &SourcePoint<Self, T>,
    ) -> SourcePoint<Self, T> {
        let ProductMap(first, second) = &self.factors;
        Pair(first.generator::<T>(&alpha.0, &z.0), second.generator::<T>(&alpha.1, &z.1))
    }

    fn equivariant_maps_descend(&self) -> bool {
        self.factors.equivariant_maps_descend()
    }

    #[cfg_attr(optimised, inline(always))]
    fn gauge<T: Real>(&self, z: &SourcePoint<Self, T>) -> SourcePoint<Self, T> {
        self.factors.gauge::<T>(z)
    }

    fn recentred<T: Real>(
        &self,
        z: &SourcePoint<Self, T>,
        space: &mut RecentringWorkspace<T>,
    ) -> SourcePoint<Self, T> {
        self.factors.recentred::<T>(z, space)
    }
}

impl<M, N, A, B> Lift for ProductAlgebraMap<M, N>
where
    M: Lift<Target = LiePoisson<A>>,
    N: Lift<Target = LiePoisson<B>>,
    A: LieAlgebra,
    B: LieAlgebra,
{
    /// Returns the lifts of the two parts.
    fn lift<T: Real>(&self, mu: &TargetPoint<Self, T>) -> Result<SourcePoint<Self, T>, LiftError> {
        let Covector(Pair(first, second)) = *mu;
        self.factors.lift::<T>(&Pair(Covector(first), Covector(second)))
    }
}

impl<M, N, A, B> FibreSymmetry for ProductAlgebraMap<M, N>
where
    M: FibreSymmetry<Target = LiePoisson<A>>,
    N: FibreSymmetry<Target = LiePoisson<B>>,
    A: LieAlgebra,
    B: LieAlgebra,
{
    const COUNT: usize = M::COUNT + N::COUNT;

    /// Returns the flow with the given index. The flows of the first map come first, then those of the second.
    fn flow<T: Real>(&self, index: usize, s: T, z: &SourcePoint<Self, T>) -> SourcePoint<Self, T> {
        self.factors.flow::<T>(index, s, z)
    }

    fn momentum<T: Real>(&self, index: usize, z: &SourcePoint<Self, T>) -> T {
        self.factors.momentum::<T>(index, z)
    }
}
