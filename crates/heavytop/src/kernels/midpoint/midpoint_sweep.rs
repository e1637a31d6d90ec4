//! The collective midpoint rule for many tops at once.

use crate::HeavyTop;
use crate::kernels::midpoint::formulas::{ManyTops, Member};
use crate::kernels::midpoint::reduced_midpoint::{ReducedMidpoint, ReducedMidpointSpace};
use crate::kernels::midpoint::top_midpoint::TopMidpoint;
use collective_integrators::{
    BatchIntegrator, CHECKPOINT, IntegrationError, Integrator, StepError,
};
use core::ops::Range;
use lie_poisson::{InstructionSet, MissingInstructions, Se3Dual, Width, dispatch};

/// States of one top. They are advanced in the lanes of the processor's registers, two
/// registers at a time, and each has the bits of its own
/// [`trajectory`](collective_integrators::Start::trajectory) on the same instructions, of AVX2 and of
/// AVX-512 alike; on [`InstructionSet::Portable`] it has others, since nothing is fused there. Steps
/// that do not converge in their lane, for large steps, are made by [`ReducedMidpoint`] from then on.
///
/// # Example
/// Tops with different angular momenta:
/// ```
/// use collective_integrators::Ensemble;
/// use heavytop::{HeavyTop, TopMidpoint};
/// use lie_poisson::Se3Dual;
/// use nalgebra::Vector3;
/// let start = |i: usize| Se3Dual::new(Vector3::new(1.0, 0.1 * i as f64, 2.0), Vector3::z());
/// let mut tops: Vec<_> = (0..20).map(start).collect();
/// tops[7].0.0.x = f64::NAN;
/// let midpoint = Ensemble::new(TopMidpoint::new(HeavyTop::kovalevskaya(1.0, 1.0)?));
/// let failures = midpoint.advance(&mut tops, 0.01, 0..1000);
/// assert!(failures.len() == 1 && failures[0].index == 7 && failures[0].source.step == 1);
/// for (i, mu) in tops.iter().enumerate().filter(|&(i, _)| i != 7) {
///     assert!((mu.0.0.dot(&mu.0.1) - start(i).0.0.z).abs() < 1e-13, "{i}");
/// }
/// # Ok::<(), heavytop::TopError>(())
/// ```
impl BatchIntegrator for TopMidpoint {
    type Member = Se3Dual;

    /// That of [`ReducedMidpoint`].
    type Workspace = ReducedMidpointSpace<HeavyTop>;

    fn workspace(&self) -> Self::Workspace {
        self.general().workspace()
    }

    fn advance(
        &self,
        states: &mut [Se3Dual],
        step: f64,
        steps: Range<u64>,
        space: &mut Self::Workspace,
        failed: &mut dyn FnMut(usize, IntegrationError),
    ) {
        let (top, general) = (*self.top(), self.general());
        let until = steps.end;
        let left = &mut |i: usize, made: u64, state: &mut Se3Dual| {
            if let Err(failure) = go_on(general, state, step, made..until, space) {
                failed(i, failure);
            }
        };
        let task = ManyTops { top: |_: &_| top, members: states, step, steps, left };
        run(task, self.instructions());
    }
}

/// Steps by the formulas for any system.
fn go_on(
    midpoint: &ReducedMidpoint<HeavyTop>,
    state: &mut Se3Dual,
    step: f64,
    steps: Range<u64>,
    space: &mut ReducedMidpointSpace<HeavyTop>,
) -> Result<(), IntegrationError> {
    StepError::check_start(state, step)
        .map_err(|refused| IntegrationError::after(steps.start, step, refused))?;
    midpoint.forget(space);
    for made in steps {
        if made.is_multiple_of(CHECKPOINT) {
            midpoint.forget(space);
        }
        let next = midpoint.step(state, step, space);
        let failure = |source| IntegrationError::after(made, step, source);
        *state = next.map_err(failure)?.point;
    }
    Ok(())
}

/// [`TopMidpoint`] for many tops, each with its own parameters and start: (top, μ).
///
/// # Example
/// Lagrange tops of different moments, with Π₃ conserved:
/// ```
/// use collective_integrators::Ensemble;
/// use heavytop::{HeavyTop, MidpointSweep};
/// use lie_poisson::Se3Dual;
/// use nalgebra::Vector3;
/// let start = Se3Dual::new(Vector3::new(0.3, 0.0, 2.0), Vector3::z());
/// let tops = (1..10).map(|i| HeavyTop::lagrange(1.0, 0.1 * f64::from(i), 1.0));
/// let mut members: Vec<_> = tops.map(|top| Ok((top?, start))).collect::<Result<_, heavytop::TopError>>()?;
/// let sweep = Ensemble::new(MidpointSweep::new());
/// assert!(sweep.advance(&mut members, 0.01, 0..1000).is_empty());
/// assert!(members.iter().all(|(_, mu)| (mu.0.0.z - 2.0).abs() < 1e-12));
/// assert!((members[0].1.0.0.x - members[1].1.0.0.x).abs() > 1e-3);
/// # Ok::<(), heavytop::TopError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MidpointSweep {
    instructions: InstructionSet,
}

impl Default for MidpointSweep {
    fn default() -> Self {
        Self::new()
    }
}

impl MidpointSweep {
    /// On the widest instructions that the processor has.
    #[must_use]
    pub fn new() -> Self {
        Self { instructions: InstructionSet::detected() }
    }

    /// On other instructions.
    ///
    /// # Errors
    /// If the processor lacks them.
    pub fn with_instructions(set: InstructionSet) -> Result<Self, MissingInstructions> {
        if set.is_available() {
            Ok(Self { instructions: set })
        } else {
            Err(MissingInstructions { set })
        }
    }
}

/// As of [`TopMidpoint`]. A member that leaves the lanes takes storage for its steps.
impl BatchIntegrator for MidpointSweep {
    type Member = (HeavyTop, Se3Dual);
    type Workspace = ();

    fn workspace(&self) {}

    fn advance(
        &self,
        members: &mut [(HeavyTop, Se3Dual)],
        step: f64,
        steps: Range<u64>,
        (): &mut (),
        failed: &mut dyn FnMut(usize, IntegrationError),
    ) {
        let until = steps.end;
        let left = &mut |i: usize, made: u64, (top, state): &mut (HeavyTop, Se3Dual)| {
            let midpoint = ReducedMidpoint::new(*top);
            let mut space = midpoint.workspace();
            if let Err(failure) = go_on(&midpoint, state, step, made..until, &mut space) {
                failed(i, failure);
            }
        };
        let top = |member: &(HeavyTop, Se3Dual)| member.0;
        run(ManyTops { top, members, step, steps, left }, self.instructions);
    }
}

impl Member for Se3Dual {
    fn state(&self) -> &Se3Dual {
        self
    }
    fn state_mut(&mut self) -> &mut Se3Dual {
        self
    }
}

impl Member for (HeavyTop, Se3Dual) {
    fn state(&self) -> &Se3Dual {
        &self.1
    }
    fn state_mut(&mut self) -> &mut Se3Dual {
        &mut self.1
    }
}

/// Runs the steps, on instructions that the processor has, as whoever chose them has made sure.
fn run<M: Member, F: Fn(&M) -> HeavyTop>(task: ManyTops<'_, M, F>, set: InstructionSet) {
    match dispatch(task, set, Width::TwoRegisters) {
        Ok(()) | Err(MissingInstructions { .. }) => {}
    }
}
