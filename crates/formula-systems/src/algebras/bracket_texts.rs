//! Brackets of coordinates as text, such as `"K, H" = "P"`.

use crate::error::FormulaSystemError;
use lie_poisson_formulas::{Coordinates, Formula, Parameters, StructureEntry, Vocabulary};

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
        let constants = bracket.linear_form();
        let constants =
            constants.ok_or_else(|| FormulaSystemError::NotLinear { key: key.into() })?;
        let nonzero = constants.into_iter().enumerate().filter(|(_, value)| *value != 0.0);
        entries.extend(nonzero.map(|(k, value)| StructureEntry { i, j, k, value }));
    }
    Ok(entries)
}
