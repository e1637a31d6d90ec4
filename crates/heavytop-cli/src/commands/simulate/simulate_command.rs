//! The command `simulate`: runs a configuration and writes the output.

use super::checkpoint::Checkpoint;
use super::recording::{RecordedRun, Recording};
use super::renewal::Renewal;
use super::run_summary::{Deviations, RunSummary};
use super::simulate_options::SimulateOptions;
use crate::Error;
use crate::configuration::Config;
use crate::formats::RunTable;
use crate::runs::method_warning::method_warning;
use crate::runs::run_check::accuracy_warning;
use crate::supervision::Progress;
use crate::supervision::warnings::warn;
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
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn simulate(
    config: &Config,
    out: &Path,
    options: &SimulateOptions<'_>,
) -> Result<RunSummary, Error> {
    let experiment = config.experiment()?;
    let (table, pace) = (RunTable::new(&experiment), experiment.pace());
    let config = config.with_integrator();
    let dimension = experiment.dimension()?;
    let recorded = RecordedRun { pace, dimension, table: &table, casimirs: Vec::new() };
    let mut recording = Recording::begin(out, &config, &recorded, options)?;
    let accuracy = options.estimated(|going| experiment.accuracy(going))?;
    recording.add_estimate(accuracy.error);
    let warnings = [method_warning(&experiment.method), accuracy_warning(&accuracy)];
    warnings.into_iter().flatten().for_each(warn);
    let initial = table.values_at(&experiment.start).collect();
    let mut deviations = Deviations::new(initial, options.resume);
    let progress = Progress::new(&experiment, options.quiet);
    let saved = options.resume.map(Checkpoint::saved);
    progress.begin(saved.as_ref().map_or(0, |saved| saved.step));
    let mut renewal = Renewal::new(options, pace.schedule.steps);
    let (mut row, mut last) = (Vec::with_capacity(table.width()), experiment.start);
    let outcome = experiment.follow(saved.as_ref(), |moment| {
        progress.at(moment.step);
        last = *moment.momentum;
        if pace.keeps(moment.step) {
            table.fill(&mut row, moment);
            deviations.add(table.invariant_values(&row));
            recording.append(&row)?;
        }
        renewal.pause(moment.step, || moment.saved(), &mut recording, &deviations)
    });
    drop(progress);
    let summary = RunSummary::new(out.into(), &experiment, &last, &deviations, &table);
    recording.conclude(outcome)?;
    let check = options.check.then(|| experiment.check(&|| options.going())).transpose()?;
    Ok(RunSummary { error_estimate: accuracy.error, check, ..summary })
}
