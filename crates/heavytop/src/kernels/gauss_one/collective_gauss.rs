//! Collective Gauss methods of one heavy top, with the stages in the SIMD lanes of a register.

use super::compensated_point::CompensatedPoint;
use super::gauss_coefficients::GaussCoefficients;
use super::row::WIDTH;
use super::stage_equations::{Attempt, MOST};
use super::stage_history::StageHistory;
use crate::attitude::step_rotation::{TurnedStep, Turning, turned_by_spinors};
use crate::paper::spinor_realisation::{SpinorPoint, SpinorRealisation};
use crate::tops::top::HeavyTop;
use collective_integrators::{
    Collective, CollectiveWorkspace, Compensated, Integrator, RungeKutta, SchemeError, StageSolver,
    StageWorkspace, Start, Step, StepError,
};
use lie_poisson::{InstructionSet, MissingInstructions, Pair, Se3Dual, State, Width, dispatch};
use momentum_map::LiftError;

/// The general integrator of the same method.
type General = Compensated<Collective<RungeKutta, SpinorRealisation, HeavyTop>>;

/// The state (z, e): a point and its rounding error.
type CompensatedSpinor = Pair<SpinorPoint, SpinorPoint>;

/// The collective Gauss method of a [`HeavyTop`] with 1 to 8 stages, of order 2 to 16.
///
/// Its steps are those of [`Collective`]`::new(`[`RungeKutta::gauss`]`(s)?, `[`SpinorRealisation`]`,
/// top).compensated()` to round-off, at a fraction of the cost. That integrator accepts every other
/// Hamiltonian and any number of stages.
///
/// The state is (z, e). Here z = (χ, ψ) ∈ T∗C² is the lift, and e is the part that rounding removed from the last sum
/// z + δz. The momentum is μ = **M**(z).
///
/// # Method
/// The stage equations
///
/// ```text
/// Z_i = z + Σ_j μ_ij ℓ_j,    ℓ_j = h b_j X(Z_j),    μ_ij = a_ij / b_j,    z₁ = z + Σ_j ℓ_j
/// ```
///
/// are solved with one stage in each SIMD lane of a register, by AVX-512, AVX2 or plain arithmetic, depending on what
/// the processor has when the integrator is created. They are iterated until Ω changes by round-off alone. If a step
/// has the size of the last step and continues from its end, the iteration begins with the polynomial through the ℓ of
/// that step. A step therefore depends on the previous one, by round-off; [`forget`](Integrator::forget) removes this
/// dependence. μ_ij + μ_ji = 1 holds exactly, so that rounding of coefficients causes no drift of Casimirs. When ‖χ‖
/// has grown to √2 times its minimum along the fibre, χ slides back by a power of two times ψ.
///
/// If the iteration does not converge, as for large steps, the [general](Self::general) integrator makes the step, with
/// Newton's iteration if necessary.
///
/// With eight stages and step 1/4 the error of the paper's experiment is 1e-14 at t = 10. In the source repository
/// `docs/performance.md` has computing times, `cargo bench -p heavytop` measures them on your machine, and
/// `cargo run --release -p measurements --bin collective_gauss` measures errors.
///
/// Source: Ohsawa 2019, §5.1; Antoñana, Makazaga & Murua, *Reducing and monitoring round-off
/// error propagation for symplectic implicit Runge–Kutta schemes*, Numer. Algorithms 76 (2017),
/// for μ; Hairer, McLachlan & Razakarivony, *Achieving Brouwer's law with implicit Runge–Kutta
/// methods*, BIT 48 (2008), for compensation and for iterating to the floor.
///
/// # Example
/// ```
/// use collective_integrators::Start;
/// use heavytop::{CollectiveGauss, HeavyTop, Invariant};
/// use lie_poisson::Se3Dual;
/// use nalgebra::Vector3;
/// let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
/// let start = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.6, 0.0, 0.8));
/// let gauss = CollectiveGauss::new(8, top)?;
/// for sample in gauss.trajectory(&start, 0.25)?.take(4001) {
///     let mu = sample?.momentum;
///     let deviation = |i: Invariant| (i.value(&top, &mu) - i.value(&top, &start)).abs();
///     assert!(deviation(Invariant::Energy) < 1e-12);
///     assert!(deviation(Invariant::VerticalSquared) < 1e-14);
///     assert!(deviation(Invariant::VerticalMomentum) < 5e-14);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CollectiveGauss {
    general: General,
    coefficients: GaussCoefficients,
    instructions: InstructionSet,
    tolerance: f64,
}

/// The workspace of [`CollectiveGauss`].
#[derive(Clone, Debug)]
pub struct CollectiveGaussWorkspace {
    history: StageHistory,
    general: CollectiveWorkspace<StageWorkspace<SpinorPoint>, SpinorPoint>,
}

impl HeavyTop {
    /// Creates the collective Gauss method with the given number of stages for this top:
    /// [`CollectiveGauss::new`].
    ///
    /// # Errors
    /// Returns [`SchemeError`] unless there are 1 to 8 stages.
    pub fn gauss(&self, stages: usize) -> Result<CollectiveGauss, SchemeError> {
        CollectiveGauss::new(stages, *self)
    }
}

impl CollectiveGauss {
    /// Creates the method with the given number of stages. The order is twice this number.
    ///
    /// # Errors
    /// Returns [`SchemeError`] unless there are 1 to 8 stages.
    pub fn new(stages: usize, top: HeavyTop) -> Result<Self, SchemeError> {
        let gauss = RungeKutta::gauss(stages)?;
        if stages > WIDTH {
            let family = "CollectiveGauss";
            return Err(SchemeError::Family { family, least: 1, most: WIDTH, stages });
        }
        let coefficients = GaussCoefficients::new(gauss.tableau(), &top);
        let general = Collective::new(gauss, SpinorRealisation, top).compensated();
        Ok(Self { general, coefficients, instructions: fastest(stages), tolerance: 0.0 })
    }

    /// Lets the iteration end where a sweep changes the stages by at most this part of the point, h |δk| ≤ τ |z|. At 0, the
    /// default, and at numbers that are not positive, it goes on to the round-off floor.
    ///
    /// τ has no unit, and the steps are the same in all units. What is left of a step has the same sign in the next one, so that
    /// the Casimirs drift in proportion to the time.
    #[must_use]
    pub fn with_tolerance(self, tolerance: f64) -> Self {
        let tolerance = if tolerance > 0.0 { tolerance } else { 0.0 };
        let collective = self.general.base();
        let solver = StageSolver { tolerance, ..StageSolver::default() };
        let scheme = collective.scheme().clone().with_solver(solver);
        let top = collective.system().hamiltonian;
        let general = Collective::new(scheme, SpinorRealisation, top).compensated();
        Self { general, tolerance, ..self }
    }

    /// Replaces the instruction set. Steps on different sets differ by round-off.
    ///
    /// # Errors
    /// Returns [`MissingInstructions`] if the processor lacks them.
    pub fn with_instructions(self, set: InstructionSet) -> Result<Self, MissingInstructions> {
        Ok(Self { instructions: set.if_available()?, ..self })
    }

    /// Returns the instruction set in use.
    #[must_use]
    pub fn instructions(&self) -> InstructionSet {
        self.instructions
    }

    /// Returns the general integrator, which makes the steps for which the iteration does not converge.
    #[must_use]
    pub fn general(&self) -> &General {
        &self.general
    }

    /// Attempts a step in registers with room for S stages.
    ///
    /// Returns the end with the number of sweeps, or `None` if the iteration does not converge.
    #[inline]
    fn attempt<const S: usize>(
        &self,
        step: f64,
        start: &CompensatedPoint,
        history: &mut StageHistory,
    ) -> Option<(CompensatedPoint, usize)> {
        let (coefficients, tolerance) = (&self.coefficients, self.tolerance);
        let task = Attempt::<S> { coefficients, step, tolerance, start, history };
        dispatch(task, self.instructions, Width::Register).ok().flatten()
    }

    /// Makes a step with the general integrator.
    #[cold]
    fn rescue(
        &self,
        state: &CompensatedSpinor,
        step: f64,
        workspace: &mut CollectiveGaussWorkspace,
    ) -> Result<Step<CompensatedSpinor>, StepError> {
        workspace.history.forget();
        let next = self.general.step(state, step, &mut workspace.general)?;
        Ok(Step { iterations: MOST + next.iterations, ..next })
    }
}

/// Returns the fastest instruction set of the processor for this number of stages.
///
/// Up to four stages fit a register of AVX2, which is faster than a wider register that is half empty.
fn fastest(stages: usize) -> InstructionSet {
    match InstructionSet::detected() {
        InstructionSet::Avx512 if stages <= 4 => InstructionSet::Avx2,
        set => set,
    }
}

impl Integrator for CollectiveGauss {
    type State = CompensatedSpinor;
    type Momentum = Se3Dual;
    type Workspace = CollectiveGaussWorkspace;

    fn workspace(&self) -> CollectiveGaussWorkspace {
        CollectiveGaussWorkspace { history: StageHistory::new(), general: self.general.workspace() }
    }

    #[inline]
    fn step(
        &self,
        state: &Self::State,
        step: f64,
        workspace: &mut CollectiveGaussWorkspace,
    ) -> Result<Step<Self::State>, StepError> {
        let (start, history) = (CompensatedPoint::from_state(state), &mut workspace.history);
        let attempt = match self.coefficients.stages {
            ..=4 => self.attempt::<4>(step, &start, history),
            5 | 6 => self.attempt::<6>(step, &start, history),
            _ => self.attempt::<8>(step, &start, history),
        };
        match attempt.map(|(end, iterations)| Step { point: end.state(), iterations }) {
            Some(next) if self.momentum(&next.point).is_finite() => Ok(next),
            _ => self.rescue(state, step, workspace),
        }
    }

    fn forget(&self, workspace: &mut CollectiveGaussWorkspace) {
        workspace.history.forget();
        self.general.forget(&mut workspace.general);
    }

    #[inline]
    fn momentum(&self, state: &Self::State) -> Se3Dual {
        self.general.momentum(state)
    }
}

impl Start for CollectiveGauss {
    /// Creates the state (z, 0) with the lift z of least norm.
    fn start(&self, mu: &Se3Dual) -> Result<Self::State, LiftError> {
        self.general.start(mu)
    }
}

/// The rotation is Q, with ψₙ₊₁ = Q ψₙ.
impl Turning for CollectiveGauss {
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
