//! Normal numbers from uniform ones, by the inverse of the normal distribution function.
#![allow(clippy::excessive_precision)] // The digits are those of the source.

use lie_poisson::{Mask, Real};

/// Returns the probability (n + ½)/2⁵² of the upper 52 of 64 bits n. It is exact, also its difference from ½ and from 1.
#[inline]
pub(super) fn probability(bits: u64) -> f64 {
    ((bits >> 12) as f64 + 0.5) * 0.5_f64.powi(52)
}

/// Returns the number x below which a standard normal number lies with a [probability]. So uniform bits give normal numbers, none of
/// which is larger than 8.3. It increases with the bits, and the relative error is 1e-15.
///
/// Source: Wichura, *Algorithm AS 241: the percentage points of the normal distribution*, J. R. Stat. Soc. C 37 (1988).
#[inline]
pub(super) fn quantile(p: f64) -> f64 {
    if is_central(p) { central(p) } else { in_tail(p) }
}

/// Returns the [`quantile`] in each lane, with the same bits. Of all numbers 85 % are central, and the others are computed one by one.
#[cfg_attr(optimised, inline(always))]
pub(super) fn quantiles<T: Real>(p: T) -> T {
    let x = central(p);
    match (p - HALF).magnitude().at_most(T::from_f64(CENTRAL)).all() {
        true => x,
        false => x.lane_by_lane(p, |x, p| if is_central(p) { x } else { in_tail(p) }),
    }
}

const HALF: f64 = 0.5;

/// The distance from ½ up to which a probability is central.
const CENTRAL: f64 = 0.425;

#[inline]
fn is_central(p: f64) -> bool {
    (p - HALF).abs() <= CENTRAL
}

#[cfg_attr(optimised, inline(always))]
fn central<T: Real>(p: T) -> T {
    let q = p - HALF;
    q * ratio(&CENTRE, -(q * q) + 0.180625)
}

fn in_tail(p: f64) -> f64 {
    let r = (-p.min(1.0 - p).ln()).sqrt();
    let x = if r <= 5.0 { ratio(&TAIL, r - 1.6) } else { ratio(&FAR_TAIL, r - 5.0) };
    x.copysign(p - HALF)
}

/// The coefficients of a numerator and of a denominator, from those of the highest power down.
type Coefficients = [[f64; 8]; 2];

/// Returns the quotient of two polynomials, by Horner's scheme.
#[cfg_attr(optimised, inline(always))]
fn ratio<T: Real>([numerator, denominator]: &Coefficients, r: T) -> T {
    let (mut above, mut below) = (T::zero(), T::zero());
    for (a, b) in numerator.iter().zip(denominator) {
        above = above * r + *a;
        below = below * r + *b;
    }
    above / below
}

#[rustfmt::skip]
const CENTRE: Coefficients = [
    [
        2.509_080_928_730_122_672_7e3, 3.343_057_558_358_812_810_5e4,
        6.726_577_092_700_870_085_3e4, 4.592_195_393_154_987_145_7e4,
        1.373_169_376_550_946_112_5e4, 1.971_590_950_306_551_442_7e3,
        1.331_416_678_917_843_774_5e2, 3.387_132_872_796_366_608_0,
    ],
    [
        5.226_495_278_852_854_561_0e3, 2.872_908_573_572_194_267_4e4,
        3.930_789_580_009_271_061_0e4, 2.121_379_430_158_659_586_7e4,
        5.394_196_021_424_751_107_7e3, 6.871_870_074_920_579_083_0e2,
        4.231_333_070_160_091_125_2e1, 1.0,
    ],
];

#[rustfmt::skip]
const TAIL: Coefficients = [
    [
        7.745_450_142_783_414_076_40e-4, 2.272_384_498_926_918_458_33e-2,
        2.417_807_251_774_506_117_70e-1, 1.270_458_252_452_368_382_58,
        3.647_848_324_763_204_605_04, 5.769_497_221_460_691_405_50,
        4.630_337_846_156_545_295_90, 1.423_437_110_749_683_577_34,
    ],
    [
        1.050_750_071_644_416_843_24e-9, 5.475_938_084_995_344_946_00e-4,
        1.519_866_656_361_645_719_66e-2, 1.481_039_764_274_800_745_90e-1,
        6.897_673_349_851_000_045_50e-1, 1.676_384_830_183_803_849_40,
        2.053_191_626_637_758_821_87, 1.0,
    ],
];

#[rustfmt::skip]
const FAR_TAIL: Coefficients = [
    [
        2.010_334_399_292_288_132_65e-7, 2.711_555_568_743_487_578_15e-5,
        1.242_660_947_388_078_438_60e-3, 2.653_218_952_657_612_309_30e-2,
        2.965_605_718_285_048_912_30e-1, 1.784_826_539_917_291_335_80,
        5.463_784_911_164_114_369_90, 6.657_904_643_501_103_777_20,
    ],
    [
        2.044_263_103_389_939_785_64e-15, 1.421_511_758_316_445_888_70e-7,
        1.846_318_317_510_054_681_80e-5, 7.868_691_311_456_132_591_00e-4,
        1.487_536_129_085_061_485_25e-2, 1.369_298_809_227_358_053_10e-1,
        5.998_322_065_558_879_376_90e-1, 1.0,
    ],
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::open_systems::paths::philox::philox;
    use lie_poisson::{DefaultLanes, Lanes};

    fn normal_of(bits: u64) -> f64 {
        quantile(probability(bits))
    }

    /// Returns the bits of a probability.
    fn at(p: f64) -> u64 {
        ((p * 2.0_f64.powi(52)) as u64) << 12
    }

    /// Returns the normal distribution function below x < 0, by Laplace's continued fraction for x ≤ -2 and otherwise by
    /// the series about 0.
    fn distribution(x: f64) -> f64 {
        let density = (-0.5 * x * x).exp() / core::f64::consts::TAU.sqrt();
        if x < -2.0 {
            return density / (1..400).rev().fold(-x, |tail, k| -x + f64::from(k) / tail);
        }
        let mut term = x;
        let series = (1..200).fold(x, |sum, k| {
            term *= x * x / f64::from(2 * k + 1);
            sum + term
        });
        0.5 + density * series
    }

    #[test]
    fn it_is_the_inverse_of_the_distribution() {
        for exponent in 1..=50 {
            for factor in [1.0, 1.3, 1.7] {
                let p = 0.5_f64.powi(exponent) * factor * 0.55;
                let bits = at(p);
                let p = ((bits >> 12) as f64 + 0.5) * 0.5_f64.powi(52);
                let found = distribution(normal_of(bits));
                // The density is up to 8.3 times the probability, so that an ε of x is 70 ε of it.
                assert!((found - p).abs() < 1e-13 * p, "{p:e} {found:e}");
                assert_eq!(normal_of(!bits), -normal_of(bits));
            }
        }
    }

    /// Known quantiles.
    #[test]
    fn quantiles_are_those_of_tables() {
        for (p, x) in [(0.975, 1.959_963_984_540_054), (0.001, -3.090_232_306_167_813_5)] {
            assert!((normal_of(at(p)) - x).abs() < 1e-14);
        }
        // exp(−25) is where the last two forms meet.
        let meet = (-25.0_f64).exp();
        let [before, after] = [1.0 - 1e-4, 1.0 + 1e-4].map(|part| normal_of(at(meet * part)));
        assert!(before < after && after - before < 1e-4);
    }

    /// In lanes, some of them central.
    #[test]
    fn lanes_have_the_bits_of_numbers() {
        for first in 0..200_u64 {
            let bits = |lane: usize| philox([first, 0], [lane as u64; 4])[0];
            let p = DefaultLanes::from_lanes(|lane| probability(bits(lane)));
            for lane in 0..DefaultLanes::COUNT {
                assert_eq!(quantiles(p).lane(lane).to_bits(), normal_of(bits(lane)).to_bits());
            }
        }
    }

    #[test]
    fn extreme_numbers_are_finite() {
        assert_eq!(normal_of(0), -normal_of(u64::MAX));
        assert!((8.2..8.3).contains(&normal_of(u64::MAX)));
        assert!(normal_of(1 << 63).abs() < 1e-15);
    }
}
