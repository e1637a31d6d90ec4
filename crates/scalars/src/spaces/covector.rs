//! Elements of the dual space, as a separate type: [`Covector`].

use crate::numbers::real::Real;
use crate::spaces::state::State;
use crate::spaces::vector::Vector;
use core::ops::{Add, AddAssign, Neg, Sub, SubAssign};

/// An element of the dual space V∗, stored by its coordinates in the dual basis.
///
/// A momentum in 𝔤∗ is a `Covector` of the element type of the algebra. It cannot be confused with a
/// velocity in 𝔤, though both may hold three numbers. Pattern matching gives access to the coordinates:
///
/// ```
/// use generic_scalars::Covector;
/// use nalgebra::Vector3;
/// let momentum = Covector(Vector3::new(1.0, 0.0, 0.0));
/// let Covector(coordinates) = momentum;
/// assert_eq!(coordinates.x, 1.0);
/// ```
/// ```compile_fail
/// use generic_scalars::Covector;
/// use nalgebra::Vector3;
/// let velocity = Vector3::new(1.0, 0.0, 0.0);
/// let _ = velocity + Covector(velocity); // 𝔤 + 𝔤* has no meaning
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(transparent)]
pub struct Covector<V>(pub V);

impl<V: State> State for Covector<V> {
    type Scalar = V::Scalar;
    type Blocks = V::Blocks;
    type Shape = V::Shape;
    type Pool = V::Pool;

    #[cfg_attr(optimised, inline(always))]
    fn dimension(&self) -> usize {
        self.0.dimension()
    }

    #[cfg_attr(optimised, inline(always))]
    fn shape(&self) -> V::Shape {
        self.0.shape()
    }

    #[cfg_attr(optimised, inline(always))]
    fn zeros_of(shape: &V::Shape) -> Self {
        Self(V::zeros_of(shape))
    }

    #[cfg_attr(optimised, inline(always))]
    fn take(pool: &mut V::Pool, like: &Self) -> Self {
        Self(V::take(pool, &like.0))
    }

    #[cfg_attr(optimised, inline(always))]
    fn give(self, pool: &mut V::Pool) {
        self.0.give(pool);
    }

    #[cfg_attr(optimised, inline(always))]
    fn assign(&mut self, x: &Self) {
        self.0.assign(&x.0);
    }

    #[cfg_attr(optimised, inline(always))]
    fn move_from(&mut self, other: &mut Self) {
        self.0.move_from(&mut other.0);
    }

    #[cfg_attr(optimised, inline(always))]
    fn entry(&self, i: usize) -> V::Scalar {
        self.0.entry(i)
    }

    #[cfg_attr(optimised, inline(always))]
    fn set_entry(&mut self, i: usize, x: V::Scalar) {
        self.0.set_entry(i, x);
    }

    #[cfg_attr(optimised, inline(always))]
    fn block_of(&self, i: usize) -> usize {
        self.0.block_of(i)
    }

    #[cfg_attr(optimised, inline(always))]
    fn set_zero(&mut self) {
        self.0.set_zero();
    }

    #[cfg_attr(optimised, inline(always))]
    fn add_in_place(&mut self, x: &Self) {
        self.0.add_in_place(&x.0);
    }

    #[cfg_attr(optimised, inline(always))]
    fn subtract_in_place(&mut self, x: &Self) {
        self.0.subtract_in_place(&x.0);
    }

    #[cfg_attr(optimised, inline(always))]
    fn subtract_from(&mut self, x: &Self) {
        self.0.subtract_from(&x.0);
    }

    #[cfg_attr(optimised, inline(always))]
    fn scale_in_place(&mut self, s: V::Scalar) {
        self.0.scale_in_place(s);
    }

    #[cfg_attr(optimised, inline(always))]
    fn add_multiple(&mut self, s: V::Scalar, x: &Self) {
        self.0.add_multiple(s, &x.0);
    }

    #[cfg_attr(optimised, inline(always))]
    fn set_entries(&mut self, f: impl Fn(usize) -> V::Scalar) {
        self.0.set_entries(f);
    }

    #[cfg_attr(optimised, inline(always))]
    fn replace_where(&mut self, mask: <V::Scalar as Real>::Mask, x: &Self) {
        self.0.replace_where(mask, &x.0);
    }

    #[cfg_attr(optimised, inline(always))]
    fn measure(&self, largest: &mut V::Blocks, sum: &mut V::Scalar) {
        self.0.measure(largest, sum);
    }

    #[cfg_attr(optimised, inline(always))]
    fn measure_difference(&self, x: &Self, largest: &mut V::Blocks, sum: &mut V::Scalar) {
        self.0.measure_difference(&x.0, largest, sum);
    }

    #[cfg_attr(optimised, inline(always))]
    fn all_finite(&self) -> bool {
        self.0.all_finite()
    }
}

impl<V: Vector<Dual = Covector<V>>> Vector for Covector<V> {
    type Dual = V;
    const DIM: usize = V::DIM;

    #[cfg_attr(optimised, inline(always))]
    fn block(i: usize) -> usize {
        V::block(i)
    }

    #[cfg_attr(optimised, inline(always))]
    fn from_coordinates(f: impl FnMut(usize) -> V::Scalar) -> Self {
        Self(V::from_coordinates(f))
    }

    #[cfg_attr(optimised, inline(always))]
    fn coordinate(&self, i: usize) -> V::Scalar {
        self.0.coordinate(i)
    }

    #[cfg_attr(optimised, inline(always))]
    fn scaled(&self, s: V::Scalar) -> Self {
        Self(self.0.scaled(s))
    }
}

impl<V: Add<Output = V>> Add for Covector<V> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
    fn add(self, rhs: Self) -> Self {
        Self(self.0 + rhs.0)
    }
}

impl<V: Sub<Output = V>> Sub for Covector<V> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
    fn sub(self, rhs: Self) -> Self {
        Self(self.0 - rhs.0)
    }
}

impl<V: Neg<Output = V>> Neg for Covector<V> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<V: AddAssign> AddAssign for Covector<V> {
    #[cfg_attr(optimised, inline(always))]
    fn add_assign(&mut self, rhs: Self) {
        self.0 += rhs.0;
    }
}

impl<V: SubAssign> SubAssign for Covector<V> {
    #[cfg_attr(optimised, inline(always))]
    fn sub_assign(&mut self, rhs: Self) {
        self.0 -= rhs.0;
    }
}
