//! The coefficients of named composition methods.

use crate::step_fractions::substeps::Substeps;

impl Substeps {
    /// Creates the 3 substeps of order 4 of Yoshida: the triple jump from order 2.
    ///
    /// Source: Yoshida, Phys. Lett. A 150 (1990).
    #[must_use]
    pub fn yoshida4() -> Self {
        Self::jump(1, 2)
    }

    /// Creates the 7 substeps of order 6 of Yoshida, solution A.
    ///
    /// Source: Yoshida, Phys. Lett. A 150 (1990), Table 1; Hairer, Lubich & Wanner, eq. (V.3.11).
    #[must_use]
    pub fn yoshida6() -> Self {
        Self::palindrome(&[
            0.784_513_610_477_557_3,
            0.235_573_213_359_358_13,
            -1.177_679_984_178_871,
            1.315_186_320_683_911_2,
        ])
    }

    /// Creates the 15 substeps of order 8 of Yoshida, solution C.
    ///
    /// It has the shortest substeps, with max |γ_i| = 1.68. The printed 15 digits were refined by Newton's method in
    /// 50-digit arithmetic.
    ///
    /// Source: Yoshida, Phys. Lett. A 150 (1990), Table 2.
    #[must_use]
    pub fn yoshida8() -> Self {
        Self::palindrome(&[
            0.629_030_650_210_370_8,
            1.369_349_464_168_817_7,
            -1.064_587_147_891_825,
            1.663_358_099_633_505_2,
            -1.678_969_282_596_738_4,
            -1.559_468_038_214_702_6,
            0.311_790_812_418_466_8,
            1.658_990_884_544_211_4,
        ])
    }

    /// Creates the 5 substeps of order 4 of Suzuki: Suzuki's fractal from order 2.
    ///
    /// Source: Suzuki, Phys. Lett. A 146 (1990); Hairer, Lubich & Wanner, eq. (II.4.5).
    #[must_use]
    pub fn suzuki4() -> Self {
        Self::jump(2, 2)
    }

    /// Creates the 5 substeps of order 4 of McLachlan, whose error is smaller than that of other choices with the same
    /// number of substeps.
    ///
    /// Source: McLachlan, *On the numerical integration of ordinary differential equations by
    /// symmetric composition methods*, SIAM J. Sci. Comput. 16 (1995).
    #[must_use]
    pub fn mclachlan4() -> Self {
        Self::palindrome(&[0.28, 0.625_466_428_467_670_1, -0.810_932_856_935_340_1])
    }

    /// Creates the 9 substeps of order 6 of McLachlan, whose error is smaller than that of other choices with the same
    /// number of substeps.
    ///
    /// Source: McLachlan, SIAM J. Sci. Comput. 16 (1995).
    #[must_use]
    pub fn mclachlan6() -> Self {
        Self::palindrome(&[
            0.1867,
            0.555_497_023_712_478_4,
            0.129_466_948_913_475_36,
            -0.843_265_623_387_734_6,
            0.943_203_301_523_561_7,
        ])
    }

    /// Creates the 15 substeps of order 8 of Suzuki, Umeno and McLachlan, whose error is smaller than that of other
    /// choices with the same number of substeps.
    ///
    /// Source: Suzuki & Umeno (1993); McLachlan, SIAM J. Sci. Comput. 16 (1995); Hairer, Lubich &
    /// Wanner, eq. (V.3.13).
    #[must_use]
    pub fn mclachlan8() -> Self {
        Self::palindrome(&[
            0.741_670_364_350_613,
            -0.409_100_825_800_031_6,
            0.190_754_710_296_238_4,
            -0.573_862_471_116_082_3,
            0.299_064_181_303_655_9,
            0.334_624_918_245_298_2,
            0.315_293_092_396_766_6,
            -0.796_887_939_352_916_3,
        ])
    }

    /// Creates the 9 substeps of order 6 of Kahan and Li.
    ///
    /// Source: Kahan & Li, *Composition constants for raising the orders of unconventional schemes
    /// for ordinary differential equations*, Math. Comp. 66 (1997); Hairer, Lubich & Wanner, eq.
    /// (V.3.12).
    #[must_use]
    pub fn kahan_li6() -> Self {
        Self::palindrome(&[
            0.392_161_444_007_314_2,
            0.332_599_136_789_359_44,
            -0.706_246_172_557_639_4,
            0.082_213_596_293_550_8,
            0.798_543_990_934_83,
        ])
    }

    /// Creates the 17 substeps of order 8 of Kahan and Li.
    ///
    /// Source: Kahan & Li, Math. Comp. 66 (1997); Hairer, Lubich & Wanner, eq. (V.3.14).
    #[must_use]
    pub fn kahan_li8() -> Self {
        Self::palindrome(&[
            0.130_202_483_088_890_08,
            0.561_162_981_775_108_4,
            -0.389_474_962_644_847_3,
            0.158_841_906_555_155_6,
            -0.395_903_894_133_237_6,
            0.184_539_640_978_315_7,
            0.258_374_387_686_322_05,
            0.295_011_723_609_310_3,
            -0.605_508_533_830_034_5,
        ])
    }

    /// Creates the 35 substeps of order 10 of Sofroniou and Spaletta.
    ///
    /// Source: Sofroniou & Spaletta, *Derivation of symmetric composition constants for symmetric
    /// integrators*, Optim. Methods Softw. 20 (2005); Hairer, Lubich & Wanner, eq. (V.3.15).
    #[must_use]
    pub fn sofroniou_spaletta10() -> Self {
        Self::palindrome(&[
            0.078_795_722_521_686_42,
            0.313_096_103_415_108_5,
            0.027_918_383_235_078_067,
            -0.229_592_841_593_907_1,
            0.130_962_061_077_164_86,
            -0.269_733_405_654_510_7,
            0.074_973_343_155_891_44,
            0.111_993_423_999_810_2,
            0.366_133_449_546_226_8,
            -0.399_105_630_136_035_9,
            0.103_087_398_527_471_07,
            0.411_430_873_955_890_24,
            -0.004_866_360_583_135_262,
            -0.392_033_353_708_639_9,
            0.051_942_502_962_449_65,
            0.050_665_090_759_924_5,
            0.049_674_370_639_729_88,
            0.049_317_735_759_594_54,
        ])
    }
}
