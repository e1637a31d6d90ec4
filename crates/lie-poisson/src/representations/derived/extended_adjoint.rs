//! The adjoint representation, extended by a derivation: [`ExtendedAdjoint`].

use crate::algebras::derivation::largest_constant;
use crate::{
    Covector, Derivation, DerivationError, LieAlgebra, Pair, Real, Representation,
    RepresentedElement, Vector,
};
use nalgebra::Vector1;

/// The representation of 𝔤 on 𝔤 ⋊ RD, the extension of 𝔤 by a derivation D with [D, ξ] = Dξ:
///
/// ```text
/// ξ (η, s) = ([ξ, η] − s Dξ, 0)
/// ```
///
/// Its kernel consists of the central elements with Dξ = 0, while the kernel of the adjoint representation is the whole
/// centre. It is faithful if and only if D is injective on the centre. Every Lie algebra of dimension up to 5 that the
/// tests contain has such a derivation. There are algebras without one from dimension 7 on: those whose derivations
/// are all nilpotent.
///
/// Source: N. Jacobson, *Lie Algebras* (1962), §I.4 (split extensions) and §VI.2 (Ado's theorem); J. Dixmier & W. G.
/// Lister, *Derivations of nilpotent Lie algebras*, Proc. AMS 8 (1957), for nilpotent derivations.
///
/// # Example
/// The abelian algebra R², whose adjoint representation is zero, acts by translations:
/// ```
/// use lie_poisson::{ExtendedAdjoint, Pair, Representation, StructureConstants};
/// use nalgebra::{Vector1, Vector2};
/// let extended = ExtendedAdjoint::of(StructureConstants::<2>::new(|_, _, _| 0.0)?)?;
/// let (xi, point) = (Vector2::new(1.0, 2.0), Pair(Vector2::new(5.0, 7.0), Vector1::new(3.0)));
/// assert_eq!(extended.act(&xi, &point), Pair(xi * -3.0, Vector1::new(0.0)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ExtendedAdjoint<A>(pub Derivation<A>);

impl<A: LieAlgebra> ExtendedAdjoint<A> {
    /// Creates the extension by the derivation [nearest to the identity](Derivation::nearest_to_identity).
    ///
    /// D is multiplied by the largest structure constant, so that both terms of ξ(η, s) have one scale.
    ///
    /// # Errors
    /// Returns [`DerivationError`] if a structure constant is not finite.
    pub fn of(algebra: A) -> Result<Self, DerivationError> {
        let size = largest_constant(&algebra);
        let derivation = Derivation::nearest_to_identity(algebra)?;
        Ok(Self(derivation.scaled(if size > 0.0 { size } else { 1.0 })))
    }
}

impl<A: LieAlgebra> Representation for ExtendedAdjoint<A> {
    type Algebra = A;
    type Space<T: Real> = Pair<A::Element<T>, Vector1<T>>;

    fn algebra(&self) -> A {
        self.0.algebra().clone()
    }

    #[inline]
    fn act<T: Real>(&self, xi: &RepresentedElement<Self, T>, v: &Self::Space<T>) -> Self::Space<T> {
        let Pair(eta, s) = v;
        let inner = self.0.algebra().bracket::<T>(xi, eta);
        Pair(inner - self.0.apply::<T>(xi).scaled(s.x), Vector::zero())
    }

    /// Returns ξᵀ(α, σ) = (`ad∗_ξ α`, −⟨α, Dξ⟩).
    #[inline]
    fn transpose_act<T: Real>(
        &self,
        xi: &RepresentedElement<Self, T>,
        alpha: &Covector<Self::Space<T>>,
    ) -> Covector<Self::Space<T>> {
        let alpha = Covector(alpha.0.0);
        let along = alpha.pairing(&self.0.apply::<T>(xi));
        Covector(Pair(self.0.algebra().coadjoint::<T>(xi, &alpha).0, Vector1::new(-along)))
    }

    /// Returns (η, s) ◇ (α, σ) = `−ad∗_η α` − s Dᵀα.
    #[inline]
    fn diamond<T: Real>(
        &self,
        v: &Self::Space<T>,
        alpha: &Covector<Self::Space<T>>,
    ) -> Covector<A::Element<T>> {
        let (Pair(eta, s), alpha) = (v, Covector(alpha.0.0));
        let inner = self.0.algebra().coadjoint::<T>(eta, &alpha);
        -inner - self.0.transpose_apply::<T>(&alpha).scaled(s.x)
    }
}
