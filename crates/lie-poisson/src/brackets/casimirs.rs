//! Casimir functions of Lie–Poisson brackets: [`Casimirs`].

use crate::algebras::algebra::{LieAlgebra, Momentum};
use crate::algebras::product::{PowerAlgebra, ProductAlgebra};
use crate::groups::sl2::Sl2;
use crate::groups::so2::So2;
use crate::groups::so3::So3;
use crate::groups::su2::Su2;
use crate::groups::unitary::UnitaryAlgebra;
use crate::representations::euclidean::{Se2, Se3};
use crate::representations::semidirect::SemidirectAlgebra;
use crate::representations::unitary_matrices::SU2OnC2;
use generic_scalars::{Covector, DualNumber, Real, RealSpace, State, Vector, differential};
use nalgebra::SMatrix;
use num_complex::Complex;

/// The Casimirs of the Lie–Poisson bracket on 𝔤∗: functions c with {c, f} = 0 for every f.
///
/// Every Hamiltonian flow conserves them. They are the same for both signs of the bracket. In terms of ad∗ they are
/// the functions c with `ad∗_ξ μ` = 0 for ξ = dc(μ).
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
    /// The number of independent Casimirs that are listed.
    const COUNT: usize;

    /// Returns the value of the Casimir with the given index, or zero for `index` ≥ `COUNT`.
    fn casimir<T: Real>(&self, index: usize, mu: &Momentum<Self, T>) -> T;

    /// Returns the exact differential dc(μ) ∈ 𝔤 of the Casimir with the given index.
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

    /// Returns the Casimir |Π|².
    #[cfg_attr(optimised, inline(always))]
    fn casimir<T: Real>(&self, index: usize, mu: &Momentum<Self, T>) -> T {
        if index == 0 { mu.0.dot(&mu.0) } else { T::zero() }
    }
}

impl Casimirs for Su2 {
    const COUNT: usize = 1;

    /// Returns the Casimir |μ|².
    #[cfg_attr(optimised, inline(always))]
    fn casimir<T: Real>(&self, index: usize, mu: &Momentum<Self, T>) -> T {
        So3.casimir(index, mu)
    }
}

impl Casimirs for Se3 {
    const COUNT: usize = 2;

    /// Returns the Casimir f₁ = |Γ|² (index 0) or f₂ = Π·Γ (index 1). Source: Ohsawa 2019, §4.2.
    #[cfg_attr(optimised, inline(always))]
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

    /// Returns the Casimir |Γ|² of (Π, Γ) ∈ R × R².
    #[cfg_attr(optimised, inline(always))]
    fn casimir<T: Real>(&self, index: usize, mu: &Momentum<Self, T>) -> T {
        let gamma = mu.0.1;
        if index == 0 { gamma.dot(&gamma) } else { T::zero() }
    }
}

impl Casimirs for SemidirectAlgebra<SU2OnC2> {
    const COUNT: usize = 1;

    /// Returns the Casimir ‖α‖² of (μ, α) ∈ su(2)∗ × (C²)∗, since SU(2) is transitive on the spheres of C².
    #[cfg_attr(optimised, inline(always))]
    fn casimir<T: Real>(&self, index: usize, mu: &Momentum<Self, T>) -> T {
        let alpha = mu.0.1;
        if index == 0 { alpha.pairing(&Covector(alpha)) } else { T::zero() }
    }
}

impl Casimirs for Sl2 {
    const COUNT: usize = 1;

    /// Returns the Casimir ¼α² + βγ of μ = (α, β, γ).
    ///
    /// It is −det of the matrix that represents μ by the trace form ⟨μ, ξ⟩ = tr(mξ). It is negative on the
    /// elliptic orbits and positive on the hyperbolic ones.
    #[cfg_attr(optimised, inline(always))]
    fn casimir<T: Real>(&self, index: usize, mu: &Momentum<Self, T>) -> T {
        let m = mu.0;
        if index == 0 { m.x * m.x * 0.25 + m.y * m.z } else { T::zero() }
    }
}

impl Casimirs for So2 {
    const COUNT: usize = 1;

    /// Returns the momentum itself, since the algebra is abelian.
    #[cfg_attr(optimised, inline(always))]
    fn casimir<T: Real>(&self, index: usize, mu: &Momentum<Self, T>) -> T {
        mu.coordinate(index)
    }
}

impl<const N: usize> Casimirs for RealSpace<N> {
    const COUNT: usize = N;

    /// Returns the coordinate with the given index, since the algebra is abelian.
    #[cfg_attr(optimised, inline(always))]
    fn casimir<T: Real>(&self, index: usize, mu: &Momentum<Self, T>) -> T {
        mu.coordinate(index)
    }
}

impl<const N: usize> Casimirs for UnitaryAlgebra<N> {
    const COUNT: usize = N;

    /// Returns the Casimir with the given index among tr H, tr H², …, tr Hᴺ of the Hermitian matrix H of μ.
    fn casimir<T: Real>(&self, index: usize, mu: &Momentum<Self, T>) -> T {
        let h = self.hermitian(mu);
        let one = SMatrix::<Complex<T>, N, N>::identity();
        let power = (0..=index.min(N)).fold(one, |power, _| power * h);
        if index < N { power.trace().re } else { T::zero() }
    }
}

impl<A: Casimirs, B: Casimirs> Casimirs for ProductAlgebra<A, B> {
    const COUNT: usize = A::COUNT + B::COUNT;

    /// Returns the Casimir with the given index. The Casimirs of the first factor come first, then those of the
    /// second.
    #[cfg_attr(optimised, inline(always))]
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

    /// Returns the Casimir with the given index. The Casimirs of the first factor come first, then those of the
    /// second, and so on.
    #[cfg_attr(optimised, inline(always))]
    fn casimir<T: Real>(&self, index: usize, mu: &Momentum<Self, T>) -> T {
        let count = A::COUNT.max(1);
        let factor = mu.0.0.get(index / count);
        factor.map_or_else(T::zero, |factor| self.0.casimir::<T>(index % count, &Covector(*factor)))
    }
}
