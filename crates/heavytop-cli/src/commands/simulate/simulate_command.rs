//! The command `simulate`: runs a configuration and writes the output.

use super::checkpoint::{Checkpoint, argument};
use super::recording::Recording;
use super::run_summary::{Deviations, RunSummary};
use super::simulate_options::SimulateOptions;
use crate::Error;
use crate::configuration::{Config, Integration};
use crate::formats::RunTable;
use crate::runs::{Experiment, Moment};
use crate::supervision::Progress;
use collective_integrators::CHECKPOINT;
use lie_poisson::Se3Dual;
use std::path::Path;
use std::sync::atomic::Ordering;
use std::time::Instant;

/// Runs the configuration and writes `out`, in the format that its ending names.
///
/// Until the run is complete its rows are in `OUT.partial` for CSV. Otherwise they are in `OUT.rows` as 64-bit
/// numbers, which takes as much disk again as the output does. An interrupted run continues from `OUT.checkpoint`.
/// Its file then equals that of an uninterrupted run byte for byte.
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
    let table = RunTable::new(&experiment);
    // The configuration to write includes all that was left out.
    let integrator = config.integrator.or(Integration::default()).into();
    let config = Config { integrator, ..config.clone() };
    let mut recording = Recording::begin(out, &config, &experiment, &table, options)?;
    let deviations = Deviations::new(&table, &experiment, options.resume);
    let progress = Progress::new(&experiment, options.quiet);
    let saved = options.resume.map(Checkpoint::saved);
    progress.begin(saved.as_ref().map_or(0, |saved| saved.step));
    let mut run = Run {
        experiment: &experiment,
        table: &table,
        options,
        recording: &mut recording,
        progress,
        deviations,
        row: Vec::with_capacity(table.width()),
        last: experiment.start,
        renewed: Instant::now(),
    };
    let outcome = experiment.follow(saved.as_ref(), |moment| run.visit(moment));
    let summary = RunSummary::new(out.into(), &experiment, &run.last, &run.deviations, &table);
    drop(run);
    recording.conclude(outcome)?;
    Ok(summary)
}

/// The state of a run underway.
struct Run<'a> {
    experiment: &'a Experiment,
    table: &'a RunTable,
    options: &'a SimulateOptions<'a>,
    recording: &'a mut Recording,
    progress: Progress,
    deviations: Deviations,
    row: Vec<f64>,
    last: Se3Dual,
    /// The time of the last checkpoint.
    renewed: Instant,
}

impl Run<'_> {
    fn visit(&mut self, moment: &Moment<'_>) -> Result<(), Error> {
        self.progress.at(moment.step);
        self.last = *moment.momentum;
        if self.experiment.keeps(moment.step) {
            self.table.fill(&mut self.row, moment);
            self.deviations.add(self.table.invariant_values(&self.row));
            self.recording.append(&self.row)?;
        }
        if moment.step.is_multiple_of(CHECKPOINT) && moment.step < self.experiment.schedule.steps {
            self.pause(moment)?;
        }
        Ok(())
    }

    /// Makes a checkpoint when one is due, and ends the run when it shall stop.
    fn pause(&mut self, moment: &Moment<'_>) -> Result<(), Error> {
        let stop = self.options.stop.is_some_and(|stop| stop.load(Ordering::Relaxed));
        if !stop && self.renewed.elapsed() < self.options.interval {
            return Ok(());
        }
        let checkpoint = self.recording.save(moment.saved(), &self.deviations.largest)?;
        self.renewed = Instant::now();
        if stop {
            Err(Error::Interrupted { resume: checkpoint.as_deref().map(argument) })
        } else {
            Ok(())
        }
    }
}
