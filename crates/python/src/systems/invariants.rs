//! The conserved quantities of a system along a run.

use crate::errors::message;
use crate::runs::recording::Quantities;
use lie_poisson_formula_systems::FormulaSystem;

/// The Hamiltonian and the Casimirs of a system.
pub(super) struct Invariants<'a>(pub(super) &'a FormulaSystem);

impl Quantities for Invariants<'_> {
    fn count(&self) -> usize {
        1 + self.0.casimirs().len()
    }

    fn append(&self, mu: &[f64], values: &mut Vec<f64>) {
        values.push(self.0.hamiltonian().value_at(mu));
        values.extend(self.0.casimirs().iter().map(|casimir| casimir.value_at(mu)));
    }

    /// Names the formula, its part without a value, and the state.
    fn without_value(&self, mu: &[f64]) -> String {
        self.0
            .invariants(mu)
            .map_or_else(|error| message(&error), |_| "an invariant is not finite".into())
    }
}
