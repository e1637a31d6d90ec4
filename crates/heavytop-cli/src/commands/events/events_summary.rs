//! The summary of events, which `heavytop events` prints.

use crate::files::place::shown;
use crate::runs::Experiment;
use crate::runs::run_check::{write_accuracy, write_method};
use crate::vocabulary::brief::number;
use lie_poisson_formulas::Formula;
use serde::Serialize;
use std::fmt;
use std::path::{Path, PathBuf};

/// The summary of the events of a run, in numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct EventsSummary {
    /// The path of the table.
    pub out: PathBuf,
    /// The formulation's name.
    pub formulation: &'static str,
    /// The scheme's name.
    pub scheme: &'static str,
    /// The time step, s.
    pub step: f64,
    /// The time to which events were searched, s: that of the event that ended the run, if one did.
    pub end: f64,
    /// The events of each function.
    pub functions: Vec<EventsOf>,
    /// The estimated error of the run, relative to the state.
    pub error_estimate: Option<f64>,
}

/// The events of one function.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct EventsOf {
    /// The function.
    pub function: String,
    /// The number of its events.
    pub events: u64,
    /// The time of the first one, s.
    pub first: Option<f64>,
    /// The time of the last one, s.
    pub last: Option<f64>,
    /// The mean time from one to the next, s, if there are two.
    pub interval: Option<f64>,
}

impl EventsOf {
    /// Begins the count of a function.
    pub(super) fn new(function: &Formula) -> Self {
        let function = function.to_string();
        Self { function, events: 0, first: None, last: None, interval: None }
    }

    /// Counts an event at a time, s.
    pub(super) fn add(&mut self, time: f64) {
        let first = *self.first.get_or_insert(time);
        self.interval = (self.events > 0).then(|| (time - first).abs() / self.events as f64);
        self.events += 1;
        self.last = Some(time);
    }
}

impl EventsSummary {
    /// Creates the summary of a run that ended at this time, as yet without its accuracy.
    pub(super) fn new(run: &Experiment, functions: Vec<EventsOf>, end: f64, out: &Path) -> Self {
        Self {
            out: out.into(),
            formulation: run.method.formulation().name(),
            scheme: run.method.scheme().name(),
            step: run.pace.schedule.step,
            end,
            functions,
            error_estimate: None,
        }
    }
}

impl fmt::Display for EventsSummary {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, of) in self.functions.iter().enumerate() {
            let separator = if place > 0 { ", " } else { "" };
            let zeros = if of.events == 1 { "zero" } else { "zeros" };
            write!(to, "{separator}{} {zeros} of {}", of.events, of.function)?;
            match (of.first, of.interval) {
                (Some(first), Some(interval)) => {
                    let [first, interval] = [first, interval].map(number);
                    write!(to, " (from {first} s on, {interval} s apart on average)")?;
                }
                (Some(first), None) => write!(to, " (at {} s)", number(first))?,
                (None, _) => {}
            }
        }
        write!(to, ", in {}", shown(&self.out))?;
        write_accuracy(to, (self.error_estimate, "the state"), None)?;
        write_method(to, (self.formulation, self.scheme), (self.step, self.end))
    }
}
