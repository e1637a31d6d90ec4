//! Vectors of R³ in the form in which the formulas use them.

use lie_poisson::{Lanes, Real};

/// A vector of R³ in registers: three components in SIMD lanes of their own
/// ([`Components`](super::components::Components)), or all three in one register
/// ([`InRegister`](super::in_register::InRegister)).
///
/// Every operation except `dot` and `sum` acts on each component by itself, so that both forms round alike.
/// Dot products and sums have one order of summation.
pub(super) trait RegisterVector: Copy {
    /// The scalar type: one number, or one in each lane.
    type Scalar: Lanes;

    /// Returns the vector (x, x, x).
    fn uniform(x: Self::Scalar) -> Self;
    /// Returns the cyclic shift (v₁, v₂, v₀).
    fn next(self) -> Self;
    /// Returns the cyclic shift (v₂, v₀, v₁).
    fn previous(self) -> Self;

    /// Returns the products uᵢ vᵢ of components.
    fn times(self, v: Self) -> Self;
    /// Returns the sums uᵢ + vᵢ.
    fn plus(self, v: Self) -> Self;
    /// Returns the differences uᵢ − vᵢ.
    fn minus(self, v: Self) -> Self;
    /// Returns the sums uᵢ vᵢ + xᵢ.
    fn multiply_add(self, v: Self, x: Self) -> Self;
    /// Returns the differences uᵢ vᵢ − xᵢ.
    fn multiply_subtract(self, v: Self, x: Self) -> Self;
    /// Returns the differences xᵢ − uᵢ vᵢ.
    fn negative_multiply_add(self, v: Self, x: Self) -> Self;
    /// Returns `yes` where the mask is true and `no` elsewhere.
    fn select(mask: MaskOf<Self>, yes: Self, no: Self) -> Self;

    /// Returns the dot product u₀v₀ + (u₁v₁ + u₂v₂).
    fn dot(self, v: Self) -> Self::Scalar;
    /// Returns the sum (v₀ + v₁) + v₂.
    fn sum(self) -> Self::Scalar;
}

/// The mask of a vector: one truth value, or one in each lane.
pub(super) type MaskOf<V> = <<V as RegisterVector>::Scalar as Real>::Mask;

/// The two cyclic shifts of a vector, from which cross products are computed.
#[derive(Clone, Copy)]
pub(super) struct CyclicShifts<V> {
    /// The forward cyclic shift (v₁, v₂, v₀).
    pub next: V,
    /// The backward cyclic shift (v₂, v₀, v₁).
    pub previous: V,
}

impl<V: RegisterVector> CyclicShifts<V> {
    #[cfg_attr(optimised, inline(always))]
    pub fn new(v: V) -> Self {
        Self { next: v.next(), previous: v.previous() }
    }
}

/// Returns the sum x + u×v.
#[cfg_attr(optimised, inline(always))]
pub(super) fn add_cross<V: RegisterVector>(x: V, u: CyclicShifts<V>, v: CyclicShifts<V>) -> V {
    u.next.multiply_add(v.previous, u.previous.negative_multiply_add(v.next, x))
}
