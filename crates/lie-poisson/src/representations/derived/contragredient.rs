//! The representation on the dual space: [`Contragredient`].

use crate::algebras::algebra::Momentum;
use crate::representations::representation::{Representation, RepresentedElement};
use generic_scalars::{Covector, Real};

/// The contragredient of a representation on V, which is the representation ξα = −ξᵀα on V∗.
///
/// A covector is stored by its coordinates, in the type of a vector of V. The contragredient of
/// [`InfinitesimalAdjoint`](crate::InfinitesimalAdjoint) is the coadjoint representation, `ξα = −ad∗_ξ α`.
///
/// # Example
/// ```
/// use lie_poisson::{Contragredient, Representation, SL2OnR2};
/// use nalgebra::{Vector2, Vector3};
/// let (xi, v, alpha) = (Vector3::new(1.0, 2.0, 3.0), Vector2::new(1.0, -1.0), Vector2::new(0.5, 2.0));
/// // ⟨ξα, v⟩ + ⟨α, ξv⟩ = 0
/// let turned = Contragredient(SL2OnR2).act(&xi, &alpha);
/// assert_eq!(turned.dot(&v) + alpha.dot(&SL2OnR2.act(&xi, &v)), 0.0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Contragredient<R>(pub R);

impl<R: Representation> Representation for Contragredient<R> {
    type Algebra = R::Algebra;
    type Space<T: Real> = R::Space<T>;

    fn algebra(&self) -> R::Algebra {
        self.0.algebra()
    }

    #[cfg_attr(optimised, inline(always))]
    fn act<T: Real>(&self, xi: &RepresentedElement<R, T>, v: &R::Space<T>) -> R::Space<T> {
        -self.0.transpose_act::<T>(xi, &Covector(*v)).0
    }

    /// Returns the transposed action −ξα.
    #[cfg_attr(optimised, inline(always))]
    fn transpose_act<T: Real>(
        &self,
        xi: &RepresentedElement<R, T>,
        alpha: &Covector<R::Space<T>>,
    ) -> Covector<R::Space<T>> {
        Covector(-self.0.act::<T>(xi, &alpha.0))
    }

    /// Returns −α ◇ v, the diamond product of the representation on V.
    #[cfg_attr(optimised, inline(always))]
    fn diamond<T: Real>(
        &self,
        v: &R::Space<T>,
        alpha: &Covector<R::Space<T>>,
    ) -> Momentum<R::Algebra, T> {
        -self.0.diamond::<T>(&alpha.0, &Covector(*v))
    }
}
