//! A rigid body with two rotors.

use crate::algebras::system_algebra::SystemAlgebra;
use crate::catalogue::parameter::Parameter;
use crate::catalogue::system_kind::{Description, Given, KindError, Sign, SystemKind};

/// A rigid body that turns freely and carries two balanced rotors, whose axes are its first two axes, without friction or
/// motors: Zhukovskii's and Volterra's gyrostat with rotors that are free.
///
/// Π is the angular momentum of body and rotors, I_i are the principal moments of the body with the rotors, but without
/// their moments J about their own axes, and l the angular momenta of the rotors about these axes:
///
/// ```text
/// h = (Π₁ − l₁)²/(2 I₁) + (Π₂ − l₂)²/(2 I₂) + Π₃²/(2 I₃) + l₁²/(2 J₁) + l₂²/(2 J₂),
/// dΠ/dt = Π × Ω,    dl/dt = 0,    Ω = ((Π₁ − l₁)/I₁, (Π₂ − l₂)/I₂, Π₃/I₃).
/// ```
///
/// The algebra is so(3) ⊕ R². The Casimirs are l₁, l₂ and |Π|².
///
/// Source: P. S. Krishnaprasad, *Lie–Poisson structures, dual-spin spacecraft and asymptotic stability*, Nonlinear Anal. 9
/// (1985), 1011–1035.
pub(in crate::catalogue) const BODY_WITH_ROTORS: SystemKind = SystemKind {
    name: "body-with-rotors",
    about: "a free rigid body with two rotors along its first two axes",
    parameters: &[
        Parameter::vector("I", 3, "moments without those of the rotors about their axes, kg m²"),
        Parameter::vector("J", 2, "moments of the rotors about their axes, kg m²"),
    ],
    describe,
    orbit: None,
    directions: &[],
    start: None,
};

fn describe(given: &Given<'_>) -> Result<Description, KindError> {
    given.require("I", Sign::Positive)?;
    given.require("J", Sign::Positive)?;
    let hamiltonian =
        "(Pi1 - l1)^2/(2*I1) + (Pi2 - l2)^2/(2*I2) + Pi3^2/(2*I3) + l1^2/(2*J1) + l2^2/(2*J2)";
    Ok(Description {
        algebra: SystemAlgebra::named("so(3) + R2")?.with_symbols(&["Pi", "l"])?,
        hamiltonian: hamiltonian.into(),
        parameters: given.parameters(&["I", "J"])?,
        has_plus_bracket: false,
    })
}
