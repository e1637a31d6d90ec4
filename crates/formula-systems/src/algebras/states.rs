//! States by the names of their coordinates.

use super::system_algebra::SystemAlgebra;
use crate::error::FormulaSystemError;

impl SystemAlgebra {
    /// Returns the coordinates of a state on 𝔤∗ from their values by name. The components of a vector may be given
    /// together or one by one.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::NoCoordinate`] for a name that is not the name of a coordinate,
    /// [`FormulaSystemError::WrongValue`] for a value with the wrong number of components or one that is not finite,
    /// [`FormulaSystemError::SecondValue`] for a coordinate with a value of its own and one in its vector, and [`FormulaSystemError::NoValue`] if a coordinate has no value.
    ///
    /// # Example
    /// ```
    /// use lie_poisson_formula_systems::SystemAlgebra;
    /// let se3 = SystemAlgebra::named("se(3)")?;
    /// let state = se3.state([("Pi", &[2.0, 3.0, 4.0][..]), ("Gamma", &[0.6, 0.0, 0.8])])?;
    /// assert_eq!(state, [2.0, 3.0, 4.0, 0.6, 0.0, 0.8]);
    /// let error = se3.state([("Pi", &[2.0, 3.0, 4.0][..]), ("Gamma1", &[0.6])]).unwrap_err();
    /// assert_eq!(error.to_string(), "initial has no value for Gamma2, Gamma3");
    /// let twice = [("Pi", &[2.0, 3.0, 4.0][..]), ("Pi1", &[2.0]), ("Gamma", &[0.6, 0.0, 0.8])];
    /// assert_eq!(se3.state(twice).unwrap_err().to_string(), "initial.Pi1 gives a value again that Pi gives");
    /// # Ok::<(), lie_poisson_formula_systems::FormulaSystemError>(())
    /// ```
    pub fn state<'a>(
        &self,
        values: impl IntoIterator<Item = (&'a str, &'a [f64])>,
    ) -> Result<Vec<f64>, FormulaSystemError> {
        let coordinates = self.coordinates();
        // The value of each coordinate, and the name by which it was given.
        let mut state = vec![None; self.dimension()];
        for (name, values) in values {
            let places =
                coordinates.places(name).ok_or_else(|| FormulaSystemError::NoCoordinate {
                    name: name.into(),
                    names: coordinates.names().collect::<Vec<_>>().join(", "),
                })?;
            let wrong =
                |needed: String| FormulaSystemError::WrongValue { name: name.into(), needed };
            if values.len() != places.len() {
                return Err(wrong(match places.len() {
                    1 => "one number".into(),
                    count => format!("an array of {count} numbers"),
                }));
            }
            if values.iter().any(|value| !value.is_finite()) {
                return Err(wrong("finite numbers".into()));
            }
            for (entry, value) in state.iter_mut().skip(places.start).zip(values) {
                if let Some((_, other)) = entry.replace((*value, name)) {
                    let (name, other) = (name.into(), other.into());
                    return Err(FormulaSystemError::SecondValue { name, other });
                }
            }
        }
        let missing = coordinates.names().zip(&state).filter(|(_, value)| value.is_none());
        let missing: Vec<String> = missing.map(|(name, _)| name).collect();
        if missing.is_empty() {
            Ok(state.into_iter().flatten().map(|(value, _)| value).collect())
        } else {
            Err(FormulaSystemError::NoValue { names: missing.join(", ") })
        }
    }
}
