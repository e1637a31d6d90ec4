//! Many symmetric tops at once, by splitting.

use crate::SymmetricTopSplitting;
use crate::ensemble_path::advance_one;
use crate::symmetric_kernel::{Momenta, Parameters, everywhere};
use collective_integrators::{AlternatingSplitting, AlternatingSubsteps, IntegrationError};
use lie_poisson::{
    InstructionSet, LaneTask, Lanes, Mask, MissingInstructions, Se3Dual, Vector, Width, dispatch,
};

/// Many tops with I₁ = I₂, advanced side by side in the lanes of the processor's registers.
///
/// One step is that of [`AlternatingSplitting`] over [`SymmetricTopSplitting`], to round-off: sine
/// and cosine are polynomials here, and where a step ends with the part with which the next one
/// begins, the two flows are one, so that n steps in one call and n calls differ by rounding. A top
/// that leaves the range of the polynomials (it turns by more than √2 rad in one flow), or is not
/// finite, goes through that integrator instead, and fails where it fails.
///
/// What becomes of a top does not depend on the others, nor on the number of lanes: it has the same
/// bits at every [`Width`], and on all instruction sets that fuse products with sums; those of
/// [`InstructionSet::Portable`], which does not, differ by rounding.
///
/// # Example
/// A thousand of Kovalevskaya's tops, at round-off accuracy:
/// ```
/// use collective_integrators::{AlternatingSubsteps, Substeps};
/// use heavytop::{HeavyTop, Invariant, SymmetricTopEnsemble, SymmetricTopSplitting};
/// use lie_poisson::Se3Dual;
/// use nalgebra::Vector3;
/// let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
/// let start = |i: u32| {
///     Se3Dual::new(Vector3::new(2.0, 3.0, f64::from(i) / 250.0), Vector3::new(0.6, 0.0, 0.8))
/// };
/// let mut tops: Vec<Se3Dual> = (0..1000).map(start).collect();
/// let substeps = AlternatingSubsteps::composed(&Substeps::sofroniou_spaletta10());
/// let ensemble = SymmetricTopEnsemble::new(&[SymmetricTopSplitting::new(top)?], &substeps);
/// ensemble.advance(&mut tops, 0.25, 40, &mut |index, error| panic!("{index}: {error}"));
/// for (i, mu) in (0..).zip(&tops) {
///     let change = Invariant::Energy.value(&top, mu) - Invariant::Energy.value(&top, &start(i));
///     assert!(change.abs() < 1e-12);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SymmetricTopEnsemble {
    tops: Vec<SymmetricTopSplitting>,
    substeps: AlternatingSubsteps,
    flows: Flows,
    instructions: InstructionSet,
    width: Width,
}

impl SymmetricTopEnsemble {
    /// The tops, repeated as often as there are states: one for all of them, or one for each.
    /// Without any, nothing is advanced.
    #[must_use]
    pub fn new(tops: &[SymmetricTopSplitting], substeps: &AlternatingSubsteps) -> Self {
        Self {
            tops: tops.to_vec(),
            substeps: substeps.clone(),
            flows: Flows::new(substeps),
            instructions: InstructionSet::detected(),
            width: Width::TwoRegisters,
        }
    }

    /// The same on the given instructions and width; without this call, on the widest there are.
    ///
    /// # Errors
    /// If the processor lacks the instructions.
    pub fn on(
        self,
        instructions: InstructionSet,
        width: Width,
    ) -> Result<Self, MissingInstructions> {
        if instructions.is_available() {
            Ok(Self { instructions, width, ..self })
        } else {
            Err(MissingInstructions { set: instructions })
        }
    }

    /// Every state by `steps` steps of length `step`. `failure` is told the index of each state that
    /// has no result; the state is left where its last good step ended.
    pub fn advance(
        &self,
        states: &mut [Se3Dual],
        step: f64,
        steps: u64,
        failure: &mut impl FnMut(usize, IntegrationError),
    ) {
        if self.tops.is_empty() || steps == 0 {
            return;
        }
        let mut one = |index: usize, state: &mut Se3Dual| {
            let flows = self.tops[index % self.tops.len()];
            let integrator = AlternatingSplitting::new(flows, self.substeps.clone());
            if let Err(error) = advance_one(&integrator, state, step, steps) {
                failure(index, error);
            }
        };
        let Self { tops, flows, .. } = self;
        let task = Advance { tops, flows, states, step, steps, one: &mut one };
        if let Err(MissingInstructions { .. }) = dispatch(task, self.instructions, self.width) {
            // `on` has asked the processor; it has not changed.
        }
    }
}

/// The flows of n steps, neighbours of the same part made one:
///
/// ```text
/// drift, [kick, drift, …, kick, drift] × n, kick
/// ```
///
/// The first kick and the last drift of all are shorter than those of the other steps.
#[derive(Clone, Debug, PartialEq)]
struct Flows {
    opening_drift: f64,
    first_kick: f64,
    /// Kick, then drift.
    pairs: Vec<(f64, f64)>,
    last_drift: f64,
    closing_kick: f64,
}

impl Flows {
    fn new(substeps: &AlternatingSubsteps) -> Self {
        let (drifts, kicks) = (substeps.first(), substeps.second());
        let following = drifts.iter().skip(1).copied();
        let mut pairs: Vec<(f64, f64)> = kicks.iter().copied().zip(following).collect();
        let opening_drift = drifts.first().copied().unwrap_or(0.0);
        let final_kick = kicks.last().copied().unwrap_or(0.0);
        let first_kick = kicks.first().copied().unwrap_or(0.0);
        let mut flows = Self {
            opening_drift,
            first_kick,
            pairs: Vec::new(),
            last_drift: drifts.last().copied().unwrap_or(0.0),
            closing_kick: final_kick,
        };
        match pairs.as_mut_slice() {
            [.., (_, drift)] if final_kick == 0.0 => *drift += opening_drift,
            [(kick, _), ..] if opening_drift == 0.0 => *kick += final_kick,
            _ => {
                pairs.push((final_kick, opening_drift));
                (flows.last_drift, flows.closing_kick) = (0.0, 0.0);
            }
        }
        flows.pairs = pairs;
        flows
    }
}

/// All states on lanes; `one` advances what the lanes cannot.
struct Advance<'a, F> {
    tops: &'a [SymmetricTopSplitting],
    flows: &'a Flows,
    states: &'a mut [Se3Dual],
    step: f64,
    steps: u64,
    one: &'a mut F,
}

impl<F: FnMut(usize, &mut Se3Dual)> LaneTask for Advance<'_, F> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        let Self { tops, flows, states, step, steps, one } = self;
        for (n, group) in states.chunks_mut(T::COUNT).enumerate() {
            let first = n * T::COUNT;
            let last = group.len() - 1;
            let top = Parameters::<T>::from_lanes(|i| &tops[(first + i.min(last)) % tops.len()]);
            let mut momenta = Momenta::<T>::from_lanes(|i| &group[i.min(last)]);
            let settled = advance(&mut momenta, &top, flows, step, steps);
            for (i, state) in group.iter_mut().enumerate() {
                let end = momenta.lane(i);
                if settled.lane(i) && end.is_finite() {
                    *state = end;
                } else {
                    one(first + i, state);
                }
            }
        }
    }
}

/// n steps of a group, and in which lanes all flows were in range.
#[inline(always)]
fn advance<T: Lanes>(
    momenta: &mut Momenta<T>,
    top: &Parameters<T>,
    flows: &Flows,
    step: f64,
    steps: u64,
) -> T::Mask {
    let mut settled = everywhere::<T>();
    if flows.opening_drift != 0.0 {
        settled = settled.and(momenta.drift(top, flows.opening_drift * step));
    }
    for n in 1..=steps {
        for (i, &(kick, drift)) in flows.pairs.iter().enumerate() {
            let kick = if n == 1 && i == 0 { flows.first_kick } else { kick };
            let last = n == steps && i + 1 == flows.pairs.len();
            let drift = if last { flows.last_drift } else { drift };
            momenta.kick(top, kick * step);
            settled = settled.and(momenta.drift(top, drift * step));
        }
    }
    if flows.closing_kick != 0.0 {
        momenta.kick(top, flows.closing_kick * step);
    }
    settled
}
