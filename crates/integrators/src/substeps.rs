//! The coefficients γ of composition methods.

use crate::SchemeError;
use crate::composition_conditions::order_over;

/// How far γ_i may be from γ_{s+1−i}, and their sum from 1, by rounding.
const COEFFICIENT_TOLERANCE: f64 = 1e-14;

/// The fractions γ₁, …, γ_s into which a composition divides its step,
///
/// ```text
/// Ψ_h = Φ_{γ_s h} ∘ … ∘ Φ_{γ_1 h},    γ_1 + … + γ_s = 1
/// ```
///
/// Beyond order 2 some of them are negative (Sheng; Suzuki), so Φ must run backwards too. The
/// named sets are symmetric, γ_i = γ_{s+1−i}, and raise a symmetric Φ of order 2; their orders
/// are computed, by [`order_over`](Self::order_over), not quoted.
///
/// Source: Hairer, Lubich & Wanner, *Geometric Numerical Integration*, 2nd ed. (2006), §V.3.
///
/// # Example
/// ```
/// use collective_integrators::Substeps;
/// let yoshida = Substeps::yoshida4();
/// assert_eq!(yoshida.order_over(2, true), 4);
/// // of a method of order 2 that is not symmetric it makes one of order 3
/// assert_eq!(yoshida.order_over(2, false), 3);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Substeps {
    fractions: Vec<f64>,
}

impl Substeps {
    /// The given fractions, first substep first.
    ///
    /// # Errors
    /// If there is none, one is not finite, or their sum is not 1 to within 1e-14 Σ|γ_i|.
    pub fn new(fractions: &[f64]) -> Result<Self, SchemeError> {
        if fractions.is_empty() {
            return Err(SchemeError::NoStages);
        }
        if fractions.iter().any(|x| !x.is_finite()) {
            return Err(SchemeError::NotFinite);
        }
        let sum: f64 = fractions.iter().sum();
        let size: f64 = fractions.iter().map(|x| x.abs()).sum();
        if (sum - 1.0).abs() > COEFFICIENT_TOLERANCE * size {
            return Err(SchemeError::SubstepSum { sum });
        }
        Ok(Self { fractions: fractions.to_vec() })
    }

    /// γ₁, …, γ_s
    #[must_use]
    pub fn fractions(&self) -> &[f64] {
        &self.fractions
    }

    /// Whether γ_i = γ_{s+1−i}: compositions of a symmetric method are then symmetric.
    #[must_use]
    pub fn is_symmetric(&self) -> bool {
        let reversed = self.fractions.iter().rev();
        self.fractions.iter().zip(reversed).all(|(x, y)| (x - y).abs() <= COEFFICIENT_TOLERANCE)
    }

    /// The order of the composition, for every method Φ of order `order`, symmetric or not.
    ///
    /// It is computed from the coefficients: the composition of formal exponentials
    /// exp(γ_i h E_1 + (γ_i h)^{p+1} E_{p+1} + …), even powers absent if Φ is symmetric, is compared
    /// with exp(h E_1) word by word. Orders above max(12, p + 2) are not looked for.
    ///
    /// Source: Murua & Sanz-Serna, *Order conditions for numerical integrators obtained by
    /// composing simpler integrators*, Phil. Trans. R. Soc. A 357 (1999).
    #[must_use]
    pub fn order_over(&self, order: usize, symmetric: bool) -> usize {
        order_over(&self.fractions, order, symmetric)
    }

    /// The triple jump that raises symmetric methods of even order p to order p + 2:
    ///
    /// ```text
    /// γ₁ = γ₃ = 1/(2 − r),    γ₂ = −r/(2 − r),    r = 2^{1/(p+1)}
    /// ```
    ///
    /// Source: Creutz & Gocksch, Phys. Rev. Lett. 63 (1989); Yoshida, *Construction of higher order
    /// symplectic integrators*, Phys. Lett. A 150 (1990); Hairer, Lubich &
    /// Wanner, eq. (II.4.4).
    #[must_use]
    pub fn triple_jump(order: usize) -> Self {
        let root = 2.0_f64.powf(1.0 / (order as f64 + 1.0));
        let outer = 1.0 / (2.0 - root);
        Self { fractions: vec![outer, -root * outer, outer] }
    }

    /// Suzuki's fractal, with five substeps none of which is longer than the step:
    ///
    /// ```text
    /// γ₁ = γ₂ = γ₄ = γ₅ = 1/(4 − r),    γ₃ = −r/(4 − r),    r = 4^{1/(p+1)}
    /// ```
    ///
    /// Source: Suzuki, *Fractal decomposition of exponential operators*, Phys. Lett. A 146 (1990).
    #[must_use]
    pub fn suzuki(order: usize) -> Self {
        let root = 4.0_f64.powf(1.0 / (order as f64 + 1.0));
        let outer = 1.0 / (4.0 - root);
        Self { fractions: vec![outer, outer, -root * outer, outer, outer] }
    }

    /// Order 4 with 3 substeps: the triple jump from order 2.
    ///
    /// Source: Yoshida, Phys. Lett. A 150 (1990).
    #[must_use]
    pub fn yoshida4() -> Self {
        Self::triple_jump(2)
    }

    /// Order 6 with 7 substeps, solution A.
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

    /// Order 8 with 15 substeps, solution C: that with the shortest substeps, max |γ_i| = 1.68. The
    /// printed 15 digits were refined by Newton's method in 50-digit arithmetic.
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

    /// Order 4 with 5 substeps: Suzuki's fractal from order 2.
    ///
    /// Source: Suzuki, Phys. Lett. A 146 (1990); Hairer, Lubich & Wanner, eq. (II.4.5).
    #[must_use]
    pub fn suzuki4() -> Self {
        Self::suzuki(2)
    }

    /// Order 4 with 5 substeps, of small error.
    ///
    /// Source: McLachlan, *On the numerical integration of ordinary differential equations by
    /// symmetric composition methods*, SIAM J. Sci. Comput. 16 (1995).
    #[must_use]
    pub fn mclachlan4() -> Self {
        Self::palindrome(&[0.28, 0.625_466_428_467_670_1, -0.810_932_856_935_340_1])
    }

    /// Order 6 with 9 substeps, of small error. Source: McLachlan, SIAM J. Sci. Comput. 16 (1995).
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

    /// Order 8 with 15 substeps, of small error.
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

    /// Order 6 with 9 substeps.
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

    /// Order 8 with 17 substeps.
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

    /// Order 10 with 35 substeps.
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

    /// γ₁, …, γ_m, …, γ₁ from the first half and the middle one.
    fn palindrome(half: &[f64]) -> Self {
        let mirrored = half.iter().rev().skip(1);
        Self { fractions: half.iter().chain(mirrored).copied().collect() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_orders_of_the_literature_come_out() {
        let orders = [
            (Substeps::yoshida4(), 3, 4),
            (Substeps::suzuki4(), 5, 4),
            (Substeps::mclachlan4(), 5, 4),
            (Substeps::yoshida6(), 7, 6),
            (Substeps::mclachlan6(), 9, 6),
            (Substeps::kahan_li6(), 9, 6),
            (Substeps::yoshida8(), 15, 8),
            (Substeps::mclachlan8(), 15, 8),
            (Substeps::kahan_li8(), 17, 8),
            (Substeps::sofroniou_spaletta10(), 35, 10),
        ];
        for (substeps, stages, order) in orders {
            assert_eq!(substeps.fractions().len(), stages);
            assert_eq!(substeps.order_over(2, true), order, "{substeps:?}");
            assert!(substeps.is_symmetric());
            assert_eq!(Substeps::new(substeps.fractions()), Ok(substeps));
        }
        for order in [2, 4, 6, 8, 10, 14, 24] {
            assert_eq!(Substeps::triple_jump(order).order_over(order, true), order + 2);
            assert_eq!(Substeps::suzuki(order).order_over(order, true), order + 2);
            assert_eq!(Substeps::triple_jump(order + 2).order_over(order, true), order);
        }
    }

    #[test]
    fn a_wrong_coefficient_costs_order() {
        let mut wrong = Substeps::kahan_li8();
        for i in [0, 16] {
            wrong.fractions[i] += 1e-6;
        }
        for i in [1, 15] {
            wrong.fractions[i] -= 1e-6;
        }
        assert_eq!(wrong.order_over(2, true), 2);
        assert_eq!(Substeps::new(&[]), Err(SchemeError::NoStages));
        assert_eq!(Substeps::new(&[0.5, 0.6]), Err(SchemeError::SubstepSum { sum: 1.1 }));
        assert_eq!(Substeps::new(&[f64::NAN]), Err(SchemeError::NotFinite));
        assert!(Substeps::new(&[0.25, 0.75]).is_ok_and(|s| !s.is_symmetric()));
    }
}
