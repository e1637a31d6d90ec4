//! Powers Vᴺ of a vector space.

use crate::numbers::real::Real;
use crate::spaces::covector::Covector;
use crate::spaces::sites::operations_by_sites;
use crate::spaces::state::State;
use crate::spaces::vector::Vector;
use crate::vector_operators;

/// An element (v₁, …, v_N) of the power Vᴺ, for example the state of N spins or of N vortices.
///
/// ```
/// use generic_scalars::{Power, Vector};
/// use nalgebra::Vector3;
/// let spins = Power([Vector3::new(0.0, 0.0, 1.0); 10]);
/// assert_eq!(spins.0.iter().sum::<Vector3<f64>>().z, 10.0);
/// assert_eq!(spins.max_abs(), 1.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub struct Power<V, const N: usize>(pub [V; N]);

impl<V: Vector, const N: usize> Power<V, N> {
    /// Creates (f(0), …, f(N − 1)).
    ///
    /// The factors of a small power stay in registers. [`core::array::from_fn`] and the `map` of arrays copy them
    /// through memory.
    #[cfg_attr(optimised, inline(always))]
    pub fn from_factors(mut f: impl FnMut(usize) -> V) -> Self {
        let mut factors = [V::zero(); N];
        for (n, factor) in factors.iter_mut().enumerate() {
            *factor = f(n);
        }
        Self(factors)
    }
}

impl<V: Vector, const N: usize> State for Power<V, N> {
    type Scalar = V::Scalar;
    type Blocks = V::Blocks;
    type Shape = ();
    type Pool = ();

    #[cfg_attr(optimised, inline(always))]
    fn dimension(&self) -> usize {
        Self::DIM
    }

    #[cfg_attr(optimised, inline(always))]
    fn shape(&self) {}

    #[cfg_attr(optimised, inline(always))]
    fn zeros_of((): &()) -> Self {
        Self([V::zero(); N])
    }

    #[cfg_attr(optimised, inline(always))]
    fn assign(&mut self, x: &Self) {
        *self = *x;
    }

    #[cfg_attr(optimised, inline(always))]
    fn move_from(&mut self, other: &mut Self) {
        *self = *other;
    }

    operations_by_sites!(cfg_attr(optimised, inline(always)));
}

vector_operators!([V: Vector, const N: usize] Power<V, N>);

impl<V: Vector, const N: usize> Vector for Power<V, N> {
    type Dual = Covector<Self>;
    const DIM: usize = N * V::DIM;

    #[cfg_attr(optimised, inline(always))]
    fn from_coordinates(mut f: impl FnMut(usize) -> V::Scalar) -> Self {
        Self::from_factors(|n| V::from_coordinates(|i| f(n * V::DIM + i)))
    }
}
