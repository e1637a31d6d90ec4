//! The times of a symmetric top's flows, and polynomials for their angles.

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

/// Rounds the two leading coefficients of the versines of a step so that the flows together do not stretch: each
/// rounding error is added to the next, smaller coefficient.
///
/// With s₀, s₁ of the sine and v₀, v₁ of the versine, cos² + sin² − 1 has the coefficients
///
/// ```text
/// s₀² − 2v₀ of x,    v₀² − 2v₁ + 2s₀s₁ of x²
/// ```
///
/// The first should be 0, and the second the [`defect`](StumpffPolynomials::defect) that balances the higher terms.
/// With v₀ and v₁ rounded to nearest the stretches of all flows of a step add up to about 1e-17, or 1e-18 x², which
/// exceeds the random walk of the other rounding errors within 10⁵ steps.
fn diffuse(pairs: &mut [(f64, DriftPolynomials)]) {
    let mut order: Vec<&mut DriftPolynomials> = pairs.iter_mut().map(|(_, drift)| drift).collect();
    order.sort_by(|a, b| b.sine[0].abs().total_cmp(&a.sine[0].abs()));
    let mut lost = [0.0; 2];
    for drift in order {
        let [s0, s1, ..] = drift.sine;
        let square = s0 * s0;
        let (v0, rest) = rounded(0.5 * square, 0.5 * s0.mul_add(s0, -square) + lost[0]);
        let (half, product) = (0.5 * v0 * v0, s0 * s1);
        let low = (0.5 * v0).mul_add(v0, -half) + s0.mul_add(s1, -product);
        // The sum of the products is exact, since their ratio is −3/4.
        let (v1, rest1) = rounded(half + product, low - 0.5 * drift.defect + lost[1]);
        (drift.versine[0], drift.versine[1], lost) = (v0, v1, [rest, rest1]);
    }
}

/// Returns the rounded sum of a large and a small number, and the rounding error.
fn rounded(large: f64, small: f64) -> (f64, f64) {
    let sum = large + small;
    (sum, (large - sum) + small)
}

/// The polynomials of a drift for the fraction c of a step: c c₁, c²c₂ and c tan(θ/2)/θ at θ² = c²x, in terms of x.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct DriftPolynomials {
    /// The number of coefficients of `versine`; `sine` has one more.
    terms: usize,
    /// The coefficient of x² that cos² + sin² − 1 should have.
    defect: f64,
    sine: [f64; 9],
    versine: [f64; 8],
    half_tangent: [f64; 13],
}

impl DriftPolynomials {
    /// Creates the shortest polynomials that suffice for x up to `limit`.
    fn new(c: f64, limit: f64) -> Self {
        let square = c * c;
        let will_do = |p: &&StumpffPolynomials| square * limit <= p.range;
        let [longest, ..] = &STUMPFF;
        let polynomials = STUMPFF.iter().rev().find(will_do).unwrap_or(longest);
        let scale = |mut power: f64, coefficients: &[f64], scaled: &mut [f64]| {
            for (scaled, coefficient) in scaled.iter_mut().zip(coefficients) {
                *scaled = power * coefficient;
                power *= square;
            }
        };
        let (mut sine, mut versine, mut half_tangent) = ([0.0; 9], [0.0; 8], [0.0; 13]);
        scale(c, polynomials.first, &mut sine);
        scale(square, polynomials.second, &mut versine);
        scale(c, polynomials.half_tangent, &mut half_tangent);
        let (terms, defect) = (polynomials.second.len(), square * square * polynomials.defect);
        Self { terms, defect, sine, versine, half_tangent }
    }

    /// Returns (c c₁, c²c₂) at c²x and (c c₁, c tan(θ/2)/θ) at θ² = c²y.
    #[inline(always)]
    pub(crate) fn at<T: Lanes>(&self, x: T, y: T) -> ((T, T), (T, T)) {
        match self.terms {
            4 => self.with_terms::<T, 4, 5>(x, y),
            5 => self.with_terms::<T, 5, 7>(x, y),
            6 => self.with_terms::<T, 6, 8>(x, y),
            7 => self.with_terms::<T, 7, 10>(x, y),
            _ => self.with_terms::<T, 8, 13>(x, y),
        }
    }

    #[inline(always)]
    fn with_terms<T: Lanes, const TERMS: usize, const HALF: usize>(
        &self,
        x: T,
        y: T,
    ) -> ((T, T), (T, T)) {
        let sine = &self.sine[..=TERMS];
        let first = (polynomial(sine, x), polynomial(&self.versine[..TERMS], x));
        (first, (polynomial(sine, y), polynomial(&self.half_tangent[..HALF], y)))
    }
}

/// Evaluates a polynomial by Horner's rule.
#[inline(always)]
fn polynomial<T: Lanes>(coefficients: &[f64], x: T) -> T {
    let [lower @ .., highest] = coefficients else { return T::from_f64(0.0) };
    let mut sum = T::from_f64(*highest);
    for &coefficient in lower.iter().rev() {
        sum = sum.multiply_add(x, T::from_f64(coefficient));
    }
    sum
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
    fn drifts_have_the_sine_the_versine_and_the_half_tangent() {
        for c in [0.4, -0.2, 0.05, 0.01] {
            for range in [0.125, 2.0] {
                let limit = range / (0.4 * 0.4);
                let drift = DriftPolynomials::new(c, limit);
                for n in 0..=100 {
                    let x = limit * f64::from(n) / 100.0;
                    let ((sine, versine), (again, half_tangent)) = drift.at(x, x);
                    assert_eq!(sine, again);
                    // 1.5e-16 of the polynomials, and some roundings here and there.
                    let square = c * c * x;
                    let (first, second) = (c * square.stumpff(1), c * c * square.stumpff(2));
                    assert!((sine - first).abs() <= 4.0 * f64::EPSILON * c.abs(), "{c} {x}");
                    assert!((versine - second).abs() <= 4.0 * f64::EPSILON * c * c, "{c} {x}");
                    let angle = square.sqrt();
                    let third = if n > 0 { c * (angle / 2.0).tan() / angle } else { c / 2.0 };
                    let bound = 4.0 * f64::EPSILON * c.abs();
                    assert!((half_tangent - third).abs() <= bound, "{c} {x}");
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

    /// The sums of s₀² − 2v₀ and of v₀² − 2v₁ + 2s₀s₁ less what it should be, by exact products.
    fn stretching(pairs: &[(f64, DriftPolynomials)]) -> [f64; 2] {
        let exact = |a: f64, b: f64| (a * b, a.mul_add(b, -(a * b)));
        let lost = |drift: &DriftPolynomials| {
            let ([s0, s1, ..], [v0, v1, ..]) = (drift.sine, drift.versine);
            let (square, low) = exact(s0, s0);
            let ((versine, low1), (product, low2)) = (exact(v0, v0), exact(2.0 * s0, s1));
            [
                (square - 2.0 * v0) + low,
                ((versine + product) - 2.0 * v1) + (low1 + low2) - drift.defect,
            ]
        };
        let sum = |k: usize| pairs.iter().map(|(_, drift)| lost(drift)[k]).sum();
        [sum(0), sum(1)]
    }

    #[test]
    fn flows_of_a_step_do_not_stretch_together() {
        let mut rounded = [0.0; 2];
        for substeps in sets() {
            let flows = Flows::new(&substeps, 2.0, f64::INFINITY);
            let squares = flows.pairs.iter().map(|(_, drift)| drift.sine[0] * drift.sine[0]);
            let least = squares.fold(1.0, f64::min);
            // Only the rounding of the smallest is left, and that of the sums here.
            let [first, second] = stretching(&flows.pairs);
            assert!(first.abs() <= 0.5 * f64::EPSILON * least, "{first:e}");
            assert!(second.abs() <= 0.1 * f64::EPSILON * least, "{second:e}");
            let nearest = |(kick, drift): &(f64, DriftPolynomials)| {
                (*kick, DriftPolynomials::new(drift.sine[0], flows.limit))
            };
            let nearest = stretching(&flows.pairs.iter().map(nearest).collect::<Vec<_>>());
            rounded = [0, 1].map(|k| rounded[k] + nearest[k].abs());
        }
        // Negative control: rounded one by one they do.
        assert!(rounded[0] > 1e-17 && rounded[1] > 1e-19, "{rounded:?}");
    }

    /// At θ² = c²x the polynomials of a fraction c are those of a step at x.
    #[test]
    fn a_fraction_scales_the_polynomials() {
        let (whole, half) = (DriftPolynomials::new(1.0, 0.1), DriftPolynomials::new(0.5, 0.4));
        assert!(whole.terms == half.terms && whole.defect != 0.0);
        assert_eq!(half.defect, whole.defect / 16.0);
        let scaled = |power: f64| move |(n, x): (i32, f64)| power * x * 0.25_f64.powi(n);
        for (one, other, power) in [
            (&whole.sine[..], &half.sine[..], 0.5),
            (&whole.versine, &half.versine, 0.25),
            (&whole.half_tangent, &half.half_tangent, 0.5),
        ] {
            let expected = (0..).zip(one.iter().copied()).map(scaled(power));
            assert!(expected.eq(other.iter().copied()), "{one:?} {other:?}");
        }
    }
}
