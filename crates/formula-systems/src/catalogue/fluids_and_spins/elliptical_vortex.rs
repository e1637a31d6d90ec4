//! Kida's elliptical vortex.

use crate::algebras::system_algebra::SystemAlgebra;
use crate::catalogue::parameter::Parameter;
use crate::catalogue::system_kind::{Description, Given, KindError, KindStart, Sign, SystemKind};
use lie_poisson_formulas::{Coordinates, Parameters};

/// An elliptical patch of uniform vorticity ω in a plane flow with the strain (x, y) ↦ e (x, −y) and the angular velocity γ.
///
/// With the semi-axes a and b and the angle φ, k = ω ab and the plus bracket of so(2, 1):
///
/// ```text
/// μ = (½(a²−b²) cos 2φ, ½(a²−b²) sin 2φ, ½(a²+b²)),    [e₁, e₂] = −e₃, [e₂, e₃] = e₁, [e₃, e₁] = e₂
/// h = k ln(2μ₃ + 2ab) + 2γ μ₃ − 2e μ₂,    ab = √(μ₃² − μ₁² − μ₂²)
/// ```
///
/// The Casimir is a²b². Source: S. Kida, J. Phys. Soc. Japan 50 (1981); S. P. Meacham, P. J. Morrison & G. R. Flierl, Phys.
/// Fluids 9 (1997).
pub(in crate::catalogue) const ELLIPTICAL_VORTEX: SystemKind = SystemKind {
    name: "elliptical-vortex",
    about: "an elliptical patch of vorticity in a strain",
    parameters: &[
        Parameter::number("strength", "vorticity times product of the semi-axes, m²/s"),
        Parameter::number("strain", "rate of strain of the flow, 1/s").or(&[0.0]),
        Parameter::number("rotation", "angular velocity of the flow, 1/s").or(&[0.0]),
    ],
    describe,
    orbit: None,
    directions: &[],
    start: Some(KindStart {
        given: &[
            Parameter::number("a", "semi-axis at the angle, m"),
            Parameter::number("b", "other semi-axis, m"),
            Parameter::number("angle", "from the x-axis, rad").or(&[0.0]),
        ],
        coordinates: |_, ellipse| {
            ellipse.require("a", Sign::Positive)?;
            ellipse.require("b", Sign::Positive)?;
            let [a, b, angle] = ["a", "b", "angle"].map(|name| ellipse.number(name));
            let (sin, cos) = (2.0 * angle).sin_cos();
            // Without the cancellation of nearly equal squares.
            let difference = 0.5 * (a - b) * (a + b);
            Ok(vec![difference * cos, difference * sin, 0.5 * (a * a + b * b)])
        },
    }),
};

fn describe(given: &Given<'_>) -> Result<Description, KindError> {
    let strength = given.number("strength");
    if strength == 0.0 {
        return Err(KindError::Value("strength", "other than 0, got 0".into()));
    }
    let coordinates = Coordinates::new().vector("mu", 3)?;
    let brackets = [("mu1, mu2", "-mu3"), ("mu2, mu3", "mu1"), ("mu3, mu1", "mu2")];
    let hamiltonian =
        "strength*ln(2*mu3 + 2*sqrt(mu3^2 - mu1^2 - mu2^2)) + 2*rotation*mu3 - 2*strain*mu2";
    Ok(Description {
        algebra: SystemAlgebra::of_brackets(coordinates, brackets, &Parameters::new())?
            .called("so(2,1)"),
        hamiltonian: hamiltonian.into(),
        parameters: given.parameters(&["strength", "strain", "rotation"])?,
        has_plus_bracket: true,
    })
}
