//! Viscous friction with a rate for each coordinate: [`ViscousTorque`].

use crate::error::StepError;
use crate::open_systems::torqued::TorqueFlow;
use crate::open_systems::torques::torque_error::{TorqueError, first_wrong};
use lie_poisson::{Real, State};

/// The torque Fᵢ = −cᵢ μᵢ of viscous friction, with a rate cᵢ ≥ 0 for each coordinate.
///
/// Its flow μᵢ ↦ exp(−cᵢ h) μᵢ is exact for any h, and its inverse for −h. The rates have the type `D` over the numbers `f64`,
/// and as many coordinates as a momentum; for momenta (μ, t) with the time they are `Pair(c, Time(0.0))`, which leaves the
/// time as it is. With equal rates every Casimir that is homogeneous of degree k decays as exp(−kct). Friction in other axes than those of the
/// coordinates is [`ViscousMatrix`](crate::ViscousMatrix).
///
/// The friction acts on the momentum. One that is proportional to the velocity ξ = dh(μ), −D dh, is of this kind if h is
/// quadratic: for a rigid body with moments of inertia Iᵢ the rates are Dᵢ/Iᵢ.
///
/// # Example
/// A body loses its spin about each axis at its own rate, whatever the size of the step:
/// ```
/// use collective_integrators::{StepError, TorqueFlow, ViscousTorque};
/// use lie_poisson::Covector;
/// use nalgebra::Vector3;
/// let water = ViscousTorque::new(Vector3::new(0.0, 0.5, 2.0))?;
/// let mut pi = Covector(Vector3::new(1.0, 2.0, 4.0));
/// water.flow(&mut pi, 3.0)?;
/// assert_eq!(pi.0, Vector3::new(1.0, 2.0 * (-1.5_f64).exp(), 4.0 * (-6.0_f64).exp()));
/// water.flow(&mut pi, -3.0)?;
/// assert!((pi.0 - Vector3::new(1.0, 2.0, 4.0)).norm() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViscousTorque<D> {
    rates: D,
}

impl<D: State<Scalar = f64>> ViscousTorque<D> {
    /// Creates friction from the rates of the coordinates.
    ///
    /// # Errors
    /// Returns [`TorqueError::Rate`] if a rate is negative, NaN or infinite.
    pub fn new(rates: D) -> Result<Self, TorqueError> {
        match first_wrong(&rates, |rate| rate.is_finite() && rate >= 0.0) {
            Some((coordinate, rate)) => Err(TorqueError::Rate { coordinate, rate }),
            None => Ok(Self { rates }),
        }
    }

    /// Returns the rates cᵢ.
    pub const fn rates(&self) -> &D {
        &self.rates
    }
}

impl<D: State<Scalar = f64>, V: State> TorqueFlow<V> for ViscousTorque<D> {
    /// Multiplies each coordinate by exp(−cᵢ h).
    ///
    /// # Errors
    /// Returns [`StepError::Dimension`] if μ has not as many coordinates as there are rates.
    fn flow(&self, mu: &mut V, step: f64) -> Result<(), StepError> {
        StepError::check_dimension(mu, self.rates.dimension())?;
        for i in 0..mu.dimension() {
            let decay = (-self.rates.coordinate(i) * step).exp();
            mu.set_coordinate(i, mu.coordinate(i) * V::Scalar::from_f64(decay));
        }
        Ok(())
    }
}
