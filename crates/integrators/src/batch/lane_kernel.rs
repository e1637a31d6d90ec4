//! Kernels for many members: [`LaneKernel`], on the [`Registers`] of the processor.

use crate::batch::group_engine::{Group, MOST_LANES, advance_groups};
use crate::error::IntegrationError;
use core::marker::PhantomData;
use core::ops::Range;
use lie_poisson::{InstructionSet, LaneTask, Lanes, MissingInstructions, Width, dispatch};

/// A method for many members of one particular system, with one member in each SIMD lane (several trajectories in one
/// register).
///
/// [`Registers::advance`] turns it into a [`BatchIntegrator`](crate::BatchIntegrator).
///
/// # Example
/// Exact rotations of the plane, by one product in each step:
/// ```
/// use collective_integrators::{IntegrationError, LaneKernel, LaneResults, Registers, StepError};
/// use core::ops::Range;
/// use lie_poisson::Lanes;
/// use nalgebra::Vector2;
///
/// struct Rotations;
/// impl LaneKernel for Rotations {
///     type Member = Vector2<f64>;
///
///     #[inline(always)]
///     fn together<T: Lanes>(&self, group: &mut [Vector2<f64>], step: f64, count: u64) -> LaneResults {
///         let last = group.len() - 1;
///         let (sin, cos) = step.sin_cos();
///         let mut x = T::from_lanes(|i| group[i.min(last)].x);
///         let mut y = T::from_lanes(|i| group[i.min(last)].y);
///         for _ in 0..count {
///             (x, y) = (x * cos - y * sin, x * sin + y * cos);
///         }
///         let mut results = LaneResults::default();
///         for (i, member) in group.iter_mut().enumerate() {
///             *member = Vector2::new(x.lane(i), y.lane(i));
///             results[i] = member.x.is_finite() && member.y.is_finite();
///         }
///         results
///     }
///
///     fn alone(
///         &self,
///         member: &mut Vector2<f64>,
///         step: f64,
///         steps: Range<u64>,
///     ) -> Result<(), IntegrationError> {
///         let reason = match StepError::check_start(member, step) {
///             Err(refused) => refused,
///             Ok(()) if steps.is_empty() => return Ok(()),
///             Ok(()) => StepError::NotFinite, // The sum has overflowed.
///         };
///         Err(IntegrationError::after(steps.start, step, reason))
///     }
/// }
///
/// let mut members = [1.0, 2.0, f64::NAN].map(|x| Vector2::new(x, 0.0));
/// let mut failures = Vec::new();
/// let mut report = |index, error: IntegrationError| failures.push((index, error.step));
/// Registers::widest().advance(&Rotations, &mut members, 0.1, 0..10, &mut report);
/// assert!((members[1] - Vector2::new(1.0_f64.cos(), 1.0_f64.sin()) * 2.0).norm() < 1e-14);
/// assert_eq!(failures, [(2, 1)]);
/// ```
pub trait LaneKernel: Sync {
    /// The type of a member: its state, with its parameters if they differ from member to member.
    type Member: Copy + Send + Sync;

    /// Advances a group of at least one and at most `T::COUNT` members by `count` steps, without using any memory of
    /// earlier steps. Returns which members have a finite result; the others may be left in any state.
    ///
    /// The result of a member must depend on this member alone. Mark the method `#[inline(always)]`, as [`LaneTask`]
    /// explains.
    fn together<T: Lanes>(&self, group: &mut [Self::Member], step: f64, count: u64) -> LaneResults;

    /// Makes the steps of [`together`](Self::together) with one member by itself, if its lane has no result.
    /// [`Integrator::advance`](crate::Integrator::advance) does this with a new workspace.
    ///
    /// # Errors
    /// Returns an [`IntegrationError`] if the member cannot be advanced. The member keeps the state before the failed
    /// step.
    fn alone(
        &self,
        member: &mut Self::Member,
        step: f64,
        steps: Range<u64>,
    ) -> Result<(), IntegrationError>;
}

/// The lanes of a group in which a member has a result.
pub type LaneResults = [bool; MOST_LANES];

/// The registers in which a [`LaneKernel`] computes: an instruction set that this processor has, and a width.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Registers {
    instructions: InstructionSet,
    width: Width,
}

impl Registers {
    /// Selects the widest registers of this processor, used two at a time.
    #[must_use]
    pub fn widest() -> Self {
        Self { instructions: InstructionSet::detected(), width: Width::TwoRegisters }
    }

    /// Selects registers by instruction set and width.
    ///
    /// # Errors
    /// Returns [`MissingInstructions`] if the processor lacks the instructions.
    pub fn new(instructions: InstructionSet, width: Width) -> Result<Self, MissingInstructions> {
        Ok(Self { instructions: instructions.if_available()?, width })
    }

    /// Returns the instruction set of the registers.
    #[must_use]
    pub fn instructions(self) -> InstructionSet {
        self.instructions
    }

    /// Advances the members by a kernel, as [`BatchIntegrator::advance`](crate::BatchIntegrator::advance) promises.
    ///
    /// The kernel works in lanes from one checkpoint to the next, and with one member by itself if its lane has no
    /// result.
    pub fn advance<K: LaneKernel>(
        self,
        kernel: &K,
        members: &mut [K::Member],
        step: f64,
        steps: Range<u64>,
        failed: &mut dyn FnMut(usize, IntegrationError),
    ) {
        let task = KernelAdvance { kernel, members, step, steps, failed };
        // The constructors have tested the processor for these instructions, so that there is no error.
        dispatch(task, self.instructions, self.width).unwrap_or_default();
    }
}

/// The task to advance all members on the lanes that [`dispatch`] selects.
struct KernelAdvance<'a, K: LaneKernel> {
    kernel: &'a K,
    members: &'a mut [K::Member],
    step: f64,
    steps: Range<u64>,
    failed: &'a mut dyn FnMut(usize, IntegrationError),
}

impl<K: LaneKernel> LaneTask for KernelAdvance<'_, K> {
    type Output = ();

    #[cfg_attr(optimised, inline(always))]
    fn run<T: Lanes>(self) {
        let Self { kernel, members, step, steps, failed } = self;
        let mut group = KernelGroup::<K, T> { kernel, lanes: PhantomData };
        advance_groups(&mut group, members, step, steps, failed);
    }
}

/// A kernel on lanes of type `T`, as a group of members.
struct KernelGroup<'a, K: LaneKernel, T> {
    kernel: &'a K,
    lanes: PhantomData<T>,
}

impl<K: LaneKernel, T: Lanes> Group for KernelGroup<'_, K, T> {
    type Member = K::Member;

    #[cfg_attr(optimised, inline(always))]
    fn width(&self) -> usize {
        T::COUNT
    }

    #[cfg_attr(optimised, inline(always))]
    fn together(&mut self, group: &mut [K::Member], step: f64, count: u64) -> LaneResults {
        self.kernel.together::<T>(group, step, count)
    }

    #[cold]
    #[inline(never)]
    fn alone(
        &mut self,
        member: &mut K::Member,
        step: f64,
        steps: Range<u64>,
    ) -> Result<(), IntegrationError> {
        self.kernel.alone(member, step, steps)
    }
}
