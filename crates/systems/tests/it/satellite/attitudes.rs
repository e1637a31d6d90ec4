//! Satellites with their directions, and the integrators of the tests.

use collective_integrators::{Collective, Driven, RungeKutta};
use lie_poisson::TimeDependent;
use lie_poisson_systems::{Satellite, SatelliteDual, SatelliteOnEllipse};
use momentum_map::{TWO_FIELDS, TwoFieldRealisation};
use nalgebra::{Rotation3, Vector3};

/// The collective integrator of a satellite on a circle.
pub type OnCircle = Collective<RungeKutta, TwoFieldRealisation, Satellite>;

/// The collective integrator of a satellite on an ellipse.
pub type OnEllipse = Driven<RungeKutta, TwoFieldRealisation, TimeDependent<SatelliteOnEllipse>>;

pub fn on_circle(scheme: RungeKutta, satellite: Satellite) -> OnCircle {
    Collective::new(scheme, TWO_FIELDS, satellite)
}

pub fn on_ellipse(scheme: RungeKutta, satellite: SatelliteOnEllipse) -> OnEllipse {
    Driven::new(scheme, TWO_FIELDS, TimeDependent(satellite))
}

/// Returns Γ₁ and Γ₂ seen from a body that has turned from the axes of the orbit by a rotation vector, in its own
/// frame: with no rotation, e₁ is along the velocity, e₂ along the normal, and e₃ along the radius.
pub fn directions(turn: Vector3<f64>) -> [Vector3<f64>; 2] {
    let seen = Rotation3::new(-turn);
    [seen * Vector3::z(), seen * Vector3::y()]
}

/// Returns the angle by which a body has turned about the normal, from its view of the radius.
pub fn pitch(mu: &SatelliteDual) -> f64 {
    let radial = mu.0.1.0[0];
    -radial.x.atan2(radial.z)
}
