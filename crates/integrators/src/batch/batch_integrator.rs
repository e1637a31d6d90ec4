//! Integrators that advance many states at once: [`BatchIntegrator`].

use crate::error::IntegrationError;
use core::ops::Range;

/// A method that advances many independent states side by side, each as if it were alone.
///
/// The result of a member depends on this member alone. It does not depend on the other members, on its place among
/// them, or on their number. A member that fails, or that is not a number, changes no other member.
///
/// [`Laned`](crate::Laned) turns every [`Integrator`](crate::Integrator) into a batch integrator that uses SIMD lanes
/// (several trajectories in one register). A kernel for one particular system can also implement this trait.
/// [`Ensemble`](crate::Ensemble) runs either kind on all threads.
///
/// # Example
/// A batch of decays dx/dt = −k x with a rate k for each member, in closed form:
/// ```
/// use collective_integrators::{BatchIntegrator, Ensemble, IntegrationError};
/// use std::ops::Range;
///
/// struct Decays;
/// impl BatchIntegrator for Decays {
///     type Member = (f64, f64);
///     type Workspace = ();
///     fn workspace(&self) {}
///     fn advance(
///         &self,
///         members: &mut [(f64, f64)],
///         step: f64,
///         steps: Range<u64>,
///         (): &mut (),
///         _failed: &mut dyn FnMut(usize, IntegrationError),
///     ) {
///         for (k, x) in members {
///             for _ in steps.clone() {
///                 *x *= (-*k * step).exp();
///             }
///         }
///     }
/// }
///
/// let mut members: Vec<_> = (0..100).map(|i| (0.01 * f64::from(i), 1.0)).collect();
/// assert!(Ensemble::new(Decays).advance(&mut members, 0.1, 0..10).is_empty());
/// assert!(members.iter().all(|(k, x)| (x - (-k).exp()).abs() < 1e-14));
/// ```
pub trait BatchIntegrator: Sync {
    /// The type of a member: its state, together with its parameters if they differ from member to member.
    type Member: Copy + Send + Sync;

    /// The storage that [`advance`](Self::advance) needs, allocated for each task of a thread.
    type Workspace;

    /// Allocates the storage for [`advance`](Self::advance).
    fn workspace(&self) -> Self::Workspace;

    /// Advances each member from its state after `steps.start` steps to its state after `steps.end` steps. The size
    /// `step` may be negative. No step allocates, except a step that needs Newton's iteration and the steps of a member
    /// that is advanced by itself.
    ///
    /// A method that predicts stages from earlier steps remembers nothing at the start of a call. It forgets the
    /// earlier steps at every multiple of [`CHECKPOINT`](crate::CHECKPOINT), as a [`Trajectory`](crate::Trajectory)
    /// does.
    ///
    /// A member that cannot continue keeps its state from before the failed step. The method then calls
    /// `failed(i, error)` once, with the index of the member and with the number and the time of the step. The order of
    /// these calls is arbitrary.
    fn advance(
        &self,
        members: &mut [Self::Member],
        step: f64,
        steps: Range<u64>,
        workspace: &mut Self::Workspace,
        failed: &mut dyn FnMut(usize, IntegrationError),
    );
}
