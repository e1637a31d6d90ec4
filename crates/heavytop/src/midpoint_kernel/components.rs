//! Vectors of R³ as three components, with everything inlined into the function that has the
//! processor's features.

use lie_poisson::{Lanes, Se3Dual};
use nalgebra::Vector3;

/// An expression for each component i. (A closure would not be inlined.)
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

/// A vector of R³ in each lane.
pub(super) type Components<T> = [T; 3];

/// (Π, Γ)
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct State<T> {
    pub momentum: Components<T>,
    pub vertical: Components<T>,
}

impl<T: Lanes> State<T> {
    /// Lane i is `state(i)`.
    #[inline(always)]
    pub fn gather(state: impl Fn(usize) -> Se3Dual) -> Self {
        Self {
            momentum: each!(k => T::from_lanes(|i| state(i).0.0[k])),
            vertical: each!(k => T::from_lanes(|i| state(i).0.1[k])),
        }
    }

    /// The squares of all components.
    #[inline(always)]
    pub fn square(&self) -> T {
        dot(&self.momentum, &self.momentum) + dot(&self.vertical, &self.vertical)
    }

    /// What lane `i` holds.
    #[inline(always)]
    pub fn lane(&self, i: usize) -> Se3Dual {
        let vector = |v: &Components<T>| Vector3::new(v[0].lane(i), v[1].lane(i), v[2].lane(i));
        Se3Dual::new(vector(&self.momentum), vector(&self.vertical))
    }
}

impl State<f64> {
    /// The same in every lane.
    #[inline(always)]
    pub fn splat<T: Lanes>(&self) -> State<T> {
        State {
            momentum: each!(k => T::from_f64(self.momentum[k])),
            vertical: each!(k => T::from_f64(self.vertical[k])),
        }
    }
}

/// u·v
#[inline(always)]
pub(super) fn dot<T: Lanes>(u: &Components<T>, v: &Components<T>) -> T {
    u[0].multiply_add(v[0], u[1].multiply_add(v[1], u[2] * v[2]))
}

/// x + u×v
#[inline(always)]
pub(super) fn add_cross<T: Lanes>(
    x: &Components<T>,
    u: &Components<T>,
    v: &Components<T>,
) -> Components<T> {
    [
        u[1].multiply_add(v[2], u[2].negative_multiply_add(v[1], x[0])),
        u[2].multiply_add(v[0], u[0].negative_multiply_add(v[2], x[1])),
        u[0].multiply_add(v[1], u[1].negative_multiply_add(v[0], x[2])),
    ]
}
