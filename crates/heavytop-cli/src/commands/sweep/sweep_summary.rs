//! The summary of a sweep, which `heavytop sweep` prints.

use super::measured_row::Row;
use super::pictures::SweepPicture;
use super::sweep_plan::Plan;
use crate::vocabulary::brief::number;
use serde::Serialize;
use serde_json::{Map, Value};
use std::fmt;
use std::path::{Path, PathBuf};

/// The summary of a sweep, in numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SweepSummary {
    /// The folder of the table and the pictures.
    pub out: PathBuf,
    /// The number of tops, where tops are swept.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tops: Option<u64>,
    /// The number of runs: of tops, or of motions of another system.
    pub runs: u64,
    /// The Casimirs of a system by the names of their columns, as formulas, where all members have the same.
    #[serde(skip_serializing_if = "Map::is_empty")]
    pub casimirs: Map<String, Value>,
    /// The formulation's name.
    pub formulation: &'static str,
    /// The scheme's name.
    pub scheme: &'static str,
    /// The time step, s.
    pub step: f64,
    /// The time for which each run was followed, s.
    pub end: f64,
    /// The largest estimated error of the members that were measured, to two digits, relative to the state: some spread
    /// evenly over the sweep, and those at the corners of a grid.
    pub error_estimate: Option<f64>,
    /// The number of runs that could not be followed.
    pub failed: u64,
    /// The reason why the first of the failed runs could not be followed.
    pub first_failure: Option<String>,
    /// The word for the runs.
    #[serde(skip)]
    nouns: &'static str,
    /// The word for the pictures, if there are any.
    #[serde(skip)]
    pictures: Option<&'static str>,
}

impl SweepSummary {
    /// Creates the summary of a sweep in which nothing has failed yet.
    pub(super) fn new(plan: &Plan, error_estimate: Option<f64>, out: &Path) -> Self {
        let method = plan.family.method();
        let (formulation, scheme) = (method.formulation(), method.scheme());
        let casimirs = plan.family.casimirs().into_iter().map(Value::from);
        Self {
            out: out.into(),
            tops: Some(plan.members).filter(|_| plan.config.system.is_none()),
            runs: plan.members,
            casimirs: (1..).map(|i| format!("c{i}")).zip(casimirs).collect(),
            formulation: formulation.name(),
            scheme: scheme.name(),
            step: plan.course.schedule.step,
            end: plan.course.schedule.end(),
            error_estimate,
            failed: 0,
            first_failure: None,
            nouns: plan.nouns(),
            pictures: SweepPicture::of(plan).map(SweepPicture::nouns),
        }
    }

    /// Counts the rows that failed.
    pub(super) fn add(&mut self, rows: &[Row]) {
        for failure in rows.iter().filter_map(|row| row.failure.as_ref()) {
            self.failed += 1;
            self.first_failure.get_or_insert_with(|| failure.clone());
        }
    }
}

impl fmt::Display for SweepSummary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { out, runs, nouns, formulation, scheme, step, end, failed, .. } = self;
        let (step, end) = (number(*step), number(*end));
        writeln!(f, "{runs} {nouns}, each by {formulation}, {scheme}, step {step} s, to {end} s")?;
        for (name, formula) in &self.casimirs {
            writeln!(f, "{name} = {}", formula.as_str().unwrap_or_default())?;
        }
        if let Some(error) = self.error_estimate {
            writeln!(f, "estimated error of the worst of some {nouns}: {error:.1e} of the state")?;
        }
        if let Some(reason) = &self.first_failure {
            writeln!(f, "{failed} failed, see the column failure; the first: {reason}")?;
        }
        match self.pictures {
            Some(pictures) => write!(f, "table and {pictures} are in {}", out.display()),
            None => write!(f, "the table is in {}", out.display()),
        }
    }
}
