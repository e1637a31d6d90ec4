//! Powers of an algebra of multipliers: [`PowerMultipliers`].

use crate::multipliers::multiplier::{InvertibleMultipliers, Multipliers};
use lie_poisson::{Covector, LieAlgebra, LiePoisson, Point, Power, PowerAlgebra, Real};

/// The N-th power 𝔄ᴺ of an algebra of multipliers, for example for N spins: (Q B)_n = Q_n B_n, transport(Q, μ)_n =
/// transport(Q_n, μ_n) and (ξ Q)_n = ξ_n Q_n for n = 1, …, N.
///
/// # Example
/// A half turn of the first of two spins about the third axis:
/// ```
/// use lie_poisson::{Covector, Power, Quaternion};
/// use momentum_map::{Multipliers, PowerMultipliers, Quaternions};
/// use nalgebra::Vector3;
/// let algebra = PowerMultipliers::<_, 2>(Quaternions);
/// let half_turn = Quaternion { scalar: 0.0, vector: Vector3::z() };
/// let spins = Covector(Power([Vector3::x(), Vector3::y()]));
/// let turned = algebra.transport(&Power([half_turn, Quaternion::one()]), &spins);
/// assert_eq!(turned, Covector(Power([-Vector3::x(), Vector3::y()])));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PowerMultipliers<M, const N: usize>(pub M);

impl<M, A, const N: usize> InvertibleMultipliers for PowerMultipliers<M, N>
where
    M: InvertibleMultipliers<Space = LiePoisson<A>>,
    A: LieAlgebra,
{
}

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

    #[cfg_attr(optimised, inline(always))]
    fn one<T: Real>(&self) -> Self::Multiplier<T> {
        Power([self.0.one::<T>(); N])
    }

    #[cfg_attr(optimised, inline(always))]
    fn generate<T: Real>(
        &self,
        xi: &Power<A::Element<T>, N>,
        q: &Self::Multiplier<T>,
    ) -> Self::Multiplier<T> {
        Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| self.0.generate::<T>(&xi.0[n], &q.0[n]),
        )
    }

    #[cfg_attr(optimised, inline(always))]
    fn transport<T: Real>(
        &self,
        q: &Self::Multiplier<T>,
        mu: &Point<Self::Space, T>,
    ) -> Point<Self::Space, T> {
        Covector(Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| self.0.transport::<T>(&q.0[n], &Covector(mu.0.0[n])).0,
        ))
    }

    #[cfg_attr(optimised, inline(always))]
    fn coadjoint_change<T: Real>(
        &self,
        q: &Self::Multiplier<T>,
        mu: &Point<Self::Space, T>,
    ) -> Point<Self::Space, T> {
        Covector(Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| self.0.coadjoint_change::<T>(&q.0[n], &Covector(mu.0.0[n])).0,
        ))
    }

    #[cfg_attr(optimised, inline(always))]
    fn product<T: Real>(
        &self,
        q: &Self::Multiplier<T>,
        b: &Self::Multiplier<T>,
    ) -> Self::Multiplier<T> {
        Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| self.0.product::<T>(&q.0[n], &b.0[n]),
        )
    }

    #[cfg_attr(optimised, inline(always))]
    fn inverse<T: Real>(&self, b: &Self::Multiplier<T>) -> Self::Multiplier<T> {
        Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| self.0.inverse::<T>(&b.0[n]),
        )
    }
}
