//! The trait of Lie groups: [`LieGroup`].

use crate::{LieAlgebra, Momentum, Real, Vector};

/// An element ξ ∈ 𝔤 of the Lie algebra of a group, over the scalar `T`.
pub type AlgebraElement<G, T = f64> = <<G as LieGroup>::Algebra as LieAlgebra>::Element<T>;

/// A momentum μ ∈ 𝔤∗ for the Lie algebra of a group, over the scalar `T`.
pub type GroupMomentum<G, T = f64> = Momentum<<G as LieGroup>::Algebra, T>;

/// A Lie group G with its Lie algebra 𝔤, the tangent space at the identity.
///
/// Group elements are stored in a real vector space (matrices, pairs of matrices and vectors), so that
/// their scalar can be changed. Their sum in this vector space has no meaning in G.
///
/// Source of all conventions: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*,
/// 2nd ed., §9.1.
pub trait LieGroup: Clone {
    /// The Lie algebra 𝔤 of the group.
    type Algebra: LieAlgebra;

    /// An element g ∈ G over the scalar `T`.
    type Element<T: Real>: Vector<Scalar = T>;

    /// Returns the Lie algebra 𝔤 as a value.
    fn algebra(&self) -> Self::Algebra;

    /// Returns the identity e of the group.
    fn identity<T: Real>(&self) -> Self::Element<T>;

    /// Returns the product g h.
    fn compose<T: Real>(&self, g: &Self::Element<T>, h: &Self::Element<T>) -> Self::Element<T>;

    /// Returns the inverse g⁻¹.
    fn inverse<T: Real>(&self, g: &Self::Element<T>) -> Self::Element<T>;

    /// Applies the exponential map exp: 𝔤 → G, with d/ds exp(sξ) = ξ at s = 0.
    fn exp<T: Real>(&self, xi: &AlgebraElement<Self, T>) -> Self::Element<T>;

    /// Applies the adjoint action `Ad_g ξ` = d/ds g exp(sξ) g⁻¹ at s = 0.
    fn adjoint<T: Real>(
        &self,
        g: &Self::Element<T>,
        xi: &AlgebraElement<Self, T>,
    ) -> AlgebraElement<Self, T>;

    /// Applies `Ad∗_g`, the transpose of `Ad_g`, which is a right action of G on 𝔤∗:
    ///
    /// ```text
    /// ⟨Ad*_g μ, ξ⟩ = ⟨μ, Ad_g ξ⟩
    /// Ad*_gh = Ad*_h Ad*_g
    /// ```
    #[inline]
    fn coadjoint<T: Real>(
        &self,
        g: &Self::Element<T>,
        mu: &GroupMomentum<Self, T>,
    ) -> GroupMomentum<Self, T> {
        GroupMomentum::<Self, T>::from_coordinates(|i| {
            mu.pairing(&self.adjoint::<T>(g, &Vector::basis(i)))
        })
    }
}
