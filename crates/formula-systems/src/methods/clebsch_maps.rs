//! The Clebsch maps to the dual of an algebra from structure constants.

use crate::FormulaSystemError;
use lie_poisson::{Diagonal, ExtendedAdjoint, ExtendedCoadjoint, StructureConstants};
use momentum_map::{ClebschRealisation, Side, clebsch_realisation};

/// The map of two copies of the adjoint representation, extended by a derivation so that it sees the centre.
pub(super) type AdjointMap<const N: usize> =
    ClebschRealisation<Diagonal<ExtendedAdjoint<StructureConstants<N>>, 2>>;

/// The map of two copies of the coadjoint representation, extended in the same way.
pub(super) type CoadjointMap<const N: usize> =
    ClebschRealisation<Diagonal<ExtendedCoadjoint<StructureConstants<N>>, 2>>;

/// Returns the map of the adjoint representation. `missing` is the error of an algebra that has none.
pub(super) fn adjoint_map<const N: usize>(
    table: StructureConstants<N>,
    missing: impl Fn() -> FormulaSystemError,
) -> Result<AdjointMap<N>, FormulaSystemError> {
    let adjoint = ExtendedAdjoint::of(table).map_err(|_| missing())?;
    Ok(clebsch_realisation(Diagonal(adjoint), Side::Right)?)
}

/// Returns the map of the coadjoint representation. `missing` is the error of an algebra that has none.
pub(super) fn coadjoint_map<const N: usize>(
    table: StructureConstants<N>,
    missing: impl Fn() -> FormulaSystemError,
) -> Result<CoadjointMap<N>, FormulaSystemError> {
    let coadjoint = ExtendedCoadjoint::of(table).map_err(|_| missing())?;
    Ok(clebsch_realisation(Diagonal(coadjoint), Side::Right)?)
}
