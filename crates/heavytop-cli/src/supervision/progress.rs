//! The progress bar of a command.

use crate::runs::Experiment;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use std::fmt::Write;
use std::time::{Duration, Instant};

/// The time for which no bar is shown.
const PATIENCE: Duration = Duration::from_millis(500);

/// The number of steps between readings of the clock.
const STRIDE: u64 = 256;

/// A progress bar on stderr, if that is a terminal and the run is long.
#[derive(Debug)]
pub struct Progress {
    bar: ProgressBar,
    started: Instant,
    quiet: bool,
}

impl Progress {
    /// Creates the bar of a run; `quiet` hides it for good.
    #[must_use]
    pub fn new(experiment: &Experiment, quiet: bool) -> Self {
        let method = &experiment.method;
        let progress = Self::of(experiment.schedule.steps, "steps", quiet);
        let message = format!("{}, {}", method.formulation().name(), method.scheme().name());
        progress.bar.set_message(message);
        progress
    }

    /// Creates a bar for `items` items of a kind; `quiet` hides it for good.
    #[must_use]
    pub fn of(items: u64, kind: &str, quiet: bool) -> Self {
        let bar = ProgressBar::with_draw_target(Some(items), ProgressDrawTarget::hidden());
        let template = format!(
            "{{msg}} {{wide_bar}} {{percent:>3}} %  {{pos}}/{{len}} {kind}  {{rate}}  {{eta}} left"
        );
        if let Ok(style) = ProgressStyle::with_template(&template) {
            bar.set_style(style.with_key("rate", rate).progress_chars("━╸─"));
        }
        Self { bar, started: Instant::now(), quiet }
    }

    /// Starts the bar after so many steps were made before; rate and time left refer to the steps to come.
    pub fn begin(&self, step: u64) {
        self.bar.set_position(step);
        self.bar.reset_eta();
    }

    /// Reports the number of steps made.
    pub fn at(&self, step: u64) {
        if step.is_multiple_of(STRIDE) {
            self.show(step);
        }
    }

    /// Reports the number of items done, and the next item.
    pub fn now(&self, item: u64, message: String) {
        self.bar.set_message(message);
        self.show(item);
    }

    fn show(&self, position: u64) {
        if self.quiet {
            return;
        }
        if self.bar.is_hidden() && self.started.elapsed() > PATIENCE {
            // The bar stays hidden unless stderr is a terminal.
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        self.bar.set_position(position);
    }
}

/// Writes the number of items per second.
fn rate(state: &ProgressState, to: &mut dyn Write) {
    // The run does not fail for a bar without a rate.
    let _ = write!(to, "{:.0}/s", state.per_sec());
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
