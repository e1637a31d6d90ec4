//! Direct sums V ⊕ W of two vector spaces.

use crate::numbers::real::Real;
use crate::spaces::covector::Covector;
use crate::spaces::state::State;
use crate::spaces::vector::Vector;
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
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Pair<A, B>(pub A, pub B);

impl<A, B> Covector<Pair<A, B>> {
    /// Creates the covector (α, β) from its two parts, for example the momentum (Π, Γ) of a heavy top.
    #[cfg_attr(optimised, inline(always))]
    pub const fn new(alpha: A, beta: B) -> Self {
        Self(Pair(alpha, beta))
    }
}

impl<T: Real, A: State<Scalar = T>, B: State<Scalar = T>> State for Pair<A, B> {
    type Scalar = T;
    type Blocks = (A::Blocks, B::Blocks);
    type Shape = (A::Shape, B::Shape);
    type Pool = (A::Pool, B::Pool);

    #[cfg_attr(optimised, inline(always))]
    fn dimension(&self) -> usize {
        self.0.dimension() + self.1.dimension()
    }

    #[cfg_attr(optimised, inline(always))]
    fn shape(&self) -> Self::Shape {
        (self.0.shape(), self.1.shape())
    }

    #[cfg_attr(optimised, inline(always))]
    fn zeros_of((a, b): &Self::Shape) -> Self {
        Self(A::zeros_of(a), B::zeros_of(b))
    }

    #[cfg_attr(optimised, inline(always))]
    fn take(pool: &mut Self::Pool, like: &Self) -> Self {
        Self(A::take(&mut pool.0, &like.0), B::take(&mut pool.1, &like.1))
    }

    #[cfg_attr(optimised, inline(always))]
    fn give(self, pool: &mut Self::Pool) {
        self.0.give(&mut pool.0);
        self.1.give(&mut pool.1);
    }

    #[cfg_attr(optimised, inline(always))]
    fn assign(&mut self, x: &Self) {
        self.0.assign(&x.0);
        self.1.assign(&x.1);
    }

    #[cfg_attr(optimised, inline(always))]
    fn move_from(&mut self, other: &mut Self) {
        self.0.move_from(&mut other.0);
        self.1.move_from(&mut other.1);
    }

    #[cfg_attr(optimised, inline(always))]
    fn entry(&self, i: usize) -> T {
        let first = self.0.dimension();
        if i < first { self.0.entry(i) } else { self.1.entry(i - first) }
    }

    #[cfg_attr(optimised, inline(always))]
    fn set_entry(&mut self, i: usize, x: T) {
        let first = self.0.dimension();
        if i < first { self.0.set_entry(i, x) } else { self.1.set_entry(i - first, x) }
    }

    /// Returns the block of a coordinate: the blocks of v come first, then those of w.
    #[cfg_attr(optimised, inline(always))]
    fn block_of(&self, i: usize) -> usize {
        let first = self.0.dimension();
        if i < first { self.0.block_of(i) } else { A::BLOCKS + self.1.block_of(i - first) }
    }

    #[cfg_attr(optimised, inline(always))]
    fn set_zero(&mut self) {
        self.0.set_zero();
        self.1.set_zero();
    }

    #[cfg_attr(optimised, inline(always))]
    fn add_in_place(&mut self, x: &Self) {
        self.0.add_in_place(&x.0);
        self.1.add_in_place(&x.1);
    }

    #[cfg_attr(optimised, inline(always))]
    fn subtract_in_place(&mut self, x: &Self) {
        self.0.subtract_in_place(&x.0);
        self.1.subtract_in_place(&x.1);
    }

    #[cfg_attr(optimised, inline(always))]
    fn subtract_from(&mut self, x: &Self) {
        self.0.subtract_from(&x.0);
        self.1.subtract_from(&x.1);
    }

    #[cfg_attr(optimised, inline(always))]
    fn scale_in_place(&mut self, s: T) {
        self.0.scale_in_place(s);
        self.1.scale_in_place(s);
    }

    #[cfg_attr(optimised, inline(always))]
    fn add_multiple(&mut self, s: T, x: &Self) {
        self.0.add_multiple(s, &x.0);
        self.1.add_multiple(s, &x.1);
    }

    #[cfg_attr(optimised, inline(always))]
    fn set_entries(&mut self, f: impl Fn(usize) -> T) {
        let first = self.0.dimension();
        self.0.set_entries(&f);
        self.1.set_entries(
            #[cfg_attr(optimised, inline(always))]
            |i| f(first + i),
        );
    }

    #[cfg_attr(optimised, inline(always))]
    fn replace_where(&mut self, mask: T::Mask, x: &Self) {
        self.0.replace_where(mask, &x.0);
        self.1.replace_where(mask, &x.1);
    }

    #[cfg_attr(optimised, inline(always))]
    fn measure(&self, largest: &mut Self::Blocks, sum: &mut T) {
        self.0.measure(&mut largest.0, sum);
        self.1.measure(&mut largest.1, sum);
    }

    #[cfg_attr(optimised, inline(always))]
    fn measure_difference(&self, x: &Self, largest: &mut Self::Blocks, sum: &mut T) {
        self.0.measure_difference(&x.0, &mut largest.0, sum);
        self.1.measure_difference(&x.1, &mut largest.1, sum);
    }

    #[cfg_attr(optimised, inline(always))]
    fn all_finite(&self) -> bool {
        self.0.all_finite() && self.1.all_finite()
    }
}

impl<T: Real, A: Vector<Scalar = T>, B: Vector<Scalar = T>> Vector for Pair<A, B> {
    type Dual = Covector<Self>;
    const DIM: usize = A::DIM + B::DIM;

    /// Returns the block of a coordinate: the blocks of v come first, then those of w.
    #[cfg_attr(optimised, inline(always))]
    fn block(i: usize) -> usize {
        if i < A::DIM { A::block(i) } else { A::BLOCKS + B::block(i - A::DIM) }
    }

    #[allow(clippy::redundant_closure)] // `&mut f` would be called, and this closure is inlined.
    #[cfg_attr(optimised, inline(always))]
    fn from_coordinates(mut f: impl FnMut(usize) -> T) -> Self {
        let first = A::from_coordinates(
            #[cfg_attr(optimised, inline(always))]
            |i| f(i),
        );
        let second = B::from_coordinates(
            #[cfg_attr(optimised, inline(always))]
            |i| f(A::DIM + i),
        );
        Self(first, second)
    }

    #[cfg_attr(optimised, inline(always))]
    fn coordinate(&self, i: usize) -> T {
        if i < A::DIM { self.0.coordinate(i) } else { self.1.coordinate(i - A::DIM) }
    }

    #[cfg_attr(optimised, inline(always))]
    fn scaled(&self, s: T) -> Self {
        Self(self.0.scaled(s), self.1.scaled(s))
    }
}

impl<A: Add<Output = A>, B: Add<Output = B>> Add for Pair<A, B> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
    fn add(self, rhs: Self) -> Self {
        Self(self.0 + rhs.0, self.1 + rhs.1)
    }
}

impl<A: Sub<Output = A>, B: Sub<Output = B>> Sub for Pair<A, B> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
    fn sub(self, rhs: Self) -> Self {
        Self(self.0 - rhs.0, self.1 - rhs.1)
    }
}

impl<A: Neg<Output = A>, B: Neg<Output = B>> Neg for Pair<A, B> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

impl<A: AddAssign, B: AddAssign> AddAssign for Pair<A, B> {
    #[cfg_attr(optimised, inline(always))]
    fn add_assign(&mut self, rhs: Self) {
        self.0 += rhs.0;
        self.1 += rhs.1;
    }
}

impl<A: SubAssign, B: SubAssign> SubAssign for Pair<A, B> {
    #[cfg_attr(optimised, inline(always))]
    fn sub_assign(&mut self, rhs: Self) {
        self.0 -= rhs.0;
        self.1 -= rhs.1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Vector1, Vector2};

    #[test]
    fn blocks_are_numbered_from_the_left() {
        type First = Pair<Vector2<f64>, Vector1<f64>>;
        type Second = Pair<Vector1<f64>, Pair<Vector2<f64>, Vector1<f64>>>;
        type Both = Pair<First, Second>;
        let expected = [0, 0, 1, 2, 3, 3, 4];
        let point = Both::from_coordinates(|i| i as f64);
        for (i, block) in expected.into_iter().enumerate() {
            assert_eq!((Both::block(i), point.block_of(i)), (block, block), "{i}");
        }
        assert_eq!((Both::BLOCKS, Both::DIM), (5, expected.len()));
    }
}
