//! The states of a top with given energy and vertical angular momentum.

use crate::tops::top::HeavyTop;
use lie_poisson::{Se3Dual, State};
use nalgebra::Vector3;

/// The level set h = E, Π·Γ = c, |Γ| = 1 of a top in se(3)∗, of dimension 3.
///
/// The states over each Γ form an ellipse. With the momentum of least energy that has Π·Γ = c,
///
/// ```text
/// Π = c IΓ/(Γ·IΓ) + p,  p·Γ = 0:    h = U_c(Γ) + ½ p·I⁻¹p,    U_c(Γ) = m g l Γ·c + c²/(2 Γ·IΓ)
/// ```
///
/// where the *amended potential* U_c must not exceed E. If Π_i is given as well, i = 1, 2, 3, two states
/// remain. With u = e_i × Γ and w = Γ × I⁻¹u, where w·I⁻¹u = 0, they are
///
/// ```text
/// p = αw ± βu,   α = (Π_i − c (IΓ)_i/(Γ·IΓ))/(u·I⁻¹u),   β = √(2(E − U_c − ½α² w·I⁻¹w)/(u·I⁻¹u)),
/// dΓ_i/dt = ±β u·I⁻¹u.
/// ```
///
/// Source: S. Smale, *Topology and mechanics*, Invent. Math. 10 (1970), for the amended potential;
/// the rest is linear algebra.
///
/// # Example
/// ```
/// use heavytop::{EnergyLevel, HeavyTop, Invariant};
/// use nalgebra::Vector3;
/// let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
/// let level = EnergyLevel { top, energy: 2.0, vertical_momentum: 0.3 };
/// for mu in level.states(&Vector3::new(0.6, 0.0, 0.8), 2, 0.5).ok_or("not accessible")? {
///     assert!((Invariant::Energy.value(&top, &mu) - 2.0).abs() < 1e-15);
///     assert!((Invariant::VerticalMomentum.value(&top, &mu) - 0.3).abs() < 1e-15);
///     assert!((mu.0.0.z - 0.5).abs() < 1e-15);
/// }
/// // 9 kg m²/s about e₃ take more energy than that
/// assert_eq!(level.states(&Vector3::new(0.6, 0.0, 0.8), 2, 9.0), None);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct EnergyLevel {
    /// The heavy top.
    pub top: HeavyTop,
    /// The energy E of the states, J.
    pub energy: f64,
    /// The vertical angular momentum c = Π·Γ, kg m²/s.
    pub vertical_momentum: f64,
}

/// The states over Γ with a given Π_i, without their component along u.
struct Slowest {
    /// The momentum Π without ±βu.
    pi: Vector3<f64>,
    /// The direction u = e_i × Γ of the remaining component.
    along: Vector3<f64>,
    /// The inverse moment u·I⁻¹u along u.
    mobility: f64,
    /// The energy of (Π, Γ) with β = 0.
    energy: f64,
}

impl EnergyLevel {
    /// Returns the two states over a unit vector Γ in which Π has the component `momentum` (kg m²/s) along
    /// the principal axis 0, 1 or 2.
    ///
    /// The first has dΓ/dt ≥ 0 along that axis, the other dΓ/dt ≤ 0. There are none if the energy is too low, if Γ is
    /// along that axis, if the momentum overflows, or if the top is a thin rod, whose Π is not free.
    #[must_use]
    pub fn states(&self, gamma: &Vector3<f64>, axis: usize, momentum: f64) -> Option<[Se3Dual; 2]> {
        self.states_along(gamma, &Vector3::ith(axis.min(2), 1.0), momentum)
    }

    /// Returns the two states over Γ in which Π has the component `momentum` along a unit vector.
    pub(crate) fn states_along(
        &self,
        gamma: &Vector3<f64>,
        axis: &Vector3<f64>,
        momentum: f64,
    ) -> Option<[Se3Dual; 2]> {
        let Slowest { pi, along, mobility, energy } = self.slowest(gamma, axis, momentum)?;
        let square = 2.0 * (self.energy - energy) / mobility;
        if square.is_nan() || square < 0.0 {
            return None;
        }
        let states =
            [square.sqrt(), -square.sqrt()].map(|beta| Se3Dual::new(pi + along * beta, *gamma));
        states.iter().all(State::is_finite).then_some(states)
    }

    /// Returns the amended potential U_c(Γ), J: the least energy over Γ on Π·Γ = c.
    ///
    /// For c = 0 it is the potential energy m g l Γ·c, also where Γ is along a thin rod, about which the moment is 0. There
    /// it is infinite for every other c.
    #[must_use]
    pub fn amended_potential(&self, gamma: &Vector3<f64>) -> f64 {
        let height = self.top.weight_moment() * gamma.dot(&self.top.center_of_mass());
        if self.vertical_momentum == 0.0 {
            return height;
        }
        let moment = self.top.inertia().component_mul(gamma).dot(gamma);
        height + self.vertical_momentum * self.vertical_momentum / (2.0 * moment)
    }

    /// Returns the least energy over Γ on Π·Γ = c where Π has the component `momentum` along a unit vector.
    pub(crate) fn least_energy(
        &self,
        gamma: &Vector3<f64>,
        axis: &Vector3<f64>,
        momentum: f64,
    ) -> f64 {
        self.slowest(gamma, axis, momentum).map_or(f64::INFINITY, |slowest| slowest.energy)
    }

    fn slowest(&self, gamma: &Vector3<f64>, axis: &Vector3<f64>, momentum: f64) -> Option<Slowest> {
        let top = &self.top;
        if top.rod_axis().is_some() {
            return None;
        }
        let along = axis.cross(gamma);
        let mobility = along.dot(&top.angular_velocity(&along));
        if mobility <= 0.0 {
            return None;
        }
        let moments = top.inertia().component_mul(gamma);
        let rotation = moments * (self.vertical_momentum / moments.dot(gamma));
        let across = gamma.cross(&top.angular_velocity(&along));
        let across = across * ((momentum - rotation.dot(axis)) / mobility);
        let kinetic = 0.5 * across.dot(&top.angular_velocity(&across));
        let energy = self.amended_potential(gamma) + kinetic;
        Some(Slowest { pi: rotation + across, along, mobility, energy })
    }
}
