//! The collective midpoint rule on se(3)∗, by formulas that are specific to tops.

use super::closed_form::whole_turn;
use super::formulas::GuessHistory;
use super::reduced_midpoint::{ReducedMidpoint, ReducedMidpointWorkspace};
use crate::attitude::step_rotation::{TurnedStep, Turning};
use crate::tops::top::HeavyTop;
use collective_integrators::{Integrator, Registers, StateIsMomentum, Step, StepError};
use lie_poisson::{InstructionSet, MissingInstructions, Se3Dual, Width};

/// The collective midpoint rule of a [`HeavyTop`]: the steps of [`ReducedMidpoint`], several times faster.
///
/// Since dh = (I⁻¹Π, γ) with a constant γ, a = (h/4) Ωₘ is the only unknown of a step.
///
/// If a step has the size of the last ten steps and starts where they ended, bit for bit, a is extrapolated from them.
/// It is then corrected until its error is round-off. The formulas use the widest [instructions](InstructionSet) of the
/// processor, and rounding depends on these. If the iteration does not converge, as for large steps,
/// [`ReducedMidpoint`] makes the step.
///
/// As a [`BatchIntegrator`](collective_integrators::BatchIntegrator) it advances many states of one top at once.
/// [`MidpointBatch`](crate::MidpointBatch) has separate parameters per top. If both traits are in scope, write
/// `Integrator::advance` or `BatchIntegrator::advance`, and the same for `workspace`.
///
/// Source: the formulas are those of [`ReducedMidpoint`].
///
/// # Example
/// ```
/// use collective_integrators::Start;
/// use heavytop::{HeavyTop, TopMidpoint};
/// use lie_poisson::Se3Dual;
/// use nalgebra::Vector3;
/// let midpoint = TopMidpoint::new(HeavyTop::kovalevskaya(1.0, 1.0)?);
/// let start = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.6, 0.0, 0.8));
/// for sample in midpoint.trajectory(&start, 0.02)?.take(1000) {
///     let mu = sample?.momentum;
///     assert!((mu.0.1.norm() - 1.0).abs() < 1e-14);
///     assert!((mu.0.0.dot(&mu.0.1) - 4.4).abs() < 1e-13);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct TopMidpoint {
    general: ReducedMidpoint<HeavyTop>,
    registers: Registers,
}

impl HeavyTop {
    /// Creates the collective midpoint rule for this top: [`TopMidpoint::new`].
    #[must_use]
    pub fn midpoint(&self) -> TopMidpoint {
        TopMidpoint::new(*self)
    }
}

impl TopMidpoint {
    /// Creates the rule for a top, solved to the round-off floor on the widest instructions of the processor.
    #[must_use]
    pub fn new(top: HeavyTop) -> Self {
        Self::on(top, Registers::widest())
    }

    /// Replaces the instruction set. Steps on different sets differ by round-off.
    ///
    /// # Errors
    /// Returns [`MissingInstructions`] if the processor lacks them.
    pub fn with_instructions(self, set: InstructionSet) -> Result<Self, MissingInstructions> {
        Ok(Self { registers: Registers::new(set, Width::TwoRegisters)?, ..self })
    }

    pub(crate) fn on(top: HeavyTop, registers: Registers) -> Self {
        Self { general: ReducedMidpoint::new(top), registers }
    }

    pub(crate) fn registers(&self) -> Registers {
        self.registers
    }

    /// Returns the top that is integrated.
    #[must_use]
    pub fn top(&self) -> &HeavyTop {
        self.general.hamiltonian()
    }

    /// Returns the instruction set in use.
    #[must_use]
    pub fn instructions(&self) -> InstructionSet {
        self.registers.instructions()
    }

    /// Returns the same rule by the formulas for any Hamiltonian, which make the steps for which the formulas
    /// for tops do not converge.
    #[must_use]
    pub fn general(&self) -> &ReducedMidpoint<HeavyTop> {
        &self.general
    }

    /// Makes a step for which the formulas for tops do not converge. It is a call, so that `step` is short enough to be
    /// inlined.
    #[cold]
    fn general_step(
        &self,
        mu: &Se3Dual,
        step: f64,
        workspace: &mut TopMidpointWorkspace,
    ) -> Result<Step<Se3Dual>, StepError> {
        self.general.step(mu, step, &mut workspace.general)
    }
}

/// The workspace of [`TopMidpoint`].
#[derive(Debug)]
pub struct TopMidpointWorkspace {
    history: GuessHistory,
    general: ReducedMidpointWorkspace<HeavyTop>,
}

impl Integrator for TopMidpoint {
    type State = Se3Dual;
    type Momentum = Se3Dual;
    type Workspace = TopMidpointWorkspace;

    fn workspace(&self) -> TopMidpointWorkspace {
        TopMidpointWorkspace {
            history: GuessHistory::new(self.top()),
            general: self.general.workspace(),
        }
    }

    #[inline]
    fn step(
        &self,
        mu: &Se3Dual,
        step: f64,
        workspace: &mut TopMidpointWorkspace,
    ) -> Result<Step<Se3Dual>, StepError> {
        match workspace.history.step(self.top(), mu, step, self.instructions()) {
            Some(next) => Ok(next),
            None => self.general_step(mu, step, workspace),
        }
    }

    #[inline]
    fn forget(&self, workspace: &mut TopMidpointWorkspace) {
        workspace.history.forget();
        self.general.forget(&mut workspace.general);
    }

    #[inline]
    fn momentum(&self, mu: &Se3Dual) -> Se3Dual {
        *mu
    }
}

/// The rotation is R_a R_a.
impl Turning for TopMidpoint {
    #[inline]
    fn turn(
        &self,
        mu: &Se3Dual,
        step: f64,
        workspace: &mut TopMidpointWorkspace,
    ) -> TurnedStep<Se3Dual, f64> {
        match workspace.history.step(self.top(), mu, step, self.instructions()) {
            Some(next) => Ok((next, whole_turn(&workspace.history.newest()))),
            None => self.general.turn(mu, step, &mut workspace.general),
        }
    }
}

impl StateIsMomentum for TopMidpoint {}
