//! The momenta of a run after chosen numbers of steps.

use crate::erased::{AnyIntegrator, AnyState};
use crate::error::{IntegrationError, RunError, StepError};
use crate::integrators::trajectories::integrator::Integrator;
use crate::integrators::trajectories::start::Start;
use crate::stages::checkpoints::CHECKPOINT;

/// The momenta of a run, coordinate by coordinate.
pub(super) struct SampledRun {
    coordinates: Vec<f64>,
    width: usize,
}

impl SampledRun {
    /// Makes the run from a start with these coordinates, and keeps the first coordinates, as many as the start has, after
    /// the numbers of steps `at`, which ascend. Returns `None` if `going` tells it to end.
    ///
    /// # Errors
    /// Returns the errors of [`Start::after`].
    pub(super) fn new(
        integrator: &AnyIntegrator,
        start: &[f64],
        step: f64,
        at: impl Iterator<Item = u64>,
        going: &dyn Fn() -> bool,
    ) -> Result<Option<Self>, RunError> {
        let width = start.len();
        let mu = AnyState::from_slice(start);
        StepError::check_start(&mu, step)
            .map_err(|refused| IntegrationError::after(0, step, refused))?;
        let (mut state, mut workspace) = (integrator.start(&mu)?, integrator.workspace());
        let (mut made, mut coordinates) = (0, Vec::new());
        for until in at {
            while made < until {
                if !going() {
                    return Ok(None);
                }
                let next = until.min((made - made % CHECKPOINT).saturating_add(CHECKPOINT));
                integrator.advance(&mut state, step, made..next, &mut workspace)?;
                made = next;
            }
            coordinates.extend_from_slice(integrator.momentum(&state).as_slice());
        }
        Ok(Some(Self { coordinates, width }))
    }

    /// Returns the coordinates of each momentum.
    pub(super) fn momenta(&self) -> impl DoubleEndedIterator<Item = &[f64]> + Clone {
        self.coordinates.chunks(self.width.max(1))
    }
}
