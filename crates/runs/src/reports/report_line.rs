//! A line of a report: [`ReportLine`].

/// A number that was measured, beside those of formulas.
#[derive(Clone, Debug, PartialEq)]
pub struct ReportLine {
    /// What it is.
    pub name: &'static str,
    /// The measured number; `None` if the run is too short, or its steps are too long to show it.
    pub measured: Option<f64>,
    /// The unit.
    pub unit: &'static str,
    /// The formulas, each with its conditions and its value.
    pub formulas: Vec<(&'static str, f64)>,
}

impl ReportLine {
    /// Creates a line without a formula.
    pub(super) fn new(name: &'static str, measured: Option<f64>, unit: &'static str) -> Self {
        Self { name, measured, unit, formulas: Vec::new() }
    }

    /// Adds a formula, unless its value is not finite.
    pub(super) fn with(mut self, formula: &'static str, value: f64) -> Self {
        if value.is_finite() {
            self.formulas.push((formula, value));
        }
        self
    }
}
