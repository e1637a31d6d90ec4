//! Linear representations, from which semidirect products are built.

use crate::{AlgebraElement, Covector, LieAlgebra, LieGroup, Momentum, Real, Vector};

/// ξ ∈ 𝔤 of the represented algebra, over the scalar `T`.
pub type RepresentedElement<R, T = f64> =
    <<R as Representation>::Algebra as LieAlgebra>::Element<T>;

/// A linear representation of a Lie algebra 𝔤 on a real vector space V: [ξ, η] v = ξ(ηv) − η(ξv).
pub trait Representation: Clone {
    /// 𝔤
    type Algebra: LieAlgebra;

    /// v ∈ V over the scalar `T`.
    type Space<T: Real>: Vector<Scalar = T, Dual = Covector<Self::Space<T>>>;

    /// 𝔤 as a value.
    fn algebra(&self) -> Self::Algebra;

    /// ξ v
    fn act<T: Real>(&self, xi: &RepresentedElement<Self, T>, v: &Self::Space<T>) -> Self::Space<T>;

    /// ξᵀ α ∈ V∗, the transpose: ⟨ξᵀα, v⟩ = ⟨α, ξv⟩.
    #[inline]
    fn transpose_act<T: Real>(
        &self,
        xi: &RepresentedElement<Self, T>,
        alpha: &Covector<Self::Space<T>>,
    ) -> Covector<Self::Space<T>> {
        Covector::from_coordinates(|i| alpha.pairing(&self.act::<T>(xi, &Vector::basis(i))))
    }

    /// v ◇ α ∈ 𝔤∗, the momentum of the action on V: ⟨v ◇ α, η⟩ = ⟨α, ηv⟩.
    ///
    /// Source: Holm, Marsden & Ratiu, *The Euler–Poincaré equations and semidirect products*,
    /// Adv. Math. 137 (1998), eq. (1.2).
    #[inline]
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

/// A representation that comes from one of a Lie group G: exp(ξ) v solves v′ = ξ v.
pub trait GroupRepresentation: Representation {
    /// G
    type Group: LieGroup<Algebra = Self::Algebra>;

    /// G as a value.
    fn group(&self) -> Self::Group;

    /// g v
    fn transform<T: Real>(
        &self,
        g: &<Self::Group as LieGroup>::Element<T>,
        v: &Self::Space<T>,
    ) -> Self::Space<T>;

    /// ∫₀¹ exp(σξ) φ dσ, the translation part of the exponential of (ξ, φ) ∈ 𝔤 ⋉ V.
    ///
    /// By default the series Σ ξᵏφ/(k+1)! on a fraction ξ/n of the way, carried on by
    /// ∫₀¹ exp(σξ) φ dσ = (1/n) Σ_{j<n} exp(jξ/n) ∫₀¹ exp(σξ/n) φ dσ.
    ///
    /// Source: Ohsawa 2019, §2.3.
    fn exp_integral<T: Real>(
        &self,
        xi: &AlgebraElement<Self::Group, T>,
        phi: &Self::Space<T>,
    ) -> Self::Space<T> {
        let pieces = xi.max_abs().ceil().clamp(1.0, 4096.0);
        let fraction = xi.scaled(T::from_f64(1.0 / pieces));
        let mut term = *phi;
        let mut piece = *phi;
        let mut k = 1.0;
        // |ξ/n| ≤ 1 in coordinates: 200 terms are out of reach of any representation in use.
        while k < 200.0 && !term.max_abs().eq(&0.0) {
            k += 1.0;
            term = self.act::<T>(&fraction, &term).scaled(T::from_f64(1.0 / k));
            let previous = piece;
            piece += term;
            if piece == previous {
                break;
            }
        }
        let turn = self.group().exp::<T>(&fraction);
        let mut sum = piece;
        for _ in 1..(pieces as usize) {
            piece = self.transform::<T>(&turn, &piece);
            sum += piece;
        }
        sum.scaled(T::from_f64(1.0 / pieces))
    }
}
