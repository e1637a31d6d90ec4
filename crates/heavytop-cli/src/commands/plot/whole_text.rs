//! The choice of what a terminal shows of a run.

use super::plot_options::PlotOptions;
use super::quantities::run_column::RunColumn;
use super::quantities::selection::{chosen, column};
use super::run_arrays::RunArrays;
use super::run_subject::RunSubject;
use super::terminal::terminal_charts::terminal_charts;
use crate::errors::Error;

/// The largest number of charts of coordinates.
const MOST_CHARTS: usize = 6;

/// Draws the columns that the options choose, or the first coordinates, as charts of text.
///
/// # Errors
/// If there is no such column, the samples cannot be read, or the run or an option needs a picture.
pub(super) fn whole_text(run: &RunArrays, options: &PlotOptions) -> Result<String, Error> {
    let RunSubject::Coordinates { run: experiment, .. } = &run.subject else {
        return Err(Error::NeedsPicture { what: "a lattice, a fluid or vortices" });
    };
    if options.trace.is_some() {
        return Err(Error::NeedsPicture { what: "a direction on the sphere" });
    }
    let all = RunColumn::all(run, experiment)?;
    let failed = |error| run.failed(error);
    let columns = match options.columns.is_empty() {
        true => all.iter().filter(|one| one.name != "t").take(MOST_CHARTS).cloned().collect(),
        false => chosen(&all, &options.columns).map_err(failed)?,
    };
    let abscissa = options.against.as_deref().map(|name| column(&all, name));
    terminal_charts(run, columns, abscissa.transpose().map_err(failed)?)
}
