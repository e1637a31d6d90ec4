//! The Stumpff functions c₁ and c₂ and half tangents as polynomials on ranges of different length.

/// Polynomials for the Stumpff functions c₁ and c₂ and for the half tangent on [0, `range`], exact to 1.5e-16.
///
/// The functions are
///
/// ```text
/// c₁(θ²) = sin θ/θ,  c₂(θ²) = (1 − cos θ)/θ²,  tan(θ/2)/θ
/// ```
///
/// The polynomial for c₂ is given by that for c₁ and by the series of cos² + sin² − 1, which should vanish.
///
/// A polynomial for c₂ and the half tangent are interpolated at Chebyshev's nodes, shifted so that one of them is 0. c₁
/// interpolates √(c₂(2 − x c₂)) with that polynomial for c₂.
pub(crate) struct StumpffPolynomials {
    pub(crate) range: f64,
    pub(crate) first: &'static [f64],
    /// The leading coefficients of cos² + sin² − 1, of x, x², … with x = θ²: as many as c₂ has coefficients.
    ///
    /// With the higher coefficients, which follow from c₁ and c₂, they make the largest |cos² + sin² − 1| on the range
    /// as small as possible: 6e-19 on the longest range, below 6e-20 on the others.
    pub(crate) defect: &'static [f64],
    pub(crate) half_tangent: &'static [f64],
}

/// The polynomials for five ranges, the shortest last.
pub(crate) const STUMPFF: [StumpffPolynomials; 5] = [
    StumpffPolynomials {
        range: 2.0,
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
        defect: &[
            0.0,
            5.971_396e-17,
            -2.677_313e-16,
            -1.057_019e-16,
            2.398_325e-15,
            -5.370_902e-15,
            5.723_641e-15,
            -3.359_052e-15,
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
        defect: &[
            0.0,
            5.883_905e-18,
            4.699_409e-17,
            -1.777_434e-15,
            1.349_736e-14,
            -4.717_928e-14,
            8.656_946e-14,
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
        first: &[
            1.0,
            -0.166_666_666_666_666,
            0.008_333_333_333_301_957,
            -0.000_198_412_697_931_507_72,
            2.755_728_690_438_811_6e-6,
            -2.504_218_481_128_118_8e-8,
            1.489_652_473_258_302_2e-10,
        ],
        defect: &[0.0, 9.436_615e-18, 1.344_896e-15, -4.388_437e-14, 4.959_389e-13, -2.628_825e-12],
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
        range: 0.105,
        first: &[
            1.0,
            -0.166_666_666_666_631_57,
            0.008_333_333_330_607_932,
            -0.000_198_412_632_512_641_81,
            2.755_101_991_224_45e-6,
            -2.295_410_884_666_931_8e-8,
        ],
        defect: &[0.0, -1.303_079e-15, 1.169_737e-13, -3.801_139e-12, 5.737_915e-11],
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
        first: &[
            1.0,
            -0.166_666_666_666_474_12,
            0.008_333_333_258_549_796,
            -0.000_198_404_438_274_648_78,
            2.480_025_791_587_22e-6,
        ],
        defect: &[0.0, -3.767_764e-16, 3.237_291e-13, -6.761_596e-11],
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
mod tests {
    use super::*;

    #[test]
    fn leading_coefficients_are_exact() {
        for polynomials in &STUMPFF {
            let StumpffPolynomials { first, half_tangent, defect, .. } = polynomials;
            assert_eq!([first[0], half_tangent[0], defect[0]], [1.0, 0.5, 0.0]);
            assert_eq!(first.len(), defect.len() + 1);
        }
        assert!(STUMPFF.is_sorted_by(|a, b| a.range > b.range));
    }
}
