//! The choice of the picture that shows a whole run.

use super::histories::chain_picture::chain_picture;
use super::histories::panels_picture::{columns_picture, panels_picture};
use super::histories::phase_portrait::phase_portrait;
use super::plot_options::PlotOptions;
use super::quantities::run_column::RunColumn;
use super::quantities::selection::{attitude, chosen, column, vector};
use super::run_arrays::RunArrays;
use super::run_subject::RunSubject;
use super::samples::direction_track::{Direction, direction_track};
use super::view::View;
use crate::errors::Error;
use lie_poisson::Quaternion;
use nalgebra::Vector3;

/// Draws a whole run: the columns or the direction that the options choose, a chain of spins, or the coordinates.
///
/// # Errors
/// If there is no such column, or the samples cannot be read.
pub(super) fn whole_run(run: &RunArrays, options: &PlotOptions) -> Result<String, Error> {
    let RunSubject::Coordinates { run: experiment, .. } = &run.subject else {
        return match options.of_columns() {
            Some(option) => {
                let kind = "runs of tops and of formulas, whose columns are numbers and vectors";
                Err(Error::OtherPicture { option, kind })
            }
            None => chain_picture(run),
        };
    };
    let all = RunColumn::all(run, experiment)?;
    let failed = |error| run.failed(error);
    if let Some(name) = &options.trace {
        return match name.as_str() {
            "axis" if run.config.system.is_some() => {
                let kind = "runs of tops with their attitude; of a system name a vector";
                Err(Error::OtherPicture { option: "trace axis", kind })
            }
            "axis" => axis_track(run, &all),
            _ => {
                let array = vector(&all, name).map_err(failed)?;
                let title = array.title.clone();
                direction_track(run, &Direction { title, array, of: &<[f64]>::to_vec })
            }
        };
    }
    if options.columns.is_empty() {
        return match run.subject.view() {
            View::Chain => chain_picture(run),
            _ => panels_picture(run, experiment, &all),
        };
    }
    let columns = chosen(&all, &options.columns).map_err(failed)?;
    match &options.against {
        Some(name) => phase_portrait(run, experiment, columns, column(&all, name).map_err(failed)?),
        None => columns_picture(run, experiment, columns),
    }
}

/// Draws the track in space of the line from the support of a top to its centre of mass: R c, by the attitude.
fn axis_track(run: &RunArrays, all: &[RunColumn]) -> Result<String, Error> {
    let array = attitude(all).map_err(|error| run.failed(error))?;
    let center = Vector3::from(run.config.body.center_of_mass);
    let of = |q: &[f64]| match *q {
        [scalar, x, y, z] => {
            let rotation = Quaternion { scalar, vector: Vector3::new(x, y, z) };
            rotation.rotate(&center).iter().copied().collect()
        }
        _ => Vec::new(),
    };
    direction_track(run, &Direction { title: "the axis in space".into(), array, of: &of })
}
