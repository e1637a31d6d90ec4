//! Collective dynamics without a lift: multipliers.

use lie_poisson::{Differential, Point, PoissonSpace, Real, Vector};

/// An associative algebra 𝔄 ∋ Q of linear maps of P that contains the generators of a linear
/// collective system, and acts on 𝔤∗ in such a way that J(Qz) depends on J(z) and Q alone.
///
/// Collective dynamics ż = ξ(J(z)) z, ξ = dh, keeps the form z = Q z₀, where Q obeys
///
/// ```text
/// dQ/dt = ξ(J(Qz₀)) Q,    Q(0) = 1,    J(Qz₀) = transport(Q, J(z₀))
/// ```
///
/// which mentions z₀ only through μ₀ = J(z₀). A Runge–Kutta method commutes with the linear map
/// Q ↦ Qz₀, so the collective method on P *is* the same method for Q: a map of 𝔤∗ in closed form,
/// without a lift, without a fibre to drift along, and on all of 𝔤∗, image of J or not.
///
/// A multiplier is determined up to what `transport` does not see; the flow conserves quadratic
/// invariants of Q (|Q|² = 1 for quaternions) that make `transport` a coadjoint motion, and so
/// does every Gauss method.
pub trait Multipliers: Clone {
    /// 𝔤∗, or a product of such spaces.
    type Space: PoissonSpace;

    /// Q ∈ 𝔄 over the scalar `T`.
    type Multiplier<T: Real>: Vector<Scalar = T>;

    /// 𝔤∗ as a value.
    fn space(&self) -> Self::Space;

    /// 1 ∈ 𝔄
    fn one<T: Real>(&self) -> Self::Multiplier<T>;

    /// ξ Q, the rate of change of Q for ξ = dh.
    fn generate<T: Real>(
        &self,
        xi: &Differential<Self::Space, T>,
        q: &Self::Multiplier<T>,
    ) -> Self::Multiplier<T>;

    /// J(Qz₀) from μ₀ = J(z₀).
    fn transport<T: Real>(
        &self,
        q: &Self::Multiplier<T>,
        mu: &Point<Self::Space, T>,
    ) -> Point<Self::Space, T>;

    /// The change that the coadjoint motion by Q makes of μ, once the quadratic invariants of Q are
    /// restored, which a step has changed by round-off only. Where it is computed without
    /// cancellation, it is exact to a few roundings of its own size, and Casimirs of μ are conserved
    /// to a rounding without bias. By default transport(Q, μ) − μ.
    #[inline]
    fn coadjoint_change<T: Real>(
        &self,
        q: &Self::Multiplier<T>,
        mu: &Point<Self::Space, T>,
    ) -> Point<Self::Space, T> {
        self.transport::<T>(q, mu) - *mu
    }

    /// The product Q B in 𝔄.
    fn product<T: Real>(
        &self,
        q: &Self::Multiplier<T>,
        b: &Self::Multiplier<T>,
    ) -> Self::Multiplier<T>;

    /// B⁻¹, for a B whose quadratic invariants hold; where they are only near, next to it: good for
    /// a guess. With it a step that begins at 1 continues one that ended at B. By default `None`:
    /// there is no guess, and nothing else is lost.
    #[inline]
    fn inverse<T: Real>(&self, _b: &Self::Multiplier<T>) -> Option<Self::Multiplier<T>> {
        None
    }
}

/// A multiplier of a collective system, over the scalar `T`.
pub type Multiplier<M, T = f64> = <M as Multipliers>::Multiplier<T>;
