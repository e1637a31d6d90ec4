//! The command `compare`: runs every formulation and scheme on one top, with a ladder of steps.

use super::chart;
use super::measurement::{Measure, Measurement, Reference};
use super::recommendations::{self, Comparison};
use crate::configuration::{Config, Integration};
use crate::errors::Error;
use crate::files::place::require_folder;
use crate::files::{Kind, Output, OutputSet};
use crate::pictures::render;
use crate::runs::{Experiment, Schedule, TopInAxes};
use crate::supervision::warnings::warn;
use crate::supervision::{Progress, Watch};
use heavytop::methods::{ComposedScheme, Formulation, Method, SchemeName};
use std::io::Write;
use std::path::Path;

/// How the table is recognised.
const TABLE: Kind<'_> =
    Kind::of_first_bytes("table of compare", b"formulation,scheme,step,end,error,seconds,");

/// The number of configured steps in the interval, unless the run ends earlier. Later errors of a chaotic top tell
/// more about the top than about the integrators.
const INTERVAL: u64 = 500;

/// The number of rungs of the ladder for each factor of ten in the step.
const RUNGS: i32 = 4;

/// The number of rungs above the configured step; methods of high order are at their best with long steps.
const ABOVE: i32 = 7;

/// The number of rungs below the configured step.
const BELOW: i32 = 4;

/// The number of timings of each run; a short disturbance of the machine affects only one of them.
const PASSES: u32 = 3;

/// The number of pixels per CSS pixel: 168 dots per inch.
const SCALE: f32 = 1.75;

/// Measures every formulation and scheme on the top of the configuration, and recommends methods.
///
/// It writes `work-precision.csv`, `.svg` and `.png` into the folder `out`. The interval ends at `end` (s), or after 500
/// configured steps, or with the run if that is earlier.
///
/// # Errors
/// If the request is wrong, another run writes into the folder, or the command is stopped: then nothing is written.
/// If the reference solution is not certain. If the figure cannot be written: then `work-precision.csv.partial` is
/// kept.
///
/// # Example
/// ```
/// use heavytop_cli::commands::compare::compare;
/// use heavytop_cli::configuration::IntegratorConfig;
/// use heavytop_cli::configuration::Preset;
/// use heavytop_cli::supervision::Watch;
/// let folder = tempfile::tempdir()?;
/// let mut config = Preset::Lagrange.config();
/// config.integrator = IntegratorConfig { step: Some(0.1), end: Some(0.1), ..Default::default() };
/// let comparison = compare(&config, folder.path(), None, &Watch::default())?;
/// let fastest = comparison.recommendations[0].fastest.as_ref().unwrap();
/// assert!(fastest.error <= 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn compare(
    config: &Config,
    out: &Path,
    end: Option<f64>,
    watch: &Watch<'_>,
) -> Result<Comparison, Error> {
    let mut experiment = config.experiment()?;
    let steps = match end {
        Some(end) => {
            experiment.pace.schedule = schedule_to(&experiment, end)?;
            experiment.pace.schedule.steps
        }
        None => experiment.pace.schedule.steps.min(INTERVAL),
    };
    let methods = methods(config.integrator.or(Integration::default()))?;
    require_folder(out)?;
    let files = [
        ("work-precision.csv", &TABLE),
        ("work-precision.svg", &render::SVG),
        ("work-precision.png", &render::PNG),
    ];
    watch.safeguard.require_all(out, &files)?;
    std::fs::create_dir_all(out).map_err(|source| Error::Create { path: out.into(), source })?;
    let [csv, svg, png] = files.map(|(name, _)| out.join(name));
    // No other run writes here until the table has its name, which it gets last.
    let mut table = Output::create(&csv)?;

    if let Some(warning) = config.body_warning() {
        warn(warning);
    }
    let ladder = ladder(steps);
    let grid: Vec<(Method, u64)> =
        methods.iter().flat_map(|&method| ladder.iter().map(move |&n| (method, n))).collect();
    let progress = Progress::of(u64::from(PASSES) * grid.len() as u64, "runs", watch.quiet);
    let reference = Reference::new(&experiment, steps, watch)?;
    let (mut measurements, mut done) = (Vec::<Measurement>::with_capacity(grid.len()), 0);
    for pass in 0..PASSES {
        for (i, &(method, steps)) in grid.iter().enumerate() {
            watch.require_going()?;
            progress.now(done, label(&method));
            let measurement = measure(&experiment, method, steps, &reference)?;
            done += 1;
            if pass == 0 {
                measurements.push(measurement);
            } else {
                measurements[i].outcome.refine(&measurement.outcome);
            }
        }
    }
    drop(progress);

    table.write(|to| to.write_all(recommendations::csv(&measurements).as_bytes()))?;
    let chart = chart::chart(&measurements, &experiment, reference.end)?;
    let mut pictures = OutputSet::default();
    let drawn = render::render(&chart, SCALE).and_then(|(drawing, pixels)| {
        pictures.add(&svg, drawing.as_bytes())?;
        pictures.add(&png, &pixels)
    });
    pictures.conclude(table, drawn)?;
    Ok(Comparison::new(&measurements, &reference, out))
}

/// Returns the configured steps to the end of the interval (s).
fn schedule_to(experiment: &Experiment<TopInAxes>, end: f64) -> Result<Schedule, Error> {
    let refused = |source: lie_poisson_runs::RunFailure| Error::Argument {
        name: "end",
        source: Box::new(source.into()),
    };
    Schedule::new(experiment.pace.schedule.step, end).map_err(refused)
}

/// Returns every formulation with every scheme that makes sense in it, without duplicates: `strang` of the midpoint
/// rule is the midpoint rule.
fn methods(integration: Integration) -> Result<Vec<Method>, Error> {
    let mut methods = Vec::new();
    for &(_, formulation) in Formulation::NAMES {
        for scheme in formulation.schemes() {
            let again = scheme == SchemeName::Composed(ComposedScheme::Strang);
            if !again || formulation == Formulation::Splitting {
                methods.push(Integration { formulation, scheme, ..integration }.method()?);
            }
        }
    }
    Ok(methods)
}

/// Returns the numbers of steps of the ladder, from a fiftieth of `steps` to ten times as many.
fn ladder(steps: u64) -> Vec<u64> {
    let rung = |k: i32| steps as f64 * 10_f64.powf(f64::from(k) / f64::from(RUNGS));
    let mut ladder: Vec<u64> = (-ABOVE..=BELOW).map(|k| rung(k).round().max(1.0) as u64).collect();
    ladder.dedup();
    ladder
}

fn measure(
    experiment: &Experiment<TopInAxes>,
    method: Method,
    steps: u64,
    reference: &Reference,
) -> Result<Measurement, Error> {
    let task = Measure {
        top: &experiment.model.top,
        start: &experiment.initial_state(),
        steps,
        reference,
    };
    let outcome = task.of(&method)?;
    Ok(Measurement { method, step: reference.end / steps as f64, end: reference.end, outcome })
}

fn label(method: &Method) -> String {
    format!("{}, {}", method.formulation().name(), method.scheme().name())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ladder_goes_through_the_configured_step() {
        assert_eq!(ladder(500), [9, 16, 28, 50, 89, 158, 281, 500, 889, 1581, 2812, 5000]);
        assert_eq!(ladder(1), [1, 2, 3, 6, 10]);
    }
}
