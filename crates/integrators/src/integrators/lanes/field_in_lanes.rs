//! Integrators whose vector field can be evaluated over SIMD lanes: [`FieldInLanes`].

use crate::error::StepError;
use crate::integrators::collective::Collective;
use crate::integrators::compensated::Increments;
use crate::integrators::direct::Direct;
use crate::integrators::lift_free::LiftFree;
use crate::integrators::multiplier_field::AnyScalar;
use crate::schemes::scheme::{Equivariant, Increment, Scheme, Step};
use crate::stages::lane_field::{InLanes, LaneField};
use lie_poisson::{Hamiltonian, InstructionSet, Pair};
use momentum_map::{CollectiveHamiltonian, Multiplier, Multipliers, PoissonMap};

/// An integrator that applies a scheme to a vector field that can be evaluated over SIMD lanes (several numbers in one
/// register).
///
/// [`Direct`], [`Collective`] and [`LiftFree`] integrators implement this trait if their field or Hamiltonian is
/// implemented over every scalar. [`StagesInLanes`](crate::StagesInLanes) requires it.
#[diagnostic::on_unimplemented(
    message = "the stages of `{Self}` cannot be computed in SIMD lanes",
    note = "the field or the Hamiltonian has to be known over all scalars: a closure serves `f64` alone"
)]
pub trait FieldInLanes: Increments<f64> {
    /// Makes a step whose stages are computed in the registers of an instruction set.
    ///
    /// # Errors
    /// Returns the errors of [`Integrator::step`](crate::Integrator::step).
    fn step_in_lanes(
        &self,
        instructions: InstructionSet,
        state: &Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<Self::State>, StepError>;

    /// Returns the increment of a step whose stages are computed in the registers of an instruction set.
    ///
    /// # Errors
    /// Returns the errors of [`Increments::increment`].
    fn increment_in_lanes(
        &self,
        instructions: InstructionSet,
        state: &Pair<Self::State, Self::State>,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Increment<Self::State>, StepError>;
}

impl<S: Scheme, F: LaneField> FieldInLanes for Direct<S, F> {
    #[cfg_attr(optimised, inline(always))]
    fn step_in_lanes(
        &self,
        instructions: InstructionSet,
        state: &F::Point,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<F::Point>, StepError> {
        let field = InLanes { field: self.field(), lanes: self.field(), instructions };
        self.scheme().step::<f64, _>(&field, state, step, workspace)
    }

    #[cfg_attr(optimised, inline(always))]
    fn increment_in_lanes(
        &self,
        instructions: InstructionSet,
        Pair(z, e): &Pair<F::Point, F::Point>,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Increment<F::Point>, StepError> {
        let field = InLanes { field: self.field(), lanes: self.field(), instructions };
        self.scheme().refined_increment::<f64, _>(&field, (z, e), step, workspace)
    }
}

impl<S, M, H> FieldInLanes for Collective<S, M, H>
where
    S: Scheme,
    M: PoissonMap,
    H: Hamiltonian<M::Target>,
    CollectiveHamiltonian<M, H>: LaneField<Point = Self::State>,
{
    #[cfg_attr(optimised, inline(always))]
    fn step_in_lanes(
        &self,
        instructions: InstructionSet,
        state: &Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<Self::State>, StepError> {
        let field = InLanes { field: self.system(), lanes: self.system(), instructions };
        self.step_of::<f64, _>(&field, state, step, workspace)
    }

    #[cfg_attr(optimised, inline(always))]
    fn increment_in_lanes(
        &self,
        instructions: InstructionSet,
        state: &Pair<Self::State, Self::State>,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Increment<Self::State>, StepError> {
        let field = InLanes { field: self.system(), lanes: self.system(), instructions };
        self.increment_of::<f64, _>(&field, state, step, workspace)
    }
}

impl<S, M, H> FieldInLanes for LiftFree<S, M, H>
where
    S: Equivariant,
    M: Multipliers,
    H: Hamiltonian<M::Space>,
    for<'a> AnyScalar<'a, M, H>: LaneField<Point = Multiplier<M, f64>>,
{
    #[cfg_attr(optimised, inline(always))]
    fn step_in_lanes(
        &self,
        instructions: InstructionSet,
        mu: &Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<Self::State>, StepError> {
        let motion = self.motion_by::<f64>(
            mu,
            workspace,
            #[cfg_attr(optimised, inline(always))]
            |field, one, storage| {
                let field = InLanes { field, lanes: &AnyScalar(field), instructions };
                self.advance::<f64, _>(&field, one, step, storage)
            },
        )?;
        Ok(motion.end(mu)?.0)
    }

    #[cfg_attr(optimised, inline(always))]
    fn increment_in_lanes(
        &self,
        instructions: InstructionSet,
        Pair(mu, e): &Pair<Self::State, Self::State>,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Increment<Self::State>, StepError> {
        let motion = self.motion_by::<f64>(
            mu,
            workspace,
            #[cfg_attr(optimised, inline(always))]
            |field, one, storage| {
                let field = InLanes { field, lanes: &AnyScalar(field), instructions };
                self.refined_advance::<f64, _>(&field, one, step, storage)
            },
        )?;
        Ok(self.increment_by(&motion, e))
    }
}
