//! The progress bar of a command.

use crate::runs::Experiment;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use std::fmt::Write;
use std::io::IsTerminal;
use std::thread;
use std::time::Duration;

/// The time for which no bar is shown, and from one drawing of a bar that stands still to the next.
const PATIENCE: Duration = Duration::from_millis(500);

/// The number of steps between reports to the bar.
const STRIDE: u64 = 256;

/// The number of characters of a message, so that the line fits into 80 columns.
const MESSAGE: usize = 24;

/// A progress bar on stderr, if that is a terminal and the run is long.
#[derive(Debug)]
pub struct Progress {
    bar: ProgressBar,
}

impl Progress {
    /// Creates the bar of a run; `quiet` hides it for good.
    #[must_use]
    pub fn new(run: &Experiment, quiet: bool) -> Self {
        let (formulation, scheme) = (run.method.formulation(), run.method.scheme());
        let progress = Self::of(run.pace.schedule.steps, "steps", quiet);
        progress.say(&format!("{}, {}", formulation.name(), scheme.name()));
        progress
    }

    /// Creates a bar for `items` items of a kind; `quiet` hides it for good.
    ///
    /// It shows after half a second, even if no item is done by then.
    #[must_use]
    pub fn of(items: u64, kind: &str, quiet: bool) -> Self {
        let bar = ProgressBar::with_draw_target(Some(items), ProgressDrawTarget::hidden());
        let template = format!(
            "{{msg}} {{wide_bar}} {{percent:>3}} %  {{done}} {kind}  {{rate}}  {{eta}} left"
        );
        if let Ok(style) = ProgressStyle::with_template(&template) {
            let style = style.with_key("rate", rate).with_key("done", done);
            bar.set_style(style.progress_chars("━╸─"));
        }
        Self::shown(bar, quiet)
    }

    /// Shows that the error of a run is being estimated, and for how long already; `quiet` hides it for good.
    #[must_use]
    pub fn estimating(quiet: bool) -> Self {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template("{spinner} {msg}  {elapsed}") {
            bar.set_style(style);
        }
        bar.set_message("estimating the error");
        Self::shown(bar, quiet)
    }

    /// Shows a bar after half a second.
    fn shown(bar: ProgressBar, quiet: bool) -> Self {
        if !quiet && std::io::stderr().is_terminal() {
            let shown = bar.clone();
            // Without a thread there is no bar, and the command goes on.
            let _ = thread::Builder::new().spawn(move || {
                thread::sleep(PATIENCE);
                if !shown.is_finished() {
                    shown.set_draw_target(ProgressDrawTarget::stderr());
                    shown.enable_steady_tick(PATIENCE);
                }
            });
        }
        Self { bar }
    }

    /// Starts the bar after so many steps were made before; rate and time left refer to the steps to come.
    pub fn begin(&self, step: u64) {
        self.bar.set_position(step);
        self.bar.reset_eta();
    }

    /// Reports the number of steps made.
    pub fn at(&self, step: u64) {
        if step.is_multiple_of(STRIDE) {
            self.bar.set_position(step);
        }
    }

    /// Reports the number of items done, and the next item.
    pub fn now(&self, item: u64, message: String) {
        self.say(&message);
        self.bar.set_position(item);
    }

    fn say(&self, message: &str) {
        self.bar.set_message(message.chars().take(MESSAGE).collect::<String>());
    }
}

/// Writes the number of items per second.
fn rate(state: &ProgressState, to: &mut dyn Write) {
    // The run does not fail for a bar without a rate.
    let _ = write!(to, "{}/s", compact(state.per_sec()));
}

/// Writes the number of items done, and of all.
fn done(state: &ProgressState, to: &mut dyn Write) {
    let all = compact(state.len().unwrap_or(0) as f64);
    let _ = write!(to, "{}/{all}", compact(state.pos() as f64));
}

/// Formats a number in at most six characters, as in `12.3M`.
fn compact(number: f64) -> String {
    let units = [(1e12, "T"), (1e9, "G"), (1e6, "M"), (1e5, "k")];
    match units.iter().find(|(least, _)| number >= *least) {
        Some((_, "k")) => format!("{:.0}k", number / 1e3),
        Some((unit, name)) => format!("{:.1}{name}", number / unit),
        None => format!("{number:.0}"),
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let numbers = [0.0, 99_999.0, 123_456.0, 12_345_678.0, 1e12];
        assert_eq!(numbers.map(compact), ["0", "99999", "123k", "12.3M", "1.0T"]);
    }
}
