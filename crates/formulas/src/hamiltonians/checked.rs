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
        let failure = |part: &Self| Some(part.value_at(z)).filter(|value| !value.is_finite());
        let (term, value) = self.failing_part(z, failure).unwrap_or_else(|| (self.clone(), value));
        let term = term.to_string();
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
        let Some(place) = slopes.iter().position(|slope| !slope.is_finite()) else {
            return Ok(slopes);
        };
        let slope = |part: &Self| part.differential_at(z).get(place).copied();
        let failure = |part: &Self| slope(part).filter(|slope| !slope.is_finite());
        let (term, value) =
            self.failing_part(z, failure).unwrap_or_else(|| (self.clone(), f64::NAN));
        let coordinate = self.names().coordinates().names().nth(place).unwrap_or_default();
        let (formula, term, state) = (self.to_string(), term.to_string(), self.state(z));
        Err(ValueError::Derivative { formula, term, coordinate, value, state })
    }

    /// Returns the coordinates of a state with their names.
    fn state(&self, z: &[f64]) -> String {
        let names = self.names().coordinates().names();
        let all = names.zip(z).map(|(name, x)| format!("{name} = {}", number(*x)));
        all.collect::<Vec<_>>().join(", ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::names::name_error::NameError;
    use crate::names::parameters::Parameters;
    use crate::names::vocabulary::Vocabulary;
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

    /// A part that has no value or no slope itself is not named if the whole does not fail because of it.
    #[test]
    fn a_part_that_does_no_harm_is_not_named() -> Result<(), NameError> {
        let names = Vocabulary::of(&So3, &Parameters::new())?;
        let parts = |text: &str, z: [f64; 3]| match Formula::new(text, &names)
            .ok()?
            .checked_differential(&z)
            .err()?
        {
            ValueError::Value { term, value, .. } => Some((term, String::new(), value)),
            ValueError::Derivative { term, coordinate, value, .. } => {
                Some((term, coordinate, value))
            }
        };
        let (nan, infinite) = (f64::NAN, f64::INFINITY);
        for (text, z, term, coordinate, value) in [
            // values
            ("if(Pi1 > 0, sqrt(Pi1), 0) + ln(Pi2)", [-1.0, 0.0, 0.0], "ln(Pi2)", "", -infinite),
            ("if(Pi1 <= 0, 0, sqrt(Pi1)) + ln(Pi2)", [-1.0, 0.0, 0.0], "ln(Pi2)", "", -infinite),
            ("if(Pi1 < 0, sqrt(Pi1), 1/Pi2)", [-1.0, 0.0, 0.0], "sqrt(Pi1)", "", nan),
            ("if(ln(Pi1) > 0, 1/Pi2, 2)", [-1.0, 0.0, 0.0], "ln(Pi1)", "", nan),
            ("if(1/Pi2 > 1/Pi3, 1, 2)", [1.0, 0.0, 0.0], "1/Pi2", "", infinite),
            ("exp(-1/Pi1^2) + sqrt(Pi2)", [0.0, -1.0, 0.0], "sqrt(Pi2)", "", nan),
            ("1/Pi1 + ln(Pi2)", [0.0, -1.0, 0.0], "ln(Pi2)", "", nan),
            ("(Pi/Pi2 + Pi/Pi1)[1]", [1.0, 0.0, 0.0], "(Pi/Pi2)[1]", "", infinite),
            ("|if(Pi1 > 0, Pi/Pi2, Pi/Pi3)|", [1.0, 0.0, 0.0], "(Pi/Pi2)[2]", "", nan),
            ("Pi1 + |Pi|", [1.0, nan, 0.0], "Pi[2]", "", nan),
            // derivatives
            ("|Pi|^1.5 + sqrt(Pi1)", [0.0; 3], "sqrt(Pi1)", "Pi1", infinite),
            ("|Pi|^1.5 + sqrt(Pi2)", [0.0; 3], "sqrt(Pi2)", "Pi2", infinite),
            ("if(Pi1 > 0, sqrt(Pi1), |Pi|)", [0.0; 3], "|Pi|", "Pi1", nan),
        ] {
            let found = parts(text, z);
            let found = found.as_ref().map(|(a, b, c)| (a.as_str(), b.as_str(), c.to_string()));
            assert_eq!(found, Some((term, coordinate, value.to_string())), "{text}");
        }
        Ok(())
    }
}
