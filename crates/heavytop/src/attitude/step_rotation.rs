//! The rotation that a step makes of the vertical.

use crate::{HeavyTopSpace, SpinorPoint, SpinorRealisation};
use collective_integrators::{
    Collective, Compensated, Composition, Equivariant, ExactFlows, FlowSequence, Integrator,
    LiftFree, Scheme, Splitting, Step, StepError, compensated_sum,
};
use lie_poisson::{Hamiltonian, Pair, Quaternion, Real, Se3Dual, Vector, squaring_scale};
use momentum_map::DualQuaternions;
use nalgebra::Vector3;

/// The outcome of a step from `S`, and its rotation.
pub type TurnedStep<S, T> = Result<(Step<S>, Quaternion<T>), StepError>;

/// An integrator on se(3)∗ that knows the rotation of the body in each step.
///
/// Γₙ₊₁ alone determines it up to a rotation about Γₙ₊₁; the motion of the group that made the step
/// has it all. [`WithAttitude`](crate::WithAttitude) adds the rotations up.
pub trait Turning<T: Real = f64>: Integrator<T, Momentum = Se3Dual<T>> {
    /// One step, and the unit quaternion Q of the rotation v ↦ Q v conj(Q) that turns Γₙ/|Γₙ| to
    /// Γₙ₊₁/|Γₙ₊₁|.
    ///
    /// # Errors
    /// If the step has no result.
    fn turn(
        &self,
        state: &Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> TurnedStep<Self::State, T>;
}

/// By the [multiplier](LiftFree::multiplier).
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
        let Step { point: q, iterations } = self.multiplier::<T>(mu, step, workspace)?;
        let next = Step { point: *mu + self.change::<T>(&q, mu), iterations }.finite()?;
        Ok((next, unit(q.0)))
    }
}

/// By the multiplier.
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
        let (mu, base) = (&state.0, self.base());
        let Step { point: q, iterations } = base.refined_multiplier::<T>(mu, step, workspace)?;
        let increment = Pair(base.change::<T>(&q, mu), Vector::zero());
        let point = compensated_sum(state, &increment);
        Ok((Step { point, iterations }.finite()?, unit(q.0)))
    }
}

/// By ψₙ₊₁ = Q ψₙ: the fibre plays no part.
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

/// By ψₙ₊₁ = Q ψₙ.
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

/// q/|q|, for q of any size.
#[inline]
pub(crate) fn unit<T: Real>(q: Quaternion<T>) -> Quaternion<T> {
    let q = q.scaled(squaring_scale(&q));
    q.scaled(T::one() / q.norm_squared().sqrt())
}

/// One step, and its Q by the spinors of the states.
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

/// The unit quaternion Q = s + u, as the matrix s − i u·σ of SU(2), with ψ₁/|ψ₁| = Q ψ₀/|ψ₀|.
#[inline]
fn spinor_turn<T: Real>(before: &SpinorPoint<T>, after: &SpinorPoint<T>) -> Quaternion<T> {
    let (psi, next) = (&before.p.0, &after.p.0);
    // The first column of the matrix (ψ₁ψ₀∗ + Jψ₁(Jψ₀)∗)/(|ψ₀||ψ₁|), J(x, y) = (−y∗, x∗).
    let first = next.x * psi.x.conj() + next.y.conj() * psi.y;
    let second = next.y * psi.x.conj() - next.x.conj() * psi.y;
    unit(Quaternion { scalar: first.re, vector: Vector3::new(-second.im, second.re, -first.im) })
}

/// The rotations of the substeps, one after the other.
impl<I: Turning<T>, T: Real> Turning<T> for Composition<I> {
    #[inline]
    fn turn(
        &self,
        state: &I::State,
        step: f64,
        workspace: &mut I::Workspace,
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

/// Exact flows on se(3)∗ that know the rotation of the body.
pub trait TurningFlows<T: Real = f64>: ExactFlows<T, Point = Se3Dual<T>> {
    /// The unit quaternion Q of the rotation that the [flow](ExactFlows::flow) makes of Γ; 1 for
    /// `index` ≥ `COUNT`.
    fn flow_turn(&self, index: usize, time: f64, mu: &Se3Dual<T>) -> Quaternion<T>;
}

/// The flows of (μ, Q), where Q collects the rotations.
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

/// The rotations of the flows, one after the other.
impl<E: TurningFlows<T>, S: FlowSequence, T: Real> Turning<T> for Splitting<E, S> {
    #[inline]
    fn turn(&self, mu: &Se3Dual<T>, step: f64, (): &mut ()) -> TurnedStep<Se3Dual<T>, T> {
        let start = Pair(*mu, Quaternion::one());
        let point = self.sequence().run(&Collected(self.flows()), step, &start);
        let Step { point: Pair(end, turn), iterations } = Step { point, iterations: 0 }.finite()?;
        Ok((Step { point: end, iterations }, unit(turn)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use momentum_map::{Lift, LiftError};

    /// The rotation between two verticals does not know their unit.
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
