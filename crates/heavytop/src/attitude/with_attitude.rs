//! Trajectories with the attitude of the body: [`WithAttitude`].

use crate::attitude::step_rotation::{Turning, unit};
use collective_integrators::{Integrator, Start, Step, StepError};
use lie_poisson::{Pair, Quaternion, Real, Se3Dual, State, Vector, squaring_scale};
use momentum_map::LiftError;
use nalgebra::{Vector2, Vector3};

/// An integrator on se(3)∗ that also computes the attitude R ∈ SO(3) of the body, as a unit quaternion A.
///
/// With R v = A v conj(A), the attitude obeys
///
/// ```text
/// Aₙ₊₁ = Aₙ conj(Qₙ),    Γₙ/|Γₙ| = Rₙᵀ e₃
/// ```
///
/// where Qₙ is the rotation of the step by [`Turning`]. The state is the pair of the integrator's state and
/// A. R maps the body frame to the spatial frame. It is determined up to a rotation about the vertical, which
/// the start chooses. It solves dR/dt = R hat(Ω) with the order of the integrator.
///
/// Every formulation has an attitude except [`Direct`](collective_integrators::Direct): the six equations for
/// (Π, Γ) do not determine it.
///
/// Source: Ohsawa 2019, §1.1 for R and Γ.
///
/// # Example
/// ```
/// use collective_integrators::{Collective, RungeKutta, Start};
/// use heavytop::{HeavyTop, SpinorRealisation, WithAttitude};
/// use lie_poisson::Se3Dual;
/// use nalgebra::Vector3;
/// let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
/// let gauss = WithAttitude(Collective::new(RungeKutta::gauss(2)?, SpinorRealisation, top));
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

/// Returns the unit quaternion A of the shortest rotation of Γ/|Γ| to e₃.
///
/// For Γ along −e₃ it is the rotation about e₁ by π. The result is exact to round-off for Γ of any size.
///
/// ```
/// use heavytop::attitude_of_vertical;
/// use nalgebra::Vector3;
/// let gamma = Vector3::new(0.48, 0.6, -0.64);
/// for size in [1e-300, 1e-160, 1.0, 1e200, 1e308] {
///     let attitude = attitude_of_vertical(&(gamma * size));
///     assert!((attitude.rotate(&gamma) - Vector3::z()).norm() < 1e-15);
/// }
/// ```
#[inline]
pub fn attitude_of_vertical<T: Real>(gamma: &Vector3<T>) -> Quaternion<T> {
    let gamma = gamma * squaring_scale(gamma);
    let size = gamma.dot(&gamma).sqrt();
    // Half-angle formulas, from the larger of cosine and sine.
    let cosine = ((size + gamma.z) / (size + size)).sqrt();
    let sine = ((size - gamma.z) / (size + size)).sqrt();
    let up = Quaternion {
        scalar: cosine,
        vector: Vector3::new(gamma.y, -gamma.x, T::zero()) / ((size + size) * cosine),
    };
    let across = Vector2::new(gamma.y, -gamma.x);
    let scale = squaring_scale(&across);
    let across = across * scale;
    let length = across.dot(&across).sqrt();
    let axis = Vector3::new(across.x, across.y, T::zero()) / length;
    let pole = (-length).select_nonnegative(T::one(), T::zero());
    let safe = axis.map(|x| (-length).select_nonnegative(T::zero(), x)) + Vector3::x() * pole;
    let down = Quaternion { scalar: length / scale / ((size + size) * sine), vector: safe * sine };
    Vector::from_coordinates(|i| gamma.z.select_nonnegative(up.coordinate(i), down.coordinate(i)))
}

impl<I: Turning<T>, T: Real> Integrator<T> for WithAttitude<I> {
    type State = Pair<I::State, Quaternion<T>>;
    type Momentum = Se3Dual<T>;
    type Workspace = I::Workspace;

    fn workspace(&self) -> Self::Workspace {
        self.0.workspace()
    }

    #[inline]
    fn forget(&self, workspace: &mut Self::Workspace) {
        self.0.forget(workspace);
    }

    fn pin(&self, workspace: &mut Self::Workspace) {
        self.0.pin(workspace);
    }

    #[inline]
    fn step(
        &self,
        Pair(state, attitude): &Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<Self::State>, StepError> {
        let (next, turn) = self.0.turn(state, step, workspace)?;
        let turned = unit(*attitude * turn.conjugate());
        Step { point: Pair(next.point, turned), iterations: next.iterations }.finite()
    }

    #[inline]
    fn momentum(&self, state: &Self::State) -> Se3Dual<T> {
        self.0.momentum(&state.0)
    }
}

impl<I: Turning<T> + Start<T>, T: Real> Start<T> for WithAttitude<I> {
    /// Creates the start state of the integrator, with the [shortest attitude](attitude_of_vertical).
    ///
    /// # Errors
    /// Returns [`LiftError`] if Γ = 0, if μ is not finite, or if the integrator has no state for μ.
    fn start(&self, mu: &Se3Dual<T>) -> Result<Self::State, LiftError> {
        let state = Pair(self.0.start(mu)?, attitude_of_vertical(&mu.0.1));
        let reason = "Γ must be different from 0, and Π and Γ finite";
        LiftError::unless_finite(state, "Γ", mu.0.1.max_abs(), reason)
    }
}
