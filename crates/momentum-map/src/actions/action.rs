//! Actions of Lie groups on vector spaces: [`GroupAction`].

use crate::phase_spaces::cotangent::Cotangent;
use lie_poisson::{
    AlgebraElement, DualNumber, GroupMomentum, LieGroup, Point, Real, Sign, Vector, VectorSpace,
    derivative_part, map_coordinates, transposed_tangent,
};

/// The side on which a group acts, left or right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Side {
    /// The group acts from the left: Φ_g ∘ Φ_h = Φ_gh.
    Left,
    /// The group acts from the right: Φ_g ∘ Φ_h = Φ_hg.
    Right,
}

impl Side {
    /// Returns the sign of the Lie–Poisson bracket for which momentum maps of actions on this side are Poisson maps.
    ///
    /// It is plus for left actions and minus for right actions.
    ///
    /// Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, 2nd ed., Thm. 12.4.1.
    #[must_use]
    pub const fn lie_poisson_sign(self) -> Sign {
        match self {
            Self::Left => Sign::Plus,
            Self::Right => Sign::Minus,
        }
    }

    /// Returns the opposite side: right for left, left for right.
    #[must_use]
    pub const fn opposite(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }

    /// Returns this side, which must equal `other`: two combined actions must be on the same side.
    ///
    /// # Panics
    /// It panics if the sides differ. The side of an action is a constant, so the panic stops the compiler
    /// and never a running program.
    #[allow(clippy::panic)]
    pub(crate) const fn same_as(self, other: Self) -> Self {
        match (self, other) {
            (Self::Left, Self::Left) | (Self::Right, Self::Right) => self,
            _ => panic!("the two actions are on different sides"),
        }
    }
}

/// A point of the space that a group acts on, over the scalar `T`.
pub type ActionPoint<A, T = f64> = Point<<A as GroupAction>::Space, T>;

/// An element g ∈ G of the group of an action, over the scalar `T`.
pub type ActingElement<A, T = f64> = <<A as GroupAction>::Group as LieGroup>::Element<T>;

/// An element ξ ∈ 𝔤 of the Lie algebra of an action, over the scalar `T`.
pub type Generator<A, T = f64> = AlgebraElement<<A as GroupAction>::Group, T>;

/// A smooth action Φ: G × Q → Q of a Lie group on a vector space, not necessarily linear.
///
/// Only `act` is required. The infinitesimal generators follow from it through exp, and the [cotangent
/// lift](crate::CotangentLift) and the [momentum map](crate::MomentumMap) follow from the generators.
///
/// All derived maps are exact, but dual numbers cost time. To make an action of your own as fast as formulas written
/// by hand, implement these methods in this order, as far as you need:
///
/// | method | its formula | what it speeds up |
/// |---|---|---|
/// | [`infinitesimal_generator`](Self::infinitesimal_generator) | ξ_Q(q) | everything, since exp is no longer differentiated |
/// | [`momentum`](Self::momentum) | ⟨J(q, p), ξ⟩ = ⟨p, ξ_Q(q)⟩ | `apply` of the momentum map |
/// | [`lifted_generator`](Self::lifted_generator) | (ξ_Q(q), −(Dξ_Q(q))ᵀ p) | `generator` of the momentum map |
///
/// The actions of this crate implement all three, by the formulas of their representations or of their parts. The
/// law suites compare each with its definition.
///
/// # Example
/// Rotations of space by q ↦ Rᵀq, a right action of SO(3) on R³:
/// ```
/// use lie_poisson::{LieGroup, Real, RealSpace, SO3};
/// use momentum_map::{GroupAction, Side};
/// use nalgebra::{Matrix3, Vector3};
///
/// #[derive(Clone)]
/// struct Rotations;
/// impl GroupAction for Rotations {
///     type Group = SO3;
///     type Space = RealSpace<3>;
///     const SIDE: Side = Side::Right;
///     fn group(&self) -> SO3 { SO3 }
///     fn space(&self) -> RealSpace<3> { RealSpace }
///     fn act<T: Real>(&self, g: &Matrix3<T>, q: &Vector3<T>) -> Vector3<T> {
///         g.transpose() * q
///     }
/// }
/// // ξ_Q(q) = −ξ × q
/// let (xi, q) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(0.5, 0.0, 1.0));
/// assert_eq!(Rotations.infinitesimal_generator(&xi, &q), -xi.cross(&q));
/// ```
pub trait GroupAction: Clone {
    /// The Lie group G that acts.
    type Group: LieGroup;

    /// The space Q on which the group acts.
    type Space: VectorSpace;

    /// The side on which the group acts, left or right.
    const SIDE: Side;

    /// Returns the group G as a value.
    fn group(&self) -> Self::Group;

    /// Returns the space Q as a value.
    fn space(&self) -> Self::Space;

    /// Returns Φ_g(q), the action of g on q.
    fn act<T: Real>(
        &self,
        g: &ActingElement<Self, T>,
        q: &ActionPoint<Self, T>,
    ) -> ActionPoint<Self, T>;

    /// Returns the infinitesimal generator ξ_Q(q), the derivative d/ds Φ(exp(sξ), q) at s = 0.
    ///
    /// The default implementation evaluates exp and Φ at the dual number s = 0 + ε, which gives the exact
    /// derivative.
    fn infinitesimal_generator<T: Real>(
        &self,
        xi: &Generator<Self, T>,
        q: &ActionPoint<Self, T>,
    ) -> ActionPoint<Self, T> {
        let along: Generator<Self, DualNumber<T>> =
            map_coordinates(xi, |x| DualNumber::new(T::zero(), x));
        let g = self.group().exp::<DualNumber<T>>(&along);
        let q: ActionPoint<Self, DualNumber<T>> = map_coordinates(q, DualNumber::constant);
        derivative_part(&self.act::<DualNumber<T>>(&g, &q))
    }

    /// Returns the momentum J(q, p) ∈ 𝔤∗ of the action lifted to T∗Q, with ⟨J(q, p), ξ⟩ = ⟨p, ξ_Q(q)⟩.
    ///
    /// The default implementation evaluates one infinitesimal generator for each coordinate of 𝔤.
    ///
    /// Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, 2nd ed., Thm. 12.1.4.
    fn momentum<T: Real>(
        &self,
        z: &Cotangent<ActionPoint<Self, T>>,
    ) -> GroupMomentum<Self::Group, T> {
        GroupMomentum::<Self::Group, T>::from_coordinates(|i| {
            self.infinitesimal_generator::<T>(&Vector::basis(i), &z.q).pairing(&z.p)
        })
    }

    /// Returns the infinitesimal generator (ξ_Q(q), −(Dξ_Q(q))ᵀ p) of the action lifted to T∗Q.
    ///
    /// It is the Hamiltonian vector field of the function z ↦ ⟨J(z), ξ⟩. The default implementation
    /// differentiates the infinitesimal generator by dual numbers, once for each coordinate of Q.
    ///
    /// Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, 2nd ed., §12.1.
    fn lifted_generator<T: Real>(
        &self,
        xi: &Generator<Self, T>,
        z: &Cotangent<ActionPoint<Self, T>>,
    ) -> Cotangent<ActionPoint<Self, T>> {
        let constant: Generator<Self, DualNumber<T>> = map_coordinates(xi, DualNumber::constant);
        let field = |q: &ActionPoint<Self, DualNumber<T>>| {
            self.infinitesimal_generator::<DualNumber<T>>(&constant, q)
        };
        Cotangent {
            q: self.infinitesimal_generator::<T>(xi, &z.q),
            p: -transposed_tangent(field, &z.q, &z.p),
        }
    }
}
