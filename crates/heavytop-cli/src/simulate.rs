//! `heavytop simulate`: one top to one file.

use crate::Error;
use crate::config::Config;
use crate::output::Output;
use crate::progress::Progress;
use crate::run::Experiment;
use crate::table;
use std::io::Write;
use std::path::Path;

/// Runs the configuration, or the paper's Kovalevskaya top if there is none, and writes `out`.
///
/// # Errors
/// If the request is wrong, in which case nothing is written; or the run fails, in which case
/// what was computed until then is kept as `OUT.partial`.
pub fn simulate(config: Option<&Path>, out: &Path, quiet: bool) -> Result<(), Error> {
    let experiment = config.map_or_else(|| Ok(Config::default()), Config::read)?.experiment()?;
    require_csv(out)?;
    let mut output = Output::create(out)?;
    if let Some(warning) = experiment.method.warning() {
        // Where stderr is closed nobody can be warned.
        let _ = writeln!(std::io::stderr(), "heavytop: {warning}");
    }
    let outcome = write(&experiment, &mut output, quiet);
    output.conclude(outcome)
}

fn write(experiment: &Experiment, output: &mut Output, quiet: bool) -> Result<(), Error> {
    let top = &experiment.top;
    let invariants = table::columns(top);
    output.write(|to| table::write_header(to, &invariants, experiment.attitude))?;
    let progress = Progress::new(experiment, quiet);
    experiment.run(|step, time, mu, attitude| {
        progress.at(step);
        if experiment.keeps(step) {
            let values = invariants.iter().map(|invariant| invariant.value(top, mu));
            let values = values.chain(attitude.into_iter().flat_map(table::attitude_values));
            output.write(|to| table::write_row(to, time, mu, values))?;
        }
        Ok(())
    })
}

/// A name that ends in `.csv`, or something like `/dev/stdout` that has no ending to choose.
fn require_csv(out: &Path) -> Result<(), Error> {
    let is_csv = out.extension().is_some_and(|e| e.eq_ignore_ascii_case("csv"));
    let is_device = std::fs::metadata(out).is_ok_and(|m| !m.is_file() && !m.is_dir());
    if is_csv || is_device { Ok(()) } else { Err(Error::Format { path: out.into() }) }
}
