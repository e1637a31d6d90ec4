//! Ensembles: many initial states, advanced on all threads.

use crate::batch::batch_integrator::BatchIntegrator;
use crate::error::IntegrationError;
use core::error::Error;
use core::fmt;
use core::ops::Range;
use rayon::prelude::*;

/// The number of members that a thread works on at a time.
///
/// It is a multiple of every number of SIMD lanes, and small enough for the second-level cache of a thread. Threads can
/// share a thousand members evenly.
const CHUNK: usize = 128;

/// Many independent members of one system, advanced side by side by a [`BatchIntegrator`] on all threads of rayon's
/// current pool.
///
/// # Reproducibility
/// The result of a member does not depend on the other members, on the number of threads, or on which of them does the
/// work. For SIMD lanes (several trajectories in one register) the rules are:
///
/// * [`Laned`](crate::Laned) integrators, and kernels without fused multiply-add, return bit-identical results at every
///   width, including `f64`;
/// * kernels with fused multiply-add return bit-identical results at every width that fuses. Results with and without
///   fusion differ by rounding, since a fused multiply-add rounds a product and a sum once, together.
///
/// # Example
/// Ten thousand harmonic oscillators of different amplitudes are streamed: at any time, only those on which the threads
/// are working are in memory. The observer may be called from several threads at once, in any order.
/// ```
/// use collective_integrators::{Direct, Ensemble, Laned, RungeKutta, VectorField};
/// use lie_poisson::Real;
/// use nalgebra::Vector2;
/// use std::sync::atomic::{AtomicU64, Ordering};
///
/// struct Oscillator;
/// impl<T: Real> VectorField<T> for Oscillator {
///     type Point = Vector2<T>;
///     fn at(&self, z: &Vector2<T>) -> Vector2<T> {
///         Vector2::new(z.y, -z.x)
///     }
/// }
/// let ensemble = Ensemble::new(Laned::new(Direct::new(RungeKutta::rk4(), Oscillator)));
/// let amplitude = |index: u64| 1.0 + index as f64 / 1e4;
/// let seen = AtomicU64::new(0);
/// ensemble.stream(10_000, |index| Vector2::new(amplitude(index), 0.0), 0.05, 20, |chunk| {
///     assert!(chunk.failures.is_empty());
///     for (index, z) in (chunk.first..).zip(chunk.members) {
///         assert!((z.x - amplitude(index) * 1.0_f64.cos()).abs() < 1e-6);
///     }
///     seen.fetch_add(chunk.members.len() as u64, Ordering::Relaxed);
/// });
/// assert_eq!(seen.into_inner(), 10_000);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Ensemble<B> {
    integrator: B,
}

/// The error of a member that could not continue. Its message names the member, the step and the reason, and it has no
/// [`source`](core::error::Error::source) that would repeat them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MemberError {
    /// The index of the member in the ensemble.
    pub index: u64,
    /// The step that failed, and the reason.
    pub source: IntegrationError,
}

/// Members with successive indices, after all steps of a call.
#[derive(Clone, Copy, Debug)]
pub struct Chunk<'a, M> {
    /// The index of the first member of the chunk.
    pub first: u64,
    /// The members of the chunk. A failed member has its state from before the failed step.
    pub members: &'a [M],
    /// The errors of the failed members, by increasing index.
    pub failures: &'a [MemberError],
}

impl fmt::Display for MemberError {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "member {}: {}", self.index, self.source)
    }
}

impl Error for MemberError {}

impl<B: BatchIntegrator> Ensemble<B> {
    /// Creates an ensemble that an integrator advances.
    pub fn new(integrator: B) -> Self {
        Self { integrator }
    }

    /// Returns the integrator of the ensemble.
    pub fn integrator(&self) -> &B {
        &self.integrator
    }

    /// Starts the members i = 0, …, `count` − 1 at `start`(i), makes the given number of steps, and passes the results
    /// to the observer. The observer receives each member once, in chunks.
    ///
    /// Memory is allocated only for the chunks in progress, whatever the count. The chunks arrive in no fixed order, so
    /// a sum over chunks has no fixed order of terms either. If the last bits matter, keep one sum for each
    /// [`Chunk::first`], and add these sums in the order of their indices.
    pub fn stream(
        &self,
        count: u64,
        start: impl Fn(u64) -> B::Member + Sync,
        step: f64,
        steps: u64,
        observe: impl Fn(Chunk<'_, B::Member>) + Sync,
    ) {
        let length = CHUNK as u64;
        let storage = || (self.integrator.workspace(), Vec::new(), Vec::new());
        (0..count.div_ceil(length)).into_par_iter().for_each_init(
            storage,
            |(workspace, members, failures), n| {
                let first = n * length;
                members.clear();
                members.extend((first..count.min(first.saturating_add(length))).map(&start));
                failures.clear();
                self.advance_chunk(first, members, step, 0..steps, workspace, failures);
                observe(Chunk { first, members, failures });
            },
        );
    }

    /// Advances members in memory from their states after `steps.start` steps to their states after `steps.end` steps.
    /// Returns the errors of the failed members by increasing index; these members keep the state from before the
    /// failed step.
    ///
    /// A run that is divided into several calls is bit-identical to an undivided run if the calls meet at multiples of
    /// [`CHECKPOINT`](crate::CHECKPOINT). Do not pass failed members to later calls, which would advance them from
    /// where they are and report them again.
    pub fn advance(
        &self,
        members: &mut [B::Member],
        step: f64,
        steps: Range<u64>,
    ) -> Vec<MemberError> {
        let chunks = members.par_chunks_mut(CHUNK).enumerate();
        let advance = |workspace: &mut B::Workspace, (n, chunk): (usize, &mut [B::Member])| {
            let mut failures = Vec::new();
            let first = (n * CHUNK) as u64;
            self.advance_chunk(first, chunk, step, steps.clone(), workspace, &mut failures);
            failures
        };
        chunks.map_init(|| self.integrator.workspace(), advance).flatten_iter().collect()
    }

    fn advance_chunk(
        &self,
        first: u64,
        members: &mut [B::Member],
        step: f64,
        steps: Range<u64>,
        workspace: &mut B::Workspace,
        failures: &mut Vec<MemberError>,
    ) {
        let mut failed = |i: usize, source| {
            failures.push(MemberError { index: first + i as u64, source });
        };
        self.integrator.advance(members, step, steps, workspace, &mut failed);
        failures.sort_unstable_by_key(|failure| failure.index);
    }
}
