//! The methods of the page: [`PageMethod`].

use crate::error::PageError;
use crate::motions::damped::Damped;
use crate::motions::direct_with_attitude::DirectWithAttitude;
use crate::motions::friction::Friction;
use crate::motions::motion::Motion;
use crate::motions::snapshot::Snapshot;
use collective_integrators::{
    AnyIntegrator, Composition, RungeKutta, Splitting, Start, StepError, Substeps,
};
use heavytop::{
    HeavyTop, RotorSplitting, SymmetricTopSplitting, TopMidpoint, Turning, WithAttitude,
};
use lie_poisson::{InstructionSet, Pair, Se3Dual, Vector};

/// A method that the page offers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PageMethod {
    /// The collective Gauss method with this number of stages, of twice that order.
    Gauss {
        /// The number of stages, from 1 to 8.
        stages: u8,
    },
    /// The collective midpoint rule.
    Midpoint,
    /// Strang's splitting, of order 2.
    Splitting,
    /// Suzuki's composition of five Strang splittings, of order 4.
    Suzuki,
    /// The method of Runge and Kutta of order 4, applied to the equations directly.
    RungeKutta4,
    /// The explicit midpoint rule, applied to the equations directly.
    ExplicitMidpoint,
}

impl PageMethod {
    /// The methods of the page. Their places in this list are their numbers in [`exports`](crate::exports).
    pub const ALL: [Self; 10] = [
        Self::Gauss { stages: 2 },
        Self::Gauss { stages: 3 },
        Self::Gauss { stages: 4 },
        Self::Gauss { stages: 6 },
        Self::Gauss { stages: 8 },
        Self::Midpoint,
        Self::Splitting,
        Self::Suzuki,
        Self::RungeKutta4,
        Self::ExplicitMidpoint,
    ];

    /// Returns the name in the addresses of the page.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Gauss { stages: 2 } => "gauss-4",
            Self::Gauss { stages: 3 } => "gauss-6",
            Self::Gauss { stages: 4 } => "gauss-8",
            Self::Gauss { stages: 6 } => "gauss-12",
            Self::Gauss { stages: 8 } => "gauss-16",
            Self::Gauss { .. } => "gauss",
            Self::Midpoint => "midpoint",
            Self::Splitting => "strang",
            Self::Suzuki => "suzuki-4",
            Self::RungeKutta4 => "rk4",
            Self::ExplicitMidpoint => "explicit-midpoint",
        }
    }

    /// Starts a motion of the top, with portable instructions, and with a friction of the coefficient c, N m s.
    ///
    /// # Errors
    /// Returns [`PageError`] if a number is not finite, if Γ = 0, if the friction is negative, or if there is no Gauss
    /// method with these stages.
    pub(crate) fn motion(
        self,
        top: &HeavyTop,
        friction: f64,
        from: &Snapshot,
    ) -> Result<Motion, PageError> {
        let start = Pair(from.momentum, from.attitude);
        StepError::check_start(&start, 1.0).map_err(|error| PageError::of_step(0, 0.0, error))?;
        let friction = Friction::new(top, friction)?;
        let damped = Damped { method: self.integrator(top)?, friction };
        let state = damped.state(&from.momentum, &from.attitude)?;
        Ok(Motion::new(damped, state))
    }

    /// Returns the integrator with the attitude. It is made of its own type and not by a
    /// [`Method`](heavytop::methods::Method), so that the module of the page has the code of these methods alone.
    fn integrator(self, top: &HeavyTop) -> Result<AnyIntegrator, PageError> {
        let portable = InstructionSet::Portable;
        Ok(match self {
            Self::Gauss { stages } => {
                turning(top.gauss(stages.into())?.with_instructions(portable)?)
            }
            Self::Midpoint => turning(TopMidpoint::new(*top).with_instructions(portable)?),
            Self::Splitting => split(top, Substeps::new(&[1.0])?),
            Self::Suzuki => split(top, Substeps::suzuki4()),
            Self::RungeKutta4 => direct(RungeKutta::rk4(), top),
            Self::ExplicitMidpoint => direct(RungeKutta::explicit_midpoint(), top),
        })
    }
}

/// The number of coordinates of (Π, Γ).
const DIMENSION: usize = 6;

/// Returns an integrator that computes the attitude.
fn turning<I>(integrator: I) -> AnyIntegrator
where
    I: Turning<State: Vector> + Start<Momentum = Se3Dual> + Send + Sync + 'static,
{
    AnyIntegrator::new(WithAttitude(integrator), DIMENSION)
}

/// Returns the composition of Strang splittings that suits the top.
fn split(top: &HeavyTop, substeps: Substeps) -> AnyIntegrator {
    match SymmetricTopSplitting::new(*top) {
        Ok(flows) => turning(Composition::new(Splitting::strang(flows), substeps)),
        Err(_) => turning(Composition::new(Splitting::strang(RotorSplitting(*top)), substeps)),
    }
}

/// Returns an explicit method, applied to the equations directly.
fn direct(scheme: RungeKutta, top: &HeavyTop) -> AnyIntegrator {
    AnyIntegrator::new(DirectWithAttitude::new(scheme, *top), DIMENSION)
}
