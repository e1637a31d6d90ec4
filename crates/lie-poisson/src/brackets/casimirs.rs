//! Casimir functions.

use crate::{
    Covector, DualNumber, LieAlgebra, Momentum, PowerAlgebra, ProductAlgebra, Real, RealSpace,
    SU2OnC2, Se2, Se3, SemidirectAlgebra, Sl2, So2, So3, Su2, UnitaryAlgebra, Vector, differential,
};
use nalgebra::SMatrix;
use num_complex::Complex;

/// The Casimirs of the Lie–Poisson bracket on 𝔤∗: functions c with {c, f} = 0 for every f, so
/// that every Hamiltonian flow conserves them. They are the same for both signs.
///
/// In terms of ad∗: `ad∗_{dc(μ)} μ = 0`.
///
/// # Example
/// ```
/// use lie_poisson::{Casimirs, LieAlgebra, Se3, Se3Dual};
/// use nalgebra::Vector3;
/// let mu = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.0, 0.6, 0.8));
/// for index in 0..Se3::COUNT {
///     let rate = Se3::default().coadjoint(&Se3::default().casimir_differential(index, &mu), &mu);
///     assert!(lie_poisson::Vector::max_abs(&rate) < 1e-15);
/// }
/// ```
pub trait Casimirs: LieAlgebra {
    /// How many independent Casimirs are listed.
    const COUNT: usize;

    /// The value of the Casimir of the given index; zero for `index` ≥ `COUNT`.
    fn casimir<T: Real>(&self, index: usize, mu: &Momentum<Self, T>) -> T;

    /// Its differential dc(μ) ∈ 𝔤, exact.
    fn casimir_differential<T: Real>(
        &self,
        index: usize,
        mu: &Momentum<Self, T>,
    ) -> Self::Element<T> {
        differential(
            |mu: &Momentum<Self, DualNumber<T>>| self.casimir::<DualNumber<T>>(index, mu),
            mu,
        )
    }
}

impl Casimirs for So3 {
    const COUNT: usize = 1;

    /// |Π|²
    #[inline]
    fn casimir<T: Real>(&self, index: usize, mu: &Momentum<Self, T>) -> T {
        if index == 0 { mu.0.dot(&mu.0) } else { T::zero() }
    }
}

impl Casimirs for Su2 {
    const COUNT: usize = 1;

    /// |μ|²
    #[inline]
    fn casimir<T: Real>(&self, index: usize, mu: &Momentum<Self, T>) -> T {
        So3.casimir(index, mu)
    }
}

impl Casimirs for Se3 {
    const COUNT: usize = 2;

    /// f₁ = |Γ|² and f₂ = Π·Γ. Source: Ohsawa 2019, §4.2.
    #[inline]
    fn casimir<T: Real>(&self, index: usize, mu: &Momentum<Self, T>) -> T {
        let (pi, gamma) = (mu.0.0, mu.0.1);
        match index {
            0 => gamma.dot(&gamma),
            1 => pi.dot(&gamma),
            _ => T::zero(),
        }
    }
}

impl Casimirs for Se2 {
    const COUNT: usize = 1;

    /// |Γ|², for (Π, Γ) ∈ R × R².
    #[inline]
    fn casimir<T: Real>(&self, index: usize, mu: &Momentum<Self, T>) -> T {
        let gamma = mu.0.1;
        if index == 0 { gamma.dot(&gamma) } else { T::zero() }
    }
}

impl Casimirs for SemidirectAlgebra<SU2OnC2> {
    const COUNT: usize = 1;

    /// ‖α‖² for (μ, α) ∈ su(2)∗ × (C²)∗: SU(2) is transitive on the spheres of C².
    #[inline]
    fn casimir<T: Real>(&self, index: usize, mu: &Momentum<Self, T>) -> T {
        let alpha = mu.0.1;
        if index == 0 { alpha.pairing(&Covector(alpha)) } else { T::zero() }
    }
}

impl Casimirs for Sl2 {
    const COUNT: usize = 1;

    /// ¼α² + βγ for μ = (α, β, γ), which is −det of the matrix that represents μ by the trace
    /// form ⟨μ, ξ⟩ = tr(mξ). Negative on the elliptic orbits, positive on the hyperbolic ones.
    #[inline]
    fn casimir<T: Real>(&self, index: usize, mu: &Momentum<Self, T>) -> T {
        let m = mu.0;
        if index == 0 { m.x * m.x * 0.25 + m.y * m.z } else { T::zero() }
    }
}

impl Casimirs for So2 {
    const COUNT: usize = 1;

    /// The momentum itself: the algebra is abelian.
    #[inline]
    fn casimir<T: Real>(&self, index: usize, mu: &Momentum<Self, T>) -> T {
        mu.coordinate(index)
    }
}

impl<const N: usize> Casimirs for RealSpace<N> {
    const COUNT: usize = N;

    /// The coordinates: the algebra is abelian.
    #[inline]
    fn casimir<T: Real>(&self, index: usize, mu: &Momentum<Self, T>) -> T {
        mu.coordinate(index)
    }
}

impl<const N: usize> Casimirs for UnitaryAlgebra<N> {
    const COUNT: usize = N;

    /// tr H, tr H², …, tr Hᴺ of the Hermitian matrix H of μ.
    fn casimir<T: Real>(&self, index: usize, mu: &Momentum<Self, T>) -> T {
        let h = self.hermitian(mu);
        let one = SMatrix::<Complex<T>, N, N>::identity();
        let power = (0..=index.min(N)).fold(one, |power, _| power * h);
        if index < N { power.trace().re } else { T::zero() }
    }
}

impl<A: Casimirs, B: Casimirs> Casimirs for ProductAlgebra<A, B> {
    const COUNT: usize = A::COUNT + B::COUNT;

    /// Those of the first factor, then those of the second.
    #[inline]
    fn casimir<T: Real>(&self, index: usize, mu: &Momentum<Self, T>) -> T {
        if index < A::COUNT {
            self.0.casimir::<T>(index, &Covector(mu.0.0))
        } else {
            self.1.casimir::<T>(index - A::COUNT, &Covector(mu.0.1))
        }
    }
}

impl<A: Casimirs, const N: usize> Casimirs for PowerAlgebra<A, N> {
    const COUNT: usize = N * A::COUNT;

    /// Those of the first factor, then those of the second, and so on.
    #[inline]
    fn casimir<T: Real>(&self, index: usize, mu: &Momentum<Self, T>) -> T {
        let count = A::COUNT.max(1);
        let factor = mu.0.0.get(index / count);
        factor.map_or_else(T::zero, |factor| self.0.casimir::<T>(index % count, &Covector(*factor)))
    }
}
