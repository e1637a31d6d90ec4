//! The symplectic representation on T∗V: [`CotangentRepresentation`].

use crate::maps::symplectic_representation::{ODD_POWER_TOLERANCE, SymplecticRepresentation};
use crate::phase_spaces::cotangent::Cotangent;
use lie_poisson::{Covector, Momentum, Real, Representation, RepresentedElement, odd_power_defect};

/// The lift of a representation of 𝔤 on V to T∗V = V × V∗: ξ (q, p) = (ξq, −ξᵀp).
///
/// It preserves the canonical form dq ∧ dp. No group is needed, so that every Lie algebra has such representations.
///
/// Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, 2nd ed., §12.1.
///
/// # Example
/// ```
/// use lie_poisson::{Covector, InfinitesimalAdjoint, Representation, So3};
/// use momentum_map::{Cotangent, CotangentRepresentation};
/// use nalgebra::Vector3;
/// let (xi, q, p) = (Vector3::x(), Vector3::y(), Vector3::new(0.0, 2.0, 1.0));
/// let moved = CotangentRepresentation(InfinitesimalAdjoint(So3)).act(&xi, &Cotangent::new(q, Covector(p)));
/// assert_eq!(moved, Cotangent::new(xi.cross(&q), Covector(xi.cross(&p))));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CotangentRepresentation<R>(pub R);

impl<R: Representation> Representation for CotangentRepresentation<R> {
    type Algebra = R::Algebra;
    type Space<T: Real> = Cotangent<R::Space<T>>;

    fn algebra(&self) -> R::Algebra {
        self.0.algebra()
    }

    #[cfg_attr(optimised, inline(always))]
    fn act<T: Real>(&self, xi: &RepresentedElement<R, T>, z: &Self::Space<T>) -> Self::Space<T> {
        Cotangent { q: self.0.act::<T>(xi, &z.q), p: -self.0.transpose_act::<T>(xi, &z.p) }
    }

    /// Returns (ξᵀα, −ξv) for the covector (α, v) of T∗V.
    #[cfg_attr(optimised, inline(always))]
    fn transpose_act<T: Real>(
        &self,
        xi: &RepresentedElement<R, T>,
        alpha: &Covector<Self::Space<T>>,
    ) -> Covector<Self::Space<T>> {
        let by_q = self.0.transpose_act::<T>(xi, &Covector(alpha.0.q)).0;
        Covector(Cotangent { q: by_q, p: -Covector(self.0.act::<T>(xi, &alpha.0.p.0)) })
    }

    /// Returns q ◇ α − v ◇ p for the covector (α, v) of T∗V.
    #[cfg_attr(optimised, inline(always))]
    fn diamond<T: Real>(
        &self,
        z: &Self::Space<T>,
        alpha: &Covector<Self::Space<T>>,
    ) -> Momentum<R::Algebra, T> {
        let by_q = self.0.diamond::<T>(&z.q, &Covector(alpha.0.q));
        by_q - self.0.diamond::<T>(&alpha.0.p.0, &z.p)
    }
}

impl<R: Representation> SymplecticRepresentation for CotangentRepresentation<R> {
    /// Returns the canonical form Ω(u, v) = ⟨v.p, u.q⟩ − ⟨u.p, v.q⟩.
    #[cfg_attr(optimised, inline(always))]
    fn form<T: Real>(&self, u: &Self::Space<T>, v: &Self::Space<T>) -> T {
        pairing(&v.p, &u.q) - pairing(&u.p, &v.q)
    }

    #[cfg_attr(optimised, inline(always))]
    fn sharp<T: Real>(&self, alpha: &Covector<Self::Space<T>>) -> Self::Space<T> {
        Cotangent { q: alpha.0.p.0, p: -Covector(alpha.0.q) }
    }

    #[cfg_attr(optimised, inline(always))]
    fn flat<T: Real>(&self, x: &Self::Space<T>) -> Covector<Self::Space<T>> {
        Covector(Cotangent { q: -x.p.0, p: Covector(x.q) })
    }

    /// Returns whether the matrices of the representation on V contain their odd powers. The matrices on T∗V are
    /// pairs (ξ, −ξᵀ) and contain their odd powers under the same condition.
    fn odd_powers_belong(&self) -> bool {
        odd_power_defect(&self.0) <= ODD_POWER_TOLERANCE
    }
}

/// Returns the pairing ⟨p, q⟩.
#[inline]
fn pairing<V>(p: &Covector<V>, q: &V) -> V::Scalar
where
    V: lie_poisson::Vector<Dual = Covector<V>>,
{
    q.pairing(p)
}
