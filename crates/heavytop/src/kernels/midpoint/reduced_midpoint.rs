//! The collective midpoint rule in closed form on se(3)∗, for any Hamiltonian.

use super::closed_form::{Velocity, end, half_angle, middle, whole_turn};
use crate::attitude::step_rotation::{TurnedStep, Turning, unit};
use crate::tops::top::HeavyTopSpace;
use collective_integrators::{
    ByPointer, Integrator, LiftFree, RungeKutta, StageMemory, StageSolver, StateIsMomentum, Step,
    StepError,
};
use lie_poisson::{Hamiltonian, LiePoisson, Real, Se3, Se3Dual, Vector};
use momentum_map::DualQuaternions;
use nalgebra::Vector3;

/// The collective implicit midpoint rule on se(3)∗ for any Hamiltonian h(Π, Γ), without a lift and without
/// multipliers.
///
/// With a = (h/4) Ωₘ and the rotation R_a v = v + (2/(1+|a|²)) (v×a + (v×a)×a) of the Cayley half-step, it
/// reads
///
/// ```text
/// Γₘ = R_a Γ₀ / (1+|a|²)
/// Πₘ = [ R_a Π₀ + (h/2)( Γₘ×γₘ − (a·γₘ) Γₘ − Γₘ×(a×γₘ) ) ] / (1+|a|²)
/// (Ωₘ, γₘ) = dh(Πₘ, Γₘ)                                  (the implicit equations)
/// Γ₁ = R_a R_a Γ₀,    Π₁ = R_a ( R_a Π₀ + h Γₘ×γₘ )
/// ```
///
/// It equals [`LiftFree`] with the midpoint rule to round-off, at less cost: the state has six numbers, and so do the
/// unknowns. It is Poisson and symmetric, of order 2; compositions raise the order. For a
/// [`HeavyTop`](crate::HeavyTop), [`TopMidpoint`](crate::TopMidpoint) makes the same steps several times faster.
///
/// A fixed-point iteration solves for (Ωₘ, γₘ). It starts from an extrapolation of the last steps ([`StageMemory`]). If
/// it fails, as for large steps, Newton's iteration for the multiplier solves the step. Over
/// [lanes](collective_integrators::Laned), many states of one system are advanced at once.
///
/// Source: the rule answers, for this setting, the question of Ohsawa 2019, §5.1; the closed form is that of
/// the one-stage method on dual quaternions.
///
/// # Example
/// A heavy top with a quadratic potential:
/// ```
/// use heavytop::prelude::*;
/// let energy = from_closure::<HeavyTopSpace, _>(|Covector(Pair(pi, gamma))| {
///     (pi.x * pi.x + pi.y * pi.y) * 0.25 + pi.z * pi.z * 0.5 + gamma.x + gamma.z * gamma.z
/// });
/// let midpoint = ReducedMidpoint::new(energy);
/// let start = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.6, 0.0, 0.8));
/// for sample in midpoint.trajectory(&start, 0.02)?.take(1000) {
///     let mu = sample?.momentum;
///     assert!((mu.0.1.norm() - 1.0).abs() < 1e-13);
///     assert!((mu.0.0.dot(&mu.0.1) - 4.4).abs() < 1e-12);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ReducedMidpoint<H> {
    /// Newton's iteration is rare, so that calls of the field cost nothing.
    lift_free: LiftFree<ByPointer<RungeKutta>, DualQuaternions, H>,
    solver: StageSolver,
}

/// The solver of the fixed-point iteration, long enough for every step for which it converges fast.
const FIXED_POINT: StageSolver = StageSolver { tolerance: 0.0, max_iterations: 200, newton: true };

impl<H> ReducedMidpoint<H> {
    /// Creates the rule for h, solved to the round-off floor.
    pub fn new(hamiltonian: H) -> Self
    where
        H: Hamiltonian<LiePoisson<Se3>>,
    {
        let lift_free =
            LiftFree::new(ByPointer(RungeKutta::implicit_midpoint()), DualQuaternions, hamiltonian);
        Self { lift_free, solver: FIXED_POINT }
    }

    /// Replaces the solver of the fixed-point iteration.
    #[must_use]
    pub fn with_solver(self, solver: StageSolver) -> Self {
        Self { solver, ..self }
    }

    /// Returns the Hamiltonian h of the rule.
    pub fn hamiltonian(&self) -> &H {
        self.lift_free.hamiltonian()
    }

    /// Advances by one step, and returns a = (h/4) Ωₘ with the end.
    #[cfg_attr(optimised, inline(always))]
    fn step_and_angle<T: Real>(
        &self,
        mu: &Se3Dual<T>,
        step: f64,
        space: &mut ReducedMidpointWorkspace<H, T>,
    ) -> Result<(Step<Se3Dual<T>>, Vector3<T>), StepError>
    where
        H: Hamiltonian<HeavyTopSpace, T>,
    {
        let mut velocity = [Vector::zero()];
        let first = || self.hamiltonian().differential(mu);
        let solved = space.velocities.solve(
            &self.solver,
            &mu.0,
            step,
            &mut velocity,
            first,
            #[cfg_attr(optimised, inline(always))]
            |_, velocity: &[Velocity<T>]| {
                self.hamiltonian().differential(&middle(mu, &velocity[0], step))
            },
        );
        let [velocity] = velocity;
        let found = end(mu, &velocity, step);
        let a = velocity.0 * T::from_f64(0.25 * step);
        let (next, a) = match solved {
            Ok(iterations) => (Step { point: found, iterations }.finite()?, a),
            Err(unconverged) if T::HAS_SLOW_PATHS && self.solver.newton => {
                let (next, newton) = self.step_by_newton(mu, step, &mut space.newton)?;
                let converged = unconverged.converged;
                let point = Vector::select(converged, &found, &next.point);
                let iterations = unconverged.iterations + next.iterations;
                (Step { point, iterations }.finite()?, Vector::select(converged, &a, &newton))
            }
            Err(unconverged) => return Err(unconverged.into()),
        };
        space.velocities.end_at(&next.point.0);
        Ok((next, a))
    }

    /// Advances by one step with Newton's iteration for the multiplier, and returns a with the end.
    fn step_by_newton<T: Real>(
        &self,
        mu: &Se3Dual<T>,
        step: f64,
        newton: &mut NewtonWorkspace<H, T>,
    ) -> Result<(Step<Se3Dual<T>>, Vector3<T>), StepError>
    where
        H: Hamiltonian<HeavyTopSpace, T>,
    {
        Integrator::<T>::forget(&self.lift_free, newton);
        let (next, q) = self.lift_free.step_with_multiplier::<T>(mu, step, newton)?;
        Ok((next, half_angle(&unit(q.0))))
    }
}

/// The workspace of [`ReducedMidpoint`].
#[derive(Debug)]
pub struct ReducedMidpointWorkspace<H: Hamiltonian<HeavyTopSpace, T>, T: Real = f64> {
    /// The velocities (Ωₘ, γₘ) of the last steps.
    velocities: StageMemory<Velocity<T>>,
    /// The workspace of Newton's iteration.
    newton: NewtonWorkspace<H, T>,
}

/// The workspace of Newton's iteration.
type NewtonWorkspace<H, T> =
    <LiftFree<ByPointer<RungeKutta>, DualQuaternions, H> as Integrator<T>>::Workspace;

impl<H, T> Integrator<T> for ReducedMidpoint<H>
where
    H: Hamiltonian<HeavyTopSpace, T>,
    T: Real,
{
    type State = Se3Dual<T>;
    type Momentum = Se3Dual<T>;
    type Workspace = ReducedMidpointWorkspace<H, T>;

    fn workspace(&self) -> Self::Workspace {
        let velocities = StageMemory::new(self.lift_free.scheme().0.tableau().nodes());
        ReducedMidpointWorkspace { velocities, newton: Integrator::<T>::workspace(&self.lift_free) }
    }

    #[cfg_attr(optimised, inline(always))]
    fn step(
        &self,
        mu: &Se3Dual<T>,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<Se3Dual<T>>, StepError> {
        self.step_and_angle(mu, step, workspace).map(|(next, _)| next)
    }

    #[cfg_attr(optimised, inline(always))]
    fn forget(&self, workspace: &mut Self::Workspace) {
        workspace.velocities.forget();
    }

    #[cfg_attr(optimised, inline(always))]
    fn momentum(&self, mu: &Se3Dual<T>) -> Se3Dual<T> {
        *mu
    }
}

/// The rotation is R_a R_a.
impl<H, T> Turning<T> for ReducedMidpoint<H>
where
    H: Hamiltonian<HeavyTopSpace, T>,
    T: Real,
{
    #[cfg_attr(optimised, inline(always))]
    fn turn(
        &self,
        mu: &Se3Dual<T>,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> TurnedStep<Se3Dual<T>, T> {
        let (next, a) = self.step_and_angle(mu, step, workspace)?;
        Ok((next, whole_turn(&a)))
    }
}

impl<H> StateIsMomentum for ReducedMidpoint<H> {}
