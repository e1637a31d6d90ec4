//! Integrators on 𝔤∗, their states and momenta, and their trajectories.

use super::sample::Sample;
use crate::error::{IntegrationError, StepError};
use crate::schemes::scheme::Step;
use crate::stages::checkpoints::{CHECKPOINT, blocks};
use core::iter::StepBy;
use core::num::NonZero;
use core::ops::Range;
use lie_poisson::{Real, State};

/// A method that advances a state and reads a momentum μ from it.
///
/// A method may also advance a point of another space than 𝔤∗, as [`Direct`](crate::Direct) and
/// [`Splitting`](crate::Splitting) do for a pendulum. In that case there is no momentum: [`momentum`](Self::momentum)
/// is the identity, and the point is read from [`Sample::state`].
///
/// # Example
/// An integrator makes steps one by one, many at once, or for a trajectory. To write your own, see the example of
/// [`StateIsMomentum`](crate::StateIsMomentum).
/// ```
/// use collective_integrators::{Direct, Integrator, RungeKutta, from_fn};
/// use nalgebra::Vector2;
/// let rk4 = Direct::new(RungeKutta::rk4(), from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x)));
/// let (mut z, mut workspace) = (Vector2::new(1.0, 0.0), rk4.workspace());
/// rk4.step_in_place(&mut z, 0.1, &mut workspace)?;
/// rk4.advance(&mut z, 0.1, 1..10, &mut workspace)?;
/// assert!((z - Vector2::new(1.0_f64.cos(), -1.0_f64.sin())).norm() < 1e-6);
/// let sample = rk4.trajectory_from(Vector2::new(1.0, 0.0), 0.1).nth(10);
/// assert_eq!(sample.transpose()?.map(|sample| sample.state), Some(z));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Integrator<T: Real = f64> {
    /// The type of the state that is advanced: z ∈ P, or μ itself.
    type State: State<Scalar = T>;

    /// The type of the momentum μ ∈ 𝔤∗. For equations on a space other than 𝔤∗ it is [`State`](Self::State).
    type Momentum: State<Scalar = T>;

    /// The storage of a step.
    type Workspace;

    /// Allocates the storage of a step.
    fn workspace(&self) -> Self::Workspace;

    /// Makes one step of size `step`, which may be negative.
    ///
    /// # Errors
    /// Returns a [`StepError`] if the step has no result; see [`Scheme::step`](crate::Scheme::step).
    fn step(
        &self,
        state: &Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<Self::State>, StepError>;

    /// Replaces the state by the state after one step, in the same storage. Returns the number of iterations.
    ///
    /// The default calls [`step`](Self::step). An integrator for large states overrides it, so that no step after the
    /// first allocates, unless it needs Newton's iteration.
    ///
    /// # Errors
    /// Returns the errors of [`step`](Self::step). In that case the state is not changed.
    #[inline]
    fn step_in_place(
        &self,
        state: &mut Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<usize, StepError> {
        let Step { point, iterations } = self.step(state, step, workspace)?;
        *state = point;
        Ok(iterations)
    }

    /// Advances a state, in the same storage, from the state after `steps.start` steps to the state after `steps.end`
    /// steps. Returns the number of iterations of all these steps.
    ///
    /// The steps are bit-identical to those of a [`Trajectory`] in which the state has the number `steps.start`. As in
    /// a trajectory, the workspace [forgets](Self::forget) the earlier steps at every multiple of [`CHECKPOINT`],
    /// including 0. A run can therefore be divided anywhere: the next call with the same workspace continues it. Before
    /// another run, call [`forget`](Self::forget), or begin at 0. The state of a [`Compensated`](crate::Compensated)
    /// integrator includes the rounding errors that it carries along.
    ///
    /// An override must give bit-identical results.
    ///
    /// # Errors
    /// Returns an [`IntegrationError`] with the number, the time and the reason if a coordinate of the state or the
    /// step size is not finite, or if a step fails. The state is then the one before the failed step.
    ///
    /// # Example
    /// Gauss's method of order 4 is symmetric: with steps of the opposite size it returns to its start.
    /// ```
    /// use collective_integrators::{Direct, Integrator, RungeKutta, from_fn};
    /// use nalgebra::Vector2;
    /// let pendulum = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x.sin()));
    /// let gauss = Direct::new(RungeKutta::gauss(2)?, pendulum);
    /// let start = Vector2::new(1.0, 0.0);
    /// let (mut z, mut workspace) = (start, gauss.workspace());
    /// gauss.advance(&mut z, 0.1, 0..300, &mut workspace)?;
    /// gauss.advance(&mut z, 0.1, 300..1000, &mut workspace)?;
    /// let thousandth = gauss.trajectory_from(start, 0.1).nth(1000);
    /// assert_eq!(thousandth.transpose()?.map(|sample| sample.state), Some(z));
    /// gauss.advance(&mut z, -0.1, 0..1000, &mut workspace)?;
    /// assert!((z - start).norm() < 1e-11);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    fn advance(
        &self,
        state: &mut Self::State,
        step: f64,
        steps: Range<u64>,
        workspace: &mut Self::Workspace,
    ) -> Result<usize, IntegrationError> {
        StepError::check_start(state, step)
            .map_err(|refused| IntegrationError::after(steps.start, step, refused))?;
        let mut iterations = 0;
        for block in blocks(steps) {
            if block.start.is_multiple_of(CHECKPOINT) {
                self.forget(workspace);
            }
            for made in block {
                iterations += self
                    .step_in_place(state, step, workspace)
                    .map_err(|source| IntegrationError::after(made, step, source))?;
            }
        }
        Ok(iterations)
    }

    /// Makes the workspace forget the earlier steps, so that the next step depends on its starting point alone, to the
    /// last bit.
    ///
    /// A trajectory calls it at every multiple of [`CHECKPOINT`], where an interrupted run can then be resumed. An
    /// integrator that contains another one passes the call on. For a method that remembers nothing it does nothing.
    /// The law `forgetting` of the suite `laws::integrator` checks it.
    fn forget(&self, workspace: &mut Self::Workspace);

    /// Makes every later step with this workspace the map Φ_h alone, without a motion of the state along its fibre.
    ///
    /// A [`Collective`](crate::Collective) integrator moves z along its fibre where that saves digits of M(z). Such a
    /// motion has no tangent map of its own: it happens at some points and not at their neighbours. With a pinned
    /// workspace the step is a differentiable map, symplectic if the scheme is, and its tangent vectors are those of
    /// the motion on P. [`VariationalFlow`](crate::VariationalFlow) pins its workspaces. [`forget`](Self::forget) does
    /// not end this. In particular a step of size 0 keeps the state itself, and not only its momentum. The law `pinning` of
    /// the suite `laws::integrator` checks it.
    ///
    /// The default does nothing, for integrators that move no state along a fibre. An integrator that makes the steps
    /// of another one pins the workspace of that one.
    #[inline]
    fn pin(&self, _workspace: &mut Self::Workspace) {}

    /// Returns the momentum μ of a state. For equations on a space other than 𝔤∗ it is the state itself.
    fn momentum(&self, state: &Self::State) -> Self::Momentum;

    /// Creates the trajectory through a state at t = 0, with steps of size `step`.
    ///
    /// If a coordinate of the state or the step size is not finite, the first item is an error.
    fn trajectory_from(&self, state: Self::State, step: f64) -> Trajectory<'_, Self, T>
    where
        Self: Sized,
    {
        Trajectory::new(self, state, 0, step)
    }

    /// Returns the sample after `steps` steps of size `step` from a state at t = 0.
    ///
    /// No earlier sample is stored. After 0 steps the result is the sample of the state itself.
    ///
    /// # Errors
    /// Returns [`IntegrationError`] with the number, the time and the reason if a step fails, or if the state or the step
    /// size is not finite.
    ///
    /// # Example
    /// A rotor returns after 2π:
    /// ```
    /// use collective_integrators::{Direct, Integrator, RungeKutta, from_fn};
    /// use nalgebra::Vector2;
    /// let rotor = Direct::new(RungeKutta::gauss(4)?, from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x)));
    /// let end = rotor.after_from(Vector2::x(), core::f64::consts::TAU / 100.0, 100)?;
    /// assert!(end.step == 100 && (end.state - Vector2::x()).norm() < 1e-13);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    fn after_from(
        &self,
        state: Self::State,
        step: f64,
        steps: u64,
    ) -> Result<SampleOf<Self, T>, IntegrationError>
    where
        Self: Sized,
    {
        self.trajectory_from(state, step).after(steps)
    }

    /// Creates the trajectory that continues from a sample of another run, and continues its step numbers and times.
    ///
    /// `state` is the state after `made` steps of size `step`. The trajectory fails as
    /// [`trajectory_from`](Self::trajectory_from) does, and after the step with the number [`u64::MAX`].
    ///
    /// If `made` is a multiple of [`CHECKPOINT`](crate::CHECKPOINT), the trajectory equals that of the uninterrupted
    /// run to the last bit.
    fn trajectory_resumed(
        &self,
        state: Self::State,
        made: u64,
        step: f64,
    ) -> Trajectory<'_, Self, T>
    where
        Self: Sized,
    {
        Trajectory::new(self, state, made, step)
    }
}

/// The sample type of the trajectories of an integrator.
pub type SampleOf<I, T = f64> = Sample<<I as Integrator<T>>::State, <I as Integrator<T>>::Momentum>;

/// The endless trajectory of an integrator: the initial state, then one sample per step.
///
/// Once a step fails, every further item is its error, so that adaptors that skip items, such as `nth` or `step_by`,
/// cannot lose it. These adaptors do not compute the samples that they skip: each item of [`every`](Self::every) costs
/// what n steps cost. The iterator never returns `None`. Bound it by `take`, and leave a loop at the first error, as
/// `?` and `collect::<Result<…>>` do. Adaptors that skip errors, such as `flatten`, search for the next sample for
/// ever. [`Start::after`](crate::Start::after) returns one sample. After the first item nothing is allocated, except
/// for states on the heap: each sample has a state of its own. [`Integrator::advance`] advances such a state in place.
///
/// A run can be [resumed](Integrator::trajectory_resumed) from any of its samples. From a sample whose number is a
/// multiple of [`CHECKPOINT`] it continues bit for bit as if it had not been interrupted.
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
    /// The state after `made` steps, and the number of iterations of those after the last item.
    state: I::State,
    made: u64,
    iterations: usize,
    progress: Progress,
    /// The momentum of the first sample if it is given.
    given: Option<I::Momentum>,
}

/// What the next item of a trajectory is.
#[derive(Debug)]
enum Progress {
    /// The sample of the state.
    First,
    /// The sample one step after the state.
    After,
    Failed(IntegrationError),
}

impl<'a, I: Integrator<T>, T: Real> Trajectory<'a, I, T> {
    pub(crate) fn new(integrator: &'a I, state: I::State, made: u64, step: f64) -> Self {
        let workspace = integrator.workspace();
        let (iterations, progress) = (0, Progress::First);
        Self { integrator, workspace, step, state, made, iterations, progress, given: None }
    }

    /// Returns the trajectory whose first sample has the given momentum, bit for bit.
    ///
    /// A state that is made from μ, such as a lift, has the momentum μ only up to rounding. [`Start::trajectory`](crate::Start::trajectory) uses this
    /// method. Call it if a run begins with a state of your own for a μ that is given.
    ///
    /// # Example
    /// ```
    /// use collective_integrators::{Collective, Integrator, RungeKutta, Start};
    /// use lie_poisson::{Covector, LiePoisson, So3, from_closure};
    /// use momentum_map::HOPF;
    /// use nalgebra::Vector3;
    /// let h = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| pi.x * pi.x + pi.y * pi.z);
    /// let gauss = Collective::new(RungeKutta::gauss(2)?, HOPF, h);
    /// let mu = Covector(Vector3::new(0.1, 0.7, -0.3));
    /// let mut run = gauss.trajectory_from(gauss.start(&mu)?, 0.1).through(mu);
    /// assert_eq!(run.next().transpose()?.map(|sample| sample.momentum), Some(mu));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn through(self, momentum: I::Momentum) -> Self {
        Self { given: Some(momentum), ..self }
    }

    /// Returns the iterator over every n-th item, beginning with the next one: a `step_by(n)` that cannot panic.
    ///
    /// [`Integrator::advance`] makes the steps between two items, without samples. The items are bit-identical to those
    /// of the whole trajectory, except that each counts the iterations of all n steps. If a step fails on the way to an
    /// item, that item and all after it are its error.
    ///
    /// # Example
    /// With 100 steps in a period, 4K(sin²(θ/2)) for θ = 1 (DLMF §22.19(i)), every 100th sample of a pendulum is back
    /// at the start:
    /// ```
    /// use collective_integrators::{Direct, RungeKutta, Start, from_fn};
    /// use nalgebra::Vector2;
    /// use std::num::NonZero;
    /// const STEPS: NonZero<usize> = NonZero::new(100).unwrap();
    /// let pendulum = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x.sin()));
    /// let gauss = Direct::new(RungeKutta::gauss(5)?, pendulum);
    /// let (start, step) = (Vector2::new(1.0, 0.0), 6.699975664370453 / 100.0);
    /// for (period, sample) in (0..10).zip(gauss.trajectory(&start, step)?.every(STEPS)) {
    ///     let sample = sample?;
    ///     assert_eq!(sample.step, 100 * period);
    ///     assert!((sample.state - start).norm() < 1e-11);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn every(self, n: NonZero<usize>) -> StepBy<Self> {
        self.step_by(n.get())
    }

    /// Returns the sample `steps` items after the next one. No other sample is made.
    pub(crate) fn after(mut self, steps: u64) -> Result<SampleOf<I, T>, IntegrationError> {
        self.skip_items(steps)?;
        self.item()
    }

    /// Makes `steps` steps in place, without samples, and returns the state after them. The next item is the sample one
    /// step later.
    ///
    /// The steps are bit-identical to those of the iterator. This is how a run on the heap allocates nothing, and how a
    /// loop of your own needs no workspace:
    /// ```
    /// use collective_integrators::{Direct, Integrator, RungeKutta, from_fn};
    /// use nalgebra::Vector2;
    /// let pendulum = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x.sin()));
    /// let gauss = Direct::new(RungeKutta::gauss(2)?, pendulum);
    /// let start = Vector2::new(1.0, 0.0);
    /// let mut run = gauss.trajectory_from(start, 0.1);
    /// let mut largest = 0.0_f64;
    /// for _ in 0..20 {
    ///     largest = largest.max(run.advance(5)?.y.abs());
    /// }
    /// assert!(largest > 0.9);
    /// assert_eq!(*run.state(), gauss.after_from(start, 0.1, 100)?.state);
    /// assert_eq!(run.next().transpose()?.map(|sample| sample.step), Some(101));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// Returns the errors of the iterator, and keeps the state before the step that failed.
    pub fn advance(&mut self, steps: u64) -> Result<&I::State, IntegrationError> {
        match self.progress {
            Progress::Failed(error) => return Err(error),
            Progress::First if steps > 0 => self.reach_next_item()?,
            Progress::First | Progress::After => {}
        }
        self.skip_items(steps)?;
        Ok(&self.state)
    }

    /// Returns the state after the steps made.
    pub fn state(&self) -> &I::State {
        &self.state
    }

    /// Advances to the next item, and returns it.
    #[inline]
    fn item(&mut self) -> Result<SampleOf<I, T>, IntegrationError> {
        let is_first = matches!(self.progress, Progress::First);
        self.reach_next_item()?;
        let mut sample = self.sample();
        self.iterations = 0;
        if let (true, Some(given)) = (is_first, &self.given) {
            sample.momentum.clone_from(given);
        }
        Ok(sample)
    }

    /// Advances the state to that of the next item.
    #[inline]
    fn reach_next_item(&mut self) -> Result<(), IntegrationError> {
        let outcome = match self.progress {
            Progress::First => StepError::check_start(&self.state, self.step),
            Progress::After => self.make_step(),
            Progress::Failed(error) => return Err(error),
        };
        match outcome {
            Ok(()) => {
                self.progress = Progress::After;
                Ok(())
            }
            Err(source) => Err(self.fail(IntegrationError::after(self.made, self.step, source))),
        }
    }

    /// Makes a step in place. The state is not changed by a step that fails.
    #[inline]
    fn make_step(&mut self) -> Result<(), StepError> {
        let number = self.made.checked_add(1).ok_or(StepError::Uncountable)?;
        if self.made.is_multiple_of(CHECKPOINT) {
            self.integrator.forget(&mut self.workspace);
        }
        let Self { integrator, state, workspace, .. } = self;
        self.iterations += integrator.step_in_place(state, self.step, workspace)?;
        self.made = number;
        Ok(())
    }

    /// Advances the state to that of the n-th of the next items.
    #[inline]
    fn skip_items(&mut self, n: u64) -> Result<(), IntegrationError> {
        let Some(others) = n.checked_sub(1) else { return Ok(()) };
        self.reach_next_item()?;
        let end = self.made.saturating_add(others);
        if end > self.made {
            let Self { integrator, state, workspace, .. } = self;
            let advanced = integrator.advance(state, self.step, self.made..end, workspace);
            self.iterations += advanced.map_err(|error| self.fail(error))?;
        }
        let uncountable = others > end - self.made;
        self.made = end;
        if uncountable { self.reach_next_item() } else { Ok(()) }
    }

    /// Makes every further item this error, and returns it.
    fn fail(&mut self, error: IntegrationError) -> IntegrationError {
        self.progress = Progress::Failed(error);
        error
    }

    #[inline]
    fn sample(&self) -> SampleOf<I, T> {
        // The first time is +0, also of a negative step: −0 + 0 = +0.
        let (step, time) = (self.made, self.made as f64 * self.step + 0.0);
        let momentum = self.integrator.momentum(&self.state);
        Sample { step, time, state: self.state.clone(), momentum, iterations: self.iterations }
    }
}

impl<I: Integrator<T>, T: Real> Iterator for Trajectory<'_, I, T> {
    type Item = Result<SampleOf<I, T>, IntegrationError>;

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        Some(self.item())
    }

    /// Skips `n` items without making their samples.
    #[inline]
    fn nth(&mut self, n: usize) -> Option<Self::Item> {
        match self.skip_items(n as u64) {
            Ok(()) => self.next(),
            Err(error) => Some(Err(error)),
        }
    }
}
