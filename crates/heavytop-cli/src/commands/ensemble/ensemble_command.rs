//! The command `ensemble`: follows many paths of a motion with noise, and writes their statistics.

use super::ensemble_summary::EnsembleSummary;
use crate::configuration::Config;
use crate::errors::Error;
use crate::files::{Kind, Output, require_csv};
use crate::formats::RunTable;
use crate::formats::run_table::append_row;
use crate::supervision::warnings::warn;
use crate::supervision::{Progress, Watch};
use lie_poisson_runs::{PathEnsemble, PathRow};
use std::io::Write;
use std::path::Path;

/// How the table is recognised.
const CSV: Kind<'_> = Kind::of_first_bytes("table of an ensemble", b"paths,t,");

/// Follows the paths of the configuration's run, and writes the table `out`: the number of paths, the time, and of each column of
/// `simulate` the mean, its standard error, the standard deviation, and the quantiles.
///
/// # Errors
/// If the request is wrong, a path fails, or the run is stopped: then nothing is written.
///
/// # Example
/// ```
/// use heavytop_cli::commands::ensemble::ensemble;
/// use heavytop_cli::configuration::Config;
/// use heavytop_cli::supervision::Watch;
/// use lie_poisson_runs::PathEnsemble;
/// let config: Config = toml::from_str(r#"
///     [system]
///     algebra = "so(3)"
///     hamiltonian = "-Pi3"
///     initial.Pi = [1.0, 0.0, 0.0]
///     [damping]
///     friction = 1.0
///     [noise]
///     temperature = 0.5
///     [integrator]
///     step = 0.1
///     end = 2.0
/// "#)?;
/// let folder = tempfile::tempdir()?;
/// let paths = PathEnsemble { paths: 20, quantiles: vec![0.5] };
/// let summary = ensemble(&config, &paths, &folder.path().join("means.csv"), &Watch::default())?;
/// assert_eq!((summary.paths, summary.rows), (20, 21));
/// assert!((summary.last["c1"].mean - 1.0).abs() < 1e-13); // |Π|² is the same on every path
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn ensemble(
    config: &Config,
    paths: &PathEnsemble,
    out: &Path,
    watch: &Watch<'_>,
) -> Result<EnsembleSummary, Error> {
    let run = config.run()?;
    let table = RunTable::new(&run, &[])?;
    paths.require_sane(&run)?;
    require_csv(out)?;
    watch.safeguard.require(out, &CSV)?;
    let mut output = Output::create(out)?;
    let accuracy = run.accuracy(&|| watch.require_going().is_ok())?;
    let of_steps =
        run.model.accuracy_warning(&run.start, &accuracy).map(|text| format!("warning: {text}"));
    run.warning()?.into_iter().chain(of_steps).for_each(warn);
    let progress = Progress::of(paths.paths, "paths", watch.quiet);
    let rows = paths.follow(&run, |done| {
        progress.begin(done);
        watch.require_going().is_ok()
    })?;
    drop(progress);
    let Some(rows) = rows else { return Err(Error::Interrupted { resume: None }) };
    let names: Vec<&str> = table.header_names().skip(1).collect();
    output.write(|to| writeln!(to, "{}", header(&names, &paths.quantiles)))?;
    let mut line = Vec::new();
    for row in &rows {
        line.clear();
        append_row(&mut line, &numbers(paths.paths, row));
        output.write(|to| to.write_all(&line))?;
    }
    output.complete()?;
    Ok(EnsembleSummary::new(&run, paths.paths, (&names, &rows), out))
}

/// Returns the names of the columns.
fn header(names: &[&str], quantiles: &[f64]) -> String {
    let mut columns = vec!["paths".to_owned(), "t".into()];
    for name in names {
        columns.extend(["mean", "error", "deviation"].map(|of| format!("{name}_{of}")));
        columns.extend(quantiles.iter().map(|p| format!("{name}_q{p}")));
    }
    columns.join(",")
}

/// Returns the numbers of a row.
fn numbers(paths: u64, row: &PathRow) -> Vec<f64> {
    let mut numbers = vec![paths as f64, row.time];
    for of in &row.quantities {
        numbers.extend([of.mean, of.error, of.deviation]);
        numbers.extend(&of.quantiles);
    }
    numbers
}
