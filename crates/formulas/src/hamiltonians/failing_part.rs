//! The part because of which a formula has no value, or no derivative, at a state.

use super::formula::Formula;
use crate::text::formula_error::Problem;
use crate::text::syntax::{Operator, Part, Syntax};

/// A scalar part of a formula, or a component of a vector part, that fails.
struct Failing {
    place: usize,
    component: Option<usize>,
    formula: Formula,
    value: f64,
}

impl Formula {
    /// Returns the innermost part that fails, with the number that is not finite.
    ///
    /// `failure` returns that number for a formula that fails, and `None` for every other. From the whole the search goes
    /// to a part only if that part fails and matters: of an `if`, that is the chosen formula, or the condition if it is not
    /// a number. A formula with a short text is not taken apart, since its parts are too many to be shown.
    pub(super) fn failing_part(
        &self,
        z: &[f64],
        failure: impl Fn(&Self) -> Option<f64>,
    ) -> Option<(Self, f64)> {
        let syntax = self.syntax();
        let last = syntax.parts().count().checked_sub(1)?;
        let (formula, value) = (self.clone(), failure(self)?);
        if self.short().is_some() {
            return Some((formula, value));
        }
        let mut found = Failing { place: last, component: None, formula, value };
        while let Some(inner) = self.failing_within(&found, z, &failure) {
            found = inner;
        }
        Some((found.formula, found.value))
    }

    /// Returns the part of a failing part that makes it fail, or `None` if all its parts are finite.
    fn failing_within(
        &self,
        whole: &Failing,
        z: &[f64],
        failure: impl Fn(&Self) -> Option<f64>,
    ) -> Option<Failing> {
        let (parts, component) = self.causes(whole, z)?;
        let mut failing = Vec::new();
        for place in parts {
            for (own, formula) in self.scalars(place) {
                let matters = component.is_none() || own.is_none() || own == component;
                if let Some(value) = failure(&formula).filter(|_| matters) {
                    failing.push(Failing { place, component: own, formula, value });
                }
            }
        }
        // ∞ + NaN is not a number because of the second term.
        let alike = |part: &Failing| part.value.is_nan() == whole.value.is_nan();
        let first = failing.iter().position(alike).unwrap_or(0);
        failing.into_iter().nth(first)
    }

    /// Returns the places of the parts on which the value of a part depends at a state, and the only component of vectors
    /// among them on which it depends, if there is one.
    fn causes(&self, whole: &Failing, z: &[f64]) -> Option<(Vec<usize>, Option<usize>)> {
        let syntax = self.syntax();
        let (part, _) = syntax.parts().nth(whole.place)?;
        Some(match part {
            Part::Choose(comparison, [a, b, holds, fails]) => {
                let (above, below, is_contrary) = comparison.sides(a, b);
                let mut difference = syntax.clone();
                let minus = Part::Binary(Operator::Subtract, above, below);
                let place = difference.add(minus, 0..0);
                let value = self.with_syntax(difference.up_to(place)?).ok()?.value_at(z);
                if value.is_nan() {
                    return Some((vec![a, b], None));
                }
                let chosen = if (value >= 0.0) == is_contrary { fails } else { holds };
                (vec![chosen], whole.component)
            }
            Part::Component(x, index) => (vec![x], Some(index)),
            Part::Binary(Operator::Dot | Operator::Cross, x, y) => (vec![x, y], None),
            Part::Norm(x) => (vec![x], None),
            _ => (part.parts().collect(), whole.component),
        })
    }

    /// Returns a part, or its components with their numbers if it is a vector.
    fn scalars(&self, place: usize) -> Vec<(Option<usize>, Self)> {
        let Some(syntax) = self.syntax().up_to(place) else { return Vec::new() };
        let problem = match self.with_syntax(syntax.clone()) {
            Ok(formula) => return vec![(None, formula)],
            Err(error) => error.problem().clone(),
        };
        let Problem::NotAScalar { dimension } = problem else { return Vec::new() };
        let component = |index| {
            let formula = self.with_syntax(component_of(syntax.clone(), index)?).ok()?;
            Some((Some(index), formula))
        };
        (1..=dimension).filter_map(component).collect()
    }
}

/// Returns the tree of a component of a vector.
fn component_of(mut vector: Syntax, index: usize) -> Option<Syntax> {
    let last = vector.parts().count().checked_sub(1)?;
    vector.add(Part::Component(last, index), 0..0);
    Some(vector)
}
