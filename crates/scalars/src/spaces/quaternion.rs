//! Quaternions over any scalar: [`Quaternion`].

use crate::numbers::real::Real;
use crate::spaces::covector::Covector;
use crate::spaces::matrices::{cross, dot};
use crate::spaces::state::State;
use crate::spaces::vector::Vector;
use crate::vector_operators;
use core::ops::Mul;
use nalgebra::Vector3;

/// A quaternion s + v₁i + v₂j + v₃k ∈ H, with Hamilton's product ij = k.
///
/// Its coordinates are (s, v₁, v₂, v₃), and ⟨p, q⟩ = Re(conj(p) q). The quaternions of nalgebra require
/// more of their scalar than [`Real`] offers.
///
/// # Example
/// ```
/// use generic_scalars::{Quaternion, Real};
/// use nalgebra::Vector3;
/// let pure = |v| Quaternion { scalar: 0.0, vector: v };
/// let (u, v) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(-1.0, 0.5, 2.0));
/// // uv = −u·v + u×v
/// assert_eq!(pure(u) * pure(v), Quaternion { scalar: -u.dot(&v), vector: u.cross(&v) });
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "T: nalgebra::Scalar + serde::Serialize",
        deserialize = "T: nalgebra::Scalar + serde::Deserialize<'de>"
    ))
)]
pub struct Quaternion<T = f64> {
    /// The real part s.
    pub scalar: T,
    /// The imaginary part v.
    pub vector: Vector3<T>,
}

impl<T: Real> Quaternion<T> {
    /// Returns the quaternion 1.
    #[must_use]
    #[cfg_attr(optimised, inline(always))]
    pub fn one() -> Self {
        Self { scalar: T::one(), vector: Vector3::zeros() }
    }

    /// Returns the conjugate s − v.
    #[must_use]
    #[cfg_attr(optimised, inline(always))]
    pub fn conjugate(&self) -> Self {
        Self { scalar: self.scalar, vector: -self.vector }
    }

    /// Returns the square of the norm, |q|² = s² + |v|².
    #[cfg_attr(optimised, inline(always))]
    pub fn norm_squared(&self) -> T {
        self.scalar * self.scalar + dot(&self.vector, &self.vector)
    }

    /// Returns the product q v for imaginary v, that is −u·v + (s v + u×v) for q = s + u, without
    /// multiplying by zeros.
    ///
    /// ```
    /// use generic_scalars::Quaternion;
    /// use nalgebra::Vector3;
    /// let q = Quaternion { scalar: 2.0, vector: Vector3::new(1.0, 0.0, -1.0) };
    /// let v = Vector3::new(3.0, 1.0, 0.5);
    /// assert_eq!(q.times_imaginary(&v), q * Quaternion { scalar: 0.0, vector: v });
    /// ```
    #[must_use]
    #[cfg_attr(optimised, inline(always))]
    pub fn times_imaginary(&self, v: &Vector3<T>) -> Self {
        Self { scalar: -dot(&self.vector, v), vector: v * self.scalar + cross(&self.vector, v) }
    }

    /// Returns the product v q for imaginary v, that is −v·u + (s v + v×u) for q = s + u, without
    /// multiplying by zeros.
    ///
    /// ```
    /// use generic_scalars::Quaternion;
    /// use nalgebra::Vector3;
    /// let q = Quaternion { scalar: 2.0, vector: Vector3::new(1.0, 0.0, -1.0) };
    /// let v = Vector3::new(3.0, 1.0, 0.5);
    /// assert_eq!(Quaternion::imaginary_times(&v, &q), Quaternion { scalar: 0.0, vector: v } * q);
    /// ```
    #[must_use]
    #[cfg_attr(optimised, inline(always))]
    pub fn imaginary_times(v: &Vector3<T>, q: &Self) -> Self {
        Self { scalar: -dot(v, &q.vector), vector: v * q.scalar + cross(v, &q.vector) }
    }

    /// Returns the imaginary part t u − s w − u×w of p conj(q), for p = s + u and q = t + w.
    ///
    /// ```
    /// use generic_scalars::Quaternion;
    /// use nalgebra::Vector3;
    /// let p = Quaternion { scalar: 2.0, vector: Vector3::new(1.0, 0.0, -1.0) };
    /// let q = Quaternion { scalar: 0.5, vector: Vector3::new(3.0, 1.0, 0.5) };
    /// assert_eq!(p.imaginary_part_by_conjugate(&q), (p * q.conjugate()).vector);
    /// ```
    #[must_use]
    #[cfg_attr(optimised, inline(always))]
    pub fn imaginary_part_by_conjugate(&self, q: &Self) -> Vector3<T> {
        self.vector * q.scalar - q.vector * self.scalar - cross(&self.vector, &q.vector)
    }

    /// Returns the imaginary part of q v conj(q) for imaginary v, which is |q|² times a rotation of v.
    #[cfg_attr(optimised, inline(always))]
    pub fn sandwich(&self, v: &Vector3<T>) -> Vector3<T> {
        v * self.norm_squared() + self.twist(v)
    }

    /// Returns the rotation v + (2/|q|²)(s u×v + u×(u×v)) of v by q = s + u, for q ≠ 0 of any size.
    #[cfg_attr(optimised, inline(always))]
    pub fn rotate(&self, v: &Vector3<T>) -> Vector3<T> {
        v + self.twist(v) / self.norm_squared()
    }

    /// Returns the change (2/|q|²)(s u×v + u×(u×v)) of v under the rotation by q = s + u, for |q| near 1.
    ///
    /// The relative error is a few units of round-off. The formula uses d = |q|² − 1 = (s − 1)(s + 1) + |u|² instead
    /// of |q|²: rounding |q|² to a number next to 1 would give a biased error, since floating-point numbers lie twice
    /// as densely below 1 as above.
    #[cfg_attr(optimised, inline(always))]
    pub fn rotation_change(&self, v: &Vector3<T>) -> Vector3<T> {
        let excess = (self.scalar - 1.0) * (self.scalar + 1.0) + dot(&self.vector, &self.vector);
        let twist = self.twist(v);
        twist - twist * (excess / (excess + 1.0))
    }

    /// Returns the vector 2 (s u×v + u×(u×v)), which is |q|² times the change of v under the rotation.
    #[cfg_attr(optimised, inline(always))]
    fn twist(&self, v: &Vector3<T>) -> Vector3<T> {
        let turned = cross(&self.vector, v);
        let sum = turned * self.scalar + cross(&self.vector, &turned);
        sum + sum
    }
}

impl<T: Real> State for Quaternion<T> {
    type Scalar = T;
    type Blocks = (T,);
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
        Self::zero()
    }

    #[cfg_attr(optimised, inline(always))]
    fn coordinate(&self, i: usize) -> T {
        if i == 0 { self.scalar } else { self.vector.coordinate(i - 1) }
    }

    #[cfg_attr(optimised, inline(always))]
    fn set_coordinate(&mut self, i: usize, x: T) {
        if i == 0 { self.scalar = x } else { self.vector.set_coordinate(i - 1, x) }
    }

    #[cfg_attr(optimised, inline(always))]
    fn add_in_place(&mut self, x: &Self) {
        self.scalar += x.scalar;
        self.vector.add_in_place(&x.vector);
    }

    #[cfg_attr(optimised, inline(always))]
    fn subtract_in_place(&mut self, x: &Self) {
        self.scalar -= x.scalar;
        self.vector.subtract_in_place(&x.vector);
    }

    #[cfg_attr(optimised, inline(always))]
    fn negate_in_place(&mut self) {
        self.scalar = -self.scalar;
        self.vector.negate_in_place();
    }

    #[cfg_attr(optimised, inline(always))]
    fn scale_in_place(&mut self, s: T) {
        self.scalar *= s;
        self.vector.scale_in_place(s);
    }

    #[cfg_attr(optimised, inline(always))]
    fn add_multiple(&mut self, s: T, x: &Self) {
        self.scalar += x.scalar * s;
        self.vector.add_multiple(s, &x.vector);
    }
}

vector_operators!([T: Real] Quaternion<T>);

impl<T: Real> Vector for Quaternion<T> {
    type Dual = Covector<Self>;
    const DIM: usize = 4;

    #[cfg_attr(optimised, inline(always))]
    fn from_coordinates(mut f: impl FnMut(usize) -> T) -> Self {
        let scalar = f(0);
        Self { scalar, vector: Vector3::new(f(1), f(2), f(3)) }
    }
}

impl<T: Real> Mul for Quaternion<T> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
    fn mul(self, rhs: Self) -> Self {
        Self {
            scalar: self.scalar * rhs.scalar - dot(&self.vector, &rhs.vector),
            vector: rhs.vector * self.scalar
                + self.vector * rhs.scalar
                + cross(&self.vector, &rhs.vector),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_without_zeros_are_products() {
        let q = Quaternion { scalar: 0.5, vector: Vector3::new(1.0, -2.0, 0.25) };
        let p = Quaternion { scalar: -1.5, vector: Vector3::new(0.5, 4.0, -1.0) };
        let v = Vector3::new(3.0, 1.0, -1.0);
        let pure = Quaternion { scalar: 0.0, vector: v };
        // binary fractions: no rounding
        assert_eq!(q.times_imaginary(&v), q * pure);
        assert_eq!(Quaternion::imaginary_times(&v, &q), pure * q);
        assert_ne!(q.times_imaginary(&v), Quaternion::imaginary_times(&v, &q));
        assert_eq!(p.imaginary_part_by_conjugate(&q), (p * q.conjugate()).vector);
    }

    #[test]
    fn the_sandwich_is_a_product() {
        let q = Quaternion { scalar: 0.5, vector: Vector3::new(1.0, -2.0, 0.25) };
        let v = Vector3::new(3.0, 1.0, -1.0);
        let product = q * Quaternion { scalar: 0.0, vector: v } * q.conjugate();
        assert!((product.vector - q.sandwich(&v)).norm() < 1e-14 && product.scalar.abs() < 1e-14);
        assert!((q.sandwich(&v) - q.rotate(&v) * q.norm_squared()).norm() < 1e-14);
        assert!((v + q.rotation_change(&v) - q.rotate(&v)).norm() < 1e-14);
        assert!((q.sandwich(&v).norm() - q.norm_squared() * v.norm()).abs() < 1e-13);
    }
}
