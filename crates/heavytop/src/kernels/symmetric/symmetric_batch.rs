//! Splittings of many symmetric tops at once.

use crate::kernels::symmetric::flows::Flows;
use crate::kernels::symmetric::steps::{FlowParameters, MomentumLanes};
use crate::splittings::symmetric_top::SymmetricTopSplitting;
use collective_integrators::{
    AlternatingSubsteps, BatchIntegrator, IntegrationError, Integrator, LaneKernel, LaneResults,
    MOST_LANES, Registers, Splitting,
};
use core::ops::Range;
use lie_poisson::{
    Covector, InstructionSet, Lanes, Mask, MissingInstructions, Pair, Se3Dual, State, Width,
};

/// The largest squared angles, rad², of a flow and of a step, for the longest polynomials.
const LONG: [f64; 2] = [2.0, f64::INFINITY];

/// The largest squared angles, rad², of a flow and of a step, for shorter polynomials.
///
/// Practical step sizes are within this range. If only some tops of a group are within it, each of the two passes
/// computes all of them.
const SHORT: [f64; 2] = [0.7, 1.7];

/// The alternating splitting of many tops with I₁ = I₂, with separate parameters per top.
///
/// The tops are advanced in the SIMD lanes of the processor's registers. Each lane holds one top, so a register
/// advances several trajectories.
///
/// One step is that of an alternating [`Splitting`] over [`SymmetricTopSplitting`], to round-off. Sine and cosine are
/// polynomials here. If a step ends with the part with which the next one begins, the two flows are merged, so that n
/// steps in one call and one step in each of n calls differ by rounding. A top that leaves the range of the polynomials
/// (it turns by more than √2 rad in one flow), or is not finite, is advanced by the [`Splitting`] instead, and fails if
/// that integrator fails. A top that turns by less than 1.3 rad in a step has shorter polynomials, and is a tenth
/// faster.
///
/// Rounding causes a random walk of |Γ|² and Γ·Π. The mean over many tops does not drift: the mean of |Γ|² changes by
/// less than 1e-19 of its size per step, also at steps of 1/5. In a flow by more than 1.2 rad, changes of up to 4e-17
/// are possible.
///
/// The result for a top depends neither on the others nor on the number of lanes. It is bit-identical at every
/// [`Width`], and on all instruction sets that fuse products with sums. [`InstructionSet::Portable`] does not fuse
/// them, and its results differ by rounding.
///
/// Source: the splitting is that of [`SymmetricTopSplitting`], the fractions are those of [`AlternatingSubsteps`].
///
/// # Example
/// A thousand of Kovalevskaya's tops, at round-off accuracy:
/// ```
/// use collective_integrators::{AlternatingSubsteps, Ensemble, Substeps};
/// use heavytop::{HeavyTop, Invariant, SymmetricTopBatch, SymmetricTopSplitting};
/// use lie_poisson::Se3Dual;
/// use nalgebra::Vector3;
/// let top = SymmetricTopSplitting::new(HeavyTop::kovalevskaya(1.0, 1.0)?)?;
/// let start = |i: u32| {
///     Se3Dual::new(Vector3::new(2.0, 3.0, f64::from(i) / 250.0), Vector3::new(0.6, 0.0, 0.8))
/// };
/// let mut tops: Vec<_> = (0..1000).map(|i| (top, start(i))).collect();
/// let substeps = AlternatingSubsteps::composed(&Substeps::sofroniou_spaletta10());
/// let ensemble = Ensemble::new(SymmetricTopBatch::new(substeps));
/// assert!(ensemble.advance(&mut tops, 0.2, 0..50).is_empty());
/// let energy = |mu: &Se3Dual| Invariant::Energy.value(top.top(), mu);
/// for (i, (_, mu)) in (0..).zip(&tops) {
///     assert!((energy(mu) - energy(&start(i))).abs() < 1e-11);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SymmetricTopBatch {
    substeps: AlternatingSubsteps,
    short: Flows,
    long: Flows,
    registers: Registers,
}

impl SymmetricTopBatch {
    /// Creates the splitting with these coefficients, on the widest registers that the processor has.
    #[must_use]
    pub fn new(substeps: AlternatingSubsteps) -> Self {
        let [short, long] = [SHORT, LONG].map(|[flow, step]| Flows::new(&substeps, flow, step));
        Self { short, long, substeps, registers: Registers::widest() }
    }

    /// Replaces the instruction set and the width of the registers.
    ///
    /// # Errors
    /// Returns [`MissingInstructions`] if the processor lacks the instructions.
    pub fn on(
        self,
        instructions: InstructionSet,
        width: Width,
    ) -> Result<Self, MissingInstructions> {
        Ok(Self { registers: Registers::new(instructions, width)?, ..self })
    }
}

/// A run in several calls that meet at multiples of [`CHECKPOINT`](collective_integrators::CHECKPOINT) is bit-identical
/// to a run in one call. If the calls meet elsewhere, the results differ by rounding.
impl BatchIntegrator for SymmetricTopBatch {
    type Member = (SymmetricTopSplitting, Se3Dual);
    type Workspace = ();

    fn workspace(&self) {}

    fn advance(
        &self,
        members: &mut [(SymmetricTopSplitting, Se3Dual)],
        step: f64,
        steps: Range<u64>,
        (): &mut (),
        failed: &mut dyn FnMut(usize, IntegrationError),
    ) {
        self.registers.advance(self, members, step, steps, failed);
    }
}

impl LaneKernel for SymmetricTopBatch {
    type Member = (SymmetricTopSplitting, Se3Dual);

    #[cfg_attr(optimised, inline(always))]
    fn together<T: Lanes>(
        &self,
        group: &mut [(SymmetricTopSplitting, Se3Dual)],
        step: f64,
        count: u64,
    ) -> LaneResults {
        let last = group.len() - 1;
        let top = FlowParameters::<T>::from_lanes(step, |i| &group[i.min(last)].0);
        let start = MomentumLanes::<T>::from_lanes(&top, |i| &group[i.min(last)].1);
        let mut in_range = [false; MOST_LANES];
        group.iter().zip(&mut in_range).for_each(|(member, is)| *is = is_in_range(member, step));
        let within = |flows: &Flows, square: T| square.at_most(T::from_f64(flows.limit));
        let mut results = LaneResults::default();
        let short = within(&self.short, top.bound(&start));
        let mut finished = T::Mask::from_bool(false);
        for (flows, chosen) in [(&self.short, short), (&self.long, T::Mask::from_bool(true))] {
            let due = chosen.and(finished.not());
            if due.any() {
                let mut motion = start;
                advance(&mut motion, &top, flows, count);
                let done = due.and(within(flows, motion.largest));
                let momenta = motion.momenta(&top);
                for (i, (_, state)) in group.iter_mut().enumerate() {
                    if done.lane(i) && in_range[i] {
                        *state = momenta(i);
                        results[i] = state.is_finite();
                    }
                }
                finished = finished.or(done);
            }
        }
        results
    }

    fn alone(
        &self,
        (top, state): &mut (SymmetricTopSplitting, Se3Dual),
        step: f64,
        steps: Range<u64>,
    ) -> Result<(), IntegrationError> {
        let integrator = Splitting::alternating(*top, self.substeps.clone());
        let workspace = &mut Integrator::<f64>::workspace(&integrator);
        integrator.advance(state, step, steps, workspace).map(drop)
    }
}

/// Returns whether hΠ/I₁ and (h/I₁)², the numbers with which the flows compute, keep their digits.
fn is_in_range((top, Covector(Pair(pi, _))): &(SymmetricTopSplitting, Se3Dual), step: f64) -> bool {
    const LEAST: f64 = 1e-140;
    let factor = (step / top.top().inertia().x).abs();
    let turn = factor * pi.amax();
    factor >= LEAST && (turn >= LEAST || turn == 0.0 && pi.amax() == 0.0)
}

/// Advances a group by n steps.
#[cfg_attr(optimised, inline(always))]
fn advance<T: Lanes>(
    motion: &mut MomentumLanes<T>,
    top: &FlowParameters<T>,
    flows: &Flows,
    steps: u64,
) {
    if let Some(drift) = &flows.opening_drift {
        motion.drift(top, drift);
    }
    for n in 1..=steps {
        for (i, (kick, drift)) in flows.pairs.iter().enumerate() {
            let kick = if n == 1 && i == 0 { flows.first_kick } else { *kick };
            let last = n == steps && i + 1 == flows.pairs.len();
            let drift = if last { &flows.last_drift } else { drift };
            motion.kick(top, kick);
            motion.drift(top, drift);
        }
    }
    if flows.closing_kick != 0.0 {
        motion.kick(top, flows.closing_kick);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tops::top::HeavyTop;
    use nalgebra::Vector3;

    /// Returns the end of one top by these flows, if it stays within their range.
    fn end(
        flows: &Flows,
        member: &(SymmetricTopSplitting, Se3Dual),
        step: f64,
    ) -> (bool, Option<Se3Dual>) {
        let top = FlowParameters::<f64>::from_lanes(step, |_| &member.0);
        let mut motion = MomentumLanes::from_lanes(&top, |_| &member.1);
        let expected = top.bound(&motion) <= flows.limit;
        advance(&mut motion, &top, flows, STEPS);
        let stays = motion.largest <= flows.limit;
        (expected, stays.then(|| motion.momenta(&top)(0)))
    }

    const STEPS: u64 = 20;

    /// The choice of polynomials depends on the top alone. This holds also where its energy, which such large
    /// kicks do not conserve, made it begin with the short ones in vain.
    #[test]
    fn polynomials_are_chosen_top_by_top() -> Result<(), Box<dyn std::error::Error>> {
        let substeps = AlternatingSubsteps::new(&[0.5, 0.5], &[4.0, -3.0])?;
        let ensemble =
            SymmetricTopBatch::new(substeps).on(InstructionSet::Portable, Width::TwoRegisters)?;
        let flows = SymmetricTopSplitting::new(HeavyTop::kovalevskaya(1.0, 1.0)?)?;
        let member = |i: u32| {
            let (x, turn) = (0.25 * f64::from(i), f64::from(i * i));
            let gamma = Vector3::new(turn.cos(), 0.0, turn.sin());
            (flows, Se3Dual::new(Vector3::new(0.3, x, 0.1 * x), gamma))
        };
        let members: Vec<_> = (0..64).map(member).collect();
        let step = 0.4;
        let mut ends = members.clone();
        let mut failures = 0;
        ensemble.advance(&mut ends, step, 0..STEPS, &mut (), &mut |_, _| failures += 1);
        let (mut short, mut left, mut long, mut alone) = (0, 0, 0, 0);
        for (member, (_, found)) in members.iter().zip(&ends) {
            let (begins, by_short) = end(&ensemble.short, member, step);
            let (_, by_long) = end(&ensemble.long, member, step);
            let by_short = by_short.filter(|_| begins);
            match (by_short, by_long) {
                (Some(_), _) => short += 1,
                (None, Some(_)) if begins => left += 1,
                (None, Some(_)) => long += 1,
                (None, None) => alone += 1,
            }
            if let Some(expected) = by_short.or(by_long) {
                assert_eq!(*found, expected);
            }
        }
        assert!(short > 0 && left > 0 && long > 0 && alone > 0, "{short} {left} {long} {alone}");
        assert_eq!(failures, 0);
        Ok(())
    }

    #[test]
    fn numbers_that_lose_digits_are_out_of_range() -> Result<(), Box<dyn std::error::Error>> {
        let flows = SymmetricTopSplitting::new(HeavyTop::kovalevskaya(0.5, 1.0)?)?;
        let within = |momentum: f64, step: f64| {
            is_in_range(&(flows, Se3Dual::new(Vector3::x() * momentum, Vector3::z())), step)
        };
        for (momentum, step, expected) in [
            (1.0, 0.1, true),
            (0.0, 0.1, true),
            (-1.0, -0.1, true),
            (1e-200, 0.1, false),
            (1.0, 1e-200, false),
            (1e100, 1e-200, false),
            (0.0, 1e-200, false),
        ] {
            assert_eq!(within(momentum, step), expected, "{momentum:e} {step:e}");
        }
        Ok(())
    }
}
