//! The summary of a run, which `heavytop simulate --json` prints.

use super::checkpoints::checkpoint::Checkpoint;
use super::run_balance::RunBalance;
use crate::errors::Error;
use crate::files::place::shown;
use crate::formats::RunTable;
use crate::runs::run_check::{write_accuracy, write_method};
use crate::runs::{Experiment, RunCheck};
use lie_poisson::larger;
use serde::Serialize;
use serde_json::{Map, Value};
use std::fmt;
use std::path::PathBuf;

/// The summary of a run, in numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RunSummary {
    /// The path of the output.
    pub out: PathBuf,
    /// What is told of a system by formula.
    #[serde(flatten)]
    pub described: Described,
    /// The formulation's name.
    pub formulation: &'static str,
    /// The scheme's name.
    pub scheme: &'static str,
    /// The time step, s.
    pub step: f64,
    /// The number of steps.
    pub steps: u64,
    /// The number of rows of the output, that of the initial state included.
    pub rows: u64,
    /// The time after the last step, s.
    pub end: f64,
    /// The coordinates after the last step: the vectors `angular_momentum` (Π, kg m²/s) and `vertical` (Γ) of a top, and
    /// those of a system by their names in `last`.
    #[serde(flatten)]
    pub last: Map<String, Value>,
    /// The largest deviations max |invariant − initial value| over the rows of the output, by the names of the
    /// columns.
    pub deviations: Map<String, Value>,
    /// The largest changes of quantities that the motion does not keep, such as the energy of one with friction.
    #[serde(skip_serializing_if = "Map::is_empty")]
    pub changes: Map<String, Value>,
    /// The seed and the number of the path of the noise, if there is noise.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub noise: Option<NoisePath>,
    /// The estimated error of the run, to two digits: the largest |Δμ_b|/|μ_b| over the vectors and scalars b of
    /// coordinates, such as Π and Γ. 1 means that nothing of the state is right.
    pub error_estimate: Option<f64>,
    /// The result of a check of the whole run, if it was asked for.
    #[serde(flatten)]
    pub check: Option<RunCheck>,
    /// What the forces supplied to the conserved quantities, if that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub balance: Option<RunBalance>,
}

impl RunSummary {
    /// Creates the summary of a run that ended in a row, as yet without its accuracy and its description.
    pub(super) fn new(
        out: PathBuf,
        run: &Experiment,
        row: &[f64],
        deviations: &Deviations,
        table: &RunTable,
    ) -> Self {
        let (method, pace) = (&run.method, run.pace);
        let (kept, all) = (run.kept(), deviations.by_name(table));
        let is_kept = |name: &String| {
            let place = table.invariants().iter().position(|other| other == name);
            place.and_then(|place| kept.get(place)).is_none_or(|kept| *kept)
        };
        let (deviations, changes) = all.into_iter().partition(|(name, _)| is_kept(name));
        Self {
            out,
            described: Described::default(),
            formulation: method.formulation().name(),
            scheme: method.scheme().name(),
            step: pace.schedule.step,
            steps: pace.schedule.steps,
            rows: pace.rows(),
            end: pace.schedule.end(),
            last: last(run, row),
            deviations,
            changes,
            noise: run.model.noise().map(|(seed, path)| NoisePath { seed, path }),
            error_estimate: None,
            check: None,
            balance: None,
        }
    }

    /// Returns whether a request to stop has come between the run and a measure of it.
    #[must_use]
    pub fn was_interrupted(&self) -> bool {
        self.check.is_some_and(|check| check.was_interrupted())
            || self.balance.as_ref().is_some_and(RunBalance::was_interrupted)
    }
}

impl fmt::Display for RunSummary {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "{} rows in {}", self.rows, shown(&self.out))?;
        let Described { casimirs, descends, .. } = &self.described;
        for (name, text) in casimirs.iter().flatten() {
            write!(to, "; {name} = {}", text.as_str().unwrap_or_default())?;
        }
        if *descends == Some(false) {
            write!(to, "; the steps are not Poisson maps")?;
        }
        if let Some(NoisePath { seed, path }) = self.noise {
            write!(to, "; noise of seed {seed}, path {path}")?;
        }
        if !self.deviations.is_empty() {
            write!(to, "; largest deviations")?;
            write_deviations(to, &self.deviations)?;
        }
        if !self.changes.is_empty() {
            write!(to, "; largest changes, of what the motion does not keep,")?;
            write_deviations(to, &self.changes)?;
        }
        if let Some(balance) = &self.balance {
            balance.write(to, |name| self.changes.contains_key(name))?;
        }
        let what = if self.noise.is_some() { "this path" } else { "the state" };
        write_accuracy(to, (self.error_estimate, what), self.check.as_ref())?;
        write_method(to, (self.formulation, self.scheme), (self.step, self.end))
    }
}

/// The Brownian motions of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct NoisePath {
    /// The seed of the random numbers.
    pub seed: u64,
    /// The number of the path.
    pub path: u64,
}

/// What the summary of a run tells of a system by formula; nothing of a top.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Described {
    /// The name of the algebra.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub algebra: Option<String>,
    /// The Hamiltonian as a formula.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hamiltonian: Option<String>,
    /// Whether the steps descend to 𝔤∗; if not, they are not Poisson maps.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub descends: Option<bool>,
    /// The Casimirs by the names of their columns, as formulas.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub casimirs: Option<Map<String, Value>>,
}

/// The name of the energy among the conserved quantities.
const ENERGY: &str = "h";

impl Described {
    /// Describes the system of a run.
    ///
    /// # Errors
    /// If there is no such method.
    pub(super) fn new(run: &Experiment) -> Result<Self, Error> {
        let Some(hamiltonian) = run.model.formula(ENERGY) else { return Ok(Self::default()) };
        let casimirs = run.conserved().into_iter().filter(|name| name != ENERGY);
        let formulas = casimirs.filter_map(|name| Some((run.model.formula(&name)?.into(), name)));
        Ok(Self {
            algebra: Some(run.model.algebra_name()),
            hamiltonian: Some(hamiltonian),
            descends: Some(run.model.descends(&run.method, &run.start)?),
            casimirs: Some(formulas.map(|(formula, name)| (name, formula)).collect()),
        })
    }
}

/// The largest number of coordinates that a summary has.
const MOST_SHOWN: usize = 256;

/// Returns the last coordinates by their names in the summary.
fn last(run: &Experiment, row: &[f64]) -> Map<String, Value> {
    let columns = run.model.columns();
    let keys = if run.model.formula(ENERGY).is_none() {
        let vector = |from: usize| row.get(from..from + 3).unwrap_or_default().into();
        vec![("angular_momentum", vector(1)), ("vertical", vector(4))]
    } else {
        // Nobody reads more of them; the output has them all.
        let shown = if columns.len() > MOST_SHOWN { Vec::new() } else { columns };
        let last: Map<_, _> =
            shown.into_iter().zip(row.iter().skip(1).map(|&x| x.into())).collect();
        vec![("last", last.into())]
    };
    keys.into_iter().map(|(name, values)| (name.to_owned(), values)).collect()
}

/// Writes the names of the invariants with their deviations.
fn write_deviations(to: &mut fmt::Formatter<'_>, deviations: &Map<String, Value>) -> fmt::Result {
    let mut deviations: Vec<_> = deviations.iter().collect();
    // c2 stands before c10.
    deviations.sort_by_key(|(symbol, _)| {
        let digits = symbol.trim_start_matches(|c: char| !c.is_ascii_digit());
        (symbol.trim_end_matches(digits), digits.parse::<u64>().unwrap_or(0))
    });
    for (number, (symbol, deviation)) in deviations.into_iter().enumerate() {
        let comma = if number == 0 { "" } else { "," };
        write!(to, "{comma} {symbol} {:.1e}", deviation.as_f64().unwrap_or(f64::NAN))?;
    }
    Ok(())
}

/// The largest deviations of the invariants from their initial values.
pub(super) struct Deviations {
    initial: Vec<f64>,
    pub largest: Vec<f64>,
}

impl Deviations {
    /// Starts from zero, or from the deviations of a checkpoint.
    pub fn new(initial: Vec<f64>, from: Option<&Checkpoint>) -> Self {
        let before = from.map(|checkpoint| checkpoint.deviations.clone());
        Self { largest: before.unwrap_or_else(|| vec![0.0; initial.len()]), initial }
    }

    /// Returns the deviations by the names of the columns.
    pub fn by_name(&self, table: &RunTable) -> Map<String, Value> {
        let values = self.largest.iter().map(|&deviation| Value::from(deviation));
        table.invariants().iter().cloned().zip(values).collect()
    }

    pub fn add(&mut self, values: &[f64]) {
        for ((most, value), initial) in self.largest.iter_mut().zip(values).zip(&self.initial) {
            *most = larger(*most, (value - initial).abs());
        }
    }
}
