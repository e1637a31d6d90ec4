//! The error of a formula without a value at a state: [`ValueError`].

use thiserror::Error;

/// The reason why a formula has no value, or no derivative, at a state: the part that has none, and the state.
///
/// # Example
/// ```
/// use lie_poisson::So3;
/// use lie_poisson_formulas::{Formula, Parameters, Vocabulary};
/// let h = Formula::new("Pi2^2 + ln(Pi1 - 5)", &Vocabulary::of(&So3, &Parameters::new())?)?;
/// assert_eq!(h.checked_value(&[6.0, 2.0, 0.0])?, 4.0);
/// let error = h.checked_value(&[1.0, 2.0, 0.0]).unwrap_err();
/// let text = "Pi2^2 + ln(Pi1 - 5) has no value at Pi1 = 1, Pi2 = 2, Pi3 = 0, where ln(Pi1 - 5) is not a number";
/// assert_eq!(error.to_string(), text);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ValueError {
    /// The value is infinite or not a number.
    #[error("{formula} has no value at {state}, where {term} is {}", kind(*.value))]
    Value {
        /// The formula.
        formula: String,
        /// The innermost of its parts because of which it has none.
        term: String,
        /// The value of this part.
        value: f64,
        /// The coordinates of the state, with their names.
        state: String,
    },
    /// A derivative is infinite or not a number, although the formula has a value.
    #[error(
        "{formula} has no derivative at {state}, where that of {term} with respect to {coordinate} is {}",
        kind(*.value)
    )]
    Derivative {
        /// The formula.
        formula: String,
        /// The innermost of its parts because of which it has none.
        term: String,
        /// The name of the coordinate of the derivative.
        coordinate: String,
        /// The derivative of this part.
        value: f64,
        /// The coordinates of the state, with their names.
        state: String,
    },
}

/// Returns a number that is not finite in words.
fn kind(value: f64) -> &'static str {
    if value.is_nan() { "not a number" } else { "infinite" }
}
