//! The trait of Lie groups: [`LieGroup`].

use crate::algebras::algebra::{LieAlgebra, Momentum};
use generic_scalars::{Real, Vector};

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
///
/// # Example
/// The group of affine maps x ↦ a x + b of a line, a > 0, with g = (a, b):
/// ```
/// use lie_poisson::{LieAlgebra, LieGroup, Real, Vector};
/// use nalgebra::Vector2;
///
/// #[derive(Clone)]
/// struct AffineLine;
/// impl LieAlgebra for AffineLine {
///     type Element<T: Real> = Vector2<T>;
///     fn bracket<T: Real>(&self, xi: &Vector2<T>, eta: &Vector2<T>) -> Vector2<T> {
///         Vector2::new(T::zero(), xi.x * eta.y - eta.x * xi.y)
///     }
/// }
/// impl LieGroup for AffineLine {
///     type Algebra = Self;
///     type Element<T: Real> = Vector2<T>;
///     fn algebra(&self) -> Self {
///         AffineLine
///     }
///     fn identity<T: Real>(&self) -> Vector2<T> {
///         Vector2::new(T::one(), T::zero())
///     }
///     fn compose<T: Real>(&self, g: &Vector2<T>, h: &Vector2<T>) -> Vector2<T> {
///         Vector2::new(g.x * h.x, g.x * h.y + g.y)
///     }
///     fn inverse<T: Real>(&self, g: &Vector2<T>) -> Vector2<T> {
///         Vector2::new(T::one() / g.x, -g.y / g.x)
///     }
///     fn exp<T: Real>(&self, xi: &Vector2<T>) -> Vector2<T> {
///         // (eˣ − 1)/x = e^(x/2) sinh(x/2)/(x/2), without a special case at 0
///         let half = xi.x * 0.5;
///         Vector2::new(xi.x.exp(), xi.y * half.exp() * (-half * half).stumpff(1))
///     }
///     fn adjoint<T: Real>(&self, g: &Vector2<T>, xi: &Vector2<T>) -> Vector2<T> {
///         Vector2::new(xi.x, g.x * xi.y - xi.x * g.y)
///     }
/// }
///
/// let (xi, eta) = (Vector2::new(0.3, -0.7), Vector2::new(0.5, 0.2));
/// let g = AffineLine.exp(&xi);
/// // exp(ξ) exp(ξ) = exp(2ξ)
/// assert!((AffineLine.compose(&g, &g) - AffineLine.exp(&(xi * 2.0))).norm() < 1e-15);
/// // Ad_g is a homomorphism of the bracket
/// let moved = |v: &Vector2<f64>| AffineLine.adjoint(&g, v);
/// let bracket = AffineLine.bracket(&moved(&xi), &moved(&eta));
/// assert!((bracket - moved(&AffineLine.bracket(&xi, &eta))).norm() < 1e-15);
/// ```
pub trait LieGroup: Clone {
    /// The Lie algebra 𝔤 of the group.
    type Algebra: LieAlgebra;

    /// An element g ∈ G over the scalar `T`.
    type Element<T: Real>: Vector<Scalar = T>;

    /// Returns the Lie algebra 𝔤 as a value.
    fn algebra(&self) -> Self::Algebra;

    /// Returns the identity e of the group, by default exp(0).
    fn identity<T: Real>(&self) -> Self::Element<T> {
        self.exp::<T>(&Vector::zero())
    }

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
    #[cfg_attr(optimised, inline(always))]
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
