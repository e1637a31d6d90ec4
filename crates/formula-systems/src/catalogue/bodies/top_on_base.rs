//! A heavy top on a movable base.

use crate::algebras::system_algebra::SystemAlgebra;
use crate::catalogue::parameter::Parameter;
use crate::catalogue::system_kind::{Description, Given, KindError, Sign, SystemKind};
use nalgebra::{Matrix3, Vector3};

/// A heavy top of mass m whose point of support is a base of mass M that moves freely. A thrust carries the weight, so that
/// gravity only turns the top.
///
/// With the angular momentum Π about the base, the momentum P, the centre c = m r/(m + M) of both masses and
/// J = I − m (c·r − c rᵀ):
///
/// ```text
/// h = ½ q·J⁻¹q + |P|²/(2(m + M)) + m g r·Γ,    q = Π − c × P
/// ```
///
/// The algebra is se(3) ⋉ R³. The Casimirs are |P|², P·Γ and |Γ|².
///
/// Source: C. Contreras & T. Ohsawa, Math. Control Signals Syst. 34 (2022).
pub(in crate::catalogue) const TOP_ON_BASE: SystemKind = SystemKind {
    name: "top-on-base",
    about: "a heavy top on a base that moves freely",
    parameters: &[
        Parameter::vector("inertia", 3, "moments about the support, kg m²"),
        Parameter::number("mass", "of the top, kg"),
        Parameter::number("base_mass", "of the base, kg"),
        Parameter::number("gravity", "m/s²"),
        Parameter::vector("center_of_mass", 3, "of the top from the support, m"),
    ],
    describe,
    orbit: None,
    directions: &["Gamma"],
    start: None,
};

fn describe(given: &Given<'_>) -> Result<Description, KindError> {
    given.require_moments("inertia")?;
    given.require("mass", Sign::Positive)?;
    given.require("base_mass", Sign::NotNegative)?;
    given.require("gravity", Sign::NotNegative)?;
    let (mass, base) = (given.number("mass"), given.number("base_mass"));
    let vector = |name| Vector3::from_iterator(given.values(name));
    let (inertia, r) = (vector("inertia"), vector("center_of_mass"));
    let c = r * (mass / (mass + base));
    let moved = Matrix3::identity() * c.dot(&r) - c * r.transpose();
    let about_center = Matrix3::from_diagonal(&inertia) - moved * mass;
    let inverse = about_center.cholesky().map(|cholesky| cholesky.inverse()).ok_or_else(|| {
        let needed = "larger than those of the mass at the centre of both masses alone";
        KindError::Value("inertia", format!("{needed}, got {:?}", inertia.as_slice()))
    })?;
    let row = |i: usize| inverse.column(i).iter().copied().collect::<Vec<_>>();
    let (q, base) = ("(Pi - c×P)", "se(3)+R3");
    let parameters = (0..3).try_fold(given.parameters(&["mass", "base_mass"])?, |all, i| {
        all.vector(&format!("A_{}", i + 1), &row(i))
    });
    Ok(Description {
        algebra: SystemAlgebra::named(base)?,
        hamiltonian: format!(
            "({q}·A_1*{q}[1] + {q}·A_2*{q}[2] + {q}·A_3*{q}[3])/2 + |P|^2/(2*(mass + base_mass)) + w·Gamma"
        ),
        parameters: parameters?
            .vector("c", c.as_slice())?
            .vector("w", (r * (mass * given.number("gravity"))).as_slice())?,
        has_plus_bracket: false,
    })
}
