//! Stages side by side, for tops: the Casimirs.

use super::kinds::Kind;
use super::schemes::{scheme, steps_hold};
use crate::input::Input;
use crate::targets::conservation::top_holds;
use crate::targets::one_step::top;
use collective_integrators::{
    Collective, Composition, Direct, FieldInLanes, HamiltonianField, LiftFree, RungeKutta,
    StagesInLanes, Start, Substeps,
};
use heavytop::{HeavyTop, SpinorRealisation};
use lie_poisson::generic_scalars::InstructionSet;
use lie_poisson::{LiePoisson, Se3, Se3Dual};
use momentum_map::DualQuaternions;

pub(super) const KINDS: &[Kind] = &[
    ("StagesInLanes<Collective>", |input| collective(input, |lanes, case| holds(&lanes, case))),
    ("Compensated<StagesInLanes<Collective>>", |input| {
        collective(input, |lanes, case| holds(&lanes.compensated(), case))
    }),
    ("StagesInLanes<LiftFree>", |input| lift_free(input, |lanes, case| holds(&lanes, case))),
    ("Compensated<StagesInLanes<LiftFree>>", |input| {
        lift_free(input, |lanes, case| holds(&lanes.compensated(), case))
    }),
    ("StagesInLanes<Direct>", direct),
    ("StagesInLanes of a composition", composed),
];

/// A run of a top.
struct Case {
    top: HeavyTop,
    start: Se3Dual,
    step: f64,
    conserves: bool,
}

impl Case {
    fn new(input: &mut Input<'_>, conserves: bool) -> Option<Self> {
        let symmetric = input.choice(2) == 1;
        let top = top(input, symmetric)?;
        let start = Se3Dual::new(input.vector(), input.vector());
        Some(Self { top, start, step: input.number(), conserves })
    }
}

fn holds<I: Start<Momentum = Se3Dual>>(integrator: &I, case: &Case) -> bool {
    let Case { top, start, step, conserves } = case;
    steps_hold(integrator, start, *step, |before, after| {
        top_holds(&"stages side by side", top, [before, &after.momentum], *step, *conserves)
            && *conserves
    })
}

/// Returns the integrator on some instruction set of the processor.
fn lanes<I: FieldInLanes>(input: &mut Input<'_>, integrator: I) -> Option<StagesInLanes<I>> {
    let sets: Vec<_> = InstructionSet::available().collect();
    let set = *sets.get(input.choice(sets.len()))?;
    StagesInLanes::new(integrator).with_instructions(set).ok()
}

fn collective(
    input: &mut Input<'_>,
    holds: impl Fn(StagesInLanes<Collective<RungeKutta, SpinorRealisation, HeavyTop>>, &Case) -> bool,
) -> bool {
    let (scheme, conserves) = scheme(input);
    let Some(case) = Case::new(input, conserves) else { return false };
    let collective = Collective::new(scheme, SpinorRealisation, case.top);
    lanes(input, collective).is_some_and(|lanes| holds(lanes, &case))
}

fn lift_free(
    input: &mut Input<'_>,
    holds: impl Fn(StagesInLanes<LiftFree<RungeKutta, DualQuaternions, HeavyTop>>, &Case) -> bool,
) -> bool {
    let (scheme, conserves) = scheme(input);
    let Some(case) = Case::new(input, conserves) else { return false };
    let lift_free = LiftFree::new(scheme, DualQuaternions, case.top);
    lanes(input, lift_free).is_some_and(|lanes| holds(lanes, &case))
}

fn direct(input: &mut Input<'_>) -> bool {
    let (scheme, _) = scheme(input);
    // As in `one_step`, direct methods, which are no Poisson maps, are judged by finite numbers alone.
    let Some(case) = Case::new(input, false) else { return false };
    let space = LiePoisson::minus(Se3::default());
    let direct = Direct::new(scheme, HamiltonianField { space, hamiltonian: case.top });
    lanes(input, direct).is_some_and(|lanes| holds(&lanes, &case))
}

fn composed(input: &mut Input<'_>) -> bool {
    let (scheme, conserves) = scheme(input);
    let Some(case) = Case::new(input, conserves) else { return false };
    let composition = Composition::new(scheme, Substeps::yoshida4());
    let collective = Collective::new(composition, SpinorRealisation, case.top);
    lanes(input, collective).is_some_and(|lanes| holds(&lanes, &case))
}
