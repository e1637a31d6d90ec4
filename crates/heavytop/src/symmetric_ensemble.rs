//! Many symmetric tops at once, by splitting.

use crate::SymmetricTopSplitting;
use crate::ensemble_path::{LaneKernel, MOST_LANES, Place};
use crate::symmetric_kernel::{Momenta, Parameters, everywhere};
use collective_integrators::{
    AlternatingSplitting, AlternatingSubsteps, BatchIntegrator, IntegrationError, Start,
};
use core::ops::Range;
use lie_poisson::{InstructionSet, Lanes, Mask, MissingInstructions, Se3Dual, Width};

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
        self.place.advance(self, members, step, steps, failed);
    }
}

impl LaneKernel for SymmetricTopEnsemble {
    type Top = SymmetricTopSplitting;

    #[inline(always)]
    fn ends<T: Lanes>(
        &self,
        group: &[(SymmetricTopSplitting, Se3Dual)],
        step: f64,
        count: u64,
    ) -> [Option<Se3Dual>; MOST_LANES] {
        let last = group.len() - 1;
        let top = Parameters::<T>::from_lanes(|i| &group[i.min(last)].0);
        let mut momenta = Momenta::<T>::from_lanes(|i| &group[i.min(last)].1);
        let settled = advance(&mut momenta, &top, &self.flows, step, count);
        let mut ends = [None; MOST_LANES];
        for (i, end) in ends.iter_mut().enumerate().take(group.len()) {
            if settled.lane(i) {
                *end = Some(momenta.lane(i));
            }
        }
        ends
    }

    fn alone(
        &self,
        top: &SymmetricTopSplitting,
    ) -> impl Start<State = Se3Dual, Momentum = Se3Dual> {
        AlternatingSplitting::new(*top, self.substeps.clone())
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
