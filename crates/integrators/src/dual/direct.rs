//! Schemes on the equations as they stand.

use crate::{
    Compensated, Increment, Increments, Integrator, Scheme, StateIsMomentum, Step, StepError,
    VectorField,
};
use lie_poisson::Real;

/// A scheme applied to a vector field as it stands, such as the Lie–Poisson equations
/// μ̇ = X_h(μ) on 𝔤∗.
///
/// In general not a Poisson map of 𝔤∗: its bracket is not constant, and a scheme that is symplectic for constant
/// brackets does not preserve it. It is here to be compared with.
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
/// // the method is of order four, and |Π|² is conserved to its accuracy alone
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
    /// The scheme applied to the field.
    pub fn new(scheme: S, field: F) -> Self {
        Self { scheme, field }
    }

    /// The same with compensated summation.
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

    #[inline]
    fn step(
        &self,
        state: &F::Point,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<F::Point>, StepError> {
        self.scheme.step(&self.field, state, step, workspace)
    }

    #[inline]
    fn forget(&self, workspace: &mut Self::Workspace) {
        self.scheme.forget(workspace);
    }

    #[inline]
    fn momentum(&self, state: &F::Point) -> F::Point {
        *state
    }
}

impl<S, F, T> Increments<T> for Direct<S, F>
where
    S: Scheme,
    F: VectorField<T>,
    T: Real,
{
    #[inline]
    fn increment(
        &self,
        state: &F::Point,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Increment<Self::State>, StepError> {
        self.scheme.refined_increment(&self.field, state, step, workspace)
    }
}

impl<S, F> StateIsMomentum for Direct<S, F> {}
