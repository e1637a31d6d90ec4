//! The choice of the picture of a sample.

use super::fluid_map::FluidMap;
use super::lattice_plane::LatticePlane;
use super::sample_picture::SamplePicture;
use super::vortex_map::VortexMap;
use crate::commands::plot::run_arrays::RunArrays;
use crate::commands::plot::run_subject::RunSubject;
use crate::commands::plot::view::View;
use crate::errors::Error;

/// Returns the picture that shows a sample of a run, or `None` if runs like this are drawn against time.
///
/// # Errors
/// If there is no such plane, or the tracks of the run cannot be read.
pub(in crate::commands::plot) fn sample_picture<'a>(
    run: &'a RunArrays,
    plane: Option<usize>,
) -> Result<Option<Box<dyn SamplePicture + 'a>>, Error> {
    Ok(match (run.subject.view(), &run.subject) {
        (View::Fluid, RunSubject::Arrays { system, .. }) => {
            Some(Box::new(FluidMap::new(run, system)))
        }
        (View::Vortices, _) => Some(Box::new(VortexMap::new(run)?)),
        (View::Lattice, _) => Some(Box::new(LatticePlane::new(run, plane)?)),
        _ => None,
    })
}
