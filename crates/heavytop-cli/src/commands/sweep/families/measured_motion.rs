//! The measurement of a motion, whatever its integrator.

use super::course::Course;
use super::gauge::Gauge;
use crate::configuration::Observable;
use crate::errors::Error;
use collective_integrators::{AnyIntegrator, AnyState, AnyTangents};
use heavytop::methods::Method;
use lie_poisson_runs::TangentGrowth;

/// Follows the motion from a start, and returns the values of the columns of all observables. `method` is the one of the
/// integrator.
///
/// # Errors
/// If no state represents the start, or the motion cannot be followed to the end.
pub(super) fn measure(
    integrator: &AnyIntegrator<dyn AnyTangents>,
    start: &AnyState,
    gauge: &mut Gauge<'_>,
    course: &Course,
    method: &Method,
) -> Result<Vec<Option<f64>>, Error> {
    // A tangent vector costs more than the state: there are as many as the observables need.
    let followed = (course.tangents(), method);
    let mut observe = |time, momentum: &[f64]| gauge.observe(time, momentum);
    let grown = TangentGrowth::follow(integrator, start, course.schedule, followed, &mut observe)?;
    let values = |observable: &Observable| match observable {
        Observable::Lyapunov => vec![Some(grown.lyapunov)],
        Observable::Megno => vec![Some(grown.megno)],
        Observable::Sali => vec![grown.alignment],
        other => gauge.values(*other, grown.end.as_slice()),
    };
    Ok(course.observables.iter().flat_map(values).collect())
}
