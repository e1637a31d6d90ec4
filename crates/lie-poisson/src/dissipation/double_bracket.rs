//! Dissipation that stays on coadjoint orbits: [`DoubleBracket`].

use crate::brackets::poisson::PoissonSpace;
use crate::dissipation::dissipation_error::DissipationError;
use crate::orbits::inner_product::InnerProduct;
use crate::orbits::orbit_field::OrbitField;
use generic_scalars::{Differential, Point, Real, Vector};

/// The field of a double bracket,
///
/// ```text
/// ξ = ξ₀ + θ (Λ ξ₀)♯,    with ξ₀ the field that is damped and ♯: 𝔤∗ → 𝔤 an inner product
/// ```
///
/// For ξ₀ = dh the energy falls, dh/dt = −θ |Λ dh|², until Λ dh = 0, and the motion stays on its coadjoint orbit. On
/// so(3)∗ with the Euclidean inner product it is dΠ/dt = Π × Ω + θ Π × (Π × Ω), the equation of Landau and Lifshitz.
/// The friction θ has the unit 1/μ, if ♯ has none.
///
/// Sources: Brockett, Linear Algebra Appl. 146 (1991); Bloch, Krishnaprasad, Marsden & Ratiu, Commun. Math. Phys. 175
/// (1996).
///
/// # Example
/// A spin in the field e₃, h = −Π₃, turns towards it:
/// ```
/// use lie_poisson::{Autonomous, Covector, DoubleBracket, InnerProduct, LiePoisson, OrbitField, PoissonSpace, So3};
/// use lie_poisson::from_closure;
/// use nalgebra::Vector3;
/// let h = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| -pi.z);
/// let space = LiePoisson::minus(So3);
/// let inner_product = InnerProduct::euclidean();
/// let damped = DoubleBracket::new(space, Autonomous(h), 0.5, inner_product)?;
/// let pi = Covector(Vector3::new(0.6, 0.0, 0.8));
/// let rate = space.hamiltonian_vector(&pi, &damped.element(&pi, 0.0)).0;
/// assert!((rate.z - 0.5 * 0.36).abs() < 1e-15); // θ |Π × e₃|²
/// assert!(rate.dot(&pi.0).abs() < 1e-15);
/// assert!(DoubleBracket::new(space, damped.field(), -0.5, InnerProduct::euclidean()).is_err());
/// # Ok::<(), lie_poisson::DissipationError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct DoubleBracket<P, X> {
    space: P,
    field: X,
    friction: f64,
    inner_product: InnerProduct,
}

impl<P, X> DoubleBracket<P, X> {
    /// Creates a damped field from the space with its bracket, the field ξ₀, the friction θ and the inner product ♯.
    ///
    /// # Errors
    /// Returns [`DissipationError::Friction`] if θ is negative, infinite or NaN.
    pub fn new(
        space: P,
        field: X,
        friction: f64,
        inner_product: InnerProduct,
    ) -> Result<Self, DissipationError> {
        DissipationError::require_friction(friction)?;
        Ok(Self { space, field, friction, inner_product })
    }

    /// Returns the field ξ₀ that is damped.
    pub const fn field(&self) -> &X {
        &self.field
    }

    /// Returns the friction θ.
    pub const fn friction(&self) -> f64 {
        self.friction
    }
}

impl<P, X, T> OrbitField<P, T> for DoubleBracket<P, X>
where
    P: PoissonSpace,
    X: OrbitField<P, T>,
    T: Real,
{
    #[cfg_attr(optimised, inline(always))]
    fn element(&self, mu: &Point<P, T>, time: T) -> Differential<P, T> {
        let xi = self.field.element(mu, time);
        let rate = self.space.hamiltonian_vector::<T>(mu, &xi);
        let sharp = self.inner_product.sharp::<P, T>(&rate);
        let friction = T::from_f64(self.friction);
        xi + sharp.scaled(friction)
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        self.field.next_break(time, forward)
    }
}
