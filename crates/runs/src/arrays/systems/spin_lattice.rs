//! A lattice of classical spins.

use crate::arrays::any_arrays::Made;
use crate::arrays::arguments::Given;
use crate::arrays::open::array_terms::LatticeTerms;
use crate::arrays::sites::lattice_of::{Interactions, lattice_of};
use crate::arrays::sites::sites_arrays::SitesArrays;
use crate::arrays::sites::sites_system::SitesSystem;
use crate::arrays::sites::spin_start::{SPIN_START, spin_start};
use lie_poisson_formula_systems::Parameter;

pub(in crate::arrays) const NAME: &str = LatticeTerms::KIND;

pub(in crate::arrays) const PARAMETERS: &[Parameter] = &[
    Parameter::list("shape", "spins along each of one to three axes"),
    Parameter::number_or_list(
        "exchange",
        "J of neighbours, for all axes or for each; positive for a ferromagnet",
    )
    .or(&[0.0]),
    Parameter::list(
        "bonds",
        "rows [d1, d2, d3, J] of further bonds, each to the spin at that offset",
    )
    .or(&[]),
    Parameter::number_or_list(
        "periodic",
        "1 for axes that are rings, 0 for open ends, for all axes or for each",
    )
    .or(&[1.0]),
    Parameter::number("anisotropy", "K; positive for an easy axis").or(&[0.0]),
    Parameter::vector("axis", 3, "direction of the anisotropy").or(&[0.0, 0.0, 1.0]),
    Parameter::vector("field", 3, "B").or(&[0.0, 0.0, 0.0]),
];

pub(in crate::arrays) const START: &[Parameter] = &SPIN_START;

/// Makes spins s_i with
///
/// ```text
/// h = −Σ_i ( Σ_o J_o s_i·s_(i+o) + K (a·s_i)² + B·s_i ),    ds_i/dt = s_i × H_i,    H_i = −∂h/∂s_i
/// ```
///
/// as a [`HeisenbergLattice`](lie_poisson_systems::HeisenbergLattice), whose fastest axis is the last one of the shape,
/// without the bonds that go round an open axis.
pub(in crate::arrays) fn make(given: &Given<'_>) -> Made {
    let Interactions { lattice, symmetry } = lattice_of(given)?;
    Ok(Box::new(SitesArrays {
        shape: lattice.axes().iter().map(|(count, _)| *count).collect(),
        system: SitesSystem::Spins(lattice),
        name: "S",
        hamiltonian: "-sum(J_o*S[i]·S[i+o]) - K*sum((a·S[i])^2) - B·sum(S[i])",
        weights: None,
        symmetry,
        start: |spins, given| match &spins.system {
            SitesSystem::Spins(lattice) => spin_start(lattice.axes(), given),
            SitesSystem::Vortices(_) => Ok(Vec::new()),
        },
    }))
}
