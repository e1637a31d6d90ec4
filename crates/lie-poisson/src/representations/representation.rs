//! The traits of linear representations: [`Representation`], [`GroupRepresentation`].

use crate::algebras::algebra::{LieAlgebra, Momentum};
use crate::algebras::group::{AlgebraElement, LieGroup};
use generic_scalars::{Covector, Real, Vector};

/// An element ξ ∈ 𝔤 of the represented algebra, over the scalar `T`.
pub type RepresentedElement<R, T = f64> =
    <<R as Representation>::Algebra as LieAlgebra>::Element<T>;

/// A linear representation of a Lie algebra 𝔤 on a real vector space V: [ξ, η] v = ξ(ηv) − η(ξv).
///
/// # Example
/// The representation of so(3) on R³, and the semidirect product that is built from it:
/// ```
/// use lie_poisson::{Covector, LieAlgebra, Pair, Real, Representation, SemidirectAlgebra, So3};
/// use nalgebra::Vector3;
///
/// #[derive(Clone)]
/// struct Rotations;
/// impl Representation for Rotations {
///     type Algebra = So3;
///     type Space<T: Real> = Vector3<T>;
///     fn algebra(&self) -> So3 {
///         So3
///     }
///     fn act<T: Real>(&self, xi: &Vector3<T>, v: &Vector3<T>) -> Vector3<T> {
///         xi.cross(v)
///     }
/// }
///
/// let (v, alpha) = (Vector3::new(1.0, 2.0, 3.0), Covector(Vector3::new(0.5, 0.0, 1.0)));
/// // the diamond product follows: v ◇ α = v × α
/// assert_eq!(Rotations.diamond(&v, &alpha), Covector(v.cross(&alpha.0)));
/// // so(3) ⋉ R³ = se(3)
/// let se3 = SemidirectAlgebra(Rotations); // its elements are pairs (ξ, φ)
/// let (xi, eta) = (Pair(Vector3::x(), Vector3::y()), Pair(Vector3::y(), Vector3::z()));
/// assert_eq!(se3.bracket::<f64>(&xi, &eta), Pair(Vector3::z(), -Vector3::y()));
/// ```
pub trait Representation: Clone {
    /// The Lie algebra 𝔤 that acts.
    type Algebra: LieAlgebra;

    /// A vector v ∈ V over the scalar `T`.
    type Space<T: Real>: Vector<Scalar = T, Dual = Covector<Self::Space<T>>>;

    /// Returns the Lie algebra 𝔤 as a value.
    fn algebra(&self) -> Self::Algebra;

    /// Returns ξ v, the action of ξ ∈ 𝔤 on v.
    fn act<T: Real>(&self, xi: &RepresentedElement<Self, T>, v: &Self::Space<T>) -> Self::Space<T>;

    /// Returns ξᵀ α ∈ V∗ for the transpose of the action: ⟨ξᵀα, v⟩ = ⟨α, ξv⟩.
    #[cfg_attr(optimised, inline(always))]
    fn transpose_act<T: Real>(
        &self,
        xi: &RepresentedElement<Self, T>,
        alpha: &Covector<Self::Space<T>>,
    ) -> Covector<Self::Space<T>> {
        Covector::from_coordinates(|i| alpha.pairing(&self.act::<T>(xi, &Vector::basis(i))))
    }

    /// Returns the diamond product v ◇ α ∈ 𝔤∗, the momentum of the action on V: ⟨v ◇ α, η⟩ = ⟨α, ηv⟩.
    ///
    /// Source: Holm, Marsden & Ratiu, *The Euler–Poincaré equations and semidirect products*,
    /// Adv. Math. 137 (1998), eq. (1.2).
    #[cfg_attr(optimised, inline(always))]
    fn diamond<T: Real>(
        &self,
        v: &Self::Space<T>,
        alpha: &Covector<Self::Space<T>>,
    ) -> Momentum<Self::Algebra, T> {
        Momentum::<Self::Algebra, T>::from_coordinates(|i| {
            alpha.pairing(&self.act::<T>(&Vector::basis(i), v))
        })
    }
}

/// A representation that comes from a representation of a Lie group G: exp(sξ) v solves dv/ds = ξ v.
pub trait GroupRepresentation: Representation {
    /// The Lie group G that acts.
    type Group: LieGroup<Algebra = Self::Algebra>;

    /// Returns the Lie group G as a value.
    fn group(&self) -> Self::Group;

    /// Returns g v, the action of g ∈ G on v.
    fn transform<T: Real>(
        &self,
        g: &<Self::Group as LieGroup>::Element<T>,
        v: &Self::Space<T>,
    ) -> Self::Space<T>;

    /// Returns ∫₀¹ exp(σξ) φ dσ, the translation part of the exponential of (ξ, φ) ∈ 𝔤 ⋉ V.
    ///
    /// The default implementation sums the series Σ ξᵏφ/(k+1)! for a fraction ξ/2ᵐ with |ξ/2ᵐ| ≤ ¼ in
    /// coordinates, and doubles m times:
    ///
    /// ```text
    /// ∫₀¹ exp(2σξ) φ dσ = ½ (1 + exp ξ) ∫₀¹ exp(σξ) φ dσ
    /// ```
    ///
    /// The doublings lose about |ξ| units of round-off, as the exponential of ξ itself does.
    ///
    /// Source: Ohsawa 2019, §2.3.
    fn exp_integral<T: Real>(
        &self,
        xi: &AlgebraElement<Self::Group, T>,
        phi: &Self::Space<T>,
    ) -> Self::Space<T> {
        let size = xi.max_abs();
        // The number of doublings is at most 1026 for a finite ξ.
        let doublings = if size > 0.25 { (size * 4.0).log2().ceil().min(1026.0) } else { 0.0 };
        let fraction = xi.scaled(T::from_f64((-doublings).exp2()));
        let mut term = *phi;
        let mut integral = *phi;
        let mut k = 1.0;
        // No representation in use needs 200 terms.
        while k < 200.0 && term.max_abs() > 0.0 {
            k += 1.0;
            term = self.act::<T>(&fraction, &term).scaled(T::from_f64(1.0 / k));
            let previous = integral;
            integral += term;
            if integral == previous {
                break;
            }
        }
        let mut turn = self.group().exp::<T>(&fraction);
        for _ in 0..(doublings as usize) {
            let turned = self.transform::<T>(&turn, &integral);
            integral = (integral + turned).scaled(T::from_f64(0.5));
            turn = self.group().compose::<T>(&turn, &turn);
        }
        integral
    }
}
