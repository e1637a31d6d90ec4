//! Semidirect products 𝔤 ⋉ V and G ⋉ V, from any representation.

use crate::algebras::algebra::LieAlgebra;
use crate::algebras::group::{AlgebraElement, LieGroup};
use crate::representations::representation::{
    GroupRepresentation, Representation, RepresentedElement,
};
use generic_scalars::{Covector, Pair, Real, Vector};

/// An element (ξ, φ) ∈ 𝔤 ⋉ V of a semidirect product, over the scalar `T`.
type Element<R, T> = Pair<RepresentedElement<R, T>, <R as Representation>::Space<T>>;

/// The semidirect product 𝔤 ⋉ V of a Lie algebra and a space on which it acts:
///
/// ```text
/// [(ξ,φ), (η,ζ)] = ([ξ,η], ξζ − ηφ)
/// ad*_(ξ,φ) (μ,α) = (ad*_ξ μ − φ ◇ α, ξᵀα)
/// ```
///
/// Source: Marsden, Ratiu & Weinstein, *Semidirect products and reduction in mechanics*, Trans.
/// AMS 281 (1984), §2; Ohsawa 2019, eq. (2.4).
///
/// # Example
/// ```
/// use lie_poisson::{LieAlgebra, Pair, Se3, Se3Dual};
/// use nalgebra::Vector3;
/// let (omega, force) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(0.0, 1.0, 0.0));
/// let (pi, gamma) = (Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.0, 0.6, 0.8));
/// // ad*_(Ω,γ) (Π,Γ) = (Π×Ω + Γ×γ, Γ×Ω)
/// let rate = Se3::default().coadjoint(&Pair(omega, force), &Se3Dual::new(pi, gamma));
/// assert_eq!(rate, Se3Dual::new(pi.cross(&omega) + gamma.cross(&force), gamma.cross(&omega)));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SemidirectAlgebra<R>(pub R);

impl<R: Representation> LieAlgebra for SemidirectAlgebra<R> {
    type Element<T: Real> = Element<R, T>;

    #[cfg_attr(optimised, inline(always))]
    fn bracket<T: Real>(&self, xi: &Element<R, T>, eta: &Element<R, T>) -> Element<R, T> {
        let (Pair(xi, phi), Pair(eta, zeta)) = (xi, eta);
        Pair(
            self.0.algebra().bracket::<T>(xi, eta),
            self.0.act::<T>(xi, zeta) - self.0.act::<T>(eta, phi),
        )
    }

    #[cfg_attr(optimised, inline(always))]
    fn coadjoint<T: Real>(
        &self,
        xi: &Element<R, T>,
        mu: &Covector<Element<R, T>>,
    ) -> Covector<Element<R, T>> {
        let (Pair(xi, phi), Covector(Pair(mu, alpha))) = (xi, mu);
        let (mu, alpha) = (Covector(*mu), Covector(*alpha));
        let momentum = self.0.algebra().coadjoint::<T>(xi, &mu) - self.0.diamond::<T>(phi, &alpha);
        Covector(Pair(momentum.0, self.0.transpose_act::<T>(xi, &alpha).0))
    }
}

/// The semidirect product group G ⋉ V of affine maps x ↦ gx + v: (g, v)(h, w) = (gh, gw + v).
///
/// Source: Ohsawa 2019, §2.2.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SemidirectGroup<R>(pub R);

impl<R: GroupRepresentation> LieGroup for SemidirectGroup<R> {
    type Algebra = SemidirectAlgebra<R>;
    type Element<T: Real> = Pair<<R::Group as LieGroup>::Element<T>, R::Space<T>>;

    fn algebra(&self) -> SemidirectAlgebra<R> {
        SemidirectAlgebra(self.0.clone())
    }

    #[cfg_attr(optimised, inline(always))]
    fn identity<T: Real>(&self) -> Self::Element<T> {
        Pair(self.0.group().identity::<T>(), Vector::zero())
    }

    #[cfg_attr(optimised, inline(always))]
    fn compose<T: Real>(&self, g: &Self::Element<T>, h: &Self::Element<T>) -> Self::Element<T> {
        Pair(self.0.group().compose::<T>(&g.0, &h.0), self.0.transform::<T>(&g.0, &h.1) + g.1)
    }

    /// Returns the inverse (g⁻¹, −g⁻¹ v).
    #[cfg_attr(optimised, inline(always))]
    fn inverse<T: Real>(&self, g: &Self::Element<T>) -> Self::Element<T> {
        let inverse = self.0.group().inverse::<T>(&g.0);
        Pair(inverse, -self.0.transform::<T>(&inverse, &g.1))
    }

    /// Returns (exp ξ, ∫₀¹ exp(σξ) φ dσ). Source: Ohsawa 2019, §2.3.
    #[cfg_attr(optimised, inline(always))]
    fn exp<T: Real>(&self, xi: &AlgebraElement<Self, T>) -> Self::Element<T> {
        let Pair(xi, phi) = xi;
        Pair(self.0.group().exp::<T>(xi), self.0.exp_integral::<T>(xi, phi))
    }

    /// Returns Ad_(g,v) (ξ, φ) = (Ad_g ξ, gφ − (Ad_g ξ) v).
    #[cfg_attr(optimised, inline(always))]
    fn adjoint<T: Real>(
        &self,
        g: &Self::Element<T>,
        xi: &AlgebraElement<Self, T>,
    ) -> AlgebraElement<Self, T> {
        let turned = self.0.group().adjoint::<T>(&g.0, &xi.0);
        Pair(turned, self.0.transform::<T>(&g.0, &xi.1) - self.0.act::<T>(&turned, &g.1))
    }
}
