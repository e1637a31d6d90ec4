//! The place of an error within a formula that a configuration contains.

use crate::errors::{Error, SystemTableError};
use lie_poisson_formula_systems::{FormulaSystemError, OpenSystemError};
use lie_poisson_formulas::{FormulaError, Problem};
use std::ops::Range;

/// Returns the place of an error of a formula within the text of its value, which stands at `span`, or else all of the
/// value.
///
/// In a text with escapes, such as `\"`, places cannot be counted: all of the value is marked.
pub(super) fn within(text: &str, span: Range<usize>, error: &Error) -> Range<usize> {
    let source = formula_error(error).filter(|source| *source.problem() != Problem::Empty);
    let Some(source) = source else { return span };
    let value = text.get(span.clone()).unwrap_or_default();
    let Some(quotes) = ["\"\"\"", "'''", "\"", "'"].into_iter().find(|q| value.starts_with(q))
    else {
        return span;
    };
    let inner = value.get(quotes.len()..).unwrap_or_default();
    // The line end after three quotes does not belong to the text.
    let line_end =
        ["\r\n", "\n"].into_iter().find(|end| quotes.len() == 3 && inner.starts_with(end));
    if quotes.starts_with('"') && value.contains('\\') {
        return span;
    }
    let first = span.start + quotes.len() + line_end.map_or(0, str::len);
    let last = span.end.saturating_sub(quotes.len()).max(first);
    let Range { start, end } = source.span();
    (first + start).min(last)..(first + end).min(last)
}

/// Returns the error of the formula that an error is about.
fn formula_error(error: &Error) -> Option<&FormulaError> {
    use FormulaSystemError as E;
    let error = match error {
        Error::System(error) => match &**error {
            SystemTableError::Formula(error) => error,
            _ => return None,
        },
        Error::EventFunction { source, .. } => return Some(source),
        Error::SystemSection(error) => error,
        _ => return None,
    };
    match error {
        E::Bracket { problem, .. } | E::Axis { problem, .. } => Some(problem),
        E::Hamiltonian(problem) | E::Surface(problem) => Some(problem),
        E::Open(OpenSystemError::Formula { reason, .. }) => Some(reason),
        _ => None,
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use lie_poisson::So3;
    use lie_poisson_formulas::{Formula, Parameters, Vocabulary};

    #[test]
    fn the_place_in_the_formula_is_found_in_the_text() {
        let names = Vocabulary::of(&So3, &Parameters::new()).unwrap();
        let source = Formula::new("Π₁ + Pj2", &names).unwrap_err();
        let error = FormulaSystemError::Hamiltonian(source).into();
        for (text, marked) in [
            ("h = 'Π₁ + Pj2' # 1", "Pj2"),
            ("h = \"Π₁ + Pj2\"", "Pj2"),
            ("h = '''\nΠ₁ + Pj2'''", "Pj2"),
            ("h = \"\"\"Π₁ + Pj2\"\"\"", "Pj2"),
            ("h = \"Π₁ \\u002b Pj2\"", "\"Π₁ \\u002b Pj2\""),
            ("h = 1", "1"),
        ] {
            let end = text.find(" #").unwrap_or(text.len());
            assert_eq!(&text[within(text, 4..end, &error)], marked, "{text}");
        }
        let other = Error::AzimuthAlone;
        assert_eq!(within("h = 'x'", 4..7, &other), 4..7);
    }
}
