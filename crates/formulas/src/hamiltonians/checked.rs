//! Values and derivatives of formulas that are checked.

use super::formula::Formula;
use super::value_error::ValueError;
use crate::text::printer::number;

impl Formula {
    /// Returns the value h(z) at coordinates in a slice.
    ///
    /// # Errors
    /// Returns [`ValueError::Value`] with the part of the formula that has no finite value.
    pub fn checked_value(&self, z: &[f64]) -> Result<f64, ValueError> {
        let value = self.value_at(z);
        if value.is_finite() {
            return Ok(value);
        }
        let parts = self.parts().map(|part| (part.value_at(z), part));
        let (value, term) = parts
            .filter(|(value, _)| !value.is_finite())
            .map(|(value, part)| (value, part.to_string()))
            .next()
            .unwrap_or_else(|| (value, self.to_string()));
        Err(ValueError::Value { formula: self.to_string(), term, value, state: self.state(z) })
    }

    /// Returns the coordinates ∂h/∂zᵢ of the differential at coordinates in a slice.
    ///
    /// # Errors
    /// Returns [`ValueError`] with the part of the formula that has no finite value or derivative.
    ///
    /// # Example
    /// ```
    /// use lie_poisson::So3;
    /// use lie_poisson_formulas::{Formula, Parameters, Vocabulary};
    /// let names = Vocabulary::of(&So3, &Parameters::new())?;
    /// // The derivative of |Π|^p with p > 1 is 0 at 0; a square root of 0 has none.
    /// assert_eq!(Formula::new("|Pi|^1.5", &names)?.checked_differential(&[0.0; 3])?, [0.0; 3]);
    /// let error = Formula::new("sqrt(Pi1) + Pi3", &names)?.checked_differential(&[0.0; 3]).unwrap_err();
    /// let text = "sqrt(Pi1) + Pi3 has no derivative at Pi1 = 0, Pi2 = 0, Pi3 = 0, where that of sqrt(Pi1) with respect \
    ///             to Pi1 is infinite";
    /// assert_eq!(error.to_string(), text);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn checked_differential(&self, z: &[f64]) -> Result<Vec<f64>, ValueError> {
        self.checked_value(z)?;
        let slopes = self.differential_at(z);
        let Some((place, value)) = not_finite(&slopes) else { return Ok(slopes) };
        let of_part = |part: Self| not_finite(&part.differential_at(z)).map(|found| (found, part));
        let ((place, value), term) = self.parts().find_map(of_part).map_or_else(
            || ((place, value), self.to_string()),
            |(at, part)| (at, part.to_string()),
        );
        let coordinate = self.names().coordinates().names().nth(place).unwrap_or_default();
        let (formula, state) = (self.to_string(), self.state(z));
        Err(ValueError::Derivative { formula, term, coordinate, value, state })
    }

    /// Returns the coordinates of a state with their names.
    fn state(&self, z: &[f64]) -> String {
        let names = self.names().coordinates().names();
        let all = names.zip(z).map(|(name, x)| format!("{name} = {}", number(*x)));
        all.collect::<Vec<_>>().join(", ")
    }
}

/// Returns the first entry that is infinite or not a number, with its place.
fn not_finite(slopes: &[f64]) -> Option<(usize, f64)> {
    slopes.iter().copied().enumerate().find(|(_, slope)| !slope.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{NameError, Parameters, Vocabulary};
    use lie_poisson::So3;

    /// The innermost part is named, whatever stands around it.
    #[test]
    fn the_part_without_a_value_is_named() -> Result<(), NameError> {
        let names = Vocabulary::of(&So3, &Parameters::new())?;
        let term = |text: &str, z: [f64; 3]| match Formula::new(text, &names)
            .ok()?
            .checked_differential(&z)
            .err()?
        {
            ValueError::Value { term, .. } | ValueError::Derivative { term, .. } => Some(term),
        };
        for (text, expected) in [
            ("Pi1 + 2*exp(sqrt(Pi2 - 1)*Pi3)", "sqrt(Pi2 - 1)"),
            ("1/(Pi1*Pi2)", "1/(Pi1*Pi2)"),
            ("exp(800 + Pi1)^2", "exp(800 + Pi1)"),
            ("Pi3*|Pi| + Pi1", "|Pi|"),
        ] {
            assert_eq!(term(text, [0.0; 3]).as_deref(), Some(expected), "{text}");
            // Control: elsewhere there is a value.
            assert_eq!(term(text, [-700.0, 2.0, 1.0]), None, "{text}");
        }
        Ok(())
    }
}
