//! Integrators that advance many states at once: [`BatchIntegrator`].

use crate::IntegrationError;
use core::ops::Range;

/// A method that advances many independent states side by side, each as if it were alone.
///
/// What one member becomes depends on itself alone: not on the others, not on its place among them,
/// not on how many there are. A member that fails, or is not a number, changes no other member.
///
/// [`Laned`](crate::Laned) makes one of every [`Integrator`](crate::Integrator) over lanes; a kernel
/// for a special system is another implementation. [`Ensemble`](crate::Ensemble) runs either on
/// all threads.
pub trait BatchIntegrator: Sync {
    /// One of the many: its state, together with its parameters where they differ from member to
    /// member.
    type Member: Copy + Send + Sync;

    /// The storage that [`advance`](Self::advance) needs, allocated once per thread.
    type Workspace;

    /// Allocates it.
    fn workspace(&self) -> Self::Workspace;

    /// Advances each member, from where `steps.start` steps have led it to where `steps.end` will,
    /// with steps of size `step`, which may be negative. No step allocates.
    ///
    /// A method that remembers the steps before, to guess from them, remembers nothing at the start
    /// of a call, and forgets at every multiple of [`CHECKPOINT`](crate::CHECKPOINT), as a
    /// [`Trajectory`](crate::Trajectory) does.
    ///
    /// A member that cannot go on keeps the state before the step that failed, and
    /// `failed(i, error)` is called once with its index and the number and the time of that step.
    /// The order of these calls means nothing.
    fn advance(
        &self,
        members: &mut [Self::Member],
        step: f64,
        steps: Range<u64>,
        workspace: &mut Self::Workspace,
        failed: &mut dyn FnMut(usize, IntegrationError),
    );
}
