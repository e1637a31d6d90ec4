//! Vectors of R³ in one register, and their form in memory.

use super::components::TopState;
use super::register_vector::RegisterVector;
use lie_poisson::{FourLanes, Real, Se3Dual};
use nalgebra::Vector3;

/// A vector of R³ in one register, as (v₀, v₁, v₂, 0) in its four SIMD lanes; a scalar is the same in all
/// four.
///
/// The last lane stays 0 unless a scalar is not finite, and is never read.
#[derive(Clone, Copy)]
pub(super) struct InRegister<T>(T);

/// A vector of R³ in memory, in the form that is loaded and stored at once.
pub(super) type Stored = [f64; 4];

impl<T: FourLanes> InRegister<T> {
    /// Loads a vector from memory.
    #[cfg_attr(optimised, inline(always))]
    pub fn load(v: &Stored) -> Self {
        Self(T::load(v))
    }

    /// Stores the vector in memory.
    #[cfg_attr(optimised, inline(always))]
    pub fn store(self, v: &mut Stored) {
        self.0.store(v);
    }
}

impl<T: FourLanes> RegisterVector for InRegister<T> {
    type Scalar = T;

    #[cfg_attr(optimised, inline(always))]
    fn uniform(x: T) -> Self {
        Self(x)
    }
    #[cfg_attr(optimised, inline(always))]
    fn next(self) -> Self {
        Self(self.0.next())
    }
    #[cfg_attr(optimised, inline(always))]
    fn previous(self) -> Self {
        Self(self.0.previous())
    }
    #[cfg_attr(optimised, inline(always))]
    fn times(self, v: Self) -> Self {
        Self(self.0 * v.0)
    }
    #[cfg_attr(optimised, inline(always))]
    fn plus(self, v: Self) -> Self {
        Self(self.0 + v.0)
    }
    #[cfg_attr(optimised, inline(always))]
    fn minus(self, v: Self) -> Self {
        Self(self.0 - v.0)
    }
    #[cfg_attr(optimised, inline(always))]
    fn multiply_add(self, v: Self, x: Self) -> Self {
        Self(self.0.multiply_add(v.0, x.0))
    }
    #[cfg_attr(optimised, inline(always))]
    fn multiply_subtract(self, v: Self, x: Self) -> Self {
        Self(self.0.multiply_subtract(v.0, x.0))
    }
    #[cfg_attr(optimised, inline(always))]
    fn negative_multiply_add(self, v: Self, x: Self) -> Self {
        Self(self.0.negative_multiply_add(v.0, x.0))
    }
    #[cfg_attr(optimised, inline(always))]
    fn select(mask: <T as Real>::Mask, yes: Self, no: Self) -> Self {
        Self(T::select(mask, yes.0, no.0))
    }
    #[cfg_attr(optimised, inline(always))]
    fn dot(self, v: Self) -> T {
        let last = self.previous().times(v.previous());
        self.multiply_add(v, self.next().multiply_add(v.next(), last)).0.first()
    }
    #[cfg_attr(optimised, inline(always))]
    fn sum(self) -> T {
        self.0.sum()
    }
}

/// Returns the vector that is stored.
pub(super) fn vector(v: &Stored) -> Vector3<f64> {
    Vector3::new(v[0], v[1], v[2])
}

impl TopState<Stored> {
    /// Creates the stored form of (Π, Γ).
    #[inline]
    pub fn of(mu: &Se3Dual) -> Self {
        let stored = |v: &Vector3<f64>| [v.x, v.y, v.z, 0.0];
        Self { momentum: stored(&mu.0.0), vertical: stored(&mu.0.1) }
    }

    /// Returns the six components of (Π, Γ).
    #[inline]
    pub fn numbers(&self) -> [f64; 6] {
        let ([x, y, z, _], [u, v, w, _]) = (self.momentum, self.vertical);
        [x, y, z, u, v, w]
    }

    /// Returns the point (Π, Γ) that is stored.
    #[inline]
    pub fn point(&self) -> Se3Dual {
        Se3Dual::new(vector(&self.momentum), vector(&self.vertical))
    }
}
