//! The command `simulate`: runs a configuration and writes the output.

use super::checkpoints::checkpoint::Checkpoint;
use super::recording::{RecordedRun, Recording};
use super::renewal::Renewal;
use super::run_balance::RunBalance;
use super::run_summary::{Described, Deviations, RunSummary};
use super::simulate_options::SimulateOptions;
use crate::configuration::Config;
use crate::errors::Error;
use crate::formats::RunTable;
use crate::runs::RunCheck;
use crate::supervision::Progress;
use crate::supervision::warnings::warn;
use lie_poisson::larger;
use std::path::Path;

/// Runs the configuration and writes `out`, in the format that its ending names.
///
/// Until the run is complete its rows are in `OUT.partial` for CSV. Otherwise they are in `OUT.rows` as 64-bit
/// numbers, which takes as much disk again as the output does. An interrupted run continues from `OUT.checkpoint`.
/// Its file then equals that of an uninterrupted run byte for byte.
///
/// Warnings about the method, and about steps that are too long, go to stderr.
///
/// # Errors
/// If the request is wrong, another run is writing the output, or there is a checkpoint that shall be neither resumed
/// nor discarded: then nothing is written. If the run fails: then what was computed until then is kept as
/// `OUT.partial`. If it was stopped, or the disk is full: then it can be resumed from its checkpoint.
///
/// # Example
/// ```
/// use heavytop_cli::configuration::Config;
/// use heavytop_cli::commands::simulate::{SimulateOptions, simulate};
/// let folder = tempfile::tempdir()?;
/// let out = folder.path().join("kovalevskaya.npz");
/// let summary = simulate(&Config::default(), &out, &SimulateOptions::default())?;
/// assert_eq!((summary.steps, summary.end), (5000, 100.0));
/// assert!(summary.deviations["f1"].as_f64() < Some(1e-12));
/// assert!(out.exists());
///
/// let config: Config = toml::from_str(r#"
///     [system]
///     coordinates = ["K", "H", "P"]
///     brackets = { "K, H" = "P", "K, P" = "H" }
///     hamiltonian = "0.5*K^2 + H^2 + 0.5*P^2"
///     initial = { K = 0.1, H = 0.3, P = 0.2 }
///     [integrator]
///     end = 20.0
/// "#)?;
/// let summary = simulate(&config, &folder.path().join("poincare.csv"), &SimulateOptions::default())?;
/// assert!(summary.to_string().contains("c1 = H^2 - P^2"));
/// assert!(summary.deviations["c1"].as_f64() < Some(1e-12));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn simulate(
    config: &Config,
    out: &Path,
    options: &SimulateOptions<'_>,
) -> Result<RunSummary, Error> {
    let run = config.run()?;
    let (run, config) = (&*run, config.with_integrator());
    let (table, pace) = (RunTable::new(run, &config.output.columns)?, run.pace);
    let requested = config.top_columns()?;
    let described = Described::new(run)?;
    let formulas = described.casimirs.iter().flatten();
    let casimirs = formulas.filter_map(|(_, text)| text.as_str().map(String::from)).collect();
    let (dimension, resumable_after) = (run.dimension()?, run.model.resumable_after());
    let recorded = RecordedRun { pace, dimension, resumable_after, table: &table, casimirs };
    if options.measures.balance {
        run.model.require_balance(&run.start)?;
    }
    let mut recording = Recording::begin(out, &config, &recorded, options)?;
    let accuracy = options.estimated(|going| Ok(run.accuracy(going)?))?;
    recording.add_estimate(accuracy.error);
    let of_accuracy =
        run.model.accuracy_warning(&run.start, &accuracy).map(|text| format!("warning: {text}"));
    [run.warning()?, of_accuracy].into_iter().flatten().for_each(warn);
    let mut deviations = Deviations::new(run.initial()?, options.resume);
    let progress = Progress::new(run, options.quiet);
    let saved = options.resume.map(Checkpoint::saved);
    progress.begin(saved.as_ref().map_or(0, |saved| saved.step));
    let (mut renewal, mut last) = (Renewal::new(options, run), Vec::new());
    let outcome = run.follow(saved.as_ref(), |moment| {
        progress.at(moment.step);
        if pace.keeps(moment.step) {
            last.clear();
            last.extend_from_slice(moment.row);
            requested.iter().for_each(|columns| columns.complete(&mut last));
            deviations.add(table.invariant_values(&last));
            recording.append(&last)?;
        }
        renewal.pause(moment.step, || moment.saved(), &mut recording, &deviations)
    });
    drop(progress);
    let end = last.get(1..=dimension).unwrap_or_default();
    run.model.warning_of_end(&run.start, end).into_iter().for_each(warn);
    recording.conclude(outcome)?;
    let check = || RunCheck::of(run.compared(&|| options.going())?, &run.method);
    let check = options.measures.check.then(check).transpose()?;
    check.and_then(|check| check.warning(&accuracy)).into_iter().for_each(warn);
    let checked = check.and_then(|check| check.error);
    let error_estimate = accuracy.error.into_iter().chain(checked).reduce(larger);
    let balance = || Ok::<_, Error>(RunBalance::of(run.balances(&|| options.going())?));
    let balance = options.measures.balance.then(balance).transpose()?;
    let summary = RunSummary::new(out.into(), run, &last, &deviations, &table);
    Ok(RunSummary { described, error_estimate, check, balance, ..summary })
}
