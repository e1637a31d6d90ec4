//! Direct sums V ⊕ W of two vector spaces.

use crate::{Covector, Real, Vector};
use core::ops::{Add, AddAssign, Neg, Sub, SubAssign};

/// An element (v, w) of a direct sum V ⊕ W; the coordinates of v come first.
///
/// Elements (ξ, φ) ∈ 𝔤 ⋉ V of semidirect products, elements of direct products, and elements of the
/// corresponding groups are pairs.
///
/// ```
/// use generic_scalars::Pair;
/// use nalgebra::{Vector2, Vector3};
/// let Pair(angular, linear) = Pair(Vector3::new(1.0, 0.0, 0.0), Vector2::new(0.0, 1.0));
/// assert_eq!(angular.x, linear.y);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair<A, B>(pub A, pub B);

impl<A, B> Covector<Pair<A, B>> {
    /// Creates the covector (α, β) from its two parts, for example the momentum (Π, Γ) of a heavy top.
    #[inline]
    pub const fn new(alpha: A, beta: B) -> Self {
        Self(Pair(alpha, beta))
    }
}

impl<T: Real, A: Vector<Scalar = T>, B: Vector<Scalar = T>> Vector for Pair<A, B> {
    type Scalar = T;
    type Dual = Covector<Self>;
    type Blocks = (A::Blocks, B::Blocks);
    const DIM: usize = A::DIM + B::DIM;

    /// Returns the block of a coordinate: the blocks of v come first, then those of w.
    #[inline(always)]
    fn block(i: usize) -> usize {
        if i < A::DIM { A::block(i) } else { A::BLOCKS + B::block(i - A::DIM) }
    }

    #[inline]
    fn from_coordinates(mut f: impl FnMut(usize) -> T) -> Self {
        let first = A::from_coordinates(&mut f);
        Self(first, B::from_coordinates(|i| f(A::DIM + i)))
    }

    #[inline]
    fn coordinate(&self, i: usize) -> T {
        if i < A::DIM { self.0.coordinate(i) } else { self.1.coordinate(i - A::DIM) }
    }

    #[inline]
    fn scaled(&self, s: T) -> Self {
        Self(self.0.scaled(s), self.1.scaled(s))
    }
}

impl<A: Add<Output = A>, B: Add<Output = B>> Add for Pair<A, B> {
    type Output = Self;
    #[inline]
    fn add(self, rhs: Self) -> Self {
        Self(self.0 + rhs.0, self.1 + rhs.1)
    }
}

impl<A: Sub<Output = A>, B: Sub<Output = B>> Sub for Pair<A, B> {
    type Output = Self;
    #[inline]
    fn sub(self, rhs: Self) -> Self {
        Self(self.0 - rhs.0, self.1 - rhs.1)
    }
}

impl<A: Neg<Output = A>, B: Neg<Output = B>> Neg for Pair<A, B> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

impl<A: AddAssign, B: AddAssign> AddAssign for Pair<A, B> {
    #[inline]
    fn add_assign(&mut self, rhs: Self) {
        self.0 += rhs.0;
        self.1 += rhs.1;
    }
}

impl<A: SubAssign, B: SubAssign> SubAssign for Pair<A, B> {
    #[inline]
    fn sub_assign(&mut self, rhs: Self) {
        self.0 -= rhs.0;
        self.1 -= rhs.1;
    }
}
