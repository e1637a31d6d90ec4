//! What the ensembles of tops have in common.

use collective_integrators::{CHECKPOINT, IntegrationError, Integrator, Start, StepError};
use core::ops::Range;
use lie_poisson::{
    InstructionSet, LaneTask, Lanes, MissingInstructions, Se3Dual, Vector, Width, dispatch,
};

/// As many lanes as the widest type has.
pub(crate) const MOST_LANES: usize = 16;

/// Tops side by side in lanes, each with an integrator to fall back on.
pub(crate) trait LaneKernel {
    /// The parameters of a top.
    type Top;

    /// Where `count` steps lead a group of at most `COUNT` tops, of which there is one at least;
    /// none where the lanes cannot tell. Mark it `#[inline(always)]`, see [`LaneTask`].
    fn ends<T: Lanes>(
        &self,
        group: &[(Self::Top, Se3Dual)],
        step: f64,
        count: u64,
    ) -> [Option<Se3Dual>; MOST_LANES];

    /// The integrator of one top.
    fn alone(&self, top: &Self::Top) -> impl Start<State = Se3Dual, Momentum = Se3Dual>;
}

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

    /// Advances the members, as [`BatchIntegrator`](collective_integrators::BatchIntegrator) asks.
    pub(crate) fn advance<K: LaneKernel>(
        self,
        kernel: &K,
        members: &mut [(K::Top, Se3Dual)],
        step: f64,
        steps: Range<u64>,
        failed: &mut dyn FnMut(usize, IntegrationError),
    ) {
        let task = Advance { kernel, members, step, steps, failed };
        // `new` has asked the processor, which has not changed: there is no error.
        dispatch(task, self.instructions, self.width).unwrap_or_default();
    }
}

/// All members, group by group, on lanes where these can tell their ends.
struct Advance<'a, K: LaneKernel> {
    kernel: &'a K,
    members: &'a mut [(K::Top, Se3Dual)],
    step: f64,
    steps: Range<u64>,
    failed: &'a mut dyn FnMut(usize, IntegrationError),
}

impl<K: LaneKernel> LaneTask for Advance<'_, K> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        let Self { kernel, members, step, steps, failed } = self;
        for (n, group) in members.chunks_mut(T::COUNT).enumerate() {
            let mut lost = [false; MOST_LANES];
            for steps in segments(steps.clone()) {
                let ends = kernel.ends::<T>(group, step, steps.end - steps.start);
                for (i, ((top, state), end)) in group.iter_mut().zip(ends).enumerate() {
                    if lost[i] {
                        continue; // It stays where it was.
                    }
                    if let Some(end) = end.filter(Vector::is_finite) {
                        *state = end;
                    } else if let Err(error) =
                        advance_one(&kernel.alone(top), state, step, steps.clone())
                    {
                        lost[i] = true;
                        failed(n * T::COUNT + i, error);
                    }
                }
            }
        }
    }
}

/// The steps between one multiple of [`CHECKPOINT`] and the next.
fn segments(steps: Range<u64>) -> impl Iterator<Item = Range<u64>> {
    let next = move |&Range { end, .. }: &Range<u64>| {
        let checkpoint = (end / CHECKPOINT + 1).saturating_mul(CHECKPOINT);
        (end < steps.end).then(|| end..checkpoint.min(steps.end))
    };
    core::iter::successors(next(&(0..steps.start)), next)
}

/// The state by these steps, or as far as they go.
#[cold]
fn advance_one<I>(
    integrator: &I,
    state: &mut Se3Dual,
    step: f64,
    steps: Range<u64>,
) -> Result<(), IntegrationError>
where
    I: Integrator<State = Se3Dual, Momentum = Se3Dual> + Start,
{
    StepError::check_start(state, step)
        .map_err(|refused| IntegrationError::after(steps.start, step, refused))?;
    let mut workspace = integrator.workspace();
    for made in steps {
        let next = integrator.step(state, step, &mut workspace);
        *state = next.map_err(|source| IntegrationError::after(made, step, source))?.point;
    }
    Ok(())
}
