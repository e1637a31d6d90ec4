//! A free rigid body in any dimension.

use crate::algebras::system_algebra::SystemAlgebra;
use crate::catalogue::parameter::Parameter;
use crate::catalogue::system_kind::{Description, Given, KindError, Sign, SystemKind};

/// The free rigid body in n dimensions, with the second moments J_j = ∫x_j² dm of its mass:
///
/// ```text
/// h = Σ_(i<j) L_ij²/(2(J_i + J_j)),    dL/dt = [L, Ω],    L_ij = (J_i + J_j) Ω_ij
/// ```
///
/// L has L_ij, i < j, in row j and column i, as the rotation from the i-th to the j-th axis. The algebra is so(n); in three dimensions Π = (L₂₃, −L₁₃, L₁₂) and I₁ = J₂ + J₃.
///
/// Source: S. V. Manakov, Funct. Anal. Appl. 10 (1976); T. Ratiu, Indiana Univ. Math. J. 29 (1980).
pub(in crate::catalogue) const RIGID_BODY: SystemKind = SystemKind {
    name: "rigid-body",
    about: "a free rigid body in any dimension",
    parameters: &[Parameter::list("moments", "second moments of the mass along each axis, kg m²")],
    describe,
    orbit: None,
    directions: &[],
    start: None,
};

fn describe(given: &Given<'_>) -> Result<Description, KindError> {
    given.require("moments", Sign::Positive)?;
    let n = given.values("moments").len();
    if n < 3 {
        return Err(KindError::Value("moments", format!("at least 3 numbers, got {n}")));
    }
    let algebra = SystemAlgebra::named(&format!("so({n})"))?;
    let pairs = (1..=n).flat_map(|i| (i + 1..=n).map(move |j| (i, j)));
    let names = algebra.coordinates().names();
    let term = |((i, j), name): ((usize, usize), String)| {
        format!("{name}^2/(moments[{i}] + moments[{j}])")
    };
    let terms: Vec<String> = match n {
        // The components of Π belong to the planes 23, 31 and 12.
        3 => [(2, 3), (1, 3), (1, 2)].into_iter().zip(names).map(term).collect(),
        _ => pairs.zip(names).map(term).collect(),
    };
    Ok(Description {
        hamiltonian: format!("({})/2", terms.join(" + ")),
        algebra,
        parameters: given.parameters(&["moments"])?,
        has_plus_bracket: false,
    })
}
