//! A lattice of classical spins.

use crate::arrays::any_arrays::Made;
use crate::arrays::arguments::{Given, whole};
use crate::arrays::directions::Directions;
use crate::arrays::sites::SitesSystem;
use crate::arrays::sites_arrays::{SitesArrays, spin_start};
use lie_poisson_formula_systems::{FormulaSystemError, Parameter};
use lie_poisson_systems::HeisenbergLattice;
use nalgebra::Vector3;

pub(in crate::arrays) const NAME: &str = "spin-lattice";

pub(in crate::arrays) const PARAMETERS: &[Parameter] = &[
    Parameter::list("shape", "spins along each of one to three axes; the lattice is periodic"),
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
    Parameter::number("anisotropy", "K; positive for an easy axis").or(&[0.0]),
    Parameter::vector("axis", 3, "direction of the anisotropy").or(&[0.0, 0.0, 1.0]),
    Parameter::vector("field", 3, "B").or(&[0.0, 0.0, 0.0]),
];

/// What gives the spins at the start.
pub(in crate::arrays) const SPIN_START: [Parameter; 6] = [
    Parameter::list("S", "the components of all spins, those of the last axis of the shape first")
        .or(&[]),
    Parameter::vector("direction", 3, "of the spins, instead of S").or(&[0.0, 0.0, 1.0]),
    Parameter::list("waves", "periods of a spin wave along each axis").or(&[]),
    Parameter::number("cone", "the angle of its spins from the direction, rad").or(&[0.0]),
    Parameter::number("tilt", "the largest random angle from the direction, or from the wave, rad")
        .or(&[0.0]),
    Parameter::number("seed", "of the random angles, a whole number").or(&[0.0]),
];

pub(in crate::arrays) const START: &[Parameter] = &SPIN_START;

/// The largest seed, up to which a number of a configuration is exact.
const MOST_SEED: f64 = 1e15;

/// The largest number of spins.
const MOST: usize = 1 << 28;

/// Makes spins s_i with
///
/// ```text
/// h = −Σ_i ( Σ_o J_o s_i·s_(i+o) + K (a·s_i)² + B·s_i ),    ds_i/dt = s_i × H_i,    H_i = −∂h/∂s_i
/// ```
///
/// as a [`HeisenbergLattice`], whose fastest axis is the last one of the shape.
pub(in crate::arrays) fn make(given: &Given<'_>) -> Made {
    let shape = shape(given)?;
    let along = |offset: &[i64]| {
        let mut cells = [0; 3];
        cells
            .iter_mut()
            .zip(offset.iter().take(shape.len()).rev())
            .for_each(|(cell, d)| *cell = *d);
        cells
    };
    let mut cells = [1; 3];
    cells.iter_mut().zip(shape.iter().rev()).for_each(|(cells, count)| *cells = *count);
    let refused = |name| {
        move |error: lie_poisson_systems::SystemError| given.refused(name, error.to_string())
    };
    let mut lattice = HeisenbergLattice::new(cells).map_err(refused("shape"))?;
    let exchange = given.values("exchange");
    if ![1, shape.len()].contains(&exchange.len()) {
        let needed =
            format!("one number, or one for each of {} axes, got {}", shape.len(), exchange.len());
        return Err(given.refused("exchange", needed));
    }
    for (axis, constant) in (0..shape.len()).zip(exchange.iter().cycle()) {
        let offset: Vec<i64> = (0..shape.len()).map(|other| i64::from(other == axis)).collect();
        if *constant != 0.0 {
            lattice =
                lattice.with_exchange(along(&offset), *constant).map_err(refused("exchange"))?;
        }
    }
    let bonds = given.values("bonds");
    if !bonds.len().is_multiple_of(4) {
        let needed = format!("rows of four numbers, [d1, d2, d3, J], got {} numbers", bonds.len());
        return Err(given.refused("bonds", needed));
    }
    for bond in bonds.as_chunks::<4>().0 {
        let [offset @ .., constant] = bond;
        if offset.iter().any(|d| d.fract() != 0.0 || d.abs() > 1e9) {
            return Err(given.refused("bonds", format!("whole numbers of cells, got {offset:?}")));
        }
        let offset = offset.map(|d| d as i64);
        lattice = lattice.with_exchange(along(&offset), *constant).map_err(refused("bonds"))?;
    }
    let (anisotropy, axis, field) =
        (given.number("anisotropy"), given.vector("axis"), given.vector("field"));
    let lattice = lattice.with_anisotropy(axis, anisotropy).map_err(refused("axis"))?;
    let lattice = lattice.with_field(field).map_err(refused("field"))?;
    let symmetry = match (anisotropy != 0.0, field != Vector3::zeros()) {
        (false, false) => None,
        (true, false) => Some(axis),
        (false, true) => Some(field),
        (true, true) => {
            Some(if axis.cross(&field).amax() == 0.0 { axis } else { Vector3::zeros() })
        }
    };
    Ok(Box::new(SitesArrays {
        system: SitesSystem::Spins(lattice),
        name: "S",
        hamiltonian: "-sum(J_o*S[i]·S[i+o]) - K*sum((a·S[i])^2) - B·sum(S[i])",
        shape,
        weights: None,
        symmetry,
        start: |arrays, given| spin_start(&arrays.shape, given, &mut Directions::new(seed(given)?)),
    }))
}

/// Returns the shape of a lattice.
fn shape(given: &Given<'_>) -> Result<Vec<usize>, FormulaSystemError> {
    let found = given.values("shape");
    let counts: Vec<usize> = found.iter().filter_map(|count| whole(*count, [1, MOST])).collect();
    let product = counts.iter().try_fold(1_usize, |all, count| all.checked_mul(*count));
    let fits = counts.len() == found.len() && (1..=3).contains(&counts.len());
    match fits && product.is_some_and(|all| all <= MOST) {
        true => Ok(counts),
        false => Err(given.refused(
            "shape",
            format!("one to three whole numbers, for at most {MOST} spins, got {found:?}"),
        )),
    }
}

/// Returns the seed of a random start.
pub(in crate::arrays) fn seed(given: &Given<'_>) -> Result<u64, FormulaSystemError> {
    let seed = given.number("seed");
    match seed.fract() == 0.0 && (0.0..=MOST_SEED).contains(&seed) {
        true => Ok(seed as u64),
        false => {
            Err(given
                .refused("seed", format!("a whole number from 0 to {MOST_SEED:e}, got {seed}")))
        }
    }
}
