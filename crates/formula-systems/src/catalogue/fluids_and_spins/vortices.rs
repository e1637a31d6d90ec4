//! Point vortices on the sphere.

use crate::algebras::system_algebra::SystemAlgebra;
use crate::catalogue::parameter::Parameter;
use crate::catalogue::system_kind::{Description, Given, KindError, KindStart, SystemKind};

/// N point vortices of strengths k_i at the points x_i of the unit sphere, with m_i = k_i x_i on (so(3)∗)ᴺ:
///
/// ```text
/// h = (1/4π) Σ_(i<j) k_i k_j ln(2 − 2 x_i·x_j),    dx_i/dt = (1/4π) Σ_(j≠i) k_j (x_j × x_i)/(1 − x_i·x_j)
/// ```
///
/// Besides h and every |m_i|, which are the Casimirs, it conserves the moment of vorticity Σ m_i.
///
/// Source: V. A. Bogomolov, Fluid Dyn. 12 (1977); P. K. Newton, *The N-Vortex Problem* (2001), §4.2.
pub(in crate::catalogue) const VORTICES: SystemKind = SystemKind {
    name: "vortices",
    about: "point vortices on the unit sphere",
    parameters: &[Parameter::list("strengths", "circulation of each vortex, m²/s")],
    describe,
    orbit: None,
    directions: &[],
    start: Some(KindStart {
        given: &[Parameter::list("positions", "[x, y, z] of each vortex on the unit sphere")],
        coordinates: |vortices, given| {
            let (strengths, positions) = (vortices.values("strengths"), given.values("positions"));
            if positions.len() != 3 * strengths.len() {
                let (count, found) = (strengths.len(), positions.len());
                let needed = format!("three numbers for each of {count} vortices, got {found}");
                return Err(KindError::Value("positions", needed));
            }
            for (i, position) in (1..).zip(positions.chunks(3)) {
                let length = position.iter().map(|x| x * x).sum::<f64>().sqrt();
                if (length - 1.0).abs() > ON_SPHERE {
                    let needed =
                        format!("points of the unit sphere; the length of number {i} is {length}");
                    return Err(KindError::Value("positions", needed));
                }
            }
            let components = positions.iter().enumerate();
            Ok(components
                .map(|(i, x)| x * strengths.get(i / 3).copied().unwrap_or(f64::NAN))
                .collect())
        },
    }),
};

/// The largest distance of a vortex from the unit sphere, that of positions with six digits.
const ON_SPHERE: f64 = 1e-5;

/// The largest number of vortices: the differential has a term for each pair.
const MOST: usize = 48;

fn describe(given: &Given<'_>) -> Result<Description, KindError> {
    let strengths = given.values("strengths");
    if strengths.len() > MOST {
        let needed = format!("1 to {MOST} numbers, got {}", strengths.len());
        return Err(KindError::Value("strengths", needed));
    }
    if let Some(value) = strengths.iter().find(|strength| !strength.recip().is_finite()) {
        return Err(KindError::Value("strengths", format!("other than 0, got {value}")));
    }
    let (algebra, hamiltonian) = match strengths.len() {
        1 => (SystemAlgebra::named("so(3)")?.with_symbols(&["m"])?, "0*m1"),
        count => (
            SystemAlgebra::named(&format!("so(3)^{count}"))?.with_symbols(&["m"])?,
            "sum(strengths[i]*strengths[j]*ln(2 - 2*m[i]·m[j]/(strengths[i]*strengths[j])), i < j)/(4*pi)",
        ),
    };
    Ok(Description {
        algebra,
        hamiltonian: hamiltonian.into(),
        parameters: given.parameters(&["strengths"])?,
        has_plus_bracket: false,
    })
}
