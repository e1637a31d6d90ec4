//! The times of a symmetric top's flows, and polynomials for their sines.

use crate::kernels::symmetric::stumpff_polynomials::{STUMPFF, StumpffPolynomials};
use collective_integrators::AlternatingSubsteps;
use lie_poisson::Lanes;

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
        let mut pairs: Vec<_> = pairs.iter().map(|&(kick, time)| (kick, drift(time))).collect();
        diffuse(&mut pairs);
        Self {
            opening_drift: (opening_drift != 0.0).then(|| drift(opening_drift)),
            first_kick,
            pairs,
            last_drift: drift(last_drift),
            closing_kick,
            limit,
        }
    }
}

/// Rounds the coefficients c²/2 of a step so that their sum is correct: each rounding error is added to the
/// next, smaller coefficient.
///
/// This error of the cosine makes a flow stretch the vectors that it rotates. With c²/2 rounded to nearest
/// the stretches of all flows of a step add up to about 1e-17, which exceeds the random walk of the other
/// rounding errors within 10⁵ steps.
fn diffuse(pairs: &mut [(f64, DriftPolynomials)]) {
    let mut order: Vec<&mut DriftPolynomials> = pairs.iter_mut().map(|(_, drift)| drift).collect();
    order.sort_by(|a, b| b.sine[0].abs().total_cmp(&a.sine[0].abs()));
    let mut lost = 0.0;
    for drift in order {
        let c = drift.sine[0];
        let square = c * c;
        let rest = 0.5 * c.mul_add(c, -square) + lost;
        drift.versine[0] = 0.5 * square + rest;
        lost = (0.5 * square - drift.versine[0]) + rest;
    }
}

/// The polynomials of a drift for the fraction c of a step: c c₁ and c²c₂ at c²x, in terms of x.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct DriftPolynomials {
    /// The number of coefficients of `versine`; `sine` has one more.
    terms: usize,
    sine: [f64; 9],
    versine: [f64; 8],
}

impl DriftPolynomials {
    /// Creates the shortest polynomials that suffice for x up to `limit`.
    fn new(c: f64, limit: f64) -> Self {
        let square = c * c;
        let will_do = |p: &&StumpffPolynomials| square * limit <= p.range;
        let [longest, ..] = &STUMPFF;
        let polynomials = STUMPFF.iter().rev().find(will_do).unwrap_or(longest);
        let mut drift = Self { terms: polynomials.second.len(), sine: [0.0; 9], versine: [0.0; 8] };
        let mut power = c;
        for (scaled, coefficient) in drift.sine.iter_mut().zip(polynomials.first) {
            *scaled = power * coefficient;
            power *= square;
        }
        let mut power = square;
        for (scaled, coefficient) in drift.versine.iter_mut().zip(polynomials.second) {
            *scaled = power * coefficient;
            power *= square;
        }
        drift
    }

    /// Returns the pairs (c c₁, c²c₂) at c²x and at c²y.
    #[inline(always)]
    pub(crate) fn sines_and_versines<T: Lanes>(&self, x: T, y: T) -> ((T, T), (T, T)) {
        match self.terms {
            4 => (self.at::<T, 4>(x), self.at::<T, 4>(y)),
            5 => (self.at::<T, 5>(x), self.at::<T, 5>(y)),
            6 => (self.at::<T, 6>(x), self.at::<T, 6>(y)),
            7 => (self.at::<T, 7>(x), self.at::<T, 7>(y)),
            _ => (self.at::<T, 8>(x), self.at::<T, 8>(y)),
        }
    }

    /// Evaluates both polynomials at x by Horner's rule.
    #[inline(always)]
    fn at<T: Lanes, const TERMS: usize>(&self, x: T) -> (T, T) {
        let mut sine = T::from_f64(self.sine[TERMS]);
        let mut versine = T::from_f64(self.versine[TERMS - 1]);
        for k in (0..TERMS).rev() {
            sine = sine.multiply_add(x, T::from_f64(self.sine[k]));
            if k + 1 < TERMS {
                versine = versine.multiply_add(x, T::from_f64(self.versine[k]));
            }
        }
        (sine, versine)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use collective_integrators::Substeps;
    use lie_poisson::Real;

    fn sets() -> [AlternatingSubsteps; 3] {
        [
            AlternatingSubsteps::blanes_moan4(),
            AlternatingSubsteps::blanes_moan6(),
            AlternatingSubsteps::composed(&Substeps::sofroniou_spaletta10()),
        ]
    }

    #[test]
    fn drifts_have_the_sine_and_the_versine() {
        for c in [0.4, -0.2, 0.05, 0.01] {
            for range in [0.125, 2.0] {
                let limit = range / (0.4 * 0.4);
                let drift = DriftPolynomials::new(c, limit);
                for n in 0..=100 {
                    let x = limit * f64::from(n) / 100.0;
                    let ((sine, versine), other) = drift.sines_and_versines(x, x);
                    assert_eq!((sine, versine), other);
                    // 1.5e-16 of the polynomials, and some roundings here and there.
                    let square = c * c * x;
                    let (first, second) = (c * square.stumpff(1), c * c * square.stumpff(2));
                    assert!((sine - first).abs() <= 4.0 * f64::EPSILON * c.abs(), "{c} {x}");
                    assert!((versine - second).abs() <= 4.0 * f64::EPSILON * c * c, "{c} {x}");
                }
            }
        }
    }

    #[test]
    fn shorter_drifts_have_shorter_polynomials() {
        let terms =
            [0.4, 0.2, 0.1, 0.01].map(|c| DriftPolynomials::new(c, 2.0 / (0.4 * 0.4)).terms);
        assert_eq!(terms, [8, 7, 5, 4]);
    }

    /// Σ (c² − 2 versine₀), by exact products.
    fn stretching(pairs: &[(f64, DriftPolynomials)]) -> f64 {
        let lost = |drift: &DriftPolynomials| {
            let c = drift.sine[0];
            let square = c * c;
            (square - 2.0 * drift.versine[0]) + c.mul_add(c, -square)
        };
        pairs.iter().map(|(_, drift)| lost(drift)).sum()
    }

    #[test]
    fn flows_of_a_step_do_not_stretch_together() {
        let mut rounded = 0.0;
        for substeps in sets() {
            let flows = Flows::new(&substeps, 2.0, f64::INFINITY);
            let squares = flows.pairs.iter().map(|(_, drift)| drift.sine[0] * drift.sine[0]);
            let least = squares.fold(1.0, f64::min);
            // Only the rounding of the smallest is left.
            assert!(stretching(&flows.pairs).abs() <= 0.5 * f64::EPSILON * least);
            let nearest = |(kick, drift): &(f64, DriftPolynomials)| {
                (*kick, DriftPolynomials::new(drift.sine[0], flows.limit))
            };
            rounded += stretching(&flows.pairs.iter().map(nearest).collect::<Vec<_>>()).abs();
        }
        // Negative control: rounded one by one they do.
        assert!(rounded > 1e-17, "{rounded:e}");
    }
}
