//! Spins on a chain of moving atoms.

use crate::arrays::any_arrays::Made;
use crate::arrays::arguments::Given;
use crate::arrays::chains::chain::Chain;
use crate::arrays::sites::spin_start::SPIN_START;
use lie_poisson_formula_systems::Parameter;

pub(in crate::arrays) const NAME: &str = "vibrating-lattice";

pub(in crate::arrays) const PARAMETERS: &[Parameter] = &[
    Parameter::number(
        "atoms",
        "how many there are, at least 3; the last is a neighbour of the first",
    ),
    Parameter::number("mass", "m of an atom").or(&[1.0]),
    Parameter::number("stiffness", "of the spring between neighbours").or(&[1.0]),
    Parameter::number("exchange", "J of neighbouring spins; positive for a ferromagnet"),
    Parameter::number("coupling", "a, by which J falls with the distance of the atoms").or(&[0.0]),
];

pub(in crate::arrays) const START: &[Parameter] = &[
    SPIN_START[0],
    SPIN_START[1],
    SPIN_START[2],
    SPIN_START[3],
    SPIN_START[4],
    SPIN_START[5],
    Parameter::list("q", "displacement of each atom along the chain").or(&[]),
    Parameter::list("p", "momentum of each atom").or(&[]),
];

/// The largest number of atoms.
const MOST: usize = 1 << 24;

/// Makes N atoms with the spins s_i, the displacements q_i and the momenta p_i:
///
/// ```text
/// h = Σ_i [ p_i²/2m + ½κ(qᵢ₊₁ − q_i)² − (J − a(qᵢ₊₁ − q_i)) s_i·sᵢ₊₁ ]
/// ```
pub(in crate::arrays) fn make(given: &Given<'_>) -> Made {
    let count = given.whole("atoms", [3, MOST])?;
    let [mass, stiffness, exchange, coupling] =
        ["mass", "stiffness", "exchange", "coupling"].map(|name| given.number(name));
    if mass <= 0.0 {
        return Err(given.refused("mass", format!("positive, got {mass}")));
    }
    if stiffness < 0.0 {
        return Err(given.refused("stiffness", format!("0 or positive, got {stiffness}")));
    }
    Ok(Box::new(Chain { count, mass, stiffness, exchange, coupling }))
}
