//! Tangent vectors along a run: Lyapunov exponents, MEGNO and SALI.

use crate::errors::message;
use collective_integrators::{
    AnyIntegrator, AnyState, AnyTangents, Megno, Start, TangentFrame, smaller_alignment_index,
};
use core::sync::atomic::{AtomicBool, Ordering};
use lie_poisson_runs::Schedule;

/// The number of steps after which a run looks for a request to stop.
const BETWEEN_REQUESTS: u64 = 1 << 10;

/// The reason why an integrator has no tangent vectors.
const NO_TANGENTS: &str =
    "a collective integrator has tangent vectors of another space, with its fibres";

/// The growth of tangent vectors along a run.
#[derive(Clone, Default)]
pub(crate) struct Growth {
    /// The times at which the indicators are recorded; the last one is the end.
    pub(crate) times: Vec<f64>,
    /// The exponents at each time, per unit of time along the run: as many as were asked for.
    pub(crate) exponents: Vec<f64>,
    /// MEGNO at each time.
    pub(crate) megno: Vec<f64>,
    /// SALI at each time; none unless it was asked for.
    pub(crate) sali: Vec<f64>,
    /// The state at the end.
    pub(crate) end: Vec<f64>,
}

/// How tangent vectors are followed.
pub(crate) struct GrowthTask<'a> {
    pub(crate) start: &'a [f64],
    pub(crate) schedule: Schedule,
    /// The number of steps between two records; 0 records the end alone.
    pub(crate) every: u64,
    /// Set by others if the task is to end.
    pub(crate) stop: &'a AtomicBool,
    /// The number of exponents, each of which needs a tangent vector; `None` follows two, each by itself, for SALI.
    pub(crate) exponents: Option<usize>,
    /// Moves a state to the path of its own, if there is noise.
    pub(crate) on_path: &'a dyn Fn(&mut [f64]),
}

/// An integrator with tangent maps.
type Motion = AnyIntegrator<dyn AnyTangents>;

impl GrowthTask<'_> {
    /// Follows the tangent vectors of momenta.
    ///
    /// # Errors
    /// Returns the reason why the integrator has no such tangent vectors, or why a step fails.
    pub(crate) fn grow(&self, integrator: &Motion) -> Result<Growth, String> {
        if !integrator.states_are_momenta() {
            return Err(NO_TANGENTS.into());
        }
        let Schedule { step, steps } = self.schedule;
        let state = integrator.start(&AnyState::from_slice(self.start));
        let mut state = state.map_err(|error| message(&error))?;
        (self.on_path)(state.as_mut_slice());
        // The space may be completed by coordinates that stay zero.
        let numbers = (self.exponents.unwrap_or(2), self.start.len());
        let mut frame = TangentFrame::generic(integrator, state, numbers, step);
        let kept = self.exponents.unwrap_or(1);
        let (mut sums, mut megno) = (vec![0.0; kept], Megno::default());
        let mut growth = Growth::default();
        let stretch = |frame: &mut TangentFrame<'_, Motion>, observe: &mut dyn FnMut(&[f64])| {
            let stretches = match self.exponents {
                Some(_) => frame.orthonormalise(),
                None => frame.normalise(),
            };
            stretches.map(observe).map_err(|error| message(&error))
        };
        // Lengths at the start do not count as stretches. Where many vectors are nearly dependent, the rounding errors of the
        // first round are seen in the second.
        for _ in 0..if kept > 1 { 2 } else { 1 } {
            stretch(&mut frame, &mut |_| ())?;
        }
        while frame.steps() < steps {
            frame.advance().map_err(|error| message(&error))?;
            stretch(&mut frame, &mut |stretches| {
                sums.iter_mut().zip(stretches).for_each(|(sum, stretch)| *sum += stretch.ln());
                stretches.first().into_iter().for_each(|stretch| megno.observe(*stretch));
            })?;
            let made = frame.steps();
            if made == steps || self.every > 0 && made.is_multiple_of(self.every) {
                growth.times.push(frame.time());
                growth.exponents.extend(sums.iter().map(|sum| sum / frame.time().abs()));
                growth.megno.push(megno.mean());
                if self.exponents.is_none() {
                    let directions = frame.directions().map_err(|error| message(&error))?;
                    growth.sali.extend(directions.first_chunk().map(smaller_alignment_index));
                }
            }
            if made.is_multiple_of(BETWEEN_REQUESTS) && self.stop.load(Ordering::Relaxed) {
                break;
            }
        }
        growth.end = frame.momentum().as_slice().to_vec();
        Ok(growth)
    }
}
