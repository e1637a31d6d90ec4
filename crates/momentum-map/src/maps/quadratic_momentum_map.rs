//! The momentum maps of linear symplectic actions: [`QuadraticMomentumMap`].

use crate::actions::action::Side;
use crate::maps::poisson_map::{PoissonMap, SourcePoint, TargetDifferential, TargetPoint};
use crate::maps::symplectic_representation::{Symplectic, SymplecticRepresentation};
use lie_poisson::{Differential, LiePoisson, Real, Vector};

/// The momentum map of a linear symplectic action, derived from its representation:
///
/// ```text
/// ⟨J(z), ξ⟩ = ½ Ω(ξ_P z, z),    ξ_P z = ξz for the left action, −ξz for the right one
/// ```
///
/// The generator is ξ_P z. In terms of the diamond product and of the covector Ω(z, ·), the map is J(z) = ∓½ z ◇ Ω(z,
/// ·), with the minus sign for the left action. Three maps of this kind share this code: to so(3)∗ from C² by the
/// Hopf map, to sl(2, R)∗ from R²ⁿ, and to u(N)∗ by outer products.
///
/// Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, 2nd ed., Ch. 12
/// (linear symplectic actions); McLachlan, Modin & Verdier, *Collective symplectic integrators*,
/// Nonlinearity 27 (2014), §4.
///
/// # Example
/// The right action of SL(2, R) on the plane has J = −(qp, ½p², −½q²), whose image is a cone in sl(2, R)∗:
/// ```
/// use lie_poisson::{Casimirs, SL2OnR2, Sl2};
/// use momentum_map::{PoissonMap, QuadraticMomentumMap, Side};
/// use nalgebra::Vector2;
/// let map = QuadraticMomentumMap::new(SL2OnR2, Side::Right);
/// let j = map.apply(&Vector2::new(3.0, 4.0));
/// assert_eq!(Sl2.casimir(0, &j), 0.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct QuadraticMomentumMap<R> {
    representation: R,
    side: Side,
}

impl<R: SymplecticRepresentation> QuadraticMomentumMap<R> {
    /// Creates the momentum map of the action v ↦ gv (left) or v ↦ g⁻¹v (right).
    pub const fn new(representation: R, side: Side) -> Self {
        Self { representation, side }
    }

    /// Returns the representation of the action.
    pub const fn representation(&self) -> &R {
        &self.representation
    }

    /// Returns the side of the action.
    pub const fn side(&self) -> Side {
        self.side
    }
}

impl<R: SymplecticRepresentation> PoissonMap for QuadraticMomentumMap<R> {
    type Source = Symplectic<R>;
    type Target = LiePoisson<R::Algebra>;

    fn source(&self) -> Symplectic<R> {
        Symplectic(self.representation.clone())
    }

    fn target(&self) -> Self::Target {
        LiePoisson::new(self.representation.algebra(), self.side.lie_poisson_sign())
    }

    #[cfg_attr(optimised, inline(always))]
    fn apply<T: Real>(&self, z: &SourcePoint<Self, T>) -> TargetPoint<Self, T> {
        let twice = self.representation.diamond::<T>(z, &self.representation.flat::<T>(z));
        twice.scaled(T::from_f64(match self.side {
            Side::Left => -0.5,
            Side::Right => 0.5,
        }))
    }

    /// Returns the covector i_X Ω for the generator X, which is the Hamiltonian vector field of z ↦ ⟨J(z), ξ⟩.
    #[cfg_attr(optimised, inline(always))]
    fn pull_back<T: Real>(
        &self,
        xi: &TargetDifferential<Self, T>,
        z: &SourcePoint<Self, T>,
    ) -> Differential<Self::Source, T> {
        self.representation.flat::<T>(&self.generator::<T>(xi, z))
    }

    #[cfg_attr(optimised, inline(always))]
    fn generator<T: Real>(
        &self,
        xi: &TargetDifferential<Self, T>,
        z: &SourcePoint<Self, T>,
    ) -> SourcePoint<Self, T> {
        let velocity = self.representation.act::<T>(xi, z);
        match self.side {
            Side::Left => velocity,
            Side::Right => -velocity,
        }
    }

    /// Returns the value of [`SymplecticRepresentation::odd_powers_belong`].
    fn equivariant_maps_descend(&self) -> bool {
        self.representation.odd_powers_belong()
    }
}
