//! Batch integrators over SIMD lanes that are chosen when the program runs: [`Laned`].

use crate::batch::batch_integrator::BatchIntegrator;
use crate::batch::group_engine::{Group, advance_groups};
use crate::batch::lane_kernel::LaneResults;
use crate::error::{IntegrationError, StepError};
use crate::integrators::lanes::fastest_set::FastestSet;
use crate::integrators::trajectories::integrator::Integrator;
use core::ops::Range;
use lie_poisson::{
    DefaultLanes, InstructionSet, Lanes, MissingInstructions, State, StorageOver, TaskOver,
    UnfusedStorage, UnfusedTask, UnfusedWorkspace, Vector, dispatch_unfused,
};

/// The number of members of a run that is timed: they fill registers of every width.
const TRIAL_MEMBERS: usize = 8;

/// The number of steps of a run that is timed.
const TRIAL_STEPS: u64 = 8;

/// An integrator that advances several states side by side, in the SIMD lanes of a register (several trajectories in
/// one register).
///
/// [`new`](Self::new) uses the lanes that every processor has. [`widest`](Self::widest) uses wider registers of the
/// current processor where they are faster, which its first steps measure. Every integrator whose formulas are written
/// over all scalars is suitable. Each member is bit-identical to its [trajectory](Integrator::trajectory_from) over
/// `f64`, for all instruction sets and all neighbours: operations on lanes round as operations on `f64` do, and an
/// iteration stops in each lane by itself. If an integrator has other formulas over `f64`, such as a fused kernel, its
/// steps over `f64` differ by rounding from those over lanes. Even then, the neighbours do not matter. Members of a field with
/// [breakpoints](lie_poisson::OrbitField::next_break) that come at different times are advanced one by one.
///
/// The steps are made in blocks that end at the multiples of [`CHECKPOINT`](crate::CHECKPOINT). If a step of some lane
/// fails, or needs Newton's iteration in wide registers, the block is repeated from its start: first with four members
/// at a time, on the [lanes](DefaultLanes) that every processor has. If such a group of four fails, each of its members
/// repeats the block by itself, over `f64`. A member that fails even then takes no further step; the others continue
/// together.
///
/// # Speed of wide registers
/// The rules of [`LaneTask`](lie_poisson::LaneTask) hold for the field or the Hamiltonian of the integrator: mark its
/// methods, and what they call, with `#[inline(always)]`, and compute with components. A method without the mark is
/// correct, but its operations become function calls, and its steps may be twenty times slower in wide registers than
/// on the lanes that every processor has. [`widest`](Self::widest) then uses these. [`Direct`](crate::Direct),
/// [`LiftFree`](crate::LiftFree) and [`Collective`](crate::Collective) integrators with
/// [`RungeKutta`](crate::RungeKutta) methods and their compositions follow the rules; compensated sums, partitioned
/// methods and splittings do not.
///
/// # Example
/// Six harmonic oscillators, of which the fifth starts at NaN:
/// ```
/// use collective_integrators::{BatchIntegrator, Direct, Laned, RungeKutta, VectorField};
/// use lie_poisson::Real;
/// use nalgebra::Vector2;
///
/// struct Oscillator;
/// impl<T: Real> VectorField<T> for Oscillator {
///     type Point = Vector2<T>;
///     #[inline(always)]
///     fn at(&self, z: &Vector2<T>) -> Vector2<T> {
///         Vector2::new(z.y, -z.x)
///     }
/// }
/// let gauss = Laned::widest(Direct::new(RungeKutta::gauss(4)?, Oscillator));
/// let mut members = [1.0, 2.0, 3.0, 4.0, f64::NAN, 6.0].map(|x| Vector2::new(x, 0.0));
/// let mut failures = Vec::new();
/// let mut report = |index, error| failures.push((index, error));
/// gauss.advance(&mut members, 0.1, 0..100, &mut gauss.workspace(), &mut report);
/// assert!((members[5].x - 6.0 * 10.0_f64.cos()).abs() < 1e-11);
/// assert!(failures.len() == 1 && failures[0].0 == 4 && failures[0].1.step == 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Laned<I> {
    integrator: I,
    instructions: FastestSet,
}

impl<I> Laned<I> {
    /// Creates a batch integrator on the lanes that every processor has.
    pub fn new(integrator: I) -> Self {
        Self { integrator, instructions: FastestSet::given(InstructionSet::Portable) }
    }

    /// Creates a batch integrator on the widest instruction set that this processor has, or on a narrower one if the
    /// first steps show that it is faster.
    pub fn widest(integrator: I) -> Self {
        Self { integrator, instructions: FastestSet::up_to(InstructionSet::detected()) }
    }

    /// Replaces the instruction set. No other set is used, even if it is faster. The steps on all sets are
    /// bit-identical.
    ///
    /// # Errors
    /// Returns [`MissingInstructions`] if the processor lacks them.
    pub fn with_instructions(self, set: InstructionSet) -> Result<Self, MissingInstructions> {
        Ok(Self { instructions: FastestSet::given(set.if_available()?), ..self })
    }

    /// Returns the instruction set that the steps use. For [`widest`](Self::widest) it may become a narrower one in the
    /// first steps.
    pub fn instructions(&self) -> InstructionSet {
        self.instructions.current()
    }

    /// Returns the integrator for one member.
    pub fn integrator(&self) -> &I {
        &self.integrator
    }
}

/// The storage is the workspace of the integrator.
impl<I: Integrator<T>, T: Lanes> StorageOver<T> for Laned<I> {
    type Storage = I::Workspace;

    fn storage(&self) -> I::Workspace {
        self.integrator.workspace()
    }
}

/// The storage of a [`Laned`] integrator: the workspaces for the lanes of its registers and for members that fail
/// there.
pub struct LanedWorkspace<I>
where
    I: Integrator<f64> + Integrator<DefaultLanes>,
    Laned<I>: UnfusedStorage,
{
    lanes: UnfusedWorkspace<Laned<I>>,
    repeats: Repeats<I>,
}

/// The workspaces for members whose group has failed, created when they are first needed.
struct Repeats<I: Integrator<f64> + Integrator<DefaultLanes>> {
    four: Option<<I as Integrator<DefaultLanes>>::Workspace>,
    one: Option<<I as Integrator<f64>>::Workspace>,
}

impl<I> BatchIntegrator for Laned<I>
where
    I: Integrator<f64, State: Vector> + Integrator<DefaultLanes, State: Vector> + Sync,
    Laned<I>: UnfusedStorage,
    for<'a> Advance<'a, I>: UnfusedTask<Laned<I>>,
{
    type Member = <I as Integrator<f64>>::State;
    type Workspace = LanedWorkspace<I>;

    fn workspace(&self) -> LanedWorkspace<I> {
        let lanes = self.lanes(self.instructions());
        LanedWorkspace { lanes, repeats: Repeats { four: None, one: None } }
    }

    fn advance(
        &self,
        members: &mut [Self::Member],
        step: f64,
        steps: Range<u64>,
        LanedWorkspace { lanes, repeats }: &mut LanedWorkspace<I>,
        failed: &mut dyn FnMut(usize, IntegrationError),
    ) {
        let integrator = &self.integrator;
        let first = members.first().copied();
        let starts = || first.is_some_and(|first| StepError::check_start(&first, step).is_ok());
        let set = self.instructions.find(
            || !steps.is_empty() && starts(),
            |set| {
                let Some(first) = first else { return };
                let members = &mut [first; TRIAL_MEMBERS];
                let steps = steps.start..steps.end.min(steps.start.saturating_add(TRIAL_STEPS));
                let failed = &mut |_, _| ();
                let trial = Advance { integrator, members, step, steps, repeats, failed };
                dispatch_unfused(trial, &mut self.lanes(set));
            },
        );
        if set != lanes.instructions() {
            *lanes = self.lanes(set);
        }
        dispatch_unfused(Advance { integrator, members, step, steps, repeats, failed }, lanes);
    }
}

impl<I> Laned<I>
where
    Self: UnfusedStorage,
{
    /// Returns the storage for the lanes of a set, for which the constructors have tested the processor.
    fn lanes(&self, set: InstructionSet) -> UnfusedWorkspace<Self> {
        UnfusedWorkspace::new(self, set).unwrap_or_else(|_| UnfusedWorkspace::portable(self))
    }
}

/// The task to advance all members on the lanes that [`dispatch_unfused`] chooses.
pub struct Advance<'a, I: Integrator<f64> + Integrator<DefaultLanes>> {
    integrator: &'a I,
    members: &'a mut [<I as Integrator<f64>>::State],
    step: f64,
    steps: Range<u64>,
    repeats: &'a mut Repeats<I>,
    failed: &'a mut dyn FnMut(usize, IntegrationError),
}

impl<I, T> TaskOver<T, Laned<I>> for Advance<'_, I>
where
    I: Integrator<f64, State: Vector>
        + Integrator<DefaultLanes, State: Vector>
        + Integrator<T, State: Vector>,
    T: Lanes,
{
    #[cfg_attr(optimised, inline(always))]
    fn run(self, workspace: &mut <I as Integrator<T>>::Workspace) {
        let Self { integrator, members, step, steps, repeats, failed } = self;
        let mut group = LaneGroup::<I, T> { integrator, workspace, repeats };
        advance_groups(&mut group, members, step, steps, failed);
    }
}

/// An integrator over lanes of type `T`, as a group of members.
struct LaneGroup<'a, I: Integrator<f64> + Integrator<DefaultLanes> + Integrator<T>, T: Lanes> {
    integrator: &'a I,
    workspace: &'a mut <I as Integrator<T>>::Workspace,
    repeats: &'a mut Repeats<I>,
}

/// Makes the steps of a block with all members, each in a lane. If a step fails in some lane, no member is changed.
#[cfg_attr(optimised, inline(always))]
fn steps<I, T>(
    integrator: &I,
    workspace: &mut <I as Integrator<T>>::Workspace,
    group: &mut [<I as Integrator<f64>>::State],
    step: f64,
    count: u64,
) -> Result<(), StepError>
where
    I: Integrator<f64, State: Vector> + Integrator<T, State: Vector>,
    T: Lanes,
{
    let Some(last) = group.len().checked_sub(1) else { return Ok(()) };
    for member in group.iter() {
        StepError::check_start(member, step)?;
    }
    let mut state = <I as Integrator<T>>::State::from_coordinates(
        #[cfg_attr(optimised, inline(always))]
        |i| {
            T::from_lanes(
                #[cfg_attr(optimised, inline(always))]
                |lane| group[lane.min(last)].coordinate(i),
            )
        },
    );
    Integrator::<T>::forget(integrator, workspace);
    for _ in 0..count {
        state = Integrator::<T>::step(integrator, &state, step, workspace)?.point;
    }
    for (lane, member) in group.iter_mut().enumerate() {
        *member = Vector::from_coordinates(
            #[cfg_attr(optimised, inline(always))]
            |i| state.coordinate(i).lane(lane),
        );
    }
    Ok(())
}

/// Makes the [`steps`], compiled once for the groups of these lanes and for the members that fail in wider ones.
#[inline(never)]
fn steps_apart<I, T>(
    integrator: &I,
    workspace: &mut <I as Integrator<T>>::Workspace,
    group: &mut [<I as Integrator<f64>>::State],
    step: f64,
    count: u64,
) -> Result<(), StepError>
where
    I: Integrator<f64, State: Vector> + Integrator<T, State: Vector>,
    T: Lanes,
{
    steps::<I, T>(integrator, workspace, group, step, count)
}

impl<I, T> Group for LaneGroup<'_, I, T>
where
    I: Integrator<f64, State: Vector>
        + Integrator<DefaultLanes, State: Vector>
        + Integrator<T, State: Vector>,
    T: Lanes,
{
    type Member = <I as Integrator<f64>>::State;

    #[cfg_attr(optimised, inline(always))]
    fn width(&self) -> usize {
        T::COUNT
    }

    #[cfg_attr(optimised, inline(always))]
    fn together(&mut self, group: &mut [Self::Member], step: f64, count: u64) -> LaneResults {
        if T::HAS_SLOW_PATHS {
            let made = steps_apart::<I, T>(self.integrator, self.workspace, group, step, count);
            return core::array::from_fn(|lane| made.is_ok() && lane < group.len());
        }
        match steps::<I, T>(self.integrator, self.workspace, group, step, count) {
            Ok(()) => core::array::from_fn(|lane| lane < group.len()),
            Err(_) => self.repeats.four_at_a_time(self.integrator, group, step, count),
        }
    }

    #[cold]
    #[inline(never)]
    fn alone(
        &mut self,
        member: &mut Self::Member,
        step: f64,
        steps: Range<u64>,
    ) -> Result<(), IntegrationError> {
        let integrator = self.integrator;
        let workspace =
            self.repeats.one.get_or_insert_with(|| Integrator::<f64>::workspace(integrator));
        Integrator::<f64>::forget(integrator, workspace);
        Integrator::<f64>::advance(integrator, member, step, steps, workspace).map(drop)
    }
}

impl<I> Repeats<I>
where
    I: Integrator<f64, State: Vector> + Integrator<DefaultLanes, State: Vector>,
{
    /// Makes the steps of a block on the lanes that every processor has, which treat slow cases. Returns which members
    /// have a result.
    #[cold]
    #[inline(never)]
    fn four_at_a_time(
        &mut self,
        integrator: &I,
        group: &mut [<I as Integrator<f64>>::State],
        step: f64,
        count: u64,
    ) -> LaneResults {
        let workspace =
            self.four.get_or_insert_with(|| Integrator::<DefaultLanes>::workspace(integrator));
        let mut results = LaneResults::default();
        let width = DefaultLanes::COUNT;
        for (members, results) in group.chunks_mut(width).zip(results.chunks_mut(width)) {
            results.fill(
                steps_apart::<I, DefaultLanes>(integrator, workspace, members, step, count).is_ok(),
            );
        }
        results
    }
}
