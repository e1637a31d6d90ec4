//! Compensated summation: steps whose rounding is not lost.

use crate::{Equivariant, Integrator, LiftFree, MultiplierSpace, Start, Step, StepError};
use lie_poisson::{Hamiltonian, Pair, Point, Real, Vector};
use momentum_map::{LiftError, Multipliers};

/// A lift-free integrator that carries along what each addition μ + δμ rounds away:
///
/// ```text
/// y = δμ + e,    μ₁ = μ + y,    e₁ = y − (μ₁ − μ)
/// ```
///
/// so that the errors of a step have the size of the roundings of δμ, a factor h|Ω| below those
/// of μ. The state is (μ, e).
///
/// Source: W. Kahan, *Further remarks on reducing truncation errors*, Comm. ACM 8 (1965); Hairer,
/// McLachlan & Razakarivony, *Achieving Brouwer's law with implicit Runge–Kutta methods*, BIT 48
/// (2008), §3.
///
/// # Example
/// ```
/// use collective_integrators::{LiftFree, RungeKutta, Start};
/// use lie_poisson::{Covector, LiePoisson, So3, from_closure};
/// use momentum_map::Quaternions;
/// use nalgebra::Vector3;
/// let h = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| pi.x * pi.x * 0.5 + pi.y * pi.y);
/// let gauss = LiftFree::new(RungeKutta::gauss(3)?, Quaternions, h).compensated();
/// let start = Covector(Vector3::new(1.0, 1.0, 1.0));
/// for sample in gauss.trajectory(&start, 0.01)?.take(1000) {
///     assert!((sample?.momentum.0.norm_squared() - 3.0).abs() < 4e-15);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Compensated<I>(pub(crate) I);

impl<S, M, H, T> Integrator<T> for Compensated<LiftFree<S, M, H>>
where
    S: Equivariant,
    M: Multipliers,
    H: Hamiltonian<M::Space, T>,
    T: Real,
{
    type State = Pair<Point<M::Space, T>, Point<M::Space, T>>;
    type Momentum = Point<M::Space, T>;
    type Workspace = MultiplierSpace<S, M, T>;

    fn workspace(&self) -> Self::Workspace {
        self.0.workspace()
    }

    #[inline]
    fn forget(&self, workspace: &mut Self::Workspace) {
        self.0.forget(workspace);
    }

    #[inline]
    fn step(
        &self,
        state: &Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<Self::State>, StepError> {
        let Pair(mu, carry) = state;
        let Step { point: q, iterations } = self.0.multiplier::<T>(mu, step, workspace)?;
        let change = self.0.change::<T>(&q, mu) + *carry;
        let next = *mu + change;
        let point = Pair(next, change - (next - *mu));
        if point.is_finite() { Ok(Step { point, iterations }) } else { Err(StepError::NotFinite) }
    }

    #[inline]
    fn momentum(&self, state: &Self::State) -> Self::Momentum {
        state.0
    }
}

impl<S, M, H, T> Start<T> for Compensated<LiftFree<S, M, H>>
where
    S: Equivariant,
    M: Multipliers,
    H: Hamiltonian<M::Space, T>,
    T: Real,
{
    /// (μ, 0)
    fn start(&self, mu: &Self::Momentum) -> Result<Self::State, LiftError> {
        Ok(Pair(*mu, Vector::zero()))
    }
}
