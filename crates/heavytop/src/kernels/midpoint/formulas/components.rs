//! Vectors of R³ as three components, with everything inlined into the function that has the processor's
//! features.

use super::register_vector::{MaskOf, RegisterVector};
use lie_poisson::{Lanes, Real, Se3Dual};
use nalgebra::Vector3;

/// Evaluates an expression for each component i. (A closure would not be inlined.)
macro_rules! each {
    ($i:ident => $component:expr) => {
        [
            {
                let $i = 0;
                $component
            },
            {
                let $i = 1;
                $component
            },
            {
                let $i = 2;
                $component
            },
        ]
    };
}
pub(super) use each;

/// A vector of R³ in each SIMD lane, as three components.
pub(super) type Components<T> = [T; 3];

impl<T: Lanes> RegisterVector for Components<T> {
    type Scalar = T;

    #[cfg_attr(optimised, inline(always))]
    fn uniform(x: T) -> Self {
        [x; 3]
    }
    #[cfg_attr(optimised, inline(always))]
    fn next(self) -> Self {
        [self[1], self[2], self[0]]
    }
    #[cfg_attr(optimised, inline(always))]
    fn previous(self) -> Self {
        [self[2], self[0], self[1]]
    }
    #[cfg_attr(optimised, inline(always))]
    fn times(self, v: Self) -> Self {
        each!(i => self[i] * v[i])
    }
    #[cfg_attr(optimised, inline(always))]
    fn plus(self, v: Self) -> Self {
        each!(i => self[i] + v[i])
    }
    #[cfg_attr(optimised, inline(always))]
    fn minus(self, v: Self) -> Self {
        each!(i => self[i] - v[i])
    }
    #[cfg_attr(optimised, inline(always))]
    fn multiply_add(self, v: Self, x: Self) -> Self {
        each!(i => self[i].multiply_add(v[i], x[i]))
    }
    #[cfg_attr(optimised, inline(always))]
    fn multiply_subtract(self, v: Self, x: Self) -> Self {
        each!(i => self[i].multiply_subtract(v[i], x[i]))
    }
    #[cfg_attr(optimised, inline(always))]
    fn negative_multiply_add(self, v: Self, x: Self) -> Self {
        each!(i => self[i].negative_multiply_add(v[i], x[i]))
    }
    #[cfg_attr(optimised, inline(always))]
    fn select(mask: <T as Real>::Mask, yes: Self, no: Self) -> Self {
        each!(i => T::select(mask, yes[i], no[i]))
    }
    #[cfg_attr(optimised, inline(always))]
    fn dot(self, v: Self) -> T {
        self[0].multiply_add(v[0], self[1].multiply_add(v[1], self[2] * v[2]))
    }
    #[cfg_attr(optimised, inline(always))]
    fn sum(self) -> T {
        self[0] + self[1] + self[2]
    }
}

/// The state (Π, Γ) of a top, as two vectors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TopState<V> {
    pub momentum: V,
    pub vertical: V,
}

impl<V: RegisterVector> TopState<V> {
    /// Returns where all components are finite, and Π·Γ too.
    #[cfg_attr(optimised, inline(always))]
    pub fn is_finite(&self) -> MaskOf<V> {
        // A component that is not finite leaves a sum that is not, even beside zeros. Its product with 0 is NaN.
        let zero = V::Scalar::from_f64(0.0);
        (self.momentum.times(self.vertical).sum() * zero).at_most(zero)
    }
}

impl<T: Lanes> TopState<Components<T>> {
    /// Gathers states into lanes: lane i is `state(i)`.
    #[cfg_attr(optimised, inline(always))]
    pub fn gather(state: impl Fn(usize) -> Se3Dual) -> Self {
        Self {
            momentum: each!(k => T::from_lanes(|i| state(i).0.0[k])),
            vertical: each!(k => T::from_lanes(|i| state(i).0.1[k])),
        }
    }

    /// Returns the state in lane `i`.
    #[cfg_attr(optimised, inline(always))]
    pub fn lane(&self, i: usize) -> Se3Dual {
        let vector = |v: &Components<T>| Vector3::new(v[0].lane(i), v[1].lane(i), v[2].lane(i));
        Se3Dual::new(vector(&self.momentum), vector(&self.vertical))
    }
}
