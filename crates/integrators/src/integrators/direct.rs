//! Schemes applied directly to the equations: [`Direct`].

use crate::error::StepError;
use crate::integrators::compensated::{Compensated, Increments};
use crate::integrators::state_is_momentum::StateIsMomentum;
use crate::integrators::trajectories::integrator::Integrator;
use crate::schemes::scheme::{Increment, Scheme, Step};
use crate::vector_field::VectorField;
use lie_poisson::{Pair, Real, State};

/// A scheme applied directly to a vector field, such as that of the Lie–Poisson equations dμ/dt = X_h(μ) on 𝔤∗.
///
/// In general a step is not a Poisson map of 𝔤∗: a scheme that is symplectic for constant brackets does not preserve
/// the bracket of 𝔤∗, which is not constant. The type serves for comparisons, and as the integrator for equations on
/// other spaces.
///
/// Source: Austin, Krishnaprasad & Wang, *Almost Poisson integration of rigid body systems*,
/// J. Comput. Phys. 107 (1993); Ohsawa 2019, §5.2.
///
/// # Example
/// ```
/// use collective_integrators::{Direct, HamiltonianField, RungeKutta, Start};
/// use lie_poisson::{Covector, LiePoisson, So3, from_closure};
/// use nalgebra::Vector3;
/// let field = HamiltonianField {
///     space: LiePoisson::minus(So3),
///     hamiltonian: from_closure::<LiePoisson<So3>, _>(|Covector(pi)| pi.x * pi.x * 0.5 + pi.y * pi.y),
/// };
/// let rk4 = Direct::new(RungeKutta::rk4(), field);
/// let start = Covector(Vector3::new(1.0, 1.0, 1.0));
/// let last = rk4.trajectory(&start, 0.01)?.take(101).last().unwrap()?;
/// // the method of order four conserves |Π|² only to its accuracy
/// let drift = last.momentum.0.norm_squared() - 3.0;
/// assert!(drift.abs() < 1e-8 && drift != 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Direct<S, F> {
    scheme: S,
    field: F,
}

impl<S: Scheme, F> Direct<S, F> {
    /// Creates an integrator that applies the scheme to the field.
    pub fn new(scheme: S, field: F) -> Self {
        Self { scheme, field }
    }

    /// Returns the one-step scheme.
    pub fn scheme(&self) -> &S {
        &self.scheme
    }

    /// Returns the vector field.
    pub fn field(&self) -> &F {
        &self.field
    }

    /// Returns the integrator with [`Compensated`] summation.
    pub fn compensated(self) -> Compensated<Self> {
        Compensated(self)
    }
}

impl<S, F, T> Integrator<T> for Direct<S, F>
where
    S: Scheme,
    F: VectorField<T>,
    T: Real,
{
    type State = F::Point;
    type Momentum = F::Point;
    type Workspace = S::Workspace<F::Point>;

    fn workspace(&self) -> Self::Workspace {
        self.scheme.workspace()
    }

    #[cfg_attr(optimised, inline(always))]
    fn step(
        &self,
        state: &F::Point,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<F::Point>, StepError> {
        self.scheme.step(&self.field, state, step, workspace)
    }

    #[cfg_attr(optimised, inline(always))]
    fn step_in_place(
        &self,
        state: &mut F::Point,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<usize, StepError> {
        self.scheme.step_in_place(&self.field, state, step, workspace)
    }

    #[cfg_attr(optimised, inline(always))]
    fn forget(&self, workspace: &mut Self::Workspace) {
        self.scheme.forget(workspace);
    }

    #[cfg_attr(optimised, inline(always))]
    fn momentum(&self, state: &F::Point) -> F::Point {
        state.clone()
    }
}

impl<S, F, T> Increments<T> for Direct<S, F>
where
    S: Scheme,
    F: VectorField<T>,
    T: Real,
{
    #[cfg_attr(optimised, inline(always))]
    fn increment(
        &self,
        Pair(z, e): &Pair<F::Point, F::Point>,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Increment<Self::State>, StepError> {
        self.scheme.refined_increment(&self.field, (z, e), step, workspace)
    }

    #[cfg_attr(optimised, inline(always))]
    fn temporaries<'a>(
        &self,
        workspace: &'a mut Self::Workspace,
    ) -> Option<&'a mut <Self::State as State>::Pool> {
        self.scheme.temporaries(workspace)
    }
}

impl<S, F> StateIsMomentum for Direct<S, F> {}
