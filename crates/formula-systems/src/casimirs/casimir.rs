//! A Casimir function: [`Casimir`], and what it shares with formulas: [`ScalarFunction`].

use super::computed::computed_casimir::ComputedCasimir;
use core::fmt;
use lie_poisson_formulas::Formula;

/// A function of the coordinates of 𝔤∗ with its differential, such as a [`Formula`] or a [`Casimir`].
pub trait ScalarFunction: fmt::Display + fmt::Debug {
    /// Returns the value at coordinates in a slice, or NaN if there are fewer or more than those of 𝔤∗.
    fn value_at(&self, mu: &[f64]) -> f64;

    /// Writes the derivatives ∂f/∂μ_i at coordinates in a slice. They are NaN if there are fewer or more coordinates than
    /// those of 𝔤∗. Those for which there is no room are left out.
    fn write_differential(&self, mu: &[f64], slopes: &mut [f64]);

    /// Returns the derivatives ∂f/∂μ_i at coordinates in a slice.
    fn differential_at(&self, mu: &[f64]) -> Vec<f64> {
        let mut slopes = vec![f64::NAN; mu.len()];
        self.write_differential(mu, &mut slopes);
        slopes
    }
}

impl ScalarFunction for Formula {
    fn value_at(&self, mu: &[f64]) -> f64 {
        Self::value_at(self, mu)
    }

    fn write_differential(&self, mu: &[f64], slopes: &mut [f64]) {
        Self::write_differential(self, mu, slopes);
    }
}

/// A Casimir function, a homogeneous polynomial: a formula, or computed from matrices where its formula would be longer than a
/// formula may be.
///
/// # Example
/// The invariants of so(8): the traces of even powers up to X⁶, and the Pfaffian, which is printed by its name and has the degree 4.
/// ```
/// use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
/// use lie_poisson_formulas::Parameters;
/// let so8 = SystemAlgebra::named("so(8)")?;
/// let body = FormulaSystem::new(so8, "L12^2", &Parameters::new())?.with_found_casimirs()?;
/// let named = body.casimirs().iter().find(|casimir| casimir.to_string() == "Pf X");
/// let pfaffian = |size: f64| named.map_or(0.0, |pfaffian| pfaffian.value_at(&[size; 28]));
/// assert!(pfaffian(1.0) != 0.0 && pfaffian(2.0) == 16.0 * pfaffian(1.0));
/// # Ok::<(), lie_poisson_formula_systems::FormulaSystemError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Casimir(Kind);

#[derive(Clone, Debug, PartialEq)]
enum Kind {
    Formula(Formula),
    Computed(ComputedCasimir),
}

impl Casimir {
    /// Returns the formula, or `None` if it would be too long.
    #[must_use]
    pub const fn formula(&self) -> Option<&Formula> {
        match &self.0 {
            Kind::Formula(formula) => Some(formula),
            Kind::Computed(_) => None,
        }
    }

    /// Returns the value at coordinates in a slice, or NaN if there are fewer or more than those of 𝔤∗.
    #[must_use]
    pub fn value_at(&self, mu: &[f64]) -> f64 {
        match &self.0 {
            Kind::Formula(formula) => formula.value_at(mu),
            Kind::Computed(casimir) => casimir.value_at(mu),
        }
    }

    /// Returns the derivatives ∂C/∂μ_i at coordinates in a slice, or NaN if there are fewer or more than those of 𝔤∗.
    #[must_use]
    pub fn differential_at(&self, mu: &[f64]) -> Vec<f64> {
        ScalarFunction::differential_at(self, mu)
    }
}

impl ScalarFunction for Casimir {
    fn value_at(&self, mu: &[f64]) -> f64 {
        Self::value_at(self, mu)
    }

    fn write_differential(&self, mu: &[f64], slopes: &mut [f64]) {
        match &self.0 {
            Kind::Formula(formula) => formula.write_differential(mu, slopes),
            Kind::Computed(casimir) => casimir.write_differential(mu, slopes),
        }
    }
}

impl From<Formula> for Casimir {
    fn from(formula: Formula) -> Self {
        Self(Kind::Formula(formula))
    }
}

impl From<ComputedCasimir> for Casimir {
    fn from(casimir: ComputedCasimir) -> Self {
        Self(Kind::Computed(casimir))
    }
}

impl fmt::Display for Casimir {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Kind::Formula(formula) => formula.fmt(to),
            Kind::Computed(casimir) => casimir.fmt(to),
        }
    }
}
