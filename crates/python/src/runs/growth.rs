//! Tangent vectors along a run: Lyapunov exponents, MEGNO and SALI.

use crate::errors::message;
use collective_integrators::{
    AnyIntegrator, AnyState, AnyTangents, Megno, Start, VariationalFlow, smaller_alignment_index,
};
use core::sync::atomic::{AtomicBool, Ordering};
use lie_poisson_runs::Schedule;
use pyo3::PyResult;
use pyo3::exceptions::PyValueError;

/// The number of steps after which a run looks for a request to stop.
const BETWEEN_REQUESTS: u64 = 1 << 10;

/// The tangent vectors that are followed.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Tangents {
    /// One, for the largest exponent and MEGNO.
    One,
    /// Two, each by itself, for SALI.
    Two,
    /// As many as the space has dimensions, for all exponents.
    All,
}

/// The reason why an integrator has no tangent vectors.
const NO_TANGENTS: &str =
    "a collective integrator has tangent vectors of another space, with its fibres";

/// The growth of tangent vectors along a run.
#[derive(Clone, Default)]
pub(crate) struct Growth {
    /// The times at which the indicators are recorded; the last one is the end.
    pub(crate) times: Vec<f64>,
    /// The exponents at each time, per unit of time along the run: all, or the largest.
    pub(crate) exponents: Vec<f64>,
    /// MEGNO at each time.
    pub(crate) megno: Vec<f64>,
    /// SALI at each time; none unless there are two tangent vectors.
    pub(crate) sali: Vec<f64>,
    /// The state at the end.
    pub(crate) end: Vec<f64>,
}

/// Returns the tangent vectors of a name.
pub(crate) fn tangents_named(name: &str) -> PyResult<Tangents> {
    match name {
        "one" => Ok(Tangents::One),
        "two" => Ok(Tangents::Two),
        "all" => Ok(Tangents::All),
        other => Err(PyValueError::new_err(format!("tangents are one, two or all, got {other}"))),
    }
}

/// How tangent vectors are followed.
pub(crate) struct GrowthTask<'a> {
    pub(crate) start: &'a [f64],
    pub(crate) schedule: Schedule,
    /// The number of steps between two records; 0 records the end alone.
    pub(crate) every: u64,
    /// Set by others if the task is to end.
    pub(crate) stop: &'a AtomicBool,
    pub(crate) tangents: Tangents,
}

/// An integrator with tangent maps.
type Motion = AnyIntegrator<dyn AnyTangents>;

impl GrowthTask<'_> {
    /// Follows the tangent vectors, in a space that may be completed to 3 or 6 dimensions.
    ///
    /// # Errors
    /// Returns the reason why the integrator has no such tangent vectors, or why a step fails.
    pub(crate) fn grow(&self, integrator: &Motion) -> Result<Growth, String> {
        if !integrator.states_are_momenta() {
            return Err(NO_TANGENTS.into());
        }
        match self.tangents {
            Tangents::One => self.follow::<1>(integrator),
            Tangents::Two => self.follow::<2>(integrator),
            Tangents::All => match integrator.state_dimension() {
                3 => self.follow::<3>(integrator),
                6 => self.follow::<6>(integrator),
                10 => self.follow::<10>(integrator),
                _ => self.follow::<15>(integrator),
            },
        }
    }

    /// Follows K tangent vectors of momenta. The first of them, as many as the space has dimensions, have exponents.
    ///
    /// # Errors
    /// Returns the reason why a step fails.
    fn follow<const K: usize>(&self, integrator: &Motion) -> Result<Growth, String> {
        let (Schedule { step, steps }, tangents) = (self.schedule, self.tangents);
        let state =
            integrator.start(&AnyState::from_slice(self.start)).map_err(|error| message(&error))?;
        // The space may be completed by coordinates that stay zero.
        let dimension = self.start.len();
        let mut flow = VariationalFlow::<_, K>::generic(integrator, state, dimension, step);
        let (mut sums, mut megno, mut growth) = ([0.0; K], Megno::default(), Growth::default());
        let kept = if tangents == Tangents::All { K.min(dimension) } else { 1 };
        let stretch = |flow: &mut VariationalFlow<'_, Motion, K>| {
            if tangents == Tangents::Two { flow.normalise() } else { flow.orthonormalise() }
        };
        // Lengths at the start do not count as stretches.
        stretch(&mut flow).map_err(|error| message(&error))?;
        while flow.steps() < steps {
            flow.advance().map_err(|error| message(&error))?;
            let stretches = stretch(&mut flow).map_err(|error| message(&error))?;
            sums.iter_mut().zip(stretches).for_each(|(sum, stretch)| *sum += stretch.ln());
            stretches.first().into_iter().for_each(|stretch| megno.observe(*stretch));
            let made = flow.steps();
            if made == steps || self.every > 0 && made.is_multiple_of(self.every) {
                growth.times.push(flow.time());
                let exponents = sums.iter().take(kept).map(|sum| sum / flow.time().abs());
                growth.exponents.extend(exponents);
                growth.megno.push(megno.mean());
                let directions = flow.directions().map_err(|error| message(&error))?;
                growth.sali.extend(directions.first_chunk().map(smaller_alignment_index));
            }
            if made.is_multiple_of(BETWEEN_REQUESTS) && self.stop.load(Ordering::Relaxed) {
                break;
            }
        }
        if tangents != Tangents::Two {
            growth.sali.clear();
        }
        growth.end = flow.momentum().as_slice().to_vec();
        Ok(growth)
    }
}
