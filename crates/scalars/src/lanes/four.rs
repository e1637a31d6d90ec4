//! Four lanes that can be permuted, for one vector of R³ in one register.

use super::packed::Packed;
use super::registers::register::{Register, Two};
use super::{Baseline, Lanes};

/// Four SIMD [`Lanes`] that can be permuted, for a computation on *one* vector of R³.
///
/// The components of the vector are in the first three lanes.
///
/// Implemented by [`DefaultLanes`](super::DefaultLanes), and by the types that
/// [`dispatch_four`](super::dispatch_four()) hands to a [`FourLanesTask`](super::FourLanesTask).
///
/// # Example
/// Lane i of u×v is u[i+1] v[i+2] − u[i+2] v[i+1], with indices modulo 3:
/// ```
/// use generic_scalars::{DefaultLanes, FourLanes, Lanes};
/// fn cross<T: FourLanes>(u: T, v: T) -> T {
///     u.next().multiply_subtract(v.previous(), u.previous() * v.next())
/// }
/// let u = DefaultLanes::load(&[1.0, 2.0, 3.0, 0.0]);
/// let v = DefaultLanes::load(&[4.0, 5.0, 6.0, 0.0]);
/// assert_eq!([0, 1, 2, 3].map(|i| cross(u, v).lane(i)), [-3.0, 6.0, -3.0, 0.0]);
/// assert_eq!((u * v).sum().lane(1), 32.0);
/// ```
pub trait FourLanes: Lanes {
    /// Returns (x₁, x₂, x₀, x₃), the lanes rotated to the next component.
    #[must_use]
    fn next(self) -> Self;

    /// Returns (x₂, x₀, x₁, x₃), the lanes rotated to the previous component.
    #[must_use]
    fn previous(self) -> Self;

    /// Returns x₀ in every lane.
    #[must_use]
    fn first(self) -> Self;

    /// Returns (x₀ + x₁) + (x₂ + x₃) in every lane.
    #[must_use]
    fn sum(self) -> Self;
}

/// The permutations that a register must offer for [`FourLanes`].
pub trait Permuted: Register {
    /// Returns (x₁, x₂, x₀, x₃), the lanes rotated to the next component.
    fn next(a: Self) -> Self;
    /// Returns (x₂, x₀, x₁, x₃), the lanes rotated to the previous component.
    fn previous(a: Self) -> Self;
    /// Returns x₀ in every lane.
    fn first(a: Self) -> Self;
    /// Returns (x₁, x₀, x₃, x₂), with neighbouring lanes exchanged.
    fn neighbours(a: Self) -> Self;
    /// Returns (x₂, x₃, x₀, x₁), with the two halves exchanged.
    fn halves(a: Self) -> Self;
}

impl<R: Permuted> FourLanes for Packed<R> {
    #[cfg_attr(optimised, inline(always))]
    fn next(self) -> Self {
        Self(R::next(self.0))
    }

    #[cfg_attr(optimised, inline(always))]
    fn previous(self) -> Self {
        Self(R::previous(self.0))
    }

    #[cfg_attr(optimised, inline(always))]
    fn first(self) -> Self {
        Self(R::first(self.0))
    }

    #[cfg_attr(optimised, inline(always))]
    fn sum(self) -> Self {
        let pairs = R::add(self.0, R::neighbours(self.0));
        Self(R::add(pairs, R::halves(pairs)))
    }
}

impl Permuted for Two<Baseline> {
    #[cfg_attr(optimised, inline(always))]
    fn next(a: Self) -> Self {
        Self::from_lanes(&mut |i| Self::lane(a, [1, 2, 0, 3][i]))
    }

    #[cfg_attr(optimised, inline(always))]
    fn previous(a: Self) -> Self {
        Self::from_lanes(&mut |i| Self::lane(a, [2, 0, 1, 3][i]))
    }

    #[cfg_attr(optimised, inline(always))]
    fn first(a: Self) -> Self {
        Self::splat(Self::lane(a, 0))
    }

    #[cfg_attr(optimised, inline(always))]
    fn neighbours(a: Self) -> Self {
        Self::from_lanes(&mut |i| Self::lane(a, i ^ 1))
    }

    #[cfg_attr(optimised, inline(always))]
    fn halves(a: Self) -> Self {
        Self::from_lanes(&mut |i| Self::lane(a, i ^ 2))
    }
}
