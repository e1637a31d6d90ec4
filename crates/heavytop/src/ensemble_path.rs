//! What the ensembles of tops have in common.

use collective_integrators::{CHECKPOINT, IntegrationError, Integrator, Start, StepError};
use core::ops::Range;
use lie_poisson::{InstructionSet, LaneTask, MissingInstructions, Se3Dual, Width, dispatch};

/// Where lanes compute.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Place {
    instructions: InstructionSet,
    width: Width,
}

impl Place {
    /// The widest registers of this processor, two at a time.
    pub(crate) fn widest() -> Self {
        Self { instructions: InstructionSet::detected(), width: Width::TwoRegisters }
    }

    /// As asked for, if the processor has it.
    pub(crate) fn new(
        instructions: InstructionSet,
        width: Width,
    ) -> Result<Self, MissingInstructions> {
        if instructions.is_available() {
            Ok(Self { instructions, width })
        } else {
            Err(MissingInstructions { set: instructions })
        }
    }

    pub(crate) fn run<K: LaneTask<Output = ()>>(self, task: K) {
        // `new` has asked the processor, which has not changed: there is no error.
        dispatch(task, self.instructions, self.width).unwrap_or_default();
    }
}

/// The steps between one multiple of [`CHECKPOINT`] and the next.
pub(crate) fn segments(steps: Range<u64>) -> impl Iterator<Item = Range<u64>> {
    let next = move |&Range { end, .. }: &Range<u64>| {
        let checkpoint = (end / CHECKPOINT + 1).saturating_mul(CHECKPOINT);
        (end < steps.end).then(|| end..checkpoint.min(steps.end))
    };
    core::iter::successors(next(&(0..steps.start)), next)
}

/// The state by these steps, or as far as they go.
#[cold]
pub(crate) fn advance_one<I>(
    integrator: &I,
    state: &mut Se3Dual,
    step: f64,
    steps: Range<u64>,
) -> Result<(), IntegrationError>
where
    I: Integrator<State = Se3Dual, Momentum = Se3Dual> + Start,
{
    let mut workspace = integrator.workspace();
    for n in steps {
        let next = integrator.step(state, step, &mut workspace);
        let error =
            |source: StepError| IntegrationError { step: n + 1, time: n as f64 * step, source };
        *state = next.map_err(error)?.point;
    }
    Ok(())
}
