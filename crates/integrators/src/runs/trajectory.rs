//! Trajectories as iterators.

use crate::{IntegrationError, Integrator};
use lie_poisson::Real;

/// A point of a trajectory.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample<S, M> {
    /// The number of steps made; 0 for the initial state.
    pub step: u64,
    /// t = step · h
    pub time: f64,
    /// The state that is advanced.
    pub state: S,
    /// The momentum μ read off it.
    pub momentum: M,
    /// Iterations of the stage solver in the step that led here.
    pub iterations: usize,
}

/// The sample type of an integrator's trajectories.
pub type SampleOf<I, T = f64> = Sample<<I as Integrator<T>>::State, <I as Integrator<T>>::Momentum>;

/// A step whose number is a multiple of this begins without the memory of the steps before, from
/// which implicit methods [guess](crate::StageSolver) their stages.
pub const CHECKPOINT: u64 = 1024;

/// The endless trajectory of an integrator: the initial state, then one sample per step.
///
/// It ends early with an error if a step fails. After the first item it allocates nothing.
///
/// A run can be [resumed](Integrator::trajectory_resumed) from any of its samples; from one whose
/// number is a multiple of [`CHECKPOINT`] it goes on bit for bit as if it had not been interrupted.
///
/// # Example
/// ```
/// use collective_integrators::{CHECKPOINT, Direct, Integrator, RungeKutta, from_fn};
/// use nalgebra::Vector2;
/// let pendulum = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x.sin()));
/// let gauss = Direct::new(RungeKutta::gauss(2)?, pendulum);
/// let mut run = gauss.trajectory_from(Vector2::new(1.0, 0.0), 0.1).skip(CHECKPOINT as usize);
/// let saved = run.next().unwrap()?;
/// let resumed = gauss.trajectory_resumed(saved.state, saved.step, 0.1);
/// for (a, b) in run.zip(resumed.skip(1)).take(100) {
///     let (a, b) = (a?, b?);
///     assert_eq!((a.step, a.time, a.state), (b.step, b.time, b.state));
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Trajectory<'a, I: Integrator<T>, T: Real = f64> {
    integrator: &'a I,
    workspace: I::Workspace,
    step: f64,
    upcoming: Upcoming<I::State>,
}

#[derive(Debug)]
enum Upcoming<S> {
    First(S, u64),
    After(S, u64),
    Failed,
}

impl<'a, I: Integrator<T>, T: Real> Trajectory<'a, I, T> {
    pub(crate) fn new(integrator: &'a I, state: I::State, made: u64, step: f64) -> Self {
        let workspace = integrator.workspace();
        Self { integrator, workspace, step, upcoming: Upcoming::First(state, made) }
    }

    fn sample(&mut self, state: I::State, step: u64, iterations: usize) -> SampleOf<I, T> {
        self.upcoming = Upcoming::After(state, step);
        let momentum = self.integrator.momentum(&state);
        Sample { step, time: step as f64 * self.step, state, momentum, iterations }
    }
}

impl<I: Integrator<T>, T: Real> Iterator for Trajectory<'_, I, T> {
    type Item = Result<SampleOf<I, T>, IntegrationError>;

    fn next(&mut self) -> Option<Self::Item> {
        match self.upcoming {
            Upcoming::Failed => None,
            Upcoming::First(state, made) => Some(Ok(self.sample(state, made, 0))),
            Upcoming::After(state, step) => {
                if step.is_multiple_of(CHECKPOINT) {
                    self.integrator.forget(&mut self.workspace);
                }
                match self.integrator.step(&state, self.step, &mut self.workspace) {
                    Ok(next) => Some(Ok(self.sample(next.point, step + 1, next.iterations))),
                    Err(source) => {
                        self.upcoming = Upcoming::Failed;
                        let time = step as f64 * self.step;
                        Some(Err(IntegrationError { step: step + 1, time, source }))
                    }
                }
            }
        }
    }
}
