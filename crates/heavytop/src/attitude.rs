//! The attitude of the body, with its motion.

use crate::HeavyTopSpace;
use collective_integrators::{
    Equivariant, Integrator, LiftFree, MultiplierSpace, Start, Step, StepError,
};
use lie_poisson::{Hamiltonian, Pair, Quaternion, Real, Se3Dual, Vector};
use momentum_map::{DualQuaternions, LiftError};
use nalgebra::Vector3;

/// A lift-free integrator on se(3)* that carries the attitude R ∈ SO(3) of the body along, as a unit
/// quaternion A with R v = A v Ā:
///
/// ```text
/// Aₙ₊₁ = Aₙ conj(Qₙ),    Γₙ = Rₙᵀ e₃
/// ```
///
/// where Qₙ is the [multiplier](LiftFree::multiplier) of the step, which turns Γₙ to Γₙ₊₁. The
/// state is (μ, A); R maps the body frame to the spatial one. It is determined up to a rotation
/// about the vertical, which the start chooses.
///
/// Source: Ohsawa 2019, §1.1 for R and Γ.
///
/// # Example
/// ```
/// use collective_integrators::{LiftFree, RungeKutta, Start};
/// use heavytop::{HeavyTop, WithAttitude};
/// use lie_poisson::Se3Dual;
/// use momentum_map::DualQuaternions;
/// use nalgebra::Vector3;
/// let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
/// let gauss = WithAttitude(LiftFree::new(RungeKutta::gauss(2)?, DualQuaternions, top));
/// let start = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.6, 0.0, 0.8));
/// for sample in gauss.trajectory(&start, 0.02)?.take(1000) {
///     let sample = sample?;
///     let vertical = sample.state.1.conjugate().rotate(&Vector3::z());
///     assert!((vertical - sample.momentum.0.1).norm() < 1e-13);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct WithAttitude<I>(pub I);

/// A unit quaternion A that turns Γ/|Γ| to e₃, the shortest way; about e₁ by π for Γ along −e₃.
#[inline]
pub fn attitude_of_vertical<T: Real>(gamma: &Vector3<T>) -> Quaternion<T> {
    let size = gamma.dot(gamma).sqrt();
    // Half-angle formulas, from the larger of cosine and sine.
    let cosine = ((size + gamma.z) / (size + size)).sqrt();
    let sine = ((size - gamma.z) / (size + size)).sqrt();
    let up = Quaternion {
        scalar: cosine,
        vector: Vector3::new(gamma.y, -gamma.x, T::zero()) / ((size + size) * cosine),
    };
    let length = (gamma.x * gamma.x + gamma.y * gamma.y).sqrt();
    let axis = Vector3::new(gamma.y, -gamma.x, T::zero()) / length;
    let pole = (-length).select_nonnegative(T::one(), T::zero());
    let safe = axis.map(|x| (-length).select_nonnegative(T::zero(), x)) + Vector3::x() * pole;
    let down = Quaternion { scalar: length / ((size + size) * sine), vector: safe * sine };
    Vector::from_coordinates(|i| gamma.z.select_nonnegative(up.coordinate(i), down.coordinate(i)))
}

impl<S, H, T> Integrator<T> for WithAttitude<LiftFree<S, DualQuaternions, H>>
where
    S: Equivariant,
    H: Hamiltonian<HeavyTopSpace, T>,
    T: Real,
{
    type State = Pair<Se3Dual<T>, Quaternion<T>>;
    type Momentum = Se3Dual<T>;
    type Workspace = MultiplierSpace<S, DualQuaternions, T>;

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
        Pair(mu, attitude): &Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<Self::State>, StepError> {
        let Step { point: multiplier, iterations } = self.0.multiplier::<T>(mu, step, workspace)?;
        let turned = *attitude * multiplier.0.conjugate();
        let unit = turned.scaled(T::one() / turned.norm_squared().sqrt());
        let next = *mu + self.0.change::<T>(&multiplier, mu);
        let point = Pair(next, unit);
        if point.is_finite() { Ok(Step { point, iterations }) } else { Err(StepError::NotFinite) }
    }

    #[inline]
    fn momentum(&self, state: &Self::State) -> Se3Dual<T> {
        state.0
    }
}

impl<S, H, T> Start<T> for WithAttitude<LiftFree<S, DualQuaternions, H>>
where
    S: Equivariant,
    H: Hamiltonian<HeavyTopSpace, T>,
    T: Real,
{
    /// μ with the shortest attitude.
    ///
    /// # Errors
    /// If Γ = 0, or μ is not finite.
    fn start(&self, mu: &Se3Dual<T>) -> Result<Self::State, LiftError> {
        let state = Pair(*mu, attitude_of_vertical(&mu.0.1));
        let reason = "Γ must be different from 0, and Π and Γ finite";
        LiftError::unless_finite(state, "Γ", mu.0.1.max_abs(), reason)
    }
}
