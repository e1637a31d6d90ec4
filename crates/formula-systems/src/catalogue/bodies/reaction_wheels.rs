//! A rigid body that motors turn by reaction wheels.

use super::wheels::{AXES, MOMENTS, SPEEDS, Wheels};
use crate::catalogue::parameter::Parameter;
use crate::catalogue::system_kind::{Description, Given, KindError, KindStart, SystemKind};
use nalgebra::Vector3;

/// A rigid body that turns freely, with balanced wheels about axes `a_k` in the body.
///
/// Π is the angular momentum of the body with its wheels, I has the moments of both without those of the wheels about their own axes,
/// and `l_k` is the angular momentum of a wheel about its axis, against the stars:
///
/// ```text
/// h = ½ q·I⁻¹q + Σ_k l_k²/(2 J_k),    q = Π − Σ_k l_k a_k,    Ω = I⁻¹q
/// dΠ/dt = Π × Ω,    dl_k/dt = u_k
/// ```
///
/// Without motors u = 0: the wheels turn freely. The torques of motors on the wheels are a torque on l, by tables or formulas; what they
/// exert on the body is the other half of the same force, so that |Π| is conserved, whatever they do. They change h by
/// Σ `u_k` (`l_k`/`J_k` − `a_k`·Ω), the torques times the speeds of the wheels against the body.
///
/// A start may be given by the angular velocity of the body and by these speeds. The algebra is so(3) ⊕ R^N. The Casimirs are the
/// `l_k` and |Π|².
///
/// Source: P. C. Hughes, *Spacecraft Attitude Dynamics* (1986), ch. 3.
pub(in crate::catalogue) const REACTION_WHEELS: SystemKind = SystemKind {
    name: "reaction-wheels",
    about: "a free rigid body with reaction wheels about any axes, whose motors are a torque on l",
    parameters: &[
        Parameter::vector("I", 3, "moments without those of the wheels about their axes, kg m²"),
        AXES,
        MOMENTS,
    ],
    describe,
    orbit: None,
    directions: &[],
    start: Some(KindStart {
        given: &[
            Parameter::vector("Omega", 3, "angular velocity of the body, rad/s").or(&[0.0; 3]),
            SPEEDS.or(&[]),
        ],
        coordinates,
    }),
};

fn describe(given: &Given<'_>) -> Result<Description, KindError> {
    given.require_moments("I")?;
    let wheels = wheels(given)?;
    Ok(Description {
        algebra: wheels.algebra("so(3)", &["Pi"])?,
        hamiltonian: wheels.energy(),
        parameters: wheels.parameters(given.parameters(&["I"])?)?,
        has_plus_bracket: false,
    })
}

fn wheels(given: &Given<'_>) -> Result<Wheels, KindError> {
    let wheels = Wheels::of(given)?;
    match wheels.are_none() {
        true => Err(KindError::Value(AXES.name, "those of one wheel at least".into())),
        false => Ok(wheels),
    }
}

fn coordinates(system: &Given<'_>, start: &Given<'_>) -> Result<Vec<f64>, KindError> {
    let omega = Vector3::from_iterator(start.values("Omega"));
    let (pi, l) = wheels(system)?.momenta(&system.values("I"), omega, start)?;
    Ok(pi.iter().copied().chain(l).collect())
}
