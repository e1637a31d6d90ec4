//! A state that carries tangent vectors along, as many as it is given: [`Carrier`].

use super::orthonormal_frame::orthonormalise;
use super::tangent_scales::{Prober, TangentScales};
use super::tangent_steps::{image, normalise_images, step_tangents};
use crate::chaos::generic_tangents::generic_coordinate;
use crate::chaos::tangent_integrator::{
    DualStateOf, MomentumOf, StateOf, TangentIntegrator, VariationalError,
};
use crate::error::{IntegrationError, StepError};
use crate::integrators::trajectories::integrator::Integrator;
use crate::stages::checkpoints::CHECKPOINT;
use lie_poisson::{DualNumber, State};

/// A state with the storage of its steps and those of tangent vectors, which others keep.
pub(super) struct Carrier<'a, I>
where
    I: TangentIntegrator,
{
    integrator: &'a I,
    workspace: <I as Integrator>::Workspace,
    dual_workspace: <I as Integrator<DualNumber>>::Workspace,
    pub(super) size: f64,
    pub(super) steps: u64,
    pub(super) state: StateOf<I>,
    dual: DualStateOf<I>,
    scales: Result<TangentScales<StateOf<I>, MomentumOf<I>>, StepError>,
}

impl<'a, I> Carrier<'a, I>
where
    I: TangentIntegrator,
{
    /// Creates a state at t = 0 with steps of a size. `carries` says whether there are tangent vectors.
    pub(super) fn new(integrator: &'a I, state: StateOf<I>, step: f64, carries: bool) -> Self {
        let mut workspace = Integrator::<f64>::workspace(integrator);
        let mut dual_workspace = Integrator::<DualNumber>::workspace(integrator);
        // Without tangent vectors the state may move along its fibre.
        if carries {
            Integrator::<f64>::pin(integrator, &mut workspace);
            Integrator::<DualNumber>::pin(integrator, &mut dual_workspace);
        }
        let mut dual = State::zeros_of(&state.shape());
        let prober = Prober {
            integrator,
            workspace: &mut workspace,
            dual_workspace: &mut dual_workspace,
            dual: &mut dual,
            step,
        };
        let scales = prober.scales(&state, carries);
        Self { integrator, workspace, dual_workspace, size: step, steps: 0, state, dual, scales }
    }

    /// Writes the [`generic_tangents`](crate::generic_tangents) in units of the scales of the blocks.
    pub(super) fn begin(
        &self,
        dimension: usize,
        tangents: &mut [StateOf<I>],
        spare: &mut [StateOf<I>],
    ) {
        for (number, v) in tangents.iter_mut().enumerate() {
            v.set_coordinates(|i| generic_coordinate(number, dimension, i));
        }
        if let Ok(units) = &self.scales {
            units.multiply(tangents, spare);
        }
    }

    /// Returns the time t, which is the number of steps times h.
    pub(super) fn time(&self) -> f64 {
        self.steps as f64 * self.size
    }

    /// Advances the state by one step, and writes the tangent vectors after it to `spare`.
    ///
    /// # Errors
    /// Returns those of [`VariationalFlow::advance`](crate::VariationalFlow::advance).
    pub(super) fn advance(
        &mut self,
        tangents: &[StateOf<I>],
        spare: &mut [StateOf<I>],
    ) -> Result<(), VariationalError> {
        let (made, size) = (self.steps, self.size);
        let fail = |source: StepError| IntegrationError::after(made, size, source);
        if made == 0 {
            StepError::check_start(&self.state, size).map_err(fail)?;
            let dimension = self.state.dimension();
            let mut tangents = tangents.iter();
            tangents.try_for_each(|v| StepError::check_dimension(v, dimension)).map_err(fail)?;
        }
        let units = self.scales()?.state;
        if self.steps.is_multiple_of(CHECKPOINT) {
            Integrator::<f64>::forget(self.integrator, &mut self.workspace);
            Integrator::<DualNumber>::forget(self.integrator, &mut self.dual_workspace);
        }
        let Self { integrator, workspace, dual_workspace, state, dual, .. } = self;
        step_tangents(*integrator, (state, units), (tangents, spare), (dual, dual_workspace), size)
            .map_err(fail)?;
        Integrator::<f64>::step_in_place(*integrator, state, size, workspace).map_err(fail)?;
        self.steps += 1;
        Ok(())
    }

    /// Orthonormalises tangent vectors, and writes their previous lengths to `lengths`.
    ///
    /// # Errors
    /// Returns those of [`VariationalFlow::orthonormalise`](crate::VariationalFlow::orthonormalise).
    pub(super) fn orthonormalise(
        &self,
        tangents: &mut [StateOf<I>],
        spare: &mut [StateOf<I>],
        lengths: &mut [f64],
    ) -> Result<(), VariationalError> {
        let (time, units) = (self.time(), self.scales()?);
        units.divide(tangents, spare);
        let outcome = orthonormalise(tangents, spare, lengths, time);
        units.multiply(tangents, spare);
        outcome
    }

    /// Scales tangent vectors so that their images have the length 1, and writes the previous lengths to `lengths`.
    ///
    /// # Errors
    /// Returns those of [`VariationalFlow::normalise`](crate::VariationalFlow::normalise).
    pub(super) fn normalise(
        &mut self,
        tangents: &mut [StateOf<I>],
        lengths: &mut [f64],
    ) -> Result<(), VariationalError> {
        let (time, scales, like) = (self.time(), self.scales()?, self.momentum());
        let Self { integrator, state, dual, .. } = self;
        normalise_images(*integrator, (state, tangents), dual, (&scales, &like), lengths)
            .map_err(|(index, length)| VariationalError::Dependent { index, length, time })
    }

    /// Returns a function of the images of tangent vectors in units of the scales of the blocks.
    ///
    /// # Errors
    /// Returns those of [`VariationalFlow::directions`](crate::VariationalFlow::directions).
    pub(super) fn directions(
        &self,
    ) -> Result<impl FnMut(&StateOf<I>) -> MomentumOf<I> + '_, VariationalError> {
        let (scales, mut dual, like) = (self.scales()?, self.dual.clone(), self.momentum());
        Ok(move |v: &StateOf<I>| {
            image(self.integrator, (&self.state, v), &mut dual, &scales, &like)
        })
    }

    /// Returns the momentum of the state.
    pub(super) fn momentum(&self) -> MomentumOf<I> {
        Integrator::<f64>::momentum(self.integrator, &self.state)
    }

    /// Returns the scales of the blocks.
    fn scales(&self) -> Result<TangentScales<StateOf<I>, MomentumOf<I>>, VariationalError> {
        let fail = |source| IntegrationError::after(0, self.size, source).into();
        self.scales.map_err(fail)
    }
}
