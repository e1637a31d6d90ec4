//! The forecast of a sweep: how much it would write, and how long that would take.

use super::measured_row::measure;
use super::pictures::SweepPicture;
use super::processes::Processes;
use super::sweep_plan::Plan;
use crate::configuration::Config;
use crate::errors::Error;
use crate::runs::Schedule;
use crate::supervision::Forecast;
use crate::supervision::forecast::{in_parquet, in_text, time_of_all};
use crate::supervision::tiled_run::threads;
use std::path::Path;
use std::time::Instant;

/// The largest number of steps of a member in a trial.
const MOST_STEPS: u64 = 1000;

/// Returns the forecast of a sweep after trying some of its members for a fifth of a second, or a little longer if steps
/// are slow. Nothing is written.
///
/// # Errors
/// If there is no such sweep, or its threads cannot be started.
///
/// In an MPI job only the first process tries members and returns the forecast for all processes.
///
/// # Example
/// ```
/// use heavytop_cli::commands::sweep::dry_run;
/// use heavytop_cli::configuration::Config;
/// let forecast = dry_run(&Config::default(), "map".as_ref(), Some(1))?.ok_or("not the first process")?;
/// assert_eq!(forecast.rows, 32 * 32);
/// assert!(forecast.seconds.is_some_and(|seconds| seconds > 0.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn dry_run(
    config: &Config,
    out: &Path,
    count: Option<usize>,
) -> Result<Option<Forecast>, Error> {
    let processes = Processes::join();
    let (rank, size) = processes.place();
    let tried = Plan::new(config).and_then(|plan| {
        if rank > 0 {
            return Ok(None);
        }
        let seconds = threads(count)?.install(|| seconds(&plan))? / size as f64;
        Ok(Some(Forecast { seconds: Some(seconds), ..forecast(&plan, out) }))
    });
    processes.conclude(tried)
}

/// Returns the forecast of a sweep without trying it.
pub(super) fn forecast(plan: &Plan, out: &Path) -> Forecast {
    let (members, steps) = (plan.members, plan.course.schedule.steps);
    let (axes, columns) = (plan.axes.len() as u64, plan.columns.len() as u64);
    let numbers = members * (1 + axes + columns);
    let picture = SweepPicture::of(plan);
    let pictures = picture.map_or(0, |picture| columns * picture.bytes(members));
    let csv = if picture == Some(SweepPicture::Curve) { in_text(numbers) } else { 0 };
    let bytes = in_parquet(numbers) + csv + pictures;
    Forecast {
        out: out.into(),
        work: format!("{members} {} of {steps} steps", plan.nouns()),
        remedy: "lower the count",
        steps: Some(members.saturating_mul(steps)),
        rows: members,
        bytes,
        // Until the table is complete there are the tiles besides it, in text.
        room: bytes + in_text(members * columns),
        ..Forecast::default()
    }
}

/// Returns the time that all members would take, s, estimated from the first steps of some.
fn seconds(plan: &Plan) -> Result<f64, Error> {
    let Schedule { step, steps } = plan.course.schedule;
    let mut shortened = plan.clone();
    shortened.course.schedule = Schedule { steps: steps.min(MOST_STEPS), step };
    let parts = steps as f64 / steps.min(MOST_STEPS) as f64;
    time_of_all(plan.members, |number| {
        let begun = Instant::now();
        std::hint::black_box(measure(&shortened, number));
        Ok(begun.elapsed().as_secs_f64() * parts)
    })
}
