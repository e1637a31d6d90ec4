//! A rigid body in an ideal fluid.

use crate::algebras::system_algebra::SystemAlgebra;
use crate::catalogue::system_kind::{Description, Given, KindError, Parameter, Sign, SystemKind};

/// Kirchhoff's body with three planes of symmetry in an ideal fluid that is at rest far away.
///
/// Π is the impulsive couple, P the impulse, I and M are the moments and the masses of body and moved fluid along the axes:
///
/// ```text
/// h = Σ_i Π_i²/(2 I_i) + Σ_i P_i²/(2 M_i),    dΠ/dt = Π × Ω + P × v,    dP/dt = P × Ω
/// ```
///
/// The algebra is se(3). The Casimirs are Π·P and |P|².
///
/// Source: G. Kirchhoff, *Vorlesungen über mathematische Physik* (1876), 19th lecture; H. Lamb, *Hydrodynamics*, 6th ed.,
/// §124.
pub(in crate::catalogue) const BODY_IN_FLUID: SystemKind = SystemKind {
    name: "body-in-fluid",
    about: "a rigid body with three planes of symmetry in an ideal fluid",
    parameters: &[
        Parameter::vector("inertia", 3, "moments of body and fluid, kg m²"),
        Parameter::vector("masses", 3, "masses of body and fluid along the axes, kg"),
    ],
    describe,
    start: None,
};

fn describe(given: &Given<'_>) -> Result<Description, KindError> {
    given.require("inertia", Sign::Positive)?;
    given.require("masses", Sign::Positive)?;
    Ok(Description {
        algebra: SystemAlgebra::named("se(3)")?.with_symbols(&["Pi", "P"])?,
        hamiltonian: "sum(Pi[i]^2/inertia[i])/2 + sum(P[i]^2/masses[i])/2".into(),
        parameters: given.parameters(&["inertia", "masses"])?,
        has_plus_bracket: false,
    })
}
