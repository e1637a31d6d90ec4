//! The command `simulate` for a Lie–Poisson system instead of a top.

use super::system_summary::SystemSummary;
use crate::Error;
use crate::commands::simulate::checkpoint::Checkpoint;
use crate::commands::simulate::recording::{RecordedRun, Recording};
use crate::commands::simulate::renewal::Renewal;
use crate::commands::simulate::run_summary::Deviations;
use crate::commands::simulate::simulate_options::SimulateOptions;
use crate::configuration::Config;
use crate::formats::RunTable;
use crate::runs::SystemExperiment;
use crate::runs::method_warning::system_warning;
use crate::runs::run_check::accuracy_warning;
use crate::supervision::Progress;
use crate::supervision::warnings::warn;
use std::path::Path;

/// Runs the system of a configuration and writes `out`, as [`simulate`](crate::commands::simulate::simulate) does for a top.
///
/// # Errors
/// Those of [`simulate`](crate::commands::simulate::simulate).
///
/// # Example
/// ```
/// use heavytop_cli::configuration::Config;
/// use heavytop_cli::commands::simulate::{SimulateOptions, simulate_system};
/// let config: Config = toml::from_str(r#"
///     [system]
///     coordinates = ["K", "H", "P"]
///     brackets = { "K, H" = "P", "K, P" = "H" }
///     hamiltonian = "0.5*K^2 + H^2 + 0.5*P^2"
///     initial = { K = 0.1, H = 0.3, P = 0.2 }
///
///     [integrator]
///     scheme = "gauss-8"
///     end = 20.0
/// "#)?;
/// let folder = tempfile::tempdir()?;
/// let out = folder.path().join("poincare.csv");
/// let experiment = config.system_experiment()?.ok_or("no system")?;
/// let summary = simulate_system(&config, &experiment, &out, &SimulateOptions::default())?;
/// assert_eq!(summary.casimirs["c1"], "H^2 - P^2");
/// assert!(summary.deviations["c1"].as_f64() < Some(1e-12));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn simulate_system(
    config: &Config,
    experiment: &SystemExperiment,
    out: &Path,
    options: &SimulateOptions<'_>,
) -> Result<SystemSummary, Error> {
    let (table, pace) = (RunTable::of_system(experiment)?, experiment.pace);
    let config = config.with_integrator();
    let casimirs = experiment.system.casimirs().iter().map(ToString::to_string).collect();
    let dimension = experiment.dimension()?;
    let recorded = RecordedRun { pace, dimension, table: &table, casimirs };
    let mut recording = Recording::begin(out, &config, &recorded, options)?;
    let accuracy = options.estimated(|going| experiment.accuracy(going))?;
    recording.add_estimate(accuracy.error);
    let method = system_warning(&experiment.method, &experiment.system, &experiment.start)?;
    [method, accuracy_warning(&accuracy)].into_iter().flatten().for_each(warn);
    let mut deviations = Deviations::new(experiment.initial_invariants()?, options.resume);
    let progress = Progress::of(pace.schedule.steps, "steps", options.quiet);
    let saved = options.resume.map(Checkpoint::saved);
    progress.begin(saved.as_ref().map_or(0, |saved| saved.step));
    let (mut renewal, mut last) = (Renewal::new(options, pace.schedule.steps), Vec::new());
    let outcome = experiment.follow(saved.as_ref(), |moment| {
        progress.at(moment.step);
        last.clear();
        last.extend_from_slice(moment.row);
        if pace.keeps(moment.step) {
            deviations.add(table.invariant_values(moment.row));
            recording.append(moment.row)?;
        }
        renewal.pause(moment.step, || moment.saved(), &mut recording, &deviations)
    });
    drop(progress);
    recording.conclude(outcome)?;
    let check = options.check.then(|| experiment.check(&|| options.going())).transpose()?;
    let summary = SystemSummary::new(out.into(), experiment, &last, &deviations, &table)?;
    Ok(SystemSummary { error_estimate: accuracy.error, check, ..summary })
}
