//! The cotangent lift of an action: [`CotangentLift`].

use crate::actions::action::{ActingElement, ActionPoint, Generator, GroupAction, Side};
use crate::phase_spaces::cotangent::{Cotangent, CotangentBundle};
use lie_poisson::{DualNumber, LieGroup, Real, map_coordinates, transposed_tangent};

/// The cotangent lift of an action on Q to T∗Q, derived from the action:
///
/// ```text
/// T*Φ_g⁻¹(q, p) = (Φ_g(q), p ∘ TΦ_g⁻¹)
/// generator of the lift: ξ_(T*Q)(q, p) = (ξ_Q(q), −(Dξ_Q(q))ᵀ p)
/// ```
///
/// It acts on the same side as the action, and conserves the canonical form Θ = p dq.
///
/// Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, 2nd ed., §6.3; Ohsawa 2019,
/// §2.2.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CotangentLift<A>(pub A);

impl<A: GroupAction> GroupAction for CotangentLift<A> {
    type Group = A::Group;
    type Space = CotangentBundle<A::Space>;
    const SIDE: Side = A::SIDE;

    fn group(&self) -> A::Group {
        self.0.group()
    }

    fn space(&self) -> Self::Space {
        CotangentBundle(self.0.space())
    }

    fn act<T: Real>(
        &self,
        g: &ActingElement<A, T>,
        z: &ActionPoint<Self, T>,
    ) -> ActionPoint<Self, T> {
        let q = self.0.act::<T>(g, &z.q);
        let back = self.0.group().inverse::<T>(g);
        let back: ActingElement<A, DualNumber<T>> = map_coordinates(&back, DualNumber::constant);
        let undo = |q: &ActionPoint<A, DualNumber<T>>| self.0.act::<DualNumber<T>>(&back, q);
        Cotangent { q, p: transposed_tangent(undo, &q, &z.p) }
    }

    #[cfg_attr(optimised, inline(always))]
    fn infinitesimal_generator<T: Real>(
        &self,
        xi: &Generator<A, T>,
        z: &ActionPoint<Self, T>,
    ) -> ActionPoint<Self, T> {
        self.0.lifted_generator::<T>(xi, z)
    }
}
