//! Motions that a torque takes off their coadjoint orbits: [`Torqued`].

use crate::error::StepError;
use crate::integrators::state_is_momentum::StateIsMomentum;
use crate::integrators::trajectories::integrator::Integrator;
use crate::integrators::trajectories::start::Start;
use crate::open_systems::smooth_pieces::smooth_pieces;
use crate::schemes::scheme::Step;
use crate::step_fractions::substeps::Substeps;
use lie_poisson::{Real, State};
use momentum_map::LiftError;

/// The flow of a torque alone, dμ/dt = F(μ, t).
///
/// Ready-made are a [constant](crate::ConstantTorque), a [viscous](crate::ViscousTorque), also [by a
/// matrix](crate::ViscousMatrix), and a [tabulated](crate::TabulatedTorque) torque.
///
/// A torque that depends on time and jumps, or has a derivative that jumps, tells its breakpoints by
/// [`next_break`](Self::next_break), the time of a momentum by [`time`](Self::time), and acts as one of its smooth pieces in
/// [`flow_near`](Self::flow_near).
///
/// # Example
/// Friction that is proportional to the cube of a spin's length, F = −c|μ|²μ, of which d|μ|⁻²/dt = 2c follows:
/// ```
/// use collective_integrators::{StepError, TorqueFlow};
/// use lie_poisson::Covector;
/// use nalgebra::Vector3;
/// struct Cubic(f64);
/// impl TorqueFlow<Covector<Vector3<f64>>> for Cubic {
///     fn flow(&self, mu: &mut Covector<Vector3<f64>>, step: f64) -> Result<(), StepError> {
///         mu.0 /= (1.0 + 2.0 * self.0 * step * mu.0.norm_squared()).sqrt();
///         Ok(())
///     }
/// }
/// let mut mu = Covector(Vector3::x());
/// Cubic(1.5).flow(&mut mu, 1.0)?;
/// assert_eq!(mu.0.x, 0.5);
/// # Ok::<(), StepError>(())
/// ```
pub trait TorqueFlow<V: State> {
    /// Replaces μ by its value after a time, which may be negative. For a torque that depends on time, μ contains the time, and
    /// the flow leaves it as it is: it is frozen while the torque acts.
    ///
    /// # Errors
    /// Returns the reason why there is no value.
    fn flow(&self, mu: &mut V, step: f64) -> Result<(), StepError>;

    /// Returns the time that μ contains, for a torque with breakpoints. There is none by default.
    fn time(&self, mu: &V) -> Option<V::Scalar> {
        let _ = mu;
        None
    }

    /// Returns the next time strictly after `time`, or strictly before it if `forward` is false, at which F or a derivative
    /// of it jumps, such as a time of an [`InputTable`](lie_poisson::InputTable). [`Torqued`] ends a part of a step there,
    /// since a step across a jump loses the order. There is none by default, and none is seen without the
    /// [`time`](Self::time).
    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        let (_, _) = (time, forward);
        None
    }

    /// Replaces μ by its value after a time, as [`flow`](Self::flow) does, by the smooth piece of the torque to which the
    /// time `inside` belongs. The time of μ may be an end of that piece, and in compositions lie beyond it: there the piece
    /// is continued. The default is [`flow`](Self::flow), which is right for a torque that is smooth.
    ///
    /// # Errors
    /// Returns the reason why there is no value.
    fn flow_near(&self, mu: &mut V, step: f64, inside: V::Scalar) -> Result<(), StepError> {
        let _ = inside;
        self.flow(mu, step)
    }
}

/// The integrator of dμ/dt = Λ(μ) ξ + F(μ, t) by the flows of both parts: half a step of the torque F, a step on the coadjoint
/// orbit by an integrator, and half a step of the torque.
///
/// It has order 2, and is symmetric, if the integrator has and is. [With symmetric substeps](Self::with_substeps) it has order 4
/// or 6, as a [`Composition`](crate::Composition) of it has. The Casimirs change through the torque alone, so that where F = 0 they are
/// conserved to round-off; and a friction, however small, is not hidden by errors of the integrator.
///
/// Each step lifts μ anew, so the integrator must descend to 𝔤∗, as [`Collective`](crate::Collective) and
/// [`LiftFree`](crate::LiftFree) do. So does `Torqued` itself: several torques are added one after the other.
///
/// # Torques that depend on time
/// A momentum then contains the time, as those of [`Driven`](crate::Driven) do. A step that contains a
/// [breakpoint](TorqueFlow::next_break) of the torque is divided there, and each part is made of all substeps, so that the
/// order is kept. A [`Composition`](crate::Composition) divides each of its substeps alone, and a step of it across a
/// breakpoint has an error of the order of the third power of the step, whatever its order is. Breakpoints of the field or of
/// another torque within the integrator divide the integrator's own steps alone: a torque that jumps comes last, around those
/// that do not, and torques that jump are one [table](crate::TabulatedTorque).
///
/// Source: Strang, *On the construction and comparison of difference schemes*, SIAM J. Numer. Anal. 5 (1968).
///
/// # Example
/// A free rigid body in a viscous fluid with torque −cΠ: |Π| = exp(−ct)|Π(0)| to round-off.
/// ```
/// use collective_integrators::{Collective, RungeKutta, Start, Torqued, ViscousTorque};
/// use lie_poisson::{Covector, LiePoisson, So3, from_closure};
/// use momentum_map::HOPF;
/// use nalgebra::Vector3;
/// let viscous = ViscousTorque::new(Vector3::repeat(0.1_f64))?;
/// let h = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| pi.x * pi.x * 0.5 + pi.y * pi.y);
/// let body = Torqued::new(Collective::new(RungeKutta::implicit_midpoint(), HOPF, h), viscous);
/// let end = body.after(&Covector(Vector3::new(0.6, 0.0, 0.8)), 0.1, 100)?.momentum.0;
/// assert!((end.norm() - (-1.0_f64).exp()).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Torqued<I, F> {
    integrator: I,
    torque: F,
    substeps: Option<Substeps>,
}

impl<I, F> Torqued<I, F> {
    /// Adds a torque to the motion of an integrator.
    pub const fn new(integrator: I, torque: F) -> Self {
        Self { integrator, torque, substeps: None }
    }

    /// Returns the integrator that makes each step, or each part of a step between breakpoints of the torque, by substeps
    /// with these fractions: of order 4 by [`Substeps::suzuki4`], and of order 6 by [`Substeps::yoshida6`].
    ///
    /// Source: Hairer, Lubich & Wanner, *Geometric Numerical Integration*, 2nd ed. (2006), §V.3.
    ///
    /// # Example
    /// A spin that a motor turns faster about e₃ until t = 1: its angle goes on as t²/2, and then as t − ½.
    /// ```
    /// use collective_integrators::{Driven, RungeKutta, Start, Substeps, TabulatedTorque, Torqued};
    /// use lie_poisson::{
    ///     Autonomous, Covector, InputTable, Inputs, Interpolation, LiePoisson, Pair, So3, Time, from_closure,
    /// };
    /// use momentum_map::HOPF;
    /// use nalgebra::Vector3;
    /// let h = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| pi.z * pi.z * 0.5);
    /// let input = InputTable::new(vec![0.0, 1.0, 2.0], vec![1.0, 0.0, 0.0], Interpolation::Constant)?;
    /// let motor = TabulatedTorque(Inputs::new(vec![(Covector(Vector3::<f64>::z()), input)])?);
    /// let orbits = Driven::new(RungeKutta::implicit_midpoint(), HOPF, Autonomous(h));
    /// let body = Torqued::new(orbits, motor).with_substeps(Substeps::yoshida6());
    /// let start = Pair(Covector(Vector3::x()), Time(0.0));
    /// let Pair(Covector(end), _) = body.after(&start, 2.0 / 15.0, 15)?.momentum;
    /// assert!((end - Vector3::new(1.5_f64.cos(), -1.5_f64.sin(), 1.0)).norm() < 1e-7);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn with_substeps(self, substeps: Substeps) -> Self {
        Self { substeps: Some(substeps), ..self }
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

impl<I, F> Torqued<I, F> {
    /// Makes all substeps of a step in which the torque is smooth, by its piece at a time within the step, or by the torque
    /// as it is. Returns the number of iterations.
    fn smooth_step<T: Real>(
        &self,
        mu: &mut I::Momentum,
        (step, inside): (f64, Option<T>),
        workspace: &mut I::Workspace,
    ) -> Result<usize, StepError>
    where
        I: Start<T>,
        F: TorqueFlow<I::Momentum>,
    {
        let whole = [1.0];
        let fractions = self.substeps.as_ref().map_or(whole.as_slice(), Substeps::fractions);
        fractions.iter().try_fold(0, |iterations, fraction| {
            Ok(iterations + self.strang_step(mu, (fraction * step, inside), workspace)?)
        })
    }

    /// Makes half a step of the torque, a step on the orbit, and half a step of the torque.
    fn strang_step<T: Real>(
        &self,
        mu: &mut I::Momentum,
        (step, inside): (f64, Option<T>),
        workspace: &mut I::Workspace,
    ) -> Result<usize, StepError>
    where
        I: Start<T>,
        F: TorqueFlow<I::Momentum>,
    {
        let half = |mu: &mut I::Momentum| match inside {
            Some(inside) => self.torque.flow_near(mu, 0.5 * step, inside),
            None => self.torque.flow(mu, 0.5 * step),
        };
        half(mu)?;
        if !mu.is_finite() {
            return Err(StepError::NotFinite);
        }
        let lifted = self.integrator.start(mu);
        let lifted = lifted.map_err(|LiftError { reason, .. }| StepError::NoLift { reason })?;
        // The lift before was another point of its fibre.
        self.integrator.forget(workspace);
        let Step { point, iterations } = self.integrator.step(&lifted, step, workspace)?;
        *mu = self.integrator.momentum(&point);
        half(mu)?;
        match mu.is_finite() {
            true => Ok(iterations),
            false => Err(StepError::NotFinite),
        }
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
        let iterations = match self.torque.time(state) {
            None => self.smooth_step(&mut mu, (step, None), workspace)?,
            Some(time) => smooth_pieces(
                time,
                step,
                |time, forward| self.torque.next_break(time, forward),
                |_, elapsed, size| {
                    let inside = time + (elapsed + 0.5 * size);
                    self.smooth_step(&mut mu, (size, Some(inside)), workspace)
                },
            )?,
        };
        Ok(Step { point: mu, iterations })
    }

    fn forget(&self, workspace: &mut Self::Workspace) {
        self.integrator.forget(workspace);
    }

    fn momentum(&self, state: &I::Momentum) -> I::Momentum {
        state.clone()
    }
}
