//! The command `animate`: runs a top with its attitude and writes the page.

use super::animation::Animation;
use super::page_summary::PageSummary;
use crate::configuration::Config;
use crate::errors::Error;
use crate::files::{Kind, Output, Place, contains};
use crate::pictures::caption;
use crate::runs::run_check::accuracy_warning;
use crate::runs::{Experiment, TopInAxes};
use crate::supervision::warnings::warn;
use crate::supervision::{Progress, Watch};
use std::path::Path;

/// The largest number of frames of a page; that many take some 3.5 MB, and longer runs are thinned out.
pub const MOST_FRAMES: u64 = 20_000;

/// The largest turn of the body from frame to frame, in rad, that the page can interpolate well.
const MOST_TURN: f64 = 1.0;

/// How a page is recognised.
const KIND: Kind<'_> = Kind {
    name: "page of animate",
    first: b"<!DOCTYPE html>",
    is_whole: |head, _| Ok(contains(head, "<title>A heavy top in motion</title>")),
};

/// Runs the configuration with the attitude, and writes the page `out`.
///
/// Every n-th step is a frame, where n is the least multiple of `[output] every` that gives at most [`MOST_FRAMES`]
/// frames. The last step is a frame too.
///
/// # Errors
/// If the request is wrong, another run writes the page, or the run is stopped: then nothing is written. If the run
/// fails, the page of what was computed until then is kept as `OUT.partial`.
///
/// # Example
/// ```
/// use heavytop_cli::commands::animate::animate;
/// use heavytop_cli::configuration::Config;
/// use heavytop_cli::supervision::Watch;
/// let folder = tempfile::tempdir()?;
/// let (out, watch) = (folder.path().join("top.html"), Watch::default());
/// let summary = animate(Config::default(), &out, &watch)?;
/// assert_eq!((summary.frames, summary.steps_per_frame, summary.end), (5001, 1, 100.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn animate(mut config: Config, out: &Path, watch: &Watch<'_>) -> Result<PageSummary, Error> {
    config.output.attitude = true;
    let mut experiment = config.experiment()?;
    experiment.pace.every = frame_every(&experiment);
    require_html(out)?;
    watch.safeguard.require(out, &KIND)?;
    let mut output = Output::create(out)?;
    let accuracy = {
        let _shown = Progress::estimating(watch.quiet);
        experiment.accuracy(&|| watch.require_going().is_ok())?
    };
    let warnings = [experiment.warning()?, accuracy_warning(&accuracy), config.body_warning()];
    warnings.into_iter().flatten().for_each(warn);

    let mut animation = Animation::new(experiment.model.top, &description(&experiment));
    let outcome = record(&experiment, &mut animation, watch);
    let written = match &outcome {
        Err(Error::Interrupted { .. }) => Ok(()),
        _ if animation.is_empty() => Ok(()),
        _ => output.write(|to| animation.write(to)).and_then(|()| output.finish()),
    };
    if let Err(unwritten) = written {
        // An incomplete page is of no use. The failure of the run takes precedence over the failure to write.
        return Err(outcome.err().unwrap_or(unwritten));
    }
    output.conclude(outcome)?;
    let turn = animation.largest_turn();
    if turn > MOST_TURN {
        warn(format_args!(
            "warning: the body turns by up to {turn:.1} rad from frame to frame: the \
             motion between them is guessed; lower the end, the step or [output] every"
        ));
    }
    let summary = PageSummary::new(&experiment, &animation, out);
    Ok(PageSummary { error_estimate: accuracy.error, ..summary })
}

fn record(
    experiment: &Experiment<TopInAxes>,
    animation: &mut Animation,
    watch: &Watch<'_>,
) -> Result<(), Error> {
    let progress = Progress::new(experiment, watch.quiet);
    experiment.run(|step, time, mu, attitude| {
        watch.require_going()?;
        progress.at(step);
        match attitude {
            Some(attitude) if experiment.pace.keeps(step) => animation.push(time, mu, attitude),
            _ => {}
        }
        Ok(())
    })
}

/// Returns the least multiple of `every` that gives at most [`MOST_FRAMES`] frames, the first and the last included.
fn frame_every(experiment: &Experiment<TopInAxes>) -> u64 {
    let gaps = experiment.pace.schedule.steps.div_ceil(experiment.pace.every);
    experiment.pace.every.saturating_mul(gaps.div_ceil(MOST_FRAMES - 1))
}

/// Describes in words how the motion was computed.
fn description(experiment: &Experiment<TopInAxes>) -> String {
    let (method, step) = (experiment.method, experiment.pace.schedule.step);
    let method = caption::method(method.formulation(), method.scheme(), step);
    let frames = match experiment.pace.every {
        1 => "a frame for each step".into(),
        every => format!("a frame for every {every} steps"),
    };
    format!("{method}, {frames}")
}

/// Checks that the name ends in `.html`, or that the output is `-`, which is standard output, or a device.
fn require_html(out: &Path) -> Result<(), Error> {
    let is_html = out.extension().is_some_and(|e| e.eq_ignore_ascii_case("html"));
    let is_device = Place::of(out).is_ok_and(|place| place.is_device);
    if is_html || is_device { Ok(()) } else { Err(Error::NoPage { path: out.into() }) }
}
