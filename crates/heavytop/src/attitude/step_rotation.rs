//! Integrators and flows that report the rotation of the body in each step.

use crate::paper::spinor_realisation::{SpinorPoint, SpinorRealisation};
use crate::tops::top::HeavyTopSpace;
use collective_integrators::{
    Collective, Compensated, Composition, Equivariant, ExactFlows, FlowSequence, Integrator,
    LiftFree, Scheme, Splitting, StagesInLanes, Step, StepError, compensated_sum,
};
use lie_poisson::{Hamiltonian, Pair, Quaternion, Real, Se3Dual, Vector, squaring_scale};
use momentum_map::DualQuaternions;
use nalgebra::Vector3;

/// The result of a step: the next state of type `S` with the quaternion of the rotation, or a [`StepError`].
pub type TurnedStep<S, T> = Result<(Step<S>, Quaternion<T>), StepError>;

/// An integrator on se(3)∗ that reports the rotation of the body in each step.
///
/// The change of Γ alone determines the rotation up to a turn about Γₙ₊₁. The group element of the step determines it
/// completely. [`WithAttitude`](crate::WithAttitude) multiplies the rotations of all steps.
pub trait Turning<T: Real = f64>: Integrator<T, State: Vector, Momentum = Se3Dual<T>> {
    /// Advances by one step and returns the unit quaternion Q of its rotation v ↦ Q v conj(Q), which turns
    /// Γₙ/|Γₙ| to Γₙ₊₁/|Γₙ₊₁|.
    ///
    /// # Errors
    /// Returns [`StepError`] if the step has no result.
    fn turn(
        &self,
        state: &Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> TurnedStep<Self::State, T>;
}

/// The rotation is that of the [multiplier](LiftFree::step_with_multiplier) of the step.
impl<S, H, T> Turning<T> for LiftFree<S, DualQuaternions, H>
where
    S: Equivariant,
    H: Hamiltonian<HeavyTopSpace, T>,
    T: Real,
{
    #[inline]
    fn turn(
        &self,
        mu: &Se3Dual<T>,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> TurnedStep<Se3Dual<T>, T> {
        let (next, q) = self.step_with_multiplier::<T>(mu, step, workspace)?;
        Ok((next, unit(q.0)))
    }
}

/// The rotation is that of the multiplier of the step.
impl<S, H, T> Turning<T> for Compensated<LiftFree<S, DualQuaternions, H>>
where
    S: Equivariant,
    H: Hamiltonian<HeavyTopSpace, T>,
    T: Real,
{
    #[inline]
    fn turn(
        &self,
        state: &Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> TurnedStep<Self::State, T> {
        let Pair(mu, e) = state;
        let (next, q) = self.base().increment_with_multiplier::<T>(mu, e, step, workspace)?;
        let Step { point: increment, iterations } = next;
        let point = compensated_sum(state, &increment);
        Ok((Step { point, iterations }.finite()?, unit(q.0)))
    }
}

/// The rotation is Q, with ψₙ₊₁ = Q ψₙ. It does not depend on the position along the fibre.
impl<S, H, T> Turning<T> for Collective<S, SpinorRealisation, H>
where
    S: Scheme,
    H: Hamiltonian<HeavyTopSpace, T>,
    T: Real,
{
    #[inline]
    fn turn(
        &self,
        z: &SpinorPoint<T>,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> TurnedStep<SpinorPoint<T>, T> {
        turned_by_spinors(self, z, step, workspace, |z| z)
    }
}

/// The rotation is Q, with ψₙ₊₁ = Q ψₙ.
impl<S, H, T> Turning<T> for Compensated<Collective<S, SpinorRealisation, H>>
where
    S: Scheme,
    H: Hamiltonian<HeavyTopSpace, T>,
    T: Real,
{
    #[inline]
    fn turn(
        &self,
        state: &Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> TurnedStep<Self::State, T> {
        turned_by_spinors(self, state, step, workspace, |state| &state.0)
    }
}

/// The rotation is Q, with ψₙ₊₁ = Q ψₙ.
impl<S, H> Turning for StagesInLanes<Collective<S, SpinorRealisation, H>>
where
    Self: Integrator<State = SpinorPoint, Momentum = Se3Dual>,
{
    #[inline]
    fn turn(
        &self,
        z: &SpinorPoint,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> TurnedStep<SpinorPoint, f64> {
        turned_by_spinors(self, z, step, workspace, |z| z)
    }
}

/// The rotation is Q, with ψₙ₊₁ = Q ψₙ.
impl<S, H> Turning for Compensated<StagesInLanes<Collective<S, SpinorRealisation, H>>>
where
    Self: Integrator<State = Pair<SpinorPoint, SpinorPoint>, Momentum = Se3Dual>,
{
    #[inline]
    fn turn(
        &self,
        state: &Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> TurnedStep<Self::State, f64> {
        turned_by_spinors(self, state, step, workspace, |state| &state.0)
    }
}

/// Returns the unit quaternion q/|q| for a q of any size.
#[inline]
pub(crate) fn unit<T: Real>(q: Quaternion<T>) -> Quaternion<T> {
    let q = q.scaled(squaring_scale(&q));
    q.scaled(T::one() / q.norm_squared().sqrt())
}

/// Advances by one step and computes its rotation Q from the spinors ψ before and after it.
#[inline]
pub(crate) fn turned_by_spinors<I: Integrator<T>, T: Real>(
    integrator: &I,
    state: &I::State,
    step: f64,
    workspace: &mut I::Workspace,
    spinors: impl Fn(&I::State) -> &SpinorPoint<T>,
) -> TurnedStep<I::State, T> {
    let next = integrator.step(state, step, workspace)?;
    let turn = spinor_turn(spinors(state), spinors(&next.point));
    Ok((next, turn))
}

/// Returns the unit quaternion Q = s + u with ψ₁/|ψ₁| = Q ψ₀/|ψ₀|, where Q acts as the matrix s − i u·σ of
/// SU(2).
#[inline]
fn spinor_turn<T: Real>(before: &SpinorPoint<T>, after: &SpinorPoint<T>) -> Quaternion<T> {
    let (psi, next) = (&before.p.0, &after.p.0);
    // The first column of the matrix (ψ₁ψ₀∗ + Jψ₁(Jψ₀)∗)/(|ψ₀||ψ₁|), J(x, y) = (−y∗, x∗).
    let first = next.x * psi.x.conj() + next.y.conj() * psi.y;
    let second = next.y * psi.x.conj() - next.x.conj() * psi.y;
    unit(Quaternion { scalar: first.re, vector: Vector3::new(-second.im, second.re, -first.im) })
}

/// The rotation is the product of the rotations of the substeps.
impl<I: Turning<T>, T: Real> Turning<T> for Composition<I> {
    #[inline]
    fn turn(
        &self,
        state: &I::State,
        step: f64,
        (workspace, _): &mut Self::Workspace,
    ) -> TurnedStep<I::State, T> {
        let mut total = (Step { point: *state, iterations: 0 }, Quaternion::one());
        for gamma in self.substeps().fractions() {
            let (next, turn) = self.base().turn(&total.0.point, gamma * step, workspace)?;
            let iterations = total.0.iterations + next.iterations;
            total = (Step { iterations, ..next }, turn * total.1);
        }
        Ok(total)
    }
}

/// Exact flows on se(3)∗ that report the rotation of the body.
///
/// A flow over the time t turns the body by R(Q), so that Γ(t) = R(Q)ᵀ Γ(0) in the body frame. The rotations of the
/// flows of a step are multiplied in their order, Q = Q₁ Q₂ …, and so are those of successive steps.
pub trait TurningFlows<T: Real = f64>: ExactFlows<T, Point = Se3Dual<T>> {
    /// Returns the unit quaternion Q of the rotation of Γ by the [flow](ExactFlows::flow); 1 for `index` ≥
    /// `COUNT`.
    fn flow_turn(&self, index: usize, time: f64, mu: &Se3Dual<T>) -> Quaternion<T>;
}

/// The flows of (μ, Q), where Q is the product of the rotations so far.
struct Collected<'a, E>(&'a E);

impl<E: TurningFlows<T>, T: Real> ExactFlows<T> for Collected<'_, E> {
    type Point = Pair<Se3Dual<T>, Quaternion<T>>;
    const COUNT: usize = E::COUNT;

    #[inline]
    fn flow(&self, index: usize, time: f64, Pair(mu, turn): &Self::Point) -> Self::Point {
        let turned = self.0.flow_turn(index, time, mu) * *turn;
        Pair(self.0.flow(index, time, mu), turned)
    }
}

/// The rotation is the product of the rotations of the flows.
impl<E: TurningFlows<T>, S: FlowSequence, T: Real> Turning<T> for Splitting<E, S> {
    #[inline]
    fn turn(
        &self,
        mu: &Se3Dual<T>,
        step: f64,
        _: &mut Self::Workspace,
    ) -> TurnedStep<Se3Dual<T>, T> {
        let mut point = Pair(*mu, Quaternion::one());
        self.sequence().run(&Collected(self.flows()), step, &mut point, &mut Default::default());
        let Step { point: Pair(end, turn), iterations } = Step { point, iterations: 0 }.finite()?;
        Ok((Step { point: end, iterations }, unit(turn)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use momentum_map::{Lift, LiftError};

    /// The rotation between two verticals does not depend on their unit.
    #[test]
    fn rotations_of_spinors_of_every_size() -> Result<(), LiftError> {
        let turn = |size: f64| {
            let spinor = |gamma: Vector3<f64>| {
                SpinorRealisation.lift(&Se3Dual::new(Vector3::zeros(), gamma * size))
            };
            let [before, after] = [Vector3::new(0.6, 0.0, 0.8), Vector3::new(0.0, 0.6, 0.8)];
            let q = spinor_turn(&spinor(before)?, &spinor(after)?);
            assert!((q.rotate(&before) - after).norm() < 1e-15, "{size:e}: {q:?}");
            Ok(q)
        };
        let one = turn(1.0)?;
        for size in [1e-300, 1e-200, 1e-160, 1e160, 1e200, 1e300] {
            assert!((turn(size)? - one).max_abs() < 1e-15, "{size:e}");
        }
        Ok(())
    }
}
