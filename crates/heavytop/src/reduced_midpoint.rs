//! The collective midpoint rule in closed form on se(3)*.

use crate::turning::unit;
use crate::{HeavyTopSpace, Turned, Turning};
use collective_integrators::{Integrator, StageSolver, Start, Step, StepError};
use lie_poisson::{Covector, Hamiltonian, Pair, Quaternion, Real, Se3Dual, Vector};
use momentum_map::LiftError;
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
    hamiltonian: H,
    solver: StageSolver,
}

impl<H> ReducedMidpoint<H> {
    /// The rule for h, solved to the round-off floor.
    pub fn new(hamiltonian: H) -> Self {
        let solver = StageSolver { max_iterations: 200, ..StageSolver::default() };
        Self { hamiltonian, solver }
    }

    /// The same with another solver, of which the fixed-point iteration is used.
    #[must_use]
    pub fn with_solver(self, solver: StageSolver) -> Self {
        Self { solver, ..self }
    }

    /// h
    pub fn hamiltonian(&self) -> &H {
        &self.hamiltonian
    }

    /// One step, and a = (h/4) Ω̄.
    #[inline]
    fn advance<T: Real>(
        &self,
        mu: &Se3Dual<T>,
        step: f64,
    ) -> Result<(Step<Se3Dual<T>>, Vector3<T>), StepError>
    where
        H: Hamiltonian<HeavyTopSpace, T>,
    {
        let mut velocity = [Vector::zero()];
        let first = self.hamiltonian.differential(mu);
        let iterations = self.solver.solve(first, step, &mut velocity, |_, velocity| {
            self.hamiltonian.differential(&middle(mu, &velocity[0], step))
        })?;
        let next = Step { point: end(mu, &velocity[0], step), iterations }.finite()?;
        Ok((next, velocity[0].0 * T::from_f64(0.25 * step)))
    }
}

/// R_a v
#[inline]
fn half_turn<T: Real>(a: &Vector3<T>, v: &Vector3<T>) -> Vector3<T> {
    let turned = v.cross(a);
    v + (turned + turned.cross(a)) * (T::from_f64(2.0) / (a.dot(a) + 1.0))
}

/// (Π̄, Γ̄)
#[inline]
fn middle<T: Real>(start: &Se3Dual<T>, velocity: &Velocity<T>, step: f64) -> Se3Dual<T> {
    let (Covector(Pair(pi, gamma)), Pair(omega, force)) = (start, velocity);
    let a = omega * T::from_f64(0.25 * step);
    let scale = T::one() / (a.dot(&a) + 1.0);
    let vertical = half_turn(&a, gamma) * scale;
    let torque = vertical.cross(force) - vertical * a.dot(force) - vertical.cross(&a.cross(force));
    let pi = half_turn(&a, pi) + torque * T::from_f64(0.5 * step);
    Se3Dual::new(pi * scale, vertical)
}

/// (Π₁, Γ₁)
#[inline]
fn end<T: Real>(start: &Se3Dual<T>, velocity: &Velocity<T>, step: f64) -> Se3Dual<T> {
    let (Covector(Pair(pi, gamma)), Pair(omega, force)) = (start, velocity);
    let a = omega * T::from_f64(0.25 * step);
    let half = half_turn(&a, gamma);
    let torque = half.cross(force) * (T::from_f64(step) / (a.dot(&a) + 1.0));
    Se3Dual::new(half_turn(&a, &(half_turn(&a, pi) + torque)), half_turn(&a, &half))
}

impl<H, T> Integrator<T> for ReducedMidpoint<H>
where
    H: Hamiltonian<HeavyTopSpace, T>,
    T: Real,
{
    type State = Se3Dual<T>;
    type Momentum = Se3Dual<T>;
    type Workspace = ();

    fn workspace(&self) {}

    #[inline]
    fn step(&self, mu: &Se3Dual<T>, step: f64, (): &mut ()) -> Result<Step<Se3Dual<T>>, StepError> {
        self.advance(mu, step).map(|(next, _)| next)
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
    fn turn(&self, mu: &Se3Dual<T>, step: f64, (): &mut ()) -> Turned<Se3Dual<T>, T> {
        let (next, a) = self.advance(mu, step)?;
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
