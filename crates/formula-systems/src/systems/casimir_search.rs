//! The search for the Casimirs of an algebra whose dimension is known when the program runs.

use crate::algebras::system_algebra::SystemAlgebra;
use crate::error::FormulaSystemError;
use lie_poisson_formulas::{
    DimensionTask, PolynomialCasimirs, find_casimirs, for_dimension, structure_constants,
};

/// Finds the polynomial Casimirs of an algebra up to degree 4.
pub(super) fn casimirs(algebra: &SystemAlgebra) -> Result<PolynomialCasimirs, FormulaSystemError> {
    let (count, most) = (algebra.dimension(), SystemAlgebra::MOST_DIMENSIONS);
    let found = for_dimension(count, Find { algebra });
    found.unwrap_or(Err(FormulaSystemError::Dimension { count, most }))
}

/// The search for the Casimirs of a table.
struct Find<'a> {
    algebra: &'a SystemAlgebra,
}

impl DimensionTask for Find<'_> {
    type Output = Result<PolynomialCasimirs, FormulaSystemError>;

    fn run<const N: usize>(self) -> Self::Output {
        let table = structure_constants::<N>(self.algebra.entries());
        let table = table.map_err(FormulaSystemError::Structure)?;
        Ok(find_casimirs(&table, self.algebra.coordinates())?)
    }
}
