//! Representations extended by a cocycle: [`CocycleExtension`].

use crate::algebras::algebra::{LieAlgebra, Momentum};
use crate::representations::cocycle::{Cocycle, CocycleError, largest_element, nonzero};
use crate::representations::derived::contragredient::Contragredient;
use crate::representations::derived::infinitesimal_adjoint::InfinitesimalAdjoint;
use crate::representations::representation::{Representation, RepresentedElement};
use generic_scalars::{Covector, Pair, Real, Vector};
use nalgebra::Vector1;

/// The representation of 𝔤 on V ⊕ R that extends a representation on V by a [`Cocycle`] c:
///
/// ```text
/// ξ (v, s) = (ξv − s c(ξ), 0)
/// ```
///
/// Its kernel consists of the ξ with ξv = 0 for all v and c(ξ) = 0. The kernel of the adjoint and of the coadjoint
/// representation is the centre of 𝔤. Their extensions are faithful if and only if c is injective on the centre. For a
/// derivation D the space 𝔤 ⊕ R is the algebra 𝔤 ⋊ RD with [D, ξ] = Dξ, on which 𝔤 acts by ad.
///
/// Some algebras have no derivation that is injective on the centre. For example, in dimension 5 all derivations of
/// `[e₁, e₄] = e₁`, `[e₂, e₅] = e₂`, `[e₄, e₅] = e₃` vanish on the centre e₃, but [`ExtendedCoadjoint`] is faithful.
///
/// Source: N. Jacobson, *Lie Algebras* (1962), §III.10.
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
pub struct CocycleExtension<R>(pub Cocycle<R>);

/// The adjoint representation, extended by a derivation.
pub type ExtendedAdjoint<A> = CocycleExtension<InfinitesimalAdjoint<A>>;

/// The coadjoint representation, extended by a cocycle.
pub type ExtendedCoadjoint<A> = CocycleExtension<Contragredient<InfinitesimalAdjoint<A>>>;

impl<A: LieAlgebra> ExtendedAdjoint<A> {
    /// Creates the extension by the derivation nearest to the identity, multiplied by the largest structure constant,
    /// so that both terms of ξ(v, s) have the same scale.
    ///
    /// # Errors
    /// Returns [`CocycleError`] if a structure constant, or the product of the largest one with the derivation, is not
    /// finite.
    pub fn of(algebra: A) -> Result<Self, CocycleError> {
        let identity = |i: usize, j: usize| if i == j { 1.0 } else { 0.0 };
        nearest_to(InfinitesimalAdjoint(algebra), identity)
    }
}

impl<A: LieAlgebra> ExtendedCoadjoint<A> {
    /// Creates the extension by a generic cocycle, multiplied by the largest structure constant.
    ///
    /// The cocycle is the one nearest to a fixed matrix whose entries obey no simple relation. If some cocycle of the
    /// coadjoint representation is injective on the centre, then the cocycle nearest to almost every matrix is
    /// injective too. This is not proved for the fixed matrix: the rank of the Clebsch map of the extension shows
    /// whether it holds (`ClebschSection::rank`).
    ///
    /// # Errors
    /// Returns [`CocycleError`] if a structure constant, or the product of the largest one with the cocycle, is not
    /// finite.
    ///
    /// # Example
    /// ```
    /// use lie_poisson::{ExtendedAdjoint, ExtendedCoadjoint, StructureConstants};
    /// use nalgebra::SVector;
    /// // [e₀, e₃] = e₀, [e₁, e₄] = e₁, [e₃, e₄] = e₂
    /// let algebra = StructureConstants::<5>::new(|i, j, k| match (i, j, k) {
    ///     (0, 3, 0) | (1, 4, 1) | (3, 4, 2) => 1.0,
    ///     (3, 0, 0) | (4, 1, 1) | (4, 3, 2) => -1.0,
    ///     _ => 0.0,
    /// })?;
    /// let centre = SVector::<f64, 5>::from_fn(|i, _| if i == 2 { 1.0 } else { 0.0 });
    /// assert!(ExtendedAdjoint::of(algebra.clone())?.0.apply(&centre).norm() < 1e-14);
    /// assert!(ExtendedCoadjoint::of(algebra)?.0.apply(&centre).norm() > 0.1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of(algebra: A) -> Result<Self, CocycleError> {
        let generic = |i: usize, j: usize| ((2 * i + 1) as f64 * 0.7 + (j * j + j) as f64).sin();
        nearest_to(Contragredient(InfinitesimalAdjoint(algebra)), generic)
    }
}

/// Returns the extension by the cocycle nearest to a matrix, multiplied by the largest structure constant.
fn nearest_to<R: Representation>(
    representation: R,
    target: impl Fn(usize, usize) -> f64,
) -> Result<CocycleExtension<R>, CocycleError> {
    let size = nonzero(largest_element(&representation));
    Ok(CocycleExtension(Cocycle::nearest_to(representation, target)?.scaled(size)?))
}

impl<R: Representation> Representation for CocycleExtension<R> {
    type Algebra = R::Algebra;
    type Space<T: Real> = Pair<R::Space<T>, Vector1<T>>;

    fn algebra(&self) -> R::Algebra {
        self.0.representation().algebra()
    }

    #[cfg_attr(optimised, inline(always))]
    fn act<T: Real>(&self, xi: &RepresentedElement<Self, T>, v: &Self::Space<T>) -> Self::Space<T> {
        let Pair(v, s) = v;
        let inner = self.0.representation().act::<T>(xi, v);
        Pair(inner - self.0.apply::<T>(xi).scaled(s.x), Vector::zero())
    }

    /// Returns ξᵀ(α, σ) = (ξᵀα, −⟨α, c(ξ)⟩).
    #[cfg_attr(optimised, inline(always))]
    fn transpose_act<T: Real>(
        &self,
        xi: &RepresentedElement<Self, T>,
        alpha: &Covector<Self::Space<T>>,
    ) -> Covector<Self::Space<T>> {
        let alpha = Covector(alpha.0.0);
        let along = alpha.pairing(&self.0.apply::<T>(xi));
        let inner = self.0.representation().transpose_act::<T>(xi, &alpha);
        Covector(Pair(inner.0, Vector1::new(-along)))
    }

    /// Returns (v, s) ◇ (α, σ) = v ◇ α − s cᵀα.
    #[cfg_attr(optimised, inline(always))]
    fn diamond<T: Real>(
        &self,
        v: &Self::Space<T>,
        alpha: &Covector<Self::Space<T>>,
    ) -> Momentum<R::Algebra, T> {
        let (Pair(v, s), alpha) = (v, Covector(alpha.0.0));
        let inner = self.0.representation().diamond::<T>(v, &alpha);
        inner - self.0.transpose_apply::<T>(&alpha).scaled(s.x)
    }
}
