//! The measurement of a motion, whatever its integrator.

use super::course::Course;
use super::gauge::Gauge;
use crate::configuration::Observable;
use crate::errors::Error;
use heavytop::methods::Method;
use lie_poisson::larger;
use lie_poisson_runs::{Conserved, Model, RunFailure, TangentGrowth};

/// Follows the motion of a model from a start by a method, and returns the values of the columns of all observables.
///
/// # Errors
/// If no state represents the start, or the motion cannot be followed to the end.
pub(super) fn measure(
    model: &dyn Model,
    run: (&Method, &[f64]),
    gauge: &mut Gauge<'_>,
    course: &Course,
) -> Result<Vec<Option<f64>>, Error> {
    // A tangent vector costs more than the state: there are as many as the observables need.
    let (schedule, tangents) = (course.schedule, course.tangents());
    let mut observe = |time, momentum: &[f64]| gauge.observe(time, momentum);
    let grown = TangentGrowth::of_model(model, run, schedule, tangents, &mut observe)?;
    let values = |observable: &Observable| match observable {
        Observable::Lyapunov => vec![Some(grown.lyapunov)],
        Observable::Megno => vec![Some(grown.megno)],
        Observable::Sali => vec![grown.alignment],
        other => gauge.values(*other, grown.end.as_slice()),
    };
    Ok(course.observables.iter().flat_map(values).collect())
}

/// Follows the motion of a model from a start by a method, and returns its end with what its tangent vectors show, and the largest
/// deviations of the quantities with columns.
///
/// # Errors
/// If no state represents the start, the motion cannot be followed to the end, or a quantity has no finite value along it.
pub(super) fn follow(
    model: &dyn Model,
    (method, start): (&Method, &[f64]),
    course: &Course,
) -> Result<(TangentGrowth, Vec<f64>), Error> {
    let mut drift = Drift::new(model, start)?;
    let mut observe = |time: f64, state: &[f64]| drift.observe(time, state);
    let (schedule, tangents) = (course.schedule, course.tangents());
    let grown = TangentGrowth::of_model(model, (method, start), schedule, tangents, &mut observe)?;
    match &drift.undefined {
        Some((time, state)) => {
            let (time, reason) = (*time, drift.conserved.without_value(*time, state));
            Err(RunFailure::NoValue { time, reason }.into())
        }
        None => Ok((grown, drift.largest)),
    }
}

/// The largest deviations of what is conserved.
struct Drift<'a> {
    conserved: Box<dyn Conserved + 'a>,
    initial: Vec<f64>,
    largest: Vec<f64>,
    values: Vec<f64>,
    /// The first time and state at which a quantity has no finite value.
    undefined: Option<(f64, Vec<f64>)>,
}

impl<'a> Drift<'a> {
    fn new(model: &'a dyn Model, start: &[f64]) -> Result<Self, Error> {
        let conserved = model.conserved(start);
        let initial = conserved.values(0.0, start);
        let initial = initial.map_err(|reason| RunFailure::NoValue { time: 0.0, reason })?;
        let (largest, values) = (vec![0.0; initial.len()], Vec::new());
        Ok(Self { conserved, initial, largest, values, undefined: None })
    }

    fn observe(&mut self, time: f64, state: &[f64]) {
        self.values.clear();
        self.conserved.append(time, state, &mut self.values);
        if self.values.iter().any(|value| !value.is_finite()) {
            self.undefined.get_or_insert_with(|| (time, state.to_vec()));
        }
        for ((most, value), initial) in self.largest.iter_mut().zip(&self.values).zip(&self.initial)
        {
            *most = larger(*most, (value - initial).abs());
        }
    }
}
