//! Powers Vᴺ of a vector space.

use crate::spaces::covector::Covector;
use crate::spaces::vector::Vector;
use crate::state_by_value;
use core::ops::{Add, AddAssign, Neg, Sub, SubAssign};

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

state_by_value!([V: Vector, const N: usize] Power<V, N>, V::Scalar, V::Blocks);

impl<V: Vector, const N: usize> Vector for Power<V, N> {
    type Dual = Covector<Self>;
    const DIM: usize = N * V::DIM;

    /// Returns the block of a coordinate within its factor: all factors share their blocks.
    #[cfg_attr(optimised, inline(always))]
    fn block(i: usize) -> usize {
        if V::BLOCKS == 1 { 0 } else { V::block(i % V::DIM.max(1)) }
    }

    #[cfg_attr(optimised, inline(always))]
    fn from_coordinates(mut f: impl FnMut(usize) -> V::Scalar) -> Self {
        Self::from_factors(|n| V::from_coordinates(|i| f(n * V::DIM + i)))
    }

    #[cfg_attr(optimised, inline(always))]
    fn coordinate(&self, i: usize) -> V::Scalar {
        // A factor of dimension 0 has no coordinates; the width 1 avoids a division by zero.
        let width = V::DIM.max(1);
        self.0.get(i / width).map_or_else(num_traits::zero, |v| v.coordinate(i % width))
    }

    #[cfg_attr(optimised, inline(always))]
    fn scaled(&self, s: V::Scalar) -> Self {
        Self::from_factors(|n| self.0[n].scaled(s))
    }
}

impl<V: Copy + Add<Output = V>, const N: usize> Add for Power<V, N> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
    fn add(mut self, rhs: Self) -> Self {
        for (v, w) in self.0.iter_mut().zip(&rhs.0) {
            *v = *v + *w;
        }
        self
    }
}

impl<V: Copy + Sub<Output = V>, const N: usize> Sub for Power<V, N> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
    fn sub(mut self, rhs: Self) -> Self {
        for (v, w) in self.0.iter_mut().zip(&rhs.0) {
            *v = *v - *w;
        }
        self
    }
}

impl<V: Copy + Neg<Output = V>, const N: usize> Neg for Power<V, N> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
    fn neg(mut self) -> Self {
        for v in &mut self.0 {
            *v = -*v;
        }
        self
    }
}

impl<V: Copy + AddAssign, const N: usize> AddAssign for Power<V, N> {
    #[cfg_attr(optimised, inline(always))]
    fn add_assign(&mut self, rhs: Self) {
        for (v, w) in self.0.iter_mut().zip(&rhs.0) {
            *v += *w;
        }
    }
}

impl<V: Copy + SubAssign, const N: usize> SubAssign for Power<V, N> {
    #[cfg_attr(optimised, inline(always))]
    fn sub_assign(&mut self, rhs: Self) {
        for (v, w) in self.0.iter_mut().zip(&rhs.0) {
            *v -= *w;
        }
    }
}
