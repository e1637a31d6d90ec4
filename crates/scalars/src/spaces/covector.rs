//! Elements of the dual space, as a type of their own: [`Covector`].

use crate::Vector;
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
#[repr(transparent)]
pub struct Covector<V>(pub V);

impl<V: Vector<Dual = Covector<V>>> Vector for Covector<V> {
    type Scalar = V::Scalar;
    type Dual = V;
    type Blocks = V::Blocks;
    const DIM: usize = V::DIM;

    #[inline(always)]
    fn block(i: usize) -> usize {
        V::block(i)
    }

    #[inline]
    fn from_coordinates(f: impl FnMut(usize) -> V::Scalar) -> Self {
        Self(V::from_coordinates(f))
    }

    #[inline]
    fn coordinate(&self, i: usize) -> V::Scalar {
        self.0.coordinate(i)
    }

    #[inline]
    fn scaled(&self, s: V::Scalar) -> Self {
        Self(self.0.scaled(s))
    }
}

impl<V: Add<Output = V>> Add for Covector<V> {
    type Output = Self;
    #[inline]
    fn add(self, rhs: Self) -> Self {
        Self(self.0 + rhs.0)
    }
}

impl<V: Sub<Output = V>> Sub for Covector<V> {
    type Output = Self;
    #[inline]
    fn sub(self, rhs: Self) -> Self {
        Self(self.0 - rhs.0)
    }
}

impl<V: Neg<Output = V>> Neg for Covector<V> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<V: AddAssign> AddAssign for Covector<V> {
    #[inline]
    fn add_assign(&mut self, rhs: Self) {
        self.0 += rhs.0;
    }
}

impl<V: SubAssign> SubAssign for Covector<V> {
    #[inline]
    fn sub_assign(&mut self, rhs: Self) {
        self.0 -= rhs.0;
    }
}
