//! Collective dynamics without a lift: multipliers.

use core::array::from_fn;
use lie_poisson::{
    Covector, Differential, LieAlgebra, LiePoisson, Pair, Point, PoissonSpace, Power, PowerAlgebra,
    ProductSpace, Quaternion, Real, SO3OnR3, Se3, Se3Dual, SemidirectAlgebra, SkewHermitian, So3,
    UnitaryAlgebra, Vector, parts,
};
use nalgebra::{SMatrix, Vector3};
use num_complex::Complex;

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

/// Quaternions, for so(3)∗ with the minus bracket and the Hopf map:
///
/// ```text
/// dQ/dt = −½ Ω Q,    Π = Q Π₀ conj(Q)
/// ```
///
/// Unit quaternions turn Π₀; the body's attitude is Rₙ₊₁ = Rₙ R_Qᵀ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Quaternions;

impl Multipliers for Quaternions {
    type Space = LiePoisson<So3>;
    type Multiplier<T: Real> = Quaternion<T>;

    fn space(&self) -> LiePoisson<So3> {
        LiePoisson::minus(So3)
    }

    #[inline]
    fn one<T: Real>(&self) -> Quaternion<T> {
        Quaternion::one()
    }

    #[inline]
    fn generate<T: Real>(&self, omega: &Vector3<T>, q: &Quaternion<T>) -> Quaternion<T> {
        Quaternion::imaginary_times(&(omega * T::from_f64(-0.5)), q)
    }

    #[inline]
    fn transport<T: Real>(
        &self,
        q: &Quaternion<T>,
        mu: &Covector<Vector3<T>>,
    ) -> Covector<Vector3<T>> {
        Covector(q.sandwich(&mu.0))
    }

    /// Of the rotation by Q/|Q|.
    #[inline]
    fn coadjoint_change<T: Real>(
        &self,
        q: &Quaternion<T>,
        mu: &Covector<Vector3<T>>,
    ) -> Covector<Vector3<T>> {
        Covector(q.rotation_change(&mu.0))
    }

    #[inline]
    fn product<T: Real>(&self, q: &Quaternion<T>, b: &Quaternion<T>) -> Quaternion<T> {
        *q * *b
    }

    #[inline]
    fn inverse<T: Real>(&self, b: &Quaternion<T>) -> Option<Quaternion<T>> {
        Some(inverse(b))
    }
}

/// q̄/|q|²
#[inline]
fn inverse<T: Real>(q: &Quaternion<T>) -> Quaternion<T> {
    q.conjugate().scaled(T::one() / q.norm_squared())
}

/// Dual quaternions Q + εN, for se(3)∗ with the minus bracket and M: T∗C² → se(3)∗. With
/// (Ω, γ) = dh,
///
/// ```text
/// dQ/dt = −½ Ω Q,    dN/dt = −½ Ω N − 2γ Q,    N conj(Q) = x₀ + x
/// Γ = Q Γ₀ conj(Q),    Π = Q Π₀ conj(Q) + (x × Γ + x₀ Γ)/(2|Q|²) = Im((Q Π₀ + ½ N Γ₀) conj(Q))
/// ```
///
/// where χ = Qχ₀ − iNψ₀ and ψ = Qψ₀ (quaternions act on C² by u ↦ −i u·σ). |Q|² = 1 and x₀ = 0 are
/// quadratic invariants: unit dual quaternions, the double cover of SE(3).
///
/// Source of dual quaternions: E. Study, *Geometrie der Dynamen* (1903).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DualQuaternions;

impl Multipliers for DualQuaternions {
    type Space = LiePoisson<Se3>;
    type Multiplier<T: Real> = Pair<Quaternion<T>, Quaternion<T>>;

    fn space(&self) -> LiePoisson<Se3> {
        LiePoisson::minus(SemidirectAlgebra(SO3OnR3))
    }

    #[inline]
    fn one<T: Real>(&self) -> Self::Multiplier<T> {
        Pair(Quaternion::one(), Vector::zero())
    }

    #[inline]
    fn generate<T: Real>(
        &self,
        dh: &Pair<Vector3<T>, Vector3<T>>,
        q: &Self::Multiplier<T>,
    ) -> Self::Multiplier<T> {
        let turn = dh.0 * T::from_f64(-0.5);
        let push = dh.1 * T::from_f64(-2.0);
        let times = Quaternion::imaginary_times;
        Pair(times(&turn, &q.0), times(&turn, &q.1) + times(&push, &q.0))
    }

    #[inline]
    fn transport<T: Real>(&self, q: &Self::Multiplier<T>, mu: &Se3Dual<T>) -> Se3Dual<T> {
        let (Pair(q, n), Covector(Pair(pi, gamma))) = (q, mu);
        let half = gamma * T::from_f64(0.5);
        let moved = q.times_imaginary(pi) + n.times_imaginary(&half);
        let turned = q.times_imaginary(gamma);
        Se3Dual::new(moved.imaginary_part_by_conjugate(q), turned.imaginary_part_by_conjugate(q))
    }

    /// Of the motion by the unit dual quaternion next to Q + εN: |Q|² = 1 and x₀ = 0.
    #[inline]
    fn coadjoint_change<T: Real>(&self, q: &Self::Multiplier<T>, mu: &Se3Dual<T>) -> Se3Dual<T> {
        let (Pair(q, n), Covector(Pair(pi, gamma))) = (q, mu);
        let change = q.rotation_change(gamma);
        let x = (*n * q.conjugate()).vector * (T::from_f64(0.5) / q.norm_squared());
        Se3Dual::new(q.rotation_change(pi) + x.cross(&(gamma + change)), change)
    }

    /// (Q + εN)(A + εB) = QA + ε(QB + NA)
    #[inline]
    fn product<T: Real>(
        &self,
        q: &Self::Multiplier<T>,
        b: &Self::Multiplier<T>,
    ) -> Self::Multiplier<T> {
        Pair(q.0 * b.0, q.0 * b.1 + q.1 * b.0)
    }

    /// (A + εB)⁻¹ = Ā/|A|² + ε (B̄ − 2 ⟨A, B⟩ Ā/|A|²)/|A|², of any with A ≠ 0.
    #[inline]
    fn inverse<T: Real>(&self, b: &Self::Multiplier<T>) -> Option<Self::Multiplier<T>> {
        let Pair(a, b) = b;
        let scale = T::one() / a.norm_squared();
        let turn = a.conjugate().scaled(scale);
        let along = a.scalar * b.scalar + a.vector.dot(&b.vector);
        Some(Pair(turn, b.conjugate().scaled(scale) - turn.scaled((along + along) * scale)))
    }
}

/// Complex N×N matrices, for u(N)∗ with the minus bracket: in terms of the Hermitian matrix H of
/// a momentum,
///
/// ```text
/// dQ/dt = −ξ Q,    H = Q H₀ Q*
/// ```
///
/// for H₀ of any rank: with Gauss methods an isospectral integrator.
///
/// Source: K. Modin & M. Viviani, *Lie–Poisson methods for isospectral flows*, Found. Comput. Math.
/// 20 (2020).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ComplexMatrices<const N: usize>;

impl<const N: usize> Multipliers for ComplexMatrices<N> {
    type Space = LiePoisson<UnitaryAlgebra<N>>;
    type Multiplier<T: Real> = SMatrix<Complex<T>, N, N>;

    fn space(&self) -> Self::Space {
        LiePoisson::minus(UnitaryAlgebra)
    }

    #[inline]
    fn one<T: Real>(&self) -> SMatrix<Complex<T>, N, N> {
        SMatrix::identity()
    }

    #[inline]
    fn generate<T: Real>(
        &self,
        xi: &SkewHermitian<T, N>,
        q: &SMatrix<Complex<T>, N, N>,
    ) -> SMatrix<Complex<T>, N, N> {
        -(xi.matrix() * q)
    }

    #[inline]
    fn transport<T: Real>(
        &self,
        q: &SMatrix<Complex<T>, N, N>,
        mu: &Covector<SkewHermitian<T, N>>,
    ) -> Covector<SkewHermitian<T, N>> {
        let moved = q * UnitaryAlgebra.hermitian(mu) * q.transpose().map(|z| z.conj());
        UnitaryAlgebra.momentum(&moved)
    }

    #[inline]
    fn product<T: Real>(
        &self,
        q: &SMatrix<Complex<T>, N, N>,
        b: &SMatrix<Complex<T>, N, N>,
    ) -> SMatrix<Complex<T>, N, N> {
        q * b
    }

    /// B∗, of unitary B.
    #[inline]
    fn inverse<T: Real>(&self, b: &SMatrix<Complex<T>, N, N>) -> Option<SMatrix<Complex<T>, N, N>> {
        Some(b.transpose().map(|z| z.conj()))
    }
}

/// The powers of an algebra of multipliers, factor by factor: N spins.
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
        Power(from_fn(|n| self.0.generate::<T>(&xi.0[n], &q.0[n])))
    }

    #[inline]
    fn transport<T: Real>(
        &self,
        q: &Self::Multiplier<T>,
        mu: &Point<Self::Space, T>,
    ) -> Point<Self::Space, T> {
        let factor = |n: usize| self.0.transport::<T>(&q.0[n], &Covector(mu.0.0[n])).0;
        Covector(Power(from_fn(factor)))
    }

    #[inline]
    fn coadjoint_change<T: Real>(
        &self,
        q: &Self::Multiplier<T>,
        mu: &Point<Self::Space, T>,
    ) -> Point<Self::Space, T> {
        let factor = |n: usize| self.0.coadjoint_change::<T>(&q.0[n], &Covector(mu.0.0[n])).0;
        Covector(Power(from_fn(factor)))
    }

    #[inline]
    fn product<T: Real>(
        &self,
        q: &Self::Multiplier<T>,
        b: &Self::Multiplier<T>,
    ) -> Self::Multiplier<T> {
        Power(from_fn(|n| self.0.product::<T>(&q.0[n], &b.0[n])))
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

/// The product of two algebras of multipliers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ProductMultipliers<M, N>(pub M, pub N);

impl<M: Multipliers, N: Multipliers> Multipliers for ProductMultipliers<M, N> {
    type Space = ProductSpace<M::Space, N::Space>;
    type Multiplier<T: Real> = Pair<M::Multiplier<T>, N::Multiplier<T>>;

    fn space(&self) -> Self::Space {
        ProductSpace(self.0.space(), self.1.space())
    }

    #[inline]
    fn one<T: Real>(&self) -> Self::Multiplier<T> {
        Pair(self.0.one::<T>(), self.1.one::<T>())
    }

    #[inline]
    fn generate<T: Real>(
        &self,
        xi: &Differential<Self::Space, T>,
        q: &Self::Multiplier<T>,
    ) -> Self::Multiplier<T> {
        let (first, second) = parts(xi);
        Pair(self.0.generate::<T>(&first, &q.0), self.1.generate::<T>(&second, &q.1))
    }

    #[inline]
    fn transport<T: Real>(
        &self,
        q: &Self::Multiplier<T>,
        mu: &Point<Self::Space, T>,
    ) -> Point<Self::Space, T> {
        Pair(self.0.transport::<T>(&q.0, &mu.0), self.1.transport::<T>(&q.1, &mu.1))
    }

    #[inline]
    fn coadjoint_change<T: Real>(
        &self,
        q: &Self::Multiplier<T>,
        mu: &Point<Self::Space, T>,
    ) -> Point<Self::Space, T> {
        Pair(self.0.coadjoint_change::<T>(&q.0, &mu.0), self.1.coadjoint_change::<T>(&q.1, &mu.1))
    }

    #[inline]
    fn product<T: Real>(
        &self,
        q: &Self::Multiplier<T>,
        b: &Self::Multiplier<T>,
    ) -> Self::Multiplier<T> {
        Pair(self.0.product::<T>(&q.0, &b.0), self.1.product::<T>(&q.1, &b.1))
    }

    #[inline]
    fn inverse<T: Real>(&self, b: &Self::Multiplier<T>) -> Option<Self::Multiplier<T>> {
        Some(Pair(self.0.inverse::<T>(&b.0)?, self.1.inverse::<T>(&b.1)?))
    }
}
