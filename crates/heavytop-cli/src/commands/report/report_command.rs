//! The command `report`: follows a top and tells its rates.

use super::report_table::ReportTable;
use crate::configuration::{Config, Integration};
use crate::errors::Error;
use crate::runs::run_check::accuracy_warning;
use crate::supervision::warnings::warn;
use heavytop::Invariant;
use lie_poisson_runs::TopReport;
use lie_poisson_runs::step_angle::{fastest_rate_of_top, usual_step};

/// Follows the top of a configuration by its method, to its end, and tells the rates of its motion, its turning points and the
/// steady rotations near it, beside the formulas of textbooks.
///
/// Warnings about steps that are too long go to stderr.
///
/// # Errors
/// If the request is wrong, the formulation has no attitude, or a step fails.
///
/// # Example
/// The preset `lagrange` has cusps: its axis begins at its highest point.
/// ```
/// use heavytop_cli::commands::report::report;
/// use heavytop_cli::configuration::Preset;
/// let table = report(&Preset::Lagrange.config())?;
/// let text = table.to_string();
/// assert!(text.contains("precession") && text.contains("m g l/(I₃ω₃)"), "{text}");
/// # Ok::<(), heavytop_cli::Error>(())
/// ```
pub fn report(config: &Config) -> Result<ReportTable, Error> {
    let mut config = config.clone();
    config.output.attitude = true;
    if config.integrator.step.is_none() {
        // A long step would count turns wrongly.
        let energy = Invariant::Energy.value(&config.top()?, &config.start()?);
        let usual = config.integrator.or(Integration::default());
        let rate = fastest_rate_of_top(&config.top()?, energy);
        config.integrator.step = Some(usual_step(usual.step, usual.end, rate));
    }
    let run = config.experiment()?;
    let accuracy = run.accuracy(&|| true)?;
    accuracy_warning(&accuracy).into_iter().for_each(warn);
    let report = TopReport::new(&run, config.known_length())?;
    Ok(ReportTable::new(&run, &report, accuracy.error))
}
