//! Motions that a torque takes off their coadjoint orbits: [`Torqued`].

use crate::error::StepError;
use crate::integrators::state_is_momentum::StateIsMomentum;
use crate::integrators::trajectories::integrator::Integrator;
use crate::integrators::trajectories::start::Start;
use crate::schemes::scheme::Step;
use lie_poisson::{Real, State};
use momentum_map::LiftError;

/// The flow of a torque alone, dμ/dt = F(μ, t).
///
/// # Example
/// Viscous friction, F = −cμ:
/// ```
/// use collective_integrators::{StepError, TorqueFlow};
/// use lie_poisson::Covector;
/// use nalgebra::Vector3;
/// struct Viscous(f64);
/// impl TorqueFlow<Covector<Vector3<f64>>> for Viscous {
///     fn flow(&self, mu: &mut Covector<Vector3<f64>>, step: f64) -> Result<(), StepError> {
///         mu.0 *= (-self.0 * step).exp();
///         Ok(())
///     }
/// }
/// let mut mu = Covector(Vector3::x());
/// Viscous(2.0).flow(&mut mu, 0.5)?;
/// assert_eq!(mu.0.x, (-1.0_f64).exp());
/// # Ok::<(), StepError>(())
/// ```
pub trait TorqueFlow<V> {
    /// Replaces μ by its value after a time, which may be negative. For a torque that depends on time, μ contains the time, and
    /// the flow leaves it as it is: it is frozen while the torque acts.
    ///
    /// # Errors
    /// Returns the reason why there is no value.
    fn flow(&self, mu: &mut V, step: f64) -> Result<(), StepError>;
}

/// The integrator of dμ/dt = Λ(μ) ξ + F(μ, t) by the flows of both parts: half a step of the torque F, a step on the coadjoint
/// orbit by an integrator, and half a step of the torque.
///
/// It has order 2, and is symmetric, if the integrator has and is. A [`Composition`](crate::Composition) of it with symmetric
/// [`Substeps`](crate::Substeps) has order 4 or 6. The Casimirs change through the torque alone, so that where F = 0 they are
/// conserved to round-off; and a friction, however small, is not hidden by errors of the integrator.
///
/// Each step lifts μ anew, so the integrator must descend to 𝔤∗, as [`Collective`](crate::Collective) and
/// [`LiftFree`](crate::LiftFree) do.
///
/// Source: Strang, *On the construction and comparison of difference schemes*, SIAM J. Numer. Anal. 5 (1968).
///
/// # Example
/// A free rigid body in a viscous fluid with torque −cΠ: |Π| = exp(−ct)|Π(0)| to round-off.
/// ```
/// use collective_integrators::{Collective, RungeKutta, Start, StepError, Torqued, TorqueFlow};
/// use lie_poisson::{Covector, LiePoisson, So3, from_closure};
/// use momentum_map::HOPF;
/// use nalgebra::Vector3;
/// struct Viscous;
/// impl TorqueFlow<Covector<Vector3<f64>>> for Viscous {
///     fn flow(&self, mu: &mut Covector<Vector3<f64>>, step: f64) -> Result<(), StepError> {
///         mu.0 *= (-0.1 * step).exp();
///         Ok(())
///     }
/// }
/// let h = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| pi.x * pi.x * 0.5 + pi.y * pi.y);
/// let body = Torqued::new(Collective::new(RungeKutta::implicit_midpoint(), HOPF, h), Viscous);
/// let end = body.after(&Covector(Vector3::new(0.6, 0.0, 0.8)), 0.1, 100)?.momentum.0;
/// assert!((end.norm() - (-1.0_f64).exp()).abs() < 1e-14);
/// # Ok::<(), collective_integrators::RunError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Torqued<I, F> {
    integrator: I,
    torque: F,
}

impl<I, F> Torqued<I, F> {
    /// Adds a torque to the motion of an integrator.
    pub const fn new(integrator: I, torque: F) -> Self {
        Self { integrator, torque }
    }

    /// Returns the integrator on the orbits.
    pub const fn integrator(&self) -> &I {
        &self.integrator
    }

    /// Returns the torque.
    pub const fn torque(&self) -> &F {
        &self.torque
    }
}

impl<I, F> StateIsMomentum for Torqued<I, F> {}

impl<T: Real, I: Start<T>, F: TorqueFlow<I::Momentum>> Integrator<T> for Torqued<I, F> {
    type State = I::Momentum;
    type Momentum = I::Momentum;
    type Workspace = I::Workspace;

    fn workspace(&self) -> Self::Workspace {
        self.integrator.workspace()
    }

    fn step(
        &self,
        state: &I::Momentum,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<I::Momentum>, StepError> {
        let mut mu = state.clone();
        self.torque.flow(&mut mu, 0.5 * step)?;
        let lifted = self.integrator.start(&mu);
        let lifted = lifted.map_err(|LiftError { reason, .. }| StepError::NoLift { reason })?;
        // The lift before was another point of its fibre.
        self.integrator.forget(workspace);
        let Step { point, iterations } = self.integrator.step(&lifted, step, workspace)?;
        mu = self.integrator.momentum(&point);
        self.torque.flow(&mut mu, 0.5 * step)?;
        match mu.is_finite() {
            true => Ok(Step { point: mu, iterations }),
            false => Err(StepError::NotFinite),
        }
    }

    fn forget(&self, workspace: &mut Self::Workspace) {
        self.integrator.forget(workspace);
    }

    fn momentum(&self, state: &I::Momentum) -> I::Momentum {
        state.clone()
    }
}
