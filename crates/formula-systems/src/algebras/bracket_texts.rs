//! Brackets of coordinates as text, such as `"K, H" = "P"`.

use crate::FormulaSystemError;
use lie_poisson::{Covector, RealSpace, Vector, VectorSpace};
use lie_poisson_formulas::{
    Coordinates, DimensionTask, Formula, Parameters, StructureEntry, Vocabulary, for_dimension,
};

/// Returns the structure constants of brackets [x, y] = Σ c z, given by the names of the coordinates of 𝔤∗.
///
/// # Errors
/// Returns an error if a key is not a pair of coordinates, or if a bracket is not a linear combination of them.
pub(super) fn entries<'a>(
    coordinates: &Coordinates,
    parameters: &Parameters,
    brackets: impl IntoIterator<Item = (&'a str, &'a str)>,
) -> Result<Vec<StructureEntry>, FormulaSystemError> {
    let vocabulary =
        Vocabulary::new(coordinates, parameters).map_err(FormulaSystemError::Parameters)?;
    let names: Vec<String> = coordinates.names().collect();
    let mut entries = Vec::new();
    for (key, text) in brackets {
        let place = |name: &str| names.iter().position(|known| known == name.trim());
        let pair = key.split_once(',').and_then(|(x, y)| Some((place(x)?, place(y)?)));
        let (i, j) = pair.ok_or_else(|| FormulaSystemError::NoPair { key: key.into() })?;
        let bracket = Formula::new(text, &vocabulary)
            .map_err(|problem| FormulaSystemError::Bracket { key: key.into(), problem })?;
        let constants = for_dimension(names.len(), Coefficients { bracket }).flatten();
        let constants =
            constants.ok_or_else(|| FormulaSystemError::NotLinear { key: key.into() })?;
        let nonzero = constants.into_iter().enumerate().filter(|(_, value)| *value != 0.0);
        entries.extend(nonzero.map(|(k, value)| StructureEntry { i, j, k, value }));
    }
    Ok(entries)
}

/// The coefficients of a linear form, or none if the formula is not linear.
struct Coefficients {
    bracket: Formula,
}

impl DimensionTask for Coefficients {
    type Output = Option<Vec<f64>>;

    fn run<const N: usize>(self) -> Option<Vec<f64>> {
        type Point<const N: usize> = Covector<<RealSpace<N> as VectorSpace>::Point<f64>>;
        let (zero, other) =
            (Point::<N>::zero(), Point::<N>::from_coordinates(|i| (i + 1) as f64 + 0.25));
        let (slope, again) = (self.bracket.differential(&zero), self.bracket.differential(&other));
        // A linear form vanishes at 0 and has the same differential everywhere.
        let is_linear = self.bracket.value(&zero) == 0.0 && slope == again;
        is_linear.then(|| (0..N).map(|i| slope.coordinate(i)).collect())
    }
}
