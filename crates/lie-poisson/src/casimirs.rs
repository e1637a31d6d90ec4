//! Casimir functions.

use crate::{DualNumber, LieAlgebra, Momentum, Real, Se3, So3, Su2, differential};

/// The Casimirs of the Lie–Poisson bracket on 𝔤*: functions c with {c, f} = 0 for every f, so
/// that every Hamiltonian flow conserves them. They are the same for both signs.
///
/// In terms of ad*: ad*_{dc(μ)} μ = 0.
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
