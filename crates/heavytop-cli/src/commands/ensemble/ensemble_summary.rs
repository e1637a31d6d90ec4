//! The summary of an ensemble of paths, which `heavytop ensemble` prints.

use crate::files::place;
use crate::runs::Experiment;
use crate::runs::run_check::write_method;
use lie_poisson_runs::PathRow;
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};

/// The summary of an ensemble, in numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct EnsembleSummary {
    /// The path of the table.
    pub out: PathBuf,
    /// The number of paths.
    pub paths: u64,
    /// The seed of the noise.
    pub seed: u64,
    /// The number of the first path.
    pub first_path: u64,
    /// The formulation's name.
    pub formulation: &'static str,
    /// The scheme's name.
    pub scheme: &'static str,
    /// The time step, s.
    pub step: f64,
    /// The time after the last step, s.
    pub end: f64,
    /// The number of rows of the table.
    pub rows: usize,
    /// The means at the end with their standard errors, by the names of the columns.
    pub last: BTreeMap<String, Mean>,
    /// The columns that the line names.
    #[serde(skip)]
    shown: Vec<String>,
}

/// A mean over the paths.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Mean {
    /// The mean.
    pub mean: f64,
    /// Its standard error.
    pub error: f64,
}

impl EnsembleSummary {
    pub(super) fn new(
        run: &Experiment,
        paths: u64,
        (names, rows): (&[&str], &[PathRow]),
        out: &Path,
    ) -> Self {
        let (seed, first_path) = run.model.noise().unwrap_or_default();
        let quantities = rows.last().map_or(&[][..], |row| &row.quantities);
        let means = quantities.iter().map(|of| Mean { mean: of.mean, error: of.error });
        Self {
            out: out.into(),
            paths,
            seed,
            first_path,
            formulation: run.method.formulation().name(),
            scheme: run.method.scheme().name(),
            step: run.pace.schedule.step,
            end: run.pace.schedule.end(),
            rows: rows.len(),
            last: names.iter().map(|name| (*name).to_owned()).zip(means).collect(),
            shown: shown(run, names),
        }
    }
}

/// The most means that a line names.
const MOST_SHOWN: usize = 12;

/// Returns the columns that a line names: all in the order of the alphabet, or, where they are too many, as of a lattice, those that are
/// no coordinates.
fn shown(run: &Experiment, names: &[&str]) -> Vec<String> {
    if names.len() > MOST_SHOWN {
        return run.conserved();
    }
    let mut names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
    names.sort_unstable();
    names
}

impl fmt::Display for EnsembleSummary {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let last = self.first_path.saturating_add(self.paths - 1);
        write!(to, "{} rows in {}; ", self.rows, place::shown(&self.out))?;
        write!(to, "paths {} to {last} of seed {}; at the end", self.first_path, self.seed)?;
        let shown = self.shown.iter().filter_map(|name| Some((name, self.last.get(name)?)));
        for (i, (name, Mean { mean, error })) in shown.take(MOST_SHOWN).enumerate() {
            let comma = if i > 0 { "," } else { "" };
            write!(to, "{comma} {name} {mean:.3e} ± {error:.0e}")?;
        }
        write_method(to, (self.formulation, self.scheme), (self.step, self.end))
    }
}
