//! A heavy body with a spinning rotor.

use crate::algebras::system_algebra::SystemAlgebra;
use crate::catalogue::parameter::Parameter;
use crate::catalogue::system_kind::{Description, Given, KindError, Sign, SystemKind};

/// A heavy gyrostat: a body with a fixed point and a rotor that is kept at a constant angular momentum ℓ in the body.
///
/// ```text
/// h = Σ_i (Π_i − ℓ_i)²/(2 I_i) + w r·Γ,    dΠ/dt = Π × Ω + w Γ × r,    dΓ/dt = Γ × Ω
/// ```
///
/// The algebra is se(3). The Casimirs are Π·Γ and |Γ|².
///
/// Source: N. E. Zhukovskii (1885); E. Leimanis, *The General Problem of the Motion of Coupled Rigid Bodies about a Fixed
/// Point* (1965), §7.
pub(in crate::catalogue) const GYROSTAT: SystemKind = SystemKind {
    name: "gyrostat",
    about: "a heavy body with a fixed point and a spinning rotor",
    parameters: &[
        Parameter::vector("inertia", 3, "moments of body and rotor about the support, kg m²"),
        Parameter::number("weight", "m g, N"),
        Parameter::vector("center_of_mass", 3, "from the support, m"),
        Parameter::vector("rotor", 3, "angular momentum of the rotor in the body, kg m²/s"),
    ],
    describe,
    orbit: None,
    directions: &["Gamma"],
    start: None,
};

fn describe(given: &Given<'_>) -> Result<Description, KindError> {
    given.require_moments("inertia")?;
    given.require("weight", Sign::NotNegative)?;
    let hamiltonian = "sum((Pi[i] - rotor[i])^2/inertia[i])/2 + weight*(center_of_mass·Gamma)";
    Ok(Description {
        algebra: SystemAlgebra::named("se(3)")?,
        hamiltonian: hamiltonian.into(),
        parameters: given.parameters(&["inertia", "weight", "center_of_mass", "rotor"])?,
        has_plus_bracket: false,
    })
}
