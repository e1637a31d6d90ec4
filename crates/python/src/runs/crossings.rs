//! The crossings of a surface.

use super::event::{Event, event_failed};
use super::interruption::Interruption;
use super::record::Points;
use super::schedule::Schedule;
use crate::errors::{failed, refused};
use collective_integrators::Start;
use lie_poisson::Vector;
use pyo3::PyResult;

/// Returns the points where a run meets an event, at most `most` of them.
pub(crate) fn crossings<I>(
    integrator: &I,
    schedule: &Schedule,
    surface: &Event,
    most: usize,
) -> PyResult<Points>
where
    I: Start<State: Vector, Momentum: Vector<Scalar = f64>>,
{
    let samples = integrator.trajectory(&schedule.start(), schedule.step).map_err(refused)?;
    let (interruption, mut search) = (Interruption::default(), surface.search(integrator));
    let mut points = Points::default();
    for sample in interruption.until(samples.take(schedule.steps as usize + 1)) {
        let found = search.observe(&sample.map_err(failed)?);
        for crossing in found.map_err(|error| event_failed(0, error))?.into_iter().flatten() {
            if points.times.len() < most {
                points.times.push(crossing.time);
                points.states.extend(schedule.coordinates(&crossing.momentum));
            }
        }
        if points.times.len() >= most {
            break;
        }
    }
    interruption.or(Ok(points))
}
