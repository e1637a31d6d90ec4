//! The measurement of a motion, whatever its integrator.

use super::course::Course;
use crate::Error;
use crate::configuration::Observable;
use collective_integrators::{
    AnyIntegrator, AnyState, AnyTangents, Megno, Start, VariationalError, VariationalFlow,
    smaller_alignment_index,
};
use heavytop::methods::{Formulation, SchemeName};
use lie_poisson::State;

/// The measurements along a motion, besides those of its tangent vectors.
pub(super) trait Gauge {
    /// Takes notice of the momentum after a step, at a time (s).
    fn observe(&mut self, time: f64, momentum: &[f64]);

    /// Returns the values of the columns of an observable that needs no tangent vectors, at the end of the motion.
    fn values(&self, observable: Observable, end: &[f64]) -> Vec<Option<f64>>;
}

/// An integrator with tangent maps.
pub(super) type Motion = AnyIntegrator<dyn AnyTangents>;

/// Follows the motion from a start, and returns the values of the columns of all observables. `method` is the one of the
/// integrator.
///
/// # Errors
/// If no state represents the start, or the motion cannot be followed to the end.
pub(super) fn measure(
    integrator: &Motion,
    start: &AnyState,
    gauge: &mut dyn Gauge,
    course: &Course,
    (formulation, scheme): (Formulation, SchemeName),
) -> Result<Vec<Option<f64>>, Error> {
    let state = integrator.start(start)?;
    // Tangent vectors are zero along coordinates that complete a space of momenta to the width of its type.
    let width = integrator.state_dimension();
    let dimension = if integrator.states_are_momenta() { start.dimension() } else { width };
    // A tangent vector costs more than the state: there are as many as the observables need.
    let measured = match course.tangents() {
        2 => follow::<2>(integrator, (state, dimension), gauge, course),
        1 => follow::<1>(integrator, (state, dimension), gauge, course),
        _ => follow::<0>(integrator, (state, dimension), gauge, course),
    };
    measured.map_err(|failure| match failure {
        VariationalError::Integration(source) => {
            Error::Integration { formulation: formulation.name(), scheme: scheme.name(), source }
        }
        lost => Error::Tangent(lost),
    })
}

/// Makes all steps of a motion with K tangent vectors.
fn follow<const K: usize>(
    integrator: &Motion,
    (state, dimension): (AnyState, usize),
    gauge: &mut dyn Gauge,
    course: &Course,
) -> Result<Vec<Option<f64>>, VariationalError> {
    let step = course.schedule.step;
    let mut flow = VariationalFlow::<_, K>::generic(integrator, state, dimension, step);
    // Sums of ln(δ_k/δ_{k−1}) over the growth δ of the first tangent vector.
    let (mut megno, mut growth) = (Megno::default(), 0.0);
    // Lengths at the start do not count as stretches.
    flow.normalise()?;
    while flow.steps() < course.schedule.steps {
        flow.advance()?;
        let stretches = flow.normalise()?;
        gauge.observe(flow.time(), flow.momentum().as_slice());
        if let Some(stretch) = stretches.first() {
            megno.observe(*stretch);
            growth += stretch.ln();
        }
    }
    let end = flow.momentum();
    let growths = Growths {
        lyapunov: growth / flow.time().abs(),
        megno: megno.mean(),
        alignment: flow.directions()?.first_chunk().map(smaller_alignment_index),
    };
    Ok(growths.columns(&course.observables, &|observable| gauge.values(observable, end.as_slice())))
}

/// How tangent vectors have grown, at the end of a motion.
struct Growths {
    lyapunov: f64,
    megno: f64,
    /// The smaller alignment index, of two tangent vectors or more.
    alignment: Option<f64>,
}

impl Growths {
    /// Returns the values of the columns of all observables; `others` has those that need no tangent vectors.
    fn columns(
        &self,
        observables: &[Observable],
        others: &dyn Fn(Observable) -> Vec<Option<f64>>,
    ) -> Vec<Option<f64>> {
        let values = |observable: &Observable| match observable {
            Observable::Lyapunov => vec![Some(self.lyapunov)],
            Observable::Megno => vec![Some(self.megno)],
            Observable::Sali => vec![self.alignment],
            other => others(*other),
        };
        observables.iter().flat_map(values).collect()
    }
}
