//! Actions of Lie groups on vector spaces.

use lie_poisson::{
    AlgebraElement, DualNumber, LieGroup, Point, Real, Sign, VectorSpace, derivative_part,
    map_coordinates,
};

/// On which side a group acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Φ_g ∘ Φ_h = Φ_{gh}
    Left,
    /// Φ_g ∘ Φ_h = Φ_{hg}
    Right,
}

impl Side {
    /// The sign of the Lie–Poisson bracket for which the momentum map of such an action is a
    /// Poisson map: plus for left actions, minus for right ones.
    ///
    /// Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, 2nd ed., Thm. 12.4.1.
    #[must_use]
    pub const fn lie_poisson_sign(self) -> Sign {
        match self {
            Self::Left => Sign::Plus,
            Self::Right => Sign::Minus,
        }
    }

    /// The other side.
    #[must_use]
    pub const fn opposite(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }

    /// This side, for two actions that must be on the same one.
    ///
    /// # Panics
    /// If they are not; as the side of an action is a constant, this stops the compiler, never a
    /// running program.
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

/// g ∈ G of an action, over the scalar `T`.
pub type ActingElement<A, T = f64> = <<A as GroupAction>::Group as LieGroup>::Element<T>;

/// ξ ∈ 𝔤 of an action, over the scalar `T`.
pub type Generator<A, T = f64> = AlgebraElement<<A as GroupAction>::Group, T>;

/// A smooth action Φ: G × Q → Q on a vector space; it need not be linear.
///
/// Only `act` is asked for. The infinitesimal generators follow from it through exp, and the
/// [cotangent lift](crate::CotangentLift) and the [momentum map](crate::MomentumMap) from them.
///
/// # Example
/// Rotations of space, R³ ∋ q ↦ Rᵀq, a right action of SO(3):
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
    /// G
    type Group: LieGroup;

    /// Q
    type Space: VectorSpace;

    /// Left or right.
    const SIDE: Side;

    /// G as a value.
    fn group(&self) -> Self::Group;

    /// Q as a value.
    fn space(&self) -> Self::Space;

    /// Φ_g(q)
    fn act<T: Real>(
        &self,
        g: &ActingElement<Self, T>,
        q: &ActionPoint<Self, T>,
    ) -> ActionPoint<Self, T>;

    /// The infinitesimal generator ξ_Q(q) = d/ds Φ_{exp(sξ)}(q) at s = 0.
    ///
    /// Derived: exp and Φ are evaluated at s = 0 + ε, which is exact.
    fn infinitesimal_generator<T: Real>(
        &self,
        xi: &Generator<Self, T>,
        q: &ActionPoint<Self, T>,
    ) -> ActionPoint<Self, T> {
        let along: Generator<Self, DualNumber<T>> =
            map_coordinates(xi, |x| DualNumber { value: T::zero(), derivative: x });
        let g = self.group().exp::<DualNumber<T>>(&along);
        let q: ActionPoint<Self, DualNumber<T>> = map_coordinates(q, DualNumber::constant);
        derivative_part(&self.act::<DualNumber<T>>(&g, &q))
    }
}
