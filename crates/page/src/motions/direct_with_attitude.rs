//! Explicit methods applied directly to the equations of (Π, Γ) and of the attitude.

use collective_integrators::{
    Direct, HamiltonianField, Integrator, RungeKutta, Start, Step, StepError, VectorField,
};
use heavytop::{HeavyTop, HeavyTopSpace, attitude_of_vertical};
use lie_poisson::{LiePoisson, Pair, Quaternion, Se3, Se3Dual};
use momentum_map::LiftError;

/// The equations of motion together with those of the attitude, dA/dt = ½ A Ω.
///
/// The six equations for (Π, Γ) do not contain A. An explicit method therefore makes the same steps of (Π, Γ) with A
/// as without it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Kinematics {
    equations: HamiltonianField<HeavyTopSpace, HeavyTop>,
}

impl VectorField for Kinematics {
    type Point = Pair<Se3Dual, Quaternion>;

    #[inline]
    fn at(&self, Pair(mu, attitude): &Self::Point) -> Self::Point {
        let omega = self.equations.hamiltonian.angular_velocity(&mu.0.0);
        Pair(self.equations.at(mu), attitude.times_imaginary(&(omega * 0.5)))
    }
}

/// An explicit Runge–Kutta method for the [`Kinematics`] of a top, as an integrator on se(3)∗.
///
/// Unlike the methods of [`WithAttitude`](heavytop::WithAttitude) it keeps neither |Γ| nor RΓ = e₃, nor the length of
/// the quaternion.
#[derive(Clone, Debug)]
pub(crate) struct DirectWithAttitude(Direct<RungeKutta, Kinematics>);

impl DirectWithAttitude {
    pub(crate) fn new(scheme: RungeKutta, top: HeavyTop) -> Self {
        let space = LiePoisson::minus(Se3::default());
        let equations = HamiltonianField { space, hamiltonian: top };
        Self(Direct::new(scheme, Kinematics { equations }))
    }
}

impl Integrator for DirectWithAttitude {
    type State = Pair<Se3Dual, Quaternion>;
    type Momentum = Se3Dual;
    type Workspace = <Direct<RungeKutta, Kinematics> as Integrator>::Workspace;

    fn workspace(&self) -> Self::Workspace {
        self.0.workspace()
    }

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
        self.0.step(state, step, workspace)
    }

    #[inline]
    fn momentum(&self, Pair(mu, _): &Self::State) -> Se3Dual {
        *mu
    }
}

/// Starts with the shortest rotation to the vertical Γ.
impl Start for DirectWithAttitude {
    fn start(&self, mu: &Se3Dual) -> Result<Self::State, LiftError> {
        Ok(Pair(*mu, attitude_of_vertical(&mu.0.1)))
    }
}
