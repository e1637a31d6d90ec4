//! Lie groups.

use crate::{LieAlgebra, Momentum, Real, Vector};

/// ξ ∈ 𝔤 of a group, over the scalar `T`.
pub type AlgebraElement<G, T = f64> = <<G as LieGroup>::Algebra as LieAlgebra>::Element<T>;

/// μ ∈ 𝔤∗ of a group, over the scalar `T`.
pub type GroupMomentum<G, T = f64> = Momentum<<G as LieGroup>::Algebra, T>;

/// A Lie group G with Lie algebra 𝔤 = T_e G.
///
/// Group elements are stored in a real vector space (matrices, pairs of matrices and vectors),
/// which lets them change scalar; their vector-space sum has no meaning in G.
///
/// Source of all conventions: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*,
/// 2nd ed., §9.1.
pub trait LieGroup: Clone {
    /// 𝔤
    type Algebra: LieAlgebra;

    /// g ∈ G over the scalar `T`.
    type Element<T: Real>: Vector<Scalar = T>;

    /// 𝔤 as a value.
    fn algebra(&self) -> Self::Algebra;

    /// The identity e.
    fn identity<T: Real>(&self) -> Self::Element<T>;

    /// The product g h.
    fn compose<T: Real>(&self, g: &Self::Element<T>, h: &Self::Element<T>) -> Self::Element<T>;

    /// g⁻¹
    fn inverse<T: Real>(&self, g: &Self::Element<T>) -> Self::Element<T>;

    /// exp: 𝔤 → G, with d/ds exp(sξ) = ξ at s = 0.
    fn exp<T: Real>(&self, xi: &AlgebraElement<Self, T>) -> Self::Element<T>;

    /// `Ad_g ξ = d/ds g exp(sξ) g⁻¹` at s = 0.
    fn adjoint<T: Real>(
        &self,
        g: &Self::Element<T>,
        xi: &AlgebraElement<Self, T>,
    ) -> AlgebraElement<Self, T>;

    /// `Ad∗_g μ`, the transpose of `Ad_g`, a right action of G on 𝔤∗:
    ///
    /// ```text
    /// ⟨Ad*_g μ, ξ⟩ = ⟨μ, Ad_g ξ⟩
    /// Ad*_{gh} = Ad*_h Ad*_g
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
