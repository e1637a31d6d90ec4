//! The summary of a sweep, which `heavytop sweep` prints.

use super::measured_row::Row;
use super::sweep_plan::Plan;
use crate::vocabulary::brief::number;
use serde::Serialize;
use std::fmt;
use std::path::{Path, PathBuf};

/// The summary of a sweep, in numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SweepSummary {
    /// The folder of the table and the heat maps.
    pub out: PathBuf,
    /// The number of tops.
    pub tops: u64,
    /// The formulation's name.
    pub formulation: &'static str,
    /// The scheme's name.
    pub scheme: &'static str,
    /// The time step, s.
    pub step: f64,
    /// The time for which each top was followed, s.
    pub end: f64,
    /// The number of tops that could not be followed.
    pub failed: u64,
    /// The reason why the first of the failed tops could not be followed.
    pub first_failure: Option<String>,
}

impl SweepSummary {
    /// Creates the summary of a sweep in which no top has failed yet.
    pub(super) fn new(plan: &Plan, out: &Path) -> Self {
        Self {
            out: out.into(),
            tops: plan.tops,
            formulation: plan.method.formulation().name(),
            scheme: plan.method.scheme().name(),
            step: plan.schedule.step,
            end: plan.schedule.end(),
            failed: 0,
            first_failure: None,
        }
    }

    /// Counts the tops that failed.
    pub(super) fn add(&mut self, rows: &[Row]) {
        for failure in rows.iter().filter_map(|row| row.failure.as_ref()) {
            self.failed += 1;
            self.first_failure.get_or_insert_with(|| failure.clone());
        }
    }
}

impl fmt::Display for SweepSummary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { out, tops, formulation, scheme, step, end, failed, first_failure } = self;
        let (step, end) = (number(*step), number(*end));
        writeln!(f, "{tops} tops, each by {formulation}, {scheme}, step {step} s, to {end} s")?;
        if let Some(reason) = first_failure {
            writeln!(f, "{failed} failed, see the column failure; the first: {reason}")?;
        }
        write!(f, "table and heat maps are in {}", out.display())
    }
}
