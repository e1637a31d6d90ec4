//! Point vortices on the sphere, more than a formula can have.

use crate::arrays::any_arrays::Made;
use crate::arrays::arguments::Given;
use crate::arrays::sites::sites_arrays::SitesArrays;
use crate::arrays::sites::sites_system::SitesSystem;
use crate::arrays::sites::vortex_start::vortex_start;
use lie_poisson_formula_systems::Parameter;
use lie_poisson_systems::ManyVortices;

pub(in crate::arrays) const NAME: &str = "vortices";

pub(in crate::arrays) const PARAMETERS: &[Parameter] =
    &[Parameter::list("strengths", "circulation of each vortex, m²/s")];

pub(in crate::arrays) const START: &[Parameter] = &[
    Parameter::list("positions", "[x, y, z] of each vortex on the unit sphere").or(&[]),
    Parameter::list("m", "positions times strengths, instead of positions").or(&[]),
    Parameter::number("seed", "of random positions, none near another, instead of positions")
        .or(&[0.0]),
];

/// Makes N vortices of strengths k_i at the points x_i of the unit sphere, m_i = k_i x_i, with
///
/// ```text
/// h = (1/4π) Σ_(i<j) k_i k_j ln(2 − 2 x_i·x_j)
/// ```
///
/// as [`ManyVortices`].
pub(in crate::arrays) fn make(given: &Given<'_>) -> Made {
    let strengths = given.values("strengths").to_vec();
    if strengths.is_empty() {
        return Err(given.refused("strengths", "at least one number, got none".into()));
    }
    if let Some(i) = strengths.iter().position(|strength| !strength.recip().is_finite()) {
        let needed = format!("other than 0; number {} is {}", i + 1, strengths[i]);
        return Err(given.refused("strengths", needed));
    }
    let vortices = ManyVortices::new(strengths.clone());
    let vortices = vortices.map_err(|error| given.refused("strengths", error.to_string()))?;
    Ok(Box::new(SitesArrays {
        system: SitesSystem::Vortices(vortices),
        name: "m",
        hamiltonian: "sum(strengths[i]*strengths[j]*ln(2 - 2*m[i]·m[j]/(strengths[i]*strengths[j])), i < j)/(4*pi)",
        shape: vec![strengths.len()],
        weights: Some(strengths.iter().map(|strength| strength.recip()).collect()),
        symmetry: None,
        start: |vortices, given| vortex_start(vortices, given),
    }))
}
