//! The flows of a symmetric top in n steps, merged: [`Flows`].

use crate::kernels::symmetric::drift_polynomials::DriftPolynomials;
use collective_integrators::AlternatingSubsteps;

/// The flows of n steps, with adjacent flows of the same part merged.
///
/// Their sequence is
///
/// ```text
/// drift, [kick, drift, …, kick, drift] × n, kick
/// ```
///
/// The first kick and the last drift of a run are shorter than those of the other steps. Times are fractions
/// of the step.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Flows {
    pub(crate) opening_drift: Option<DriftPolynomials>,
    pub(crate) first_kick: f64,
    /// The pairs of a kick and the drift that follows it.
    pub(crate) pairs: Vec<(f64, DriftPolynomials)>,
    pub(crate) last_drift: DriftPolynomials,
    pub(crate) closing_kick: f64,
    /// The largest squared angle in a step for which all angles are within range.
    pub(crate) limit: f64,
}

impl Flows {
    /// Creates the flows for squared angles up to `range` in a flow and `most` in a step.
    pub(crate) fn new(substeps: &AlternatingSubsteps, range: f64, most: f64) -> Self {
        let (drifts, kicks) = (substeps.first(), substeps.second());
        let following = drifts.iter().skip(1).copied();
        let mut pairs: Vec<(f64, f64)> = kicks.iter().copied().zip(following).collect();
        let opening_drift = drifts.first().copied().unwrap_or(0.0);
        let final_kick = kicks.last().copied().unwrap_or(0.0);
        let first_kick = kicks.first().copied().unwrap_or(0.0);
        let (mut last_drift, mut closing_kick) =
            (drifts.last().copied().unwrap_or(0.0), final_kick);
        match pairs.as_mut_slice() {
            [.., (_, drift)] if final_kick == 0.0 => *drift += opening_drift,
            [(kick, _), ..] if opening_drift == 0.0 => *kick += final_kick,
            _ => {
                pairs.push((final_kick, opening_drift));
                (last_drift, closing_kick) = (0.0, 0.0);
            }
        }
        let times = pairs.iter().map(|&(_, drift)| drift).chain([opening_drift, last_drift]);
        let limit = most.min(range / times.map(|time| time * time).fold(0.0, f64::max));
        let drift = |time: f64| DriftPolynomials::new(time, limit);
        Self {
            opening_drift: (opening_drift != 0.0).then(|| drift(opening_drift)),
            first_kick,
            pairs: pairs.iter().map(|&(kick, time)| (kick, drift(time))).collect(),
            last_drift: drift(last_drift),
            closing_kick,
            limit,
        }
    }
}
