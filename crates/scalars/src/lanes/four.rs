//! Four lanes whose numbers can change places: a vector of R³ in one register.

use super::packed::Packed;
use super::registers::register::{Register, Two};
use super::{Baseline, Lanes};

/// Four [`Lanes`] that can exchange what they hold, for a computation on *one* vector of R³, with
/// its components in the first three lanes.
///
/// Implemented by [`DefaultLanes`](super::DefaultLanes), and by the types that
/// [`dispatch_four`](super::dispatch_four()) hands to a [`FourLanesTask`](super::FourLanesTask).
///
/// # Example
/// Lane i of u×v is `u_{i+1} v_{i+2} − u_{i+2} v_{i+1}`, with indices modulo 3:
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
    /// (x₁, x₂, x₀, x₃)
    #[must_use]
    fn next(self) -> Self;

    /// (x₂, x₀, x₁, x₃)
    #[must_use]
    fn previous(self) -> Self;

    /// x₀ in every lane
    #[must_use]
    fn first(self) -> Self;

    /// (x₀ + x₁) + (x₂ + x₃) in every lane
    #[must_use]
    fn sum(self) -> Self;
}

/// What [`FourLanes`] asks of a register.
pub trait Permuted: Register {
    /// (x₁, x₂, x₀, x₃)
    fn next(a: Self) -> Self;
    /// (x₂, x₀, x₁, x₃)
    fn previous(a: Self) -> Self;
    /// x₀ in every lane.
    fn first(a: Self) -> Self;
    /// (x₁, x₀, x₃, x₂)
    fn neighbours(a: Self) -> Self;
    /// (x₂, x₃, x₀, x₁)
    fn halves(a: Self) -> Self;
}

impl<R: Permuted> FourLanes for Packed<R> {
    #[inline(always)]
    fn next(self) -> Self {
        Self(R::next(self.0))
    }

    #[inline(always)]
    fn previous(self) -> Self {
        Self(R::previous(self.0))
    }

    #[inline(always)]
    fn first(self) -> Self {
        Self(R::first(self.0))
    }

    #[inline(always)]
    fn sum(self) -> Self {
        let pairs = R::add(self.0, R::neighbours(self.0));
        Self(R::add(pairs, R::halves(pairs)))
    }
}

impl Permuted for Two<Baseline> {
    #[inline(always)]
    fn next(a: Self) -> Self {
        Self::from_lanes(&mut |i| Self::lane(a, [1, 2, 0, 3][i]))
    }

    #[inline(always)]
    fn previous(a: Self) -> Self {
        Self::from_lanes(&mut |i| Self::lane(a, [2, 0, 1, 3][i]))
    }

    #[inline(always)]
    fn first(a: Self) -> Self {
        Self::splat(Self::lane(a, 0))
    }

    #[inline(always)]
    fn neighbours(a: Self) -> Self {
        Self::from_lanes(&mut |i| Self::lane(a, i ^ 1))
    }

    #[inline(always)]
    fn halves(a: Self) -> Self {
        Self::from_lanes(&mut |i| Self::lane(a, i ^ 2))
    }
}
