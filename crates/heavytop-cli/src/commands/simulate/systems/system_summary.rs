//! The summary of a run of a system, which `heavytop simulate --json` prints.

use crate::Error;
use crate::commands::simulate::run_summary::{Deviations, write_deviations};
use crate::files::place::shown;
use crate::formats::RunTable;
use crate::runs::run_check::{write_accuracy, write_method};
use crate::runs::{RunCheck, SystemExperiment};
use serde::Serialize;
use serde_json::{Map, Value};
use std::fmt;
use std::path::PathBuf;

/// The summary of a run of a system, in numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SystemSummary {
    /// The path of the output.
    pub out: PathBuf,
    /// The name of the algebra.
    pub algebra: String,
    /// The Hamiltonian as a formula.
    pub hamiltonian: String,
    /// The formulation's name.
    pub formulation: &'static str,
    /// The scheme's name.
    pub scheme: &'static str,
    /// Whether the steps descend to 𝔤∗; if not, they are not Poisson maps.
    pub descends: bool,
    /// The time step, s.
    pub step: f64,
    /// The number of steps.
    pub steps: u64,
    /// The number of rows of the output, that of the initial state included.
    pub rows: u64,
    /// The time after the last step, s.
    pub end: f64,
    /// The coordinates after the last step, by their names.
    pub last: Map<String, Value>,
    /// The Casimirs by the names of their columns, as formulas.
    pub casimirs: Map<String, Value>,
    /// The largest deviations max |invariant − initial value| over the rows of the output, by the names of the
    /// columns.
    pub deviations: Map<String, Value>,
    /// The estimated error of the run, to two digits: the largest |Δμ_b|/|μ_b| over the vectors and scalars b of
    /// coordinates. 1 means that nothing of the state is right.
    pub error_estimate: Option<f64>,
    /// The result of a check of the whole run, if it was asked for.
    #[serde(flatten)]
    pub check: Option<RunCheck>,
}

impl SystemSummary {
    /// Creates the summary of a run that ended in a row, as yet without its accuracy.
    pub(super) fn new(
        out: PathBuf,
        experiment: &SystemExperiment,
        last: &[f64],
        deviations: &Deviations,
        table: &RunTable,
    ) -> Result<Self, Error> {
        let SystemExperiment { system, method, pace, .. } = experiment;
        let names = system.algebra().coordinates().names();
        let casimirs = system.casimirs().iter().map(|casimir| casimir.to_string().into());
        Ok(Self {
            out,
            algebra: system.algebra().name().into(),
            hamiltonian: system.hamiltonian().to_string(),
            formulation: method.formulation().name(),
            scheme: method.scheme().name(),
            descends: method.descends(system, &experiment.start)?,
            step: pace.schedule.step,
            steps: pace.schedule.steps,
            rows: pace.rows(),
            end: pace.schedule.end(),
            last: names.zip(last.iter().skip(1).map(|&x| x.into())).collect(),
            casimirs: (1..).map(|i| format!("c{i}")).zip(casimirs).collect(),
            deviations: deviations.by_name(table),
            error_estimate: None,
            check: None,
        })
    }
}

impl fmt::Display for SystemSummary {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "{} rows in {}", self.rows, shown(&self.out))?;
        for (name, text) in &self.casimirs {
            write!(to, "; {name} = {}", text.as_str().unwrap_or_default())?;
        }
        if !self.descends {
            write!(to, "; the steps are not Poisson maps")?;
        }
        write!(to, "; largest deviations")?;
        write_deviations(to, &self.deviations)?;
        write_accuracy(to, self.error_estimate, self.check.as_ref())?;
        write_method(to, (self.formulation, self.scheme), (self.step, self.end))
    }
}
