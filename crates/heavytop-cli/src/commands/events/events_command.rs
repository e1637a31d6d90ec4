//! The command `events`: follows a run and writes a table of the zeros of functions.

use super::events_summary::{EventsOf, EventsSummary};
use crate::configuration::{Config, EventsConfig};
use crate::errors::Error;
use crate::files::{Kind, Output, require_csv};
use crate::formats::RunTable;
use crate::formats::run_table::append_row;
use crate::runs::{Experiment, Schedule};
use crate::supervision::warnings::warn;
use crate::supervision::{Progress, Watch};
use collective_integrators::diagnostics::RunAccuracy;
use lie_poisson_formula_systems::SystemAlgebra;
use lie_poisson_formulas::{Formula, Parameters};
use lie_poisson_runs::EventFunctions;
use std::io::Write;
use std::ops::ControlFlow;
use std::path::Path;

/// How the table is recognised.
const CSV: Kind<'_> = Kind::of_first_bytes("table of events", b"event,t,");

/// Follows the run of the configuration, and writes the moments at which the functions of `[events]` pass zero as the table
/// `out`: the number of the function, from 1, and the columns of `simulate`.
///
/// # Errors
/// If the request is wrong, as with noise a function of coordinates is, or the run is stopped: then nothing is written. If the run fails, the events until then are kept
/// as `OUT.partial`.
///
/// # Example
/// The free body of the preset `euler` turns about a direction near its middle axis, and flips again and again.
/// ```
/// use heavytop_cli::commands::events::events;
/// use heavytop_cli::configuration::{Config, EventsConfig, Preset};
/// use heavytop_cli::supervision::Watch;
/// let folder = tempfile::tempdir()?;
/// let wanted = EventsConfig { functions: vec!["Pi2".into()], terminal: Some(3), ..EventsConfig::default() };
/// let config = Config { events: Some(wanted), ..Preset::Euler.config() };
/// let summary = events(&config, &folder.path().join("flips.csv"), &Watch::default())?;
/// assert_eq!((summary.functions[0].events, Some(summary.end)), (3, summary.functions[0].last));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn events(config: &Config, out: &Path, watch: &Watch<'_>) -> Result<EventsSummary, Error> {
    let settings = config.events.clone().unwrap_or_default();
    let functions = functions(config, &settings)?;
    let run = run(config)?;
    require_zeros(&run, &functions)?;
    let table = RunTable::new(&run, &config.output.columns)?;
    let requested = config.top_columns()?;
    require_csv(out)?;
    watch.safeguard.require(out, &CSV)?;
    let mut output = Output::create(out)?;
    run.warning()?.into_iter().chain(config.body_warning()).for_each(warn);

    output.write(|to| writeln!(to, "event,{}", table.header()))?;
    let mut counts: Vec<EventsOf> = functions.functions.iter().map(EventsOf::new).collect();
    let (mut end, mut line, mut columns) = (run.pace.schedule.end(), Vec::new(), Vec::new());
    let progress = Progress::new(&run, watch.quiet);
    let advance = |step: u64| {
        progress.at(step);
        watch.require_going()
    };
    let outcome = functions.follow(&run, advance, |place, row| -> Result<_, Error> {
        columns.clear();
        columns.extend_from_slice(row);
        requested.iter().for_each(|requested| requested.complete(&mut columns));
        line.clear();
        append_row(&mut line, &columns);
        output.write(|to| write!(to, "{},", place + 1).and_then(|()| to.write_all(&line)))?;
        let (Some(count), Some(&time)) = (counts.get_mut(place), row.first()) else {
            return Ok(ControlFlow::Continue(()));
        };
        count.add(time);
        if Some(count.events) == settings.terminal {
            end = time;
            return Ok(ControlFlow::Break(()));
        }
        Ok(ControlFlow::Continue(()))
    });
    drop(progress);
    output.conclude(outcome)?;
    let accuracy = accuracy_to(&run, end, watch)?;
    let warning = run.model.accuracy_warning(&run.start, &accuracy);
    warning.map(|text| format!("warning: {text}")).into_iter().for_each(warn);
    let summary = EventsSummary::new(&run, counts, end, out);
    Ok(EventsSummary { error_estimate: accuracy.error, ..summary })
}

/// Measures how accurate the run is to a time, s, at which an event may have ended it.
fn accuracy_to(run: &Experiment, end: f64, watch: &Watch<'_>) -> Result<RunAccuracy, Error> {
    let _shown = Progress::estimating(watch.quiet);
    let Schedule { step, steps } = run.pace.schedule;
    let made = steps.min((end / step).ceil() as u64);
    let going = || watch.require_going().is_ok();
    Ok(run.model.accuracy(&run.method, &run.start, (step, made), &going)?)
}

/// Returns the run of a top, or of a system whose coordinates formulas know.
fn run(config: &Config) -> Result<Box<Experiment>, Error> {
    if let Some(open) = config.open_run()? {
        return Ok(open);
    }
    Ok(match config.system_experiment()? {
        Some(system) => Box::new(system),
        None => Box::new(config.experiment()?),
    })
}

/// Checks that zeros do not depend on the step, as those of coordinates along a path with noise do.
fn require_zeros(run: &Experiment, functions: &EventFunctions) -> Result<(), Error> {
    let coordinates = run.model.columns().len();
    let is_of_state = |function: &Formula| (0..coordinates).any(|i| function.depends_on(i));
    let mut numbered = functions.functions.iter().enumerate();
    match numbered.find(|(_, function)| is_of_state(function)) {
        Some((number, function)) if run.model.noise().is_some() => {
            let key = format!("events.functions[{number}]");
            Err(Error::NoisyFunction { key, function: function.to_string() })
        }
        _ => Ok(()),
    }
}

/// Reads the functions whose zeros are to be found.
fn functions(config: &Config, settings: &EventsConfig) -> Result<EventFunctions, Error> {
    if settings.functions.is_empty() {
        return Err(Error::NoEvents);
    }
    if settings.terminal == Some(0) {
        let (name, range) = ("events.terminal", "at least 1");
        return Err(Error::OutOfRange { name, range, value: 0.0 });
    }
    let (algebra, parameters) = match config.system()? {
        Some(table) => (config.algebra_of(table)?, table.named_parameters()?),
        None => (SystemAlgebra::named("se(3)")?, Parameters::new()),
    };
    let names = config.named_inputs()?.vocabulary_of_functions(&algebra, &parameters)?;
    let read = |(number, text): (usize, &String)| {
        let failed = |source| Error::EventFunction { number, source: Box::new(source) };
        Formula::new(text, &names).map_err(failed)
    };
    let functions = settings.functions.iter().enumerate().map(read).collect::<Result<_, _>>()?;
    Ok(EventFunctions { functions, direction: settings.direction })
}
