//! Many symmetric tops at once, by splitting.

use crate::SymmetricTopSplitting;
use crate::ensemble_path::{Place, advance_one, segments};
use crate::symmetric_kernel::{Momenta, Parameters, everywhere};
use collective_integrators::{
    AlternatingSplitting, AlternatingSubsteps, BatchIntegrator, IntegrationError,
};
use core::ops::Range;
use lie_poisson::{
    InstructionSet, LaneTask, Lanes, Mask, MissingInstructions, Se3Dual, Vector, Width,
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
/// use collective_integrators::{AlternatingSubsteps, Ensemble, Substeps};
/// use heavytop::{HeavyTop, Invariant, SymmetricTopEnsemble, SymmetricTopSplitting};
/// use lie_poisson::Se3Dual;
/// use nalgebra::Vector3;
/// let top = SymmetricTopSplitting::new(HeavyTop::kovalevskaya(1.0, 1.0)?)?;
/// let start = |i: u32| {
///     Se3Dual::new(Vector3::new(2.0, 3.0, f64::from(i) / 250.0), Vector3::new(0.6, 0.0, 0.8))
/// };
/// let mut tops: Vec<_> = (0..1000).map(|i| (top, start(i))).collect();
/// let substeps = AlternatingSubsteps::composed(&Substeps::sofroniou_spaletta10());
/// let ensemble = Ensemble::new(SymmetricTopEnsemble::new(substeps));
/// assert!(ensemble.advance(&mut tops, 0.2, 0..50).is_empty());
/// let energy = |mu: &Se3Dual| Invariant::Energy.value(top.top(), mu);
/// for (i, (_, mu)) in (0..).zip(&tops) {
///     assert!((energy(mu) - energy(&start(i))).abs() < 1e-11);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SymmetricTopEnsemble {
    substeps: AlternatingSubsteps,
    flows: Flows,
    place: Place,
}

impl SymmetricTopEnsemble {
    /// The splitting with these coefficients, on the widest lanes that the processor has.
    #[must_use]
    pub fn new(substeps: AlternatingSubsteps) -> Self {
        Self { flows: Flows::new(&substeps), substeps, place: Place::widest() }
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
        Ok(Self { place: Place::new(instructions, width)?, ..self })
    }
}

/// Runs in several calls that meet at multiples of [`CHECKPOINT`](collective_integrators::CHECKPOINT)
/// have the bits of one run; others differ by rounding.
impl BatchIntegrator for SymmetricTopEnsemble {
    type Member = (SymmetricTopSplitting, Se3Dual);

    /// The members that have failed.
    type Workspace = Vec<usize>;

    fn workspace(&self) -> Vec<usize> {
        Vec::new()
    }

    fn advance(
        &self,
        members: &mut [(SymmetricTopSplitting, Se3Dual)],
        step: f64,
        steps: Range<u64>,
        lost: &mut Vec<usize>,
        failed: &mut dyn FnMut(usize, IntegrationError),
    ) {
        let flows = &self.flows;
        lost.clear();
        for steps in segments(steps) {
            let alone = |index: usize, (top, state): &mut (SymmetricTopSplitting, Se3Dual)| {
                let integrator = AlternatingSplitting::new(*top, self.substeps.clone());
                let ended = advance_one(&integrator, state, step, steps.clone());
                ended.map_err(|error| failed(index, error)).is_ok()
            };
            let count = steps.end - steps.start;
            let lost = &mut *lost;
            self.place.run(Advance { flows, members, step, count, lost, alone });
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

/// All members on lanes; `alone` advances those that the lanes cannot.
struct Advance<'a, F> {
    flows: &'a Flows,
    members: &'a mut [(SymmetricTopSplitting, Se3Dual)],
    step: f64,
    count: u64,
    /// The indices of those that have failed.
    lost: &'a mut Vec<usize>,
    alone: F,
}

impl<F: FnMut(usize, &mut (SymmetricTopSplitting, Se3Dual)) -> bool> LaneTask for Advance<'_, F> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        let Self { flows, members, step, count, lost, mut alone } = self;
        for (n, group) in members.chunks_mut(T::COUNT).enumerate() {
            let last = group.len() - 1;
            let top = Parameters::<T>::from_lanes(|i| &group[i.min(last)].0);
            let mut momenta = Momenta::<T>::from_lanes(|i| &group[i.min(last)].1);
            let settled = advance(&mut momenta, &top, flows, step, count);
            for (i, member) in group.iter_mut().enumerate() {
                let (index, end) = (n * T::COUNT + i, momenta.lane(i));
                if lost.contains(&index) {
                    // It stays where it was.
                } else if settled.lane(i) && end.is_finite() {
                    member.1 = end;
                } else if !alone(index, member) {
                    lost.push(index);
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
