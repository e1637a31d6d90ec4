//! The lattice that parameters describe: [`lattice_of`].

use super::open_lattice::OpenLattice;
use crate::arrays::arguments::{Given, whole};
use lie_poisson_formula_systems::FormulaSystemError;
use lie_poisson_systems::SystemError;
use nalgebra::Vector3;

/// The largest number of spins.
const MOST: usize = 1 << 28;

/// The largest offset of a bond.
const MOST_OFFSET: f64 = 1e9;

/// A lattice, and the axis along which the sum of its spins is conserved: `None` for all axes, and 0 for none.
pub(in crate::arrays) struct Interactions {
    pub(in crate::arrays) lattice: OpenLattice,
    pub(in crate::arrays) symmetry: Option<Vector3<f64>>,
}

/// Makes a lattice of spins with exchange, anisotropy and field.
///
/// # Errors
/// If a parameter has a value that it cannot have, or there is no interaction at all.
pub(in crate::arrays) fn lattice_of(given: &Given<'_>) -> Result<Interactions, FormulaSystemError> {
    if !["exchange", "bonds", "anisotropy", "field"].iter().any(|name| given.has(name)) {
        let needed = "given, or bonds, anisotropy or field; without them nothing moves";
        return Err(given.refused("exchange", needed.into()));
    }
    let mut lattice = with_neighbours(given)?;
    let bonds = given.values("bonds");
    if !bonds.len().is_multiple_of(4) {
        let needed = format!("rows of four numbers, [d1, d2, d3, J], got {} numbers", bonds.len());
        return Err(given.refused("bonds", needed));
    }
    for [offset @ .., constant] in bonds.as_chunks::<4>().0 {
        if offset.iter().any(|d| d.fract() != 0.0 || d.abs() > MOST_OFFSET) {
            return Err(given.refused("bonds", format!("whole numbers of cells, got {offset:?}")));
        }
        let all = offset.map(|d| d as i64);
        let (own, beyond) = all.split_at(lattice.axes().len());
        let inside = |((count, periodic), d): (&(usize, bool), &i64)| {
            *periodic || d.unsigned_abs() < *count as u64
        };
        let moves = |((count, _), d): (&(usize, bool), &i64)| d % *count as i64 != 0;
        let ends = || lattice.axes().iter().zip(own);
        if beyond.iter().any(|d| *d != 0) || !ends().all(inside) || !ends().any(moves) {
            let needed = "offsets to other spins of the lattice, 0 along axes that it has not";
            return Err(given.refused("bonds", format!("{needed}, got {all:?}")));
        }
        lattice = lattice.with_exchange(own, *constant).map_err(refused(given, "bonds"))?;
    }
    let (k, axis, field) =
        (given.number("anisotropy"), given.vector("axis"), given.vector("field"));
    if axis == Vector3::zeros() {
        return Err(given.refused("axis", "different from 0".into()));
    }
    let lattice = lattice.with_anisotropy(axis, k).map_err(refused(given, "axis"))?;
    let lattice = lattice.with_field(field).map_err(refused(given, "field"))?;
    let symmetry = match (k != 0.0, field != Vector3::zeros()) {
        (false, false) => None,
        (true, false) => Some(axis),
        (false, true) => Some(field),
        (true, true) => {
            Some(if axis.cross(&field).amax() == 0.0 { axis } else { Vector3::zeros() })
        }
    };
    Ok(Interactions { lattice, symmetry })
}

/// Returns the lattice with the exchange of neighbours along each axis.
fn with_neighbours(given: &Given<'_>) -> Result<OpenLattice, FormulaSystemError> {
    let shape = shape(given)?;
    let periodic = for_each_axis(given, "periodic", shape.len())?;
    if let Some(other) = periodic.iter().find(|value| ![0.0, 1.0].contains(*value)) {
        return Err(given.refused("periodic", format!("0 or 1, got {other}")));
    }
    let axes = shape.iter().zip(&periodic).map(|(count, periodic)| (*count, *periodic == 1.0));
    let mut lattice = OpenLattice::new(axes.collect()).map_err(refused(given, "shape"))?;
    for (axis, constant) in for_each_axis(given, "exchange", shape.len())?.iter().enumerate() {
        let offset: Vec<i64> = (0..shape.len()).map(|other| i64::from(other == axis)).collect();
        if *constant != 0.0 {
            lattice =
                lattice.with_exchange(&offset, *constant).map_err(refused(given, "exchange"))?;
        }
    }
    Ok(lattice)
}

/// Returns a number for each axis, of one for all or of one for each.
fn for_each_axis(
    given: &Given<'_>,
    name: &'static str,
    axes: usize,
) -> Result<Vec<f64>, FormulaSystemError> {
    match given.values(name) {
        [value] => Ok(vec![*value; axes]),
        values if values.len() == axes => Ok(values.to_vec()),
        values => {
            let needed =
                format!("one number, or one for each of {axes} axes, got {}", values.len());
            Err(given.refused(name, needed))
        }
    }
}

/// Returns the numbers of spins along the axes.
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

fn refused<'a>(
    given: &'a Given<'_>,
    name: &'static str,
) -> impl Fn(SystemError) -> FormulaSystemError + 'a {
    move |error| given.refused(name, error.to_string())
}
