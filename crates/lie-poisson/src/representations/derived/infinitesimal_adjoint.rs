//! The adjoint representation of a Lie algebra: [`InfinitesimalAdjoint`].

use crate::algebras::algebra::{LieAlgebra, Momentum};
use crate::representations::representation::Representation;
use generic_scalars::Real;

/// The adjoint representation of a Lie algebra on itself, ξ η = `ad_ξ η` = [ξ, η].
///
/// It needs no group, so that a table of [structure constants](crate::StructureConstants) suffices. The kernel of the
/// representation is the centre of 𝔤. [`Adjoint`](crate::Adjoint) is the same representation for an algebra with a
/// group.
///
/// # Example
/// ```
/// use lie_poisson::{Covector, InfinitesimalAdjoint, Representation, So3};
/// use nalgebra::Vector3;
/// let (q, p) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(0.5, 0.0, 1.0));
/// // ⟨q ◇ p, ξ⟩ = ⟨p, ξ × q⟩ = ⟨q × p, ξ⟩
/// assert_eq!(InfinitesimalAdjoint(So3).diamond(&q, &Covector(p)), Covector(q.cross(&p)));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct InfinitesimalAdjoint<A>(pub A);

impl<A: LieAlgebra> Representation for InfinitesimalAdjoint<A> {
    type Algebra = A;
    type Space<T: Real> = A::Element<T>;

    fn algebra(&self) -> A {
        self.0.clone()
    }

    #[cfg_attr(optimised, inline(always))]
    fn act<T: Real>(&self, xi: &A::Element<T>, v: &A::Element<T>) -> A::Element<T> {
        self.0.bracket::<T>(xi, v)
    }

    /// Returns the transposed action `ξᵀ α = ad∗_ξ α`.
    #[cfg_attr(optimised, inline(always))]
    fn transpose_act<T: Real>(&self, xi: &A::Element<T>, alpha: &Momentum<A, T>) -> Momentum<A, T> {
        self.0.coadjoint::<T>(xi, alpha)
    }

    /// Returns the diamond product `v ◇ α = −ad∗_v α`.
    #[cfg_attr(optimised, inline(always))]
    fn diamond<T: Real>(&self, v: &A::Element<T>, alpha: &Momentum<A, T>) -> Momentum<A, T> {
        -self.0.coadjoint::<T>(v, alpha)
    }
}
