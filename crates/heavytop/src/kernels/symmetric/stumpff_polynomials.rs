//! The Stumpff functions c₁ and c₂ and half tangents as polynomials on ranges of different length.

/// Polynomials for the Stumpff functions c₁ and c₂ and for the half tangent on [0, `range`], exact to 1.5e-16.
///
/// The functions are
///
/// ```text
/// c₁(θ²) = sin θ/θ,  c₂(θ²) = (1 − cos θ)/θ²,  tan(θ/2)/θ
/// ```
///
/// c₂ and the half tangent are interpolated at Chebyshev's nodes, shifted so that one of them is 0. c₁ interpolates √(c₂(2 − x c₂))
/// with that polynomial for c₂, so that the errors of the two compensate each other. Cosine and sine are on
/// the unit circle to 7e-19, except for the rounding of the coefficients.
pub(crate) struct StumpffPolynomials {
    pub(crate) range: f64,
    /// The coefficient of x² in cos² + sin² − 1, x = θ², for which this is least on the range, up to x = 1. That of the rounded
    /// coefficients differs by up to 2e-17.
    pub(crate) defect: f64,
    pub(crate) first: &'static [f64],
    pub(crate) second: &'static [f64],
    pub(crate) half_tangent: &'static [f64],
}

/// The polynomials for five ranges, the shortest last.
pub(crate) const STUMPFF: [StumpffPolynomials; 5] = [
    StumpffPolynomials {
        range: 2.0,
        defect: -1.414_853e-17,
        first: &[
            1.0,
            -0.166_666_666_666_666_63,
            0.008_333_333_333_332_81,
            -0.000_198_412_698_410_484_23,
            2.755_731_917_901_746e-6,
            -2.505_210_342_414_128_4e-8,
            1.605_873_544_102_307_9e-10,
            -7.636_703_163_729_302e-13,
            2.642_594_662_333_099e-15,
        ],
        second: &[
            0.5,
            -0.041_666_666_666_666_616,
            0.001_388_888_888_888_219_8,
            -2.480_158_729_869_779_8e-5,
            2.755_731_863_233_564_6e-7,
            -2.087_669_217_053_116_5e-9,
            1.146_683_995_656_349e-11,
            -4.657_258_655_232_234_4e-14,
        ],
        half_tangent: &[
            0.5,
            0.041_666_666_666_661_17,
            0.004_166_666_666_853_301,
            0.000_421_626_981_923_764_77,
            4.271_385_780_264_313_5e-5,
            4.327_706_895_085_445e-6,
            4.385_901_203_597_446e-7,
            4.428_676_256_492_590_6e-8,
            4.640_377_243_093_501e-9,
            3.642_253_187_430_797e-10,
            8.627_843_363_720_687e-11,
            -6.082_346_580_803_740_6e-12,
            1.972_975_098_874_143_7e-12,
        ],
    },
    StumpffPolynomials {
        range: 0.7,
        defect: -3.203_212e-18,
        first: &[
            1.0,
            -0.166_666_666_666_666_63,
            0.008_333_333_333_332_143,
            -0.000_198_412_698_401_731_17,
            2.755_731_875_708_125_3e-6,
            -2.505_200_711_246_362_2e-8,
            1.604_805_994_885_621e-10,
            -7.153_523_229_434_529e-13,
        ],
        second: &[
            0.5,
            -0.041_666_666_666_666_62,
            0.001_388_888_888_887_605_2,
            -2.480_158_728_971_253e-5,
            2.755_731_417_317_85e-7,
            -2.087_567_052_229_883_7e-9,
            1.135_568_983_418_209_7e-11,
        ],
        half_tangent: &[
            0.5,
            0.041_666_666_666_667_36,
            0.004_166_666_666_627_164,
            0.000_421_626_984_903_822_1,
            4.271_383_732_244_2e-5,
            4.327_792_296_797_129e-6,
            4.383_597_329_565_627e-7,
            4.469_308_555_148_336e-8,
            4.187_512_541_960_397e-9,
            6.551_911_976_411_15e-10,
        ],
    },
    StumpffPolynomials {
        range: 0.3,
        defect: -3.959_709e-17,
        first: &[
            1.0,
            -0.166_666_666_666_666,
            0.008_333_333_333_301_957,
            -0.000_198_412_697_931_507_72,
            2.755_728_690_438_811_6e-6,
            -2.504_218_481_128_118_8e-8,
            1.489_652_473_258_302_2e-10,
        ],
        second: &[
            0.5,
            -0.041_666_666_666_665_984,
            0.001_388_888_888_856_516_6,
            -2.480_158_680_481_447_2e-5,
            2.755_698_647_801_558_4e-7,
            -2.077_554_403_584_540_7e-9,
        ],
        half_tangent: &[
            0.5,
            0.041_666_666_666_669_64,
            0.004_166_666_666_413_641,
            0.000_421_626_991_390_438_8,
            4.271_374_610_042_089_6e-5,
            4.328_467_121_796_350_5e-6,
            4.356_564_558_246_341e-7,
            5.018_362_800_555_603e-8,
        ],
    },
    StumpffPolynomials {
        range: 0.125,
        defect: -8.259_194e-16,
        first: &[
            1.0,
            -0.166_666_666_666_631_57,
            0.008_333_333_330_607_932,
            -0.000_198_412_632_512_641_81,
            2.755_101_991_224_45e-6,
            -2.295_410_884_666_931_8e-8,
        ],
        second: &[
            0.5,
            -0.041_666_666_666_631_16,
            0.001_388_888_886_128_523_9,
            -2.480_152_060_002_264e-5,
            2.749_378_566_040_617_6e-7,
        ],
        half_tangent: &[
            0.5,
            0.041_666_666_666_665_2,
            0.004_166_666_666_894_711,
            0.000_421_626_972_332_396_5,
            4.271_412_497_078_358_4e-5,
            4.324_393_292_212_683e-6,
            4.582_053_884_727_773e-7,
        ],
    },
    StumpffPolynomials {
        range: 0.015_625,
        defect: -5.741_272e-16,
        first: &[
            1.0,
            -0.166_666_666_666_474_12,
            0.008_333_333_258_549_796,
            -0.000_198_404_438_274_648_78,
            2.480_025_791_587_22e-6,
        ],
        second: &[
            0.5,
            -0.041_666_666_666_473_826,
            0.001_388_888_813_991_381,
            -2.479_331_768_242_987_3e-5,
        ],
        half_tangent: &[
            0.5,
            0.041_666_666_666_648_595,
            0.004_166_666_677_902_314_4,
            0.000_421_624_813_262_978_6,
            4.287_907_439_801_374e-5,
        ],
    },
];

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use lie_poisson::Real;
    use twofloat::TwoFloat;

    fn value(coefficients: &[f64], x: f64) -> f64 {
        coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c)
    }

    /// The worst errors of the three polynomials on [from, to].
    fn worst(polynomials: &StumpffPolynomials, from: f64, to: f64) -> f64 {
        (0..=1000).fold(0.0, |worst: f64, n| {
            let x = from + (to - from) * f64::from(n) / 1000.0;
            let first = value(polynomials.first, x) - x.stumpff(1);
            let second = value(polynomials.second, x) - x.stumpff(2);
            let angle = x.sqrt();
            let ratio = if x > 0.0 { (angle / 2.0).tan() / angle } else { 0.5 };
            let third = value(polynomials.half_tangent, x) - ratio;
            worst.max(first.abs()).max(second.abs()).max(third.abs())
        })
    }

    #[test]
    fn polynomials_are_their_functions_on_their_range() {
        for polynomials in &STUMPFF {
            let range = polynomials.range;
            // 1.5e-16 of the polynomials, and some roundings of sums up to 1 here and there.
            assert!(worst(polynomials, 0.0, range) <= 2.0 * f64::EPSILON, "{range}");
            // Beyond it they are not, so that the range is needed.
            assert!(worst(polynomials, range, 4.0 * range) > 16.0 * f64::EPSILON, "{range}");
        }
    }

    #[test]
    fn leading_coefficients_are_exact() {
        for polynomials in &STUMPFF {
            let StumpffPolynomials { first, second, half_tangent, .. } = polynomials;
            assert_eq!([first[0], second[0], half_tangent[0]], [1.0, 0.5, 0.5]);
            assert_eq!(polynomials.first.len(), polynomials.second.len() + 1);
        }
        assert!(STUMPFF.is_sorted_by(|a, b| a.range > b.range));
    }

    /// The mean over the range of cos² + sin² − 1.
    fn stretching(polynomials: &StumpffPolynomials) -> f64 {
        let defect = |n: u32| {
            let x = polynomials.range * f64::from(n) / 1000.0;
            let cosine = 1.0 - x * value(polynomials.second, x);
            let first = value(polynomials.first, x);
            cosine.mul_add(cosine, -1.0) + x * first * first
        };
        (1..=1000).map(defect).sum::<f64>() / 1000.0
    }

    #[test]
    fn cosine_and_sine_stay_on_the_unit_circle() {
        for polynomials in &STUMPFF {
            // 1000 points, each with a few roundings of 1e-16 at random; and the coefficients of the
            // longest, which count for more where x is 2, are rounded to 1.2e-17 in the mean.
            assert!(stretching(polynomials).abs() < 3e-17, "{:e}", stretching(polynomials));
            // Negative control: without the last coefficient they do not.
            let (_, shorter) = polynomials.first.split_last().unwrap();
            let shorter = StumpffPolynomials { first: shorter, ..*polynomials };
            assert!(stretching(&shorter).abs() > 1e-16);
        }
    }

    /// Returns cos² + sin² − 1 at x, for v₁ of the versine plus a correction, with twice the digits.
    fn defect_at(polynomials: &StumpffPolynomials, correction: TwoFloat, x: f64) -> f64 {
        let horner = |coefficients: &[f64], k: usize, correction: TwoFloat| {
            let terms = coefficients.iter().enumerate().rev();
            terms.fold(TwoFloat::from(0.0), |sum, (i, &c)| {
                let sum = sum * x + c;
                if i == k { sum + correction } else { sum }
            })
        };
        let cosine = TwoFloat::from(1.0) - horner(polynomials.second, 1, correction) * x;
        let first = horner(polynomials.first, usize::MAX, correction);
        f64::from(cosine * cosine - 1.0 + first * first * x)
    }

    #[test]
    fn the_defect_balances_the_higher_terms() {
        let mut unbalanced = 0.0_f64;
        for polynomials in &STUMPFF {
            let ([s0, s1, ..], [v0, v1, ..]) = (polynomials.first, polynomials.second) else {
                unreachable!("there are more coefficients")
            };
            let products = TwoFloat::new_mul(*v0, *v0) + TwoFloat::new_mul(2.0 * s0, *s1);
            let correction = (products - 2.0 * v1 - polynomials.defect) / 2.0;
            for n in 0..=64 {
                let x = polynomials.range.min(1.0) * f64::from(n) / 64.0;
                let balanced = defect_at(polynomials, correction, x);
                // What the higher coefficients leave, at most: 1.3e-18 on the longest range.
                assert!(balanced.abs() < 2e-18, "{x}: {balanced:e}");
                let plain = defect_at(polynomials, TwoFloat::from(0.0), x);
                unbalanced = unbalanced.max(plain.abs());
            }
        }
        // Negative control: with the rounded v₁ it is larger.
        assert!(unbalanced > 8e-18, "{unbalanced:e}");
    }
}
