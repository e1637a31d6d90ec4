//! The progress bar.

use crate::run::Experiment;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::time::{Duration, Instant};

/// Runs that are shorter show no bar.
const PATIENCE: Duration = Duration::from_millis(500);

/// The clock is read once in so many steps.
const STRIDE: u64 = 256;

/// A bar on stderr, if that is a terminal and the run is long.
#[derive(Debug)]
pub struct Progress {
    bar: ProgressBar,
    started: Instant,
    quiet: bool,
}

impl Progress {
    /// A bar for a run, which `quiet` hides for good.
    #[must_use]
    pub fn new(experiment: &Experiment, quiet: bool) -> Self {
        let method = &experiment.method;
        let steps = Some(experiment.schedule.steps);
        let bar = ProgressBar::with_draw_target(steps, ProgressDrawTarget::hidden());
        bar.set_message(format!("{}, {}", method.formulation().name(), method.scheme().name()));
        let template = "{msg} {wide_bar} {percent:>3} %  {pos}/{len} steps  {eta} left";
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style.progress_chars("━╸─"));
        }
        Self { bar, started: Instant::now(), quiet }
    }

    /// Reports the number of steps made.
    pub fn at(&self, step: u64) {
        if self.quiet || !step.is_multiple_of(STRIDE) {
            return;
        }
        if self.bar.is_hidden() && self.started.elapsed() > PATIENCE {
            // Stays hidden unless stderr is a terminal.
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        self.bar.set_position(step);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
