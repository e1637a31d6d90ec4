//! A satellite in the gradient of gravity.

use super::wheels::{AXES, MOMENTS, SPEEDS, Wheels};
use crate::catalogue::parameter::Parameter;
use crate::catalogue::system_kind::{
    Description, ECCENTRICITY, Given, KindError, KindStart, ORBIT, Sign, SystemKind,
};
use lie_poisson_systems::KeplerOrbit;
use nalgebra::Vector3;

/// A rigid satellite on a circle or an ellipse, whose attitude is turned by the gradient of gravity.
///
/// In the frame of the body, Π is the angular momentum against the stars, Γ₁ the direction from the centre of
/// attraction to the satellite and Γ₂ the normal of the orbit, on which the satellite turns about the centre at the
/// rate n:
///
/// ```text
/// h = Σ_i Π_i²/(2 I_i) − n Π·Γ₂ + (3/2) n² Σ_i I_i Γ₁ᵢ²,    Ω_i = Π_i/I_i
/// dΠ/dt = Π × Ω + 3n² Γ₁ × IΓ₁,    dΓ_k/dt = Γ_k × (Ω − n Γ₂)
/// ```
///
/// On an ellipse n is the mean motion, and the rate dν/dt = n √(1 − e²)/u² stands for n in h, the tide GM/r³ = n²/u³ for n², with the
/// ratio u = r/a of a [`KeplerOrbit`].
///
/// Reaction wheels may be in the body, as in [`REACTION_WHEELS`](super::reaction_wheels::REACTION_WHEELS): with q = Π − Σ `l_k a_k` the
/// kinetic energy is ½ q·I⁻¹q + Σ `l_k`²/(2 `J_k`), and the tide acts on I and on the moments `J_k` about the axes. The algebra is then
/// the sum with R^N.
///
/// h is Jacobi's integral on a circle. The algebra is so(3) ⋉ (R³ ⊕ R³). The Casimirs are |Γ₁|², Γ₁·Γ₂ and |Γ₂|².
///
/// A start may be given by a yaw y about the radius, a pitch p about the normal and a roll r about the velocity, in
/// this order, each about the axis of the body that is there without the others: e₃, e₂ and e₁. The relative velocity
/// is that against the frame of the orbit, in the frame of the body.
///
/// Source: P. C. Hughes, *Spacecraft Attitude Dynamics* (1986), ch. 9.
pub(in crate::catalogue) const SATELLITE: SystemKind = SystemKind {
    name: "satellite",
    about: "a satellite on a circle or an ellipse, turned by the gradient of gravity",
    parameters: &[
        Parameter::vector("I", 3, "principal moments, kg m²"),
        Parameter::number("n", "angular velocity of the orbit, its mean on an ellipse, rad/s"),
        Parameter::number(ECCENTRICITY, "of the orbit, below 1").or(&[0.0]),
        Parameter::number("mean_anomaly", "at t = 0, rad, 0 at the pericentre").or(&[0.0]),
        Parameter::number("true_anomaly", "at t = 0, rad, instead of it").or(&[0.0]),
        AXES.or(&[]),
        MOMENTS.or(&[]),
    ],
    describe,
    orbit: Some(orbit),
    directions: &["Gamma_1", "Gamma_2"],
    start: Some(KindStart {
        given: &[
            Parameter::number("roll", "about e1, along the velocity, rad").or(&[0.0]),
            Parameter::number("pitch", "about e2, along the normal, rad").or(&[0.0]),
            Parameter::number("yaw", "about e3, along the radius, rad").or(&[0.0]),
            Parameter::vector("relative", 3, "angular velocity against the orbit, rad/s")
                .or(&[0.0; 3]),
            SPEEDS.or(&[]),
        ],
        coordinates,
    }),
};

fn describe(given: &Given<'_>) -> Result<Description, KindError> {
    given.require_moments("I")?;
    given.require("n", Sign::Positive)?;
    let [rate, tide] = match orbit(given)? {
        None => ["n", "n^2"],
        Some(_) => ORBIT,
    };
    let wheels = Wheels::of(given)?;
    let (kinetic, added) = (wheels.energy(), wheels.added_moment("Gamma_1"));
    let moment = match wheels.are_none() {
        true => "sum(I[i]*Gamma_1[i]^2)".into(),
        false => format!("(sum(I[i]*Gamma_1[i]^2){added})"),
    };
    Ok(Description {
        algebra: wheels.algebra("so(3) |x (R3 + R3)", &["Pi", "Gamma"])?,
        hamiltonian: format!("{kinetic} - {rate}*(Pi·Gamma_2) + 3*{tide}*{moment}/2"),
        parameters: wheels.parameters(given.parameters(&["I", "n"])?)?,
        has_plus_bracket: false,
    })
}

/// Returns the orbit, if it is an ellipse.
fn orbit(given: &Given<'_>) -> Result<Option<KeplerOrbit>, KindError> {
    given.require("n", Sign::Positive)?;
    let (rate, e) = (given.number("n"), given.number(ECCENTRICITY));
    if !(0.0..1.0).contains(&e) {
        return Err(KindError::Value(ECCENTRICITY, format!("at least 0 and below 1, got {e}")));
    }
    if given.has("mean_anomaly") && given.has("true_anomaly") {
        let needed = "left out where there is a mean_anomaly";
        return Err(KindError::Value("true_anomaly", needed.into()));
    }
    if e == 0.0 {
        return Ok(None);
    }
    let orbit = match given.has("true_anomaly") {
        true => KeplerOrbit::from_true_anomaly(rate, e, given.number("true_anomaly")),
        false => KeplerOrbit::from_mean_anomaly(rate, e, given.number("mean_anomaly")),
    };
    let refused = |error| KindError::Value("n", format!("that of an orbit, got {rate:?}: {error}"));
    orbit.map(Some).map_err(refused)
}

/// Returns Π, the directions that a body sees after the turns, and the angular momenta of the wheels, for Ω = w + n Γ₂.
fn coordinates(system: &Given<'_>, start: &Given<'_>) -> Result<Vec<f64>, KindError> {
    let [(sr, cr), (sp, cp), (sy, cy)] =
        ["roll", "pitch", "yaw"].map(|name| start.number(name).sin_cos());
    let radial = [-sp, sr * cp, cr * cp];
    let normal = [sy * cp, cr * cy + sr * sy * sp, cr * sy * sp - sr * cy];
    let relative = start.values("relative");
    let rate = orbit(system)?.map_or(system.number("n"), |orbit| orbit.rate(0.0));
    let omega =
        Vector3::from_iterator(relative.iter().zip(normal).map(|(w, normal)| w + rate * normal));
    let (pi, l) = Wheels::of(system)?.momenta(&system.values("I"), omega, start)?;
    Ok(pi.iter().copied().chain(radial).chain(normal).chain(l).collect())
}
