//! The trait of Lie algebras: [`LieAlgebra`].

use generic_scalars::{Covector, Real, Vector};

/// A momentum μ ∈ 𝔤∗ over the scalar `T`.
pub type Momentum<A, T = f64> = Covector<<A as LieAlgebra>::Element<T>>;

/// A real Lie algebra 𝔤 with a standard basis.
///
/// An algebra is a value, often of a unit struct, and its elements are vectors over any scalar. Only the bracket is
/// required. The coadjoint operator ad∗ follows from it; implement ad∗ by hand if speed matters.
///
/// # Example
/// The Heisenberg algebra [e₀, e₁] = e₂:
/// ```
/// use lie_poisson::{Covector, LieAlgebra, Real, Vector};
/// use nalgebra::Vector3;
///
/// #[derive(Clone)]
/// struct Heisenberg;
///
/// impl LieAlgebra for Heisenberg {
///     type Element<T: Real> = Vector3<T>;
///     fn bracket<T: Real>(&self, xi: &Vector3<T>, eta: &Vector3<T>) -> Vector3<T> {
///         Vector3::new(T::zero(), T::zero(), xi.x * eta.y - xi.y * eta.x)
///     }
/// }
///
/// let (xi, eta) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(4.0, 5.0, 6.0));
/// let mu = Covector(Vector3::new(0.5, 0.0, 2.0));
/// // ⟨ad*_ξ μ, η⟩ = ⟨μ, [ξ, η]⟩
/// let left = Heisenberg.coadjoint(&xi, &mu).pairing(&eta);
/// assert_eq!(left, mu.pairing(&Heisenberg.bracket(&xi, &eta)));
/// ```
pub trait LieAlgebra: Clone {
    /// An element ξ ∈ 𝔤 over the scalar `T`.
    type Element<T: Real>: Vector<Scalar = T, Dual = Covector<Self::Element<T>>>;

    /// Returns the Lie bracket [ξ, η] = `ad_ξ η`, which is bilinear and antisymmetric and obeys the Jacobi
    /// identity.
    fn bracket<T: Real>(&self, xi: &Self::Element<T>, eta: &Self::Element<T>) -> Self::Element<T>;

    /// Applies the coadjoint operator `ad∗_ξ: 𝔤∗ → 𝔤∗`, the transpose of `ad_ξ`:
    ///
    /// ```text
    /// ⟨ad*_ξ μ, η⟩ = ⟨μ, [ξ, η]⟩
    /// ```
    ///
    /// The definition contains no sign, so ad∗ is an antirepresentation: `ad∗_[ξ,η] = −[ad∗_ξ, ad∗_η]`.
    ///
    /// Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, 2nd ed., §9.3.
    #[cfg_attr(optimised, inline(always))]
    fn coadjoint<T: Real>(
        &self,
        xi: &Self::Element<T>,
        mu: &Momentum<Self, T>,
    ) -> Momentum<Self, T> {
        Momentum::<Self, T>::from_coordinates(|i| {
            mu.pairing(&self.bracket::<T>(xi, &Vector::basis(i)))
        })
    }
}
