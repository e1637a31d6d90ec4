//! A method with friction: [`Damped`].

use crate::motions::friction::Friction;
use collective_integrators::{
    AnyIntegrator, AnyState, AnyWorkspace, Integrator, Start, Step, StepError,
};
use lie_poisson::{Quaternion, Se3Dual, State, Vector};
use momentum_map::LiftError;

/// The number of coordinates of the attitude, which come last in a state.
const ATTITUDE: usize = 4;

/// What the friction does in a step: (Π, Γ) before and after it acts, at the beginning and at the end of the step.
pub(crate) type Frictions = [[Se3Dual; 2]; 2];

/// A method of the page, and the friction of the top.
///
/// With friction, a step is half a step of the friction, a step of the method, and half a step of the friction. This is
/// Strang's splitting, of order 2; it is [`Torqued`](collective_integrators::Torqued) with the attitude, which the
/// friction does not change. Without friction the step is that of the method.
pub(crate) struct Damped {
    pub(crate) method: AnyIntegrator,
    pub(crate) friction: Option<Friction>,
}

impl Damped {
    /// Returns the state of the method with this momentum and this attitude.
    ///
    /// # Errors
    /// Returns [`LiftError`] if the method has no state for the momentum.
    pub(crate) fn state(&self, mu: &Se3Dual, attitude: &Quaternion) -> Result<AnyState, LiftError> {
        let mut state = self.method.start(&AnyState::of(mu))?;
        let first = state.dimension().saturating_sub(ATTITUDE);
        (0..ATTITUDE).for_each(|i| state.set_coordinate(first + i, attitude.coordinate(i)));
        Ok(state)
    }

    /// Makes a step, and returns what the friction has done in it if there is any.
    ///
    /// # Errors
    /// Returns [`StepError`] if the step has no result.
    pub(crate) fn step_with_friction(
        &self,
        state: &AnyState,
        step: f64,
        workspace: &mut AnyWorkspace,
    ) -> Result<(Step<AnyState>, Option<Frictions>), StepError> {
        let Some(friction) = &self.friction else {
            return Ok((self.method.step(state, step, workspace)?, None));
        };
        let (state, first) = self.rubbed(friction, state, 0.5 * step)?;
        // The lift before was another point of its fibre.
        self.forget(workspace);
        let Step { point, iterations } = self.method.step(&state, step, workspace)?;
        let (point, second) = self.rubbed(friction, &point, 0.5 * step)?;
        Ok((Step { point, iterations }, Some([first, second])))
    }

    /// Returns the state after the friction has acted alone for a time, and (Π, Γ) before and after it.
    fn rubbed(
        &self,
        friction: &Friction,
        state: &AnyState,
        time: f64,
    ) -> Result<(AnyState, [Se3Dual; 2]), StepError> {
        let before = momentum(&self.method.momentum(state));
        let after = friction.flow(&before, time);
        let no_lift = |LiftError { reason, .. }| StepError::NoLift { reason };
        let state = self.state(&after, &last_four(state)).map_err(no_lift)?;
        Ok((state, [before, after]))
    }
}

impl Integrator for Damped {
    type State = AnyState;
    type Momentum = AnyState;
    type Workspace = AnyWorkspace;

    fn workspace(&self) -> AnyWorkspace {
        Integrator::<f64>::workspace(&self.method)
    }

    fn step(
        &self,
        state: &AnyState,
        step: f64,
        workspace: &mut AnyWorkspace,
    ) -> Result<Step<AnyState>, StepError> {
        Ok(self.step_with_friction(state, step, workspace)?.0)
    }

    fn forget(&self, workspace: &mut AnyWorkspace) {
        Integrator::<f64>::forget(&self.method, workspace);
    }

    fn momentum(&self, state: &AnyState) -> AnyState {
        self.method.momentum(state)
    }
}

/// Returns (Π, Γ) of its coordinates.
pub(crate) fn momentum(mu: &AnyState) -> Se3Dual {
    Se3Dual::from_coordinates(|i| mu.coordinate(i))
}

/// Returns the attitude of a state as it is; that of an explicit method is of another length than 1.
fn last_four(state: &AnyState) -> Quaternion {
    let first = state.dimension().saturating_sub(ATTITUDE);
    Quaternion::from_coordinates(|i| state.coordinate(first + i))
}
