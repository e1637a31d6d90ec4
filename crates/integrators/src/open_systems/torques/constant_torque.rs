//! Constant torques: [`ConstantTorque`].

use crate::error::StepError;
use crate::open_systems::torqued::TorqueFlow;
use crate::open_systems::torques::torque_error::{TorqueError, first_wrong};
use lie_poisson::{Real, State};

/// A torque F that is constant in the coordinates of 𝔤∗, such as that of a motor that turns with the body.
///
/// Its flow μ ↦ μ + hF is exact. F has the type `D` over the numbers `f64`, and as many coordinates as a momentum; for momenta
/// (μ, t) with the time it is `Pair(F, Time(0.0))`, which leaves the time as it is. The coordinates of F are those of dμ/dt, so
/// that dC/dt = ⟨dC, F⟩ for a Casimir C.
///
/// # Example
/// A body that a motor turns about its axis of symmetry, from Π₃ = ½ by the torque 2, so that Π₃(3) = 6½:
/// ```
/// use collective_integrators::{Collective, ConstantTorque, RungeKutta, Start, Torqued};
/// use lie_poisson::{Covector, LiePoisson, So3, from_closure};
/// use momentum_map::HOPF;
/// use nalgebra::Vector3;
/// let h = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| (pi.x * pi.x + pi.y * pi.y) * 0.5 + pi.z * pi.z);
/// let motor = ConstantTorque::new(Covector(Vector3::new(0.0, 0.0, 2.0)))?;
/// let body = Torqued::new(Collective::new(RungeKutta::implicit_midpoint(), HOPF, h), motor);
/// let end = body.after(&Covector(Vector3::new(1.0, 0.0, 0.5)), 0.1, 30)?.momentum.0;
/// assert!((end.z - 6.5).abs() < 1e-12 && (end.xy().norm() - 1.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConstantTorque<D> {
    torque: D,
}

impl<D: State<Scalar = f64>> ConstantTorque<D> {
    /// Creates a torque from its coordinates.
    ///
    /// # Errors
    /// Returns [`TorqueError::NotFinite`] if a coordinate is NaN or infinite.
    pub fn new(torque: D) -> Result<Self, TorqueError> {
        match first_wrong(&torque, f64::is_finite) {
            Some((coordinate, number)) => Err(TorqueError::NotFinite { coordinate, number }),
            None => Ok(Self { torque }),
        }
    }

    /// Returns the torque F.
    pub const fn torque(&self) -> &D {
        &self.torque
    }
}

impl<D: State<Scalar = f64>, V: State> TorqueFlow<V> for ConstantTorque<D> {
    /// Adds hF.
    ///
    /// # Errors
    /// Returns [`StepError::Dimension`] if μ has not as many coordinates as F.
    fn flow(&self, mu: &mut V, step: f64) -> Result<(), StepError> {
        StepError::check_dimension(mu, self.torque.dimension())?;
        for i in 0..mu.dimension() {
            let change = V::Scalar::from_f64(step * self.torque.coordinate(i));
            mu.set_coordinate(i, mu.coordinate(i) + change);
        }
        Ok(())
    }
}
