//! The collective midpoint rule in closed form on se(3)*.

use crate::attitude::step_rotation::unit;
use crate::kernels::midpoint::formulas::{Memory, Top};
use crate::{HeavyTopSpace, TurnedStep, Turning};
use collective_integrators::{
    Integrator, LiftFree, RungeKutta, StageMemory, StageSolver, Start, Step, StepError,
};
use core::any::Any;
use lie_poisson::{
    Covector, Hamiltonian, InstructionSet, MissingInstructions, Pair, Quaternion, Real, Se3Dual,
    Vector,
};
use momentum_map::{DualQuaternions, LiftError};
use nalgebra::Vector3;

/// (Ω̄, γ̄) = dh at the midpoint.
type Velocity<T> = Pair<Vector3<T>, Vector3<T>>;

/// The collective implicit midpoint rule on se(3)*, without a lift and without multipliers. With
/// a = (h/4) Ω̄ and the rotation R_a v = v + (2/(1+|a|²)) (v×a + (v×a)×a) of the Cayley half-step,
///
/// ```text
/// Γ̄ = R_a Γ₀ / (1+|a|²)
/// Π̄ = [ R_a Π₀ + (h/2)( Γ̄×γ̄ − (a·γ̄) Γ̄ − Γ̄×(a×γ̄) ) ] / (1+|a|²)
/// (Ω̄, γ̄) = dh(Π̄, Γ̄)                                  (the implicit equations)
/// Γ₁ = R_a R_a Γ₀,    Π₁ = R_a ( R_a Π₀ + h Γ̄×γ̄ )
/// ```
///
/// for any Hamiltonian h(Π, Γ). It equals [`LiftFree`](collective_integrators::LiftFree) with the
/// midpoint rule to round-off, at less cost: six numbers of state, six unknowns. Poisson and
/// symmetric, of order 2; compositions raise the order.
///
/// # Tops
/// Over `f64`, and where dh = (I⁻¹Π, γ) with a diagonal I⁻¹ and a constant γ
/// ([`Hamiltonian::affine_differential`]), as for the [`HeavyTop`](crate::HeavyTop), formulas of
/// their own solve for a, the only unknown, to the same round-off, several times faster. They
/// extrapolate a from the last ten steps, if a step has their size and starts where they ended, bit
/// for bit; and they use the widest [instructions](InstructionSet) of the processor, on which the
/// rounding depends. As a [`BatchIntegrator`](collective_integrators::BatchIntegrator) it carries many
/// tops along at once, as does [`MidpointSweep`](crate::MidpointSweep).
///
/// Where that does not settle, as for every other system, a fixed-point iteration solves for
/// (Ω̄, γ̄), guessed from the steps before ([`StageMemory`]); where that fails, for large steps,
/// Newton's iteration for the multiplier does. Over lanes ([`Laned`](collective_integrators::Laned))
/// that is how many states of any system go side by side.
///
/// Source: it answers, for this setting, the question of Ohsawa 2019, §5.1; the closed form is
/// that of the one-stage method on dual quaternions.
///
/// # Example
/// ```
/// use collective_integrators::Start;
/// use heavytop::{HeavyTop, ReducedMidpoint};
/// use lie_poisson::Se3Dual;
/// use nalgebra::Vector3;
/// let midpoint = ReducedMidpoint::new(HeavyTop::kovalevskaya(1.0, 1.0)?);
/// let start = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.6, 0.0, 0.8));
/// for sample in midpoint.trajectory(&start, 0.02)?.take(1000) {
///     let mu = sample?.momentum;
///     assert!((mu.0.1.norm() - 1.0).abs() < 1e-14);
///     assert!((mu.0.0.dot(&mu.0.1) - 4.4).abs() < 1e-13);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ReducedMidpoint<H> {
    lift_free: LiftFree<RungeKutta, DualQuaternions, H>,
    solver: StageSolver,
    instructions: InstructionSet,
}

/// A fixed-point iteration long enough for every step for which it converges at all fast.
const FIXED_POINT: StageSolver = StageSolver { tolerance: 0.0, max_iterations: 200, newton: true };

impl<H> ReducedMidpoint<H> {
    /// The rule for h, solved to the round-off floor.
    pub fn new(hamiltonian: H) -> Self {
        let lift_free =
            LiftFree::new(RungeKutta::implicit_midpoint(), DualQuaternions, hamiltonian);
        Self { lift_free, solver: FIXED_POINT, instructions: InstructionSet::detected() }
    }

    /// The same with the fixed-point iteration of another solver, for tops too, which go without
    /// formulas of their own then.
    #[must_use]
    pub fn with_solver(self, solver: StageSolver) -> Self {
        Self { solver, ..self }
    }

    /// The same on other instructions, for tops.
    ///
    /// # Errors
    /// If the processor lacks them.
    pub fn with_instructions(self, set: InstructionSet) -> Result<Self, MissingInstructions> {
        if set.is_available() {
            Ok(Self { instructions: set, ..self })
        } else {
            Err(MissingInstructions { set })
        }
    }

    /// h
    pub fn hamiltonian(&self) -> &H {
        self.lift_free.hamiltonian()
    }

    /// The instructions for tops.
    pub fn instructions(&self) -> InstructionSet {
        self.instructions
    }

    /// The parameters of the top, if h is that of one and `T` is `f64`.
    #[inline]
    pub(crate) fn top<T: Real>(&self) -> Option<Top>
    where
        H: Hamiltonian<HeavyTopSpace, T>,
    {
        if self.solver == FIXED_POINT { top_of(self.hamiltonian()) } else { None }
    }

    /// The storage for steps of any system.
    pub(crate) fn velocity_space<T: Real>(&self) -> VelocitySpace<H, T>
    where
        H: Hamiltonian<HeavyTopSpace, T>,
    {
        let velocities = StageMemory::new(self.lift_free.scheme().tableau().nodes());
        VelocitySpace { velocities, newton: Integrator::<T>::workspace(&self.lift_free) }
    }

    /// One step of any system, and a = (h/4) Ω̄.
    #[inline]
    pub(crate) fn step_of_any<T: Real>(
        &self,
        mu: &Se3Dual<T>,
        step: f64,
        space: &mut VelocitySpace<H, T>,
    ) -> Result<(Step<Se3Dual<T>>, Vector3<T>), StepError>
    where
        H: Hamiltonian<HeavyTopSpace, T>,
    {
        let mut velocity = [Vector::zero()];
        let first = || self.hamiltonian().differential(mu);
        let solve = |_, velocity: &[Velocity<T>]| {
            self.hamiltonian().differential(&middle(mu, &velocity[0], step))
        };
        let solved = space.velocities.solve(&self.solver, &mu.0, step, &mut velocity, first, solve);
        let [velocity] = velocity;
        let found = end(mu, &velocity, step);
        let a = velocity.0 * T::from_f64(0.25 * step);
        let (next, a) = match solved {
            Ok(iterations) => (Step { point: found, iterations }.finite()?, a),
            Err(unconverged) if self.solver.newton => {
                let (next, newton) = self.step_by_newton(mu, step, &mut space.newton)?;
                let converged = unconverged.converged;
                let point = Vector::select(converged, &found, &next.point);
                (Step { point, ..next }.finite()?, Vector::select(converged, &a, &newton))
            }
            Err(unconverged) => return Err(unconverged.into()),
        };
        space.velocities.end_at(&next.point.0);
        Ok((next, a))
    }

    /// One step by Newton's iteration for the multiplier, and a.
    fn step_by_newton<T: Real>(
        &self,
        mu: &Se3Dual<T>,
        step: f64,
        newton: &mut NewtonSpace<H, T>,
    ) -> Result<(Step<Se3Dual<T>>, Vector3<T>), StepError>
    where
        H: Hamiltonian<HeavyTopSpace, T>,
    {
        Integrator::<T>::forget(&self.lift_free, newton);
        let (next, turn) = self.lift_free.turn(mu, step, newton)?;
        // the quaternion of R_a R_a is (1 − |a|² − 2a)/(1 + |a|²)
        Ok((next, turn.vector * (-T::one() / (turn.scalar + 1.0))))
    }

    /// One step of a top, and a; none if h or `T` is another or a does not settle.
    #[inline]
    fn step_of_top<T: Real>(
        &self,
        mu: &Se3Dual<T>,
        step: f64,
        memory: &mut Memory,
    ) -> Option<Step<Se3Dual<T>>>
    where
        H: Hamiltonian<HeavyTopSpace, T>,
    {
        let top = self.top::<T>()?;
        let next = memory.step(&top, same_type(mu)?, step, self.instructions)?;
        Some(Step { point: *same_type(&next.point)?, iterations: next.iterations })
    }
}

/// The storage of a step of [`ReducedMidpoint`].
#[derive(Debug)]
pub struct ReducedMidpointSpace<H: Hamiltonian<HeavyTopSpace, T>, T: Real = f64> {
    /// The last steps of a top.
    memory: Memory,
    any: VelocitySpace<H, T>,
}

/// The storage of a step of any system by [`ReducedMidpoint`].
#[derive(Debug)]
pub struct VelocitySpace<H: Hamiltonian<HeavyTopSpace, T>, T: Real = f64> {
    /// (Ω̄, γ̄) of the last steps.
    velocities: StageMemory<Velocity<T>>,
    /// The storage of Newton's iteration.
    newton: NewtonSpace<H, T>,
}

impl<H: Hamiltonian<HeavyTopSpace, T>, T: Real> VelocitySpace<H, T> {
    /// Forgets the steps before.
    #[inline]
    pub(crate) fn forget(&mut self) {
        self.velocities.forget();
    }
}

/// The storage of Newton's iteration.
type NewtonSpace<H, T> = <LiftFree<RungeKutta, DualQuaternions, H> as Integrator<T>>::Workspace;

/// `x`, if `A` and `B` are the same type.
#[inline]
fn same_type<A: 'static, B: 'static>(x: &A) -> Option<&B> {
    (x as &dyn Any).downcast_ref()
}

/// The parameters of the top of which h is the energy: dh = (I⁻¹Π, γ) with a diagonal I⁻¹ and a
/// constant γ.
#[inline]
pub(crate) fn top_of<H: Hamiltonian<HeavyTopSpace, T>, T: Real>(hamiltonian: &H) -> Option<Top> {
    let affine = hamiltonian.affine_differential()?;
    let &(Pair(inverse_inertia, stiffness), Pair(spin, force)) =
        same_type::<_, (Velocity<f64>, Velocity<f64>)>(&affine)?;
    let zero = Vector3::zeros();
    (stiffness == zero && spin == zero).then_some(Top { inverse_inertia, force })
}

/// R_a v, for n = 1/(1+|a|²).
#[inline]
fn half_turn<T: Real>(a: &Vector3<T>, n: T, v: &Vector3<T>) -> Vector3<T> {
    let turned = v.cross(a);
    v + (turned + turned.cross(a)) * (n + n)
}

/// a and 1/(1+|a|²)
#[inline]
fn angle<T: Real>(omega: &Vector3<T>, step: f64) -> (Vector3<T>, T) {
    let a = omega * T::from_f64(0.25 * step);
    (a, T::one() / (a.dot(&a) + 1.0))
}

/// (Π̄, Γ̄)
#[inline]
fn middle<T: Real>(start: &Se3Dual<T>, velocity: &Velocity<T>, step: f64) -> Se3Dual<T> {
    let (Covector(Pair(pi, gamma)), Pair(omega, force)) = (start, velocity);
    let (a, n) = angle(omega, step);
    let vertical = half_turn(&a, n, gamma) * n;
    let torque = vertical.cross(&(force + force.cross(&a))) - vertical * a.dot(force);
    let pi = half_turn(&a, n, pi) + torque * T::from_f64(0.5 * step);
    Se3Dual::new(pi * n, vertical)
}

/// (Π₁, Γ₁)
#[inline]
fn end<T: Real>(start: &Se3Dual<T>, velocity: &Velocity<T>, step: f64) -> Se3Dual<T> {
    let (Covector(Pair(pi, gamma)), Pair(omega, force)) = (start, velocity);
    let (a, n) = angle(omega, step);
    let half = half_turn(&a, n, gamma);
    let torque = half.cross(force) * (n * T::from_f64(step));
    let pi = half_turn(&a, n, &(half_turn(&a, n, pi) + torque));
    Se3Dual::new(pi, half_turn(&a, n, &half))
}

impl<H, T> Integrator<T> for ReducedMidpoint<H>
where
    H: Hamiltonian<HeavyTopSpace, T>,
    T: Real,
{
    type State = Se3Dual<T>;
    type Momentum = Se3Dual<T>;
    type Workspace = ReducedMidpointSpace<H, T>;

    fn workspace(&self) -> Self::Workspace {
        ReducedMidpointSpace { memory: Memory::new(), any: self.velocity_space() }
    }

    #[inline]
    fn step(
        &self,
        mu: &Se3Dual<T>,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<Se3Dual<T>>, StepError> {
        match self.step_of_top(mu, step, &mut workspace.memory) {
            Some(next) => Ok(next),
            None => self.step_of_any(mu, step, &mut workspace.any).map(|(next, _)| next),
        }
    }

    #[inline]
    fn forget(&self, workspace: &mut Self::Workspace) {
        workspace.memory.forget();
        workspace.any.forget();
    }

    #[inline]
    fn momentum(&self, mu: &Se3Dual<T>) -> Se3Dual<T> {
        *mu
    }
}

/// R_a R_a
impl<H, T> Turning<T> for ReducedMidpoint<H>
where
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
        let (next, a) = match self.step_of_top(mu, step, &mut workspace.memory) {
            Some(next) => (next, workspace.memory.newest().map(T::from_f64)),
            None => self.step_of_any(mu, step, &mut workspace.any)?,
        };
        // R_a is the rotation by 1 − a.
        let half = Quaternion { scalar: T::one(), vector: -a };
        Ok((next, unit(half * half)))
    }
}

impl<H, T> Start<T> for ReducedMidpoint<H>
where
    H: Hamiltonian<HeavyTopSpace, T>,
    T: Real,
{
    fn start(&self, mu: &Se3Dual<T>) -> Result<Se3Dual<T>, LiftError> {
        Ok(*mu)
    }
}
