//! Vectors of R³ as the kernel computes with them.

use lie_poisson::{Lanes, Real};

/// A vector of R³ in the processor: three components in lanes of their own ([`Components`](super::components::Components)),
/// or all three in one register ([`InRegister`](super::in_register::InRegister)).
///
/// Every operation but two acts on each component by itself, so that both forms round alike; dot
/// products and sums have one order of summation.
pub(super) trait Vector: Copy {
    /// A number, or one in each lane.
    type Scalar: Lanes;

    /// (x, x, x)
    fn uniform(x: Self::Scalar) -> Self;
    /// (v₁, v₂, v₀)
    fn next(self) -> Self;
    /// (v₂, v₀, v₁)
    fn previous(self) -> Self;

    /// uᵢ vᵢ
    fn times(self, v: Self) -> Self;
    /// uᵢ vᵢ + xᵢ
    fn multiply_add(self, v: Self, x: Self) -> Self;
    /// uᵢ vᵢ − xᵢ
    fn multiply_subtract(self, v: Self, x: Self) -> Self;
    /// xᵢ − uᵢ vᵢ
    fn negative_multiply_add(self, v: Self, x: Self) -> Self;
    /// `yes` where the mask is true.
    fn select(mask: MaskOf<Self>, yes: Self, no: Self) -> Self;

    /// u₀v₀ + (u₁v₁ + u₂v₂)
    fn dot(self, v: Self) -> Self::Scalar;
    /// (v₀ + v₁) + v₂
    fn sum(self) -> Self::Scalar;
}

/// Where something is true of a vector.
pub(super) type MaskOf<V> = <<V as Vector>::Scalar as Real>::Mask;

/// What a cross product reads of a vector.
#[derive(Clone, Copy)]
pub(super) struct Turned<V> {
    /// (v₁, v₂, v₀)
    pub next: V,
    /// (v₂, v₀, v₁)
    pub previous: V,
}

impl<V: Vector> Turned<V> {
    #[inline(always)]
    pub fn new(v: V) -> Self {
        Self { next: v.next(), previous: v.previous() }
    }
}

/// x + u×v
#[inline(always)]
pub(super) fn add_cross<V: Vector>(x: V, u: Turned<V>, v: Turned<V>) -> V {
    u.next.multiply_add(v.previous, u.previous.negative_multiply_add(v.next, x))
}
