//! The coefficients γ of composition methods: [`Substeps`].

use crate::error::SchemeError;
use crate::step_fractions::composition_conditions::order_over;

/// The largest difference of fractions at mirrored places, and of their sum from 1, that counts as rounding.
pub(super) const COEFFICIENT_TOLERANCE: f64 = 1e-14;

/// The largest deviation of a sum from 1, whatever the size of the fractions.
const LARGEST_DEFECT: f64 = 1e-8;

/// The fractions γ₁, …, γ_s into which a composition divides its step:
///
/// ```text
/// Ψ(h) = Φ(γ_s h) ∘ … ∘ Φ(γ_1 h),    γ_1 + … + γ_s = 1
/// ```
///
/// Beyond order 2 some fractions are negative (Sheng; Suzuki), so Φ must also accept negative steps. The named sets are
/// symmetric, γ_i = γ_j for j = s + 1 − i, and raise the order of a symmetric Φ of order 2. Their orders are computed
/// by [`order_over`](Self::order_over), not quoted.
///
/// Source: Hairer, Lubich & Wanner, *Geometric Numerical Integration*, 2nd ed. (2006), §V.3.
///
/// # Example
/// ```
/// use collective_integrators::Substeps;
/// let yoshida = Substeps::yoshida4();
/// assert_eq!(yoshida.order_over(2, true), 4);
/// // from a method of order 2 that is not symmetric it makes one of order 3
/// assert_eq!(yoshida.order_over(2, false), 3);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Substeps {
    fractions: Vec<f64>,
}

/// Checks that fractions add up to 1 to within rounding. The tolerance grows with the fractions up to a limit, since
/// rounding leaves nothing of a sum of very large fractions.
///
/// # Errors
/// Returns [`SchemeError::SubstepSum`] with their sum.
pub(super) fn require_unit_sum(fractions: &[f64]) -> Result<(), SchemeError> {
    let sum: f64 = fractions.iter().sum();
    let size: f64 = fractions.iter().map(|x| x.abs()).sum();
    let allowed = (COEFFICIENT_TOLERANCE * size).min(LARGEST_DEFECT);
    if (sum - 1.0).abs() <= allowed { Ok(()) } else { Err(SchemeError::SubstepSum { sum }) }
}

impl Substeps {
    /// Creates the substeps from the given fractions, the first substep first.
    ///
    /// # Errors
    /// Returns [`SchemeError::NoStages`] if there are no fractions, [`SchemeError::NotFinite`] if one is not finite,
    /// and [`SchemeError::SubstepSum`] if their sum is not 1 to within 1e-14 Σ|γ_i|, and to within 1e-8.
    pub fn new(fractions: &[f64]) -> Result<Self, SchemeError> {
        if fractions.is_empty() {
            return Err(SchemeError::NoStages);
        }
        if fractions.iter().any(|x| !x.is_finite()) {
            return Err(SchemeError::NotFinite);
        }
        require_unit_sum(fractions)?;
        Ok(Self { fractions: fractions.to_vec() })
    }

    /// Returns the fractions γ₁, …, γ_s.
    #[must_use]
    pub fn fractions(&self) -> &[f64] {
        &self.fractions
    }

    /// Returns whether the fractions are the same in reverse order, γ_i = γ_j for j = s + 1 − i.
    ///
    /// Compositions of a symmetric method are then symmetric.
    #[must_use]
    pub fn is_symmetric(&self) -> bool {
        let reversed = self.fractions.iter().rev();
        self.fractions.iter().zip(reversed).all(|(x, y)| (x - y).abs() <= COEFFICIENT_TOLERANCE)
    }

    /// Computes the order of the composition, for every method Φ of order p = `order`, symmetric or not.
    ///
    /// The composition of formal exponentials exp(γ_i h E₁ + (γ_i h)ᵖ⁺¹ E(p+1) + …) is compared with exp(h E₁) word by
    /// word. Even powers are absent if Φ is symmetric. Orders above max(12, p + 2) are not tested. For p ≥ 2³¹ no order
    /// above p is found, since powers of rounded γ have no meaning there.
    ///
    /// Source: Murua & Sanz-Serna, *Order conditions for numerical integrators obtained by
    /// composing simpler integrators*, Phil. Trans. R. Soc. A 357 (1999).
    #[must_use]
    pub fn order_over(&self, order: usize, symmetric: bool) -> usize {
        order_over(&self.fractions, order, symmetric)
    }

    /// Creates the triple jump, which raises symmetric methods of even order p to order p + 2:
    ///
    /// ```text
    /// γ₁ = γ₃ = 1/(2 − r),    γ₂ = −r/(2 − r),    r = 2^(1/(p+1))
    /// ```
    ///
    /// Source: Creutz & Gocksch, Phys. Rev. Lett. 63 (1989); Yoshida, *Construction of higher order
    /// symplectic integrators*, Phys. Lett. A 150 (1990); Hairer, Lubich &
    /// Wanner, eq. (II.4.4).
    ///
    /// # Errors
    /// Returns [`SchemeError::OddOrder`] unless p is even and at least 2.
    ///
    /// # Example
    /// ```
    /// use collective_integrators::Substeps;
    /// assert_eq!(Substeps::triple_jump(6)?.order_over(6, true), 8);
    /// assert!(Substeps::triple_jump(0).is_err() && Substeps::triple_jump(3).is_err());
    /// # Ok::<(), collective_integrators::SchemeError>(())
    /// ```
    pub fn triple_jump(order: usize) -> Result<Self, SchemeError> {
        require_even("the triple jump", order)?;
        Ok(Self::jump(1, order))
    }

    /// Creates Suzuki's fractal, with five substeps none of which is longer than the step:
    ///
    /// ```text
    /// γ₁ = γ₂ = γ₄ = γ₅ = 1/(4 − r),    γ₃ = −r/(4 − r),    r = 4^(1/(p+1))
    /// ```
    ///
    /// Source: Suzuki, *Fractal decomposition of exponential operators*, Phys. Lett. A 146 (1990).
    ///
    /// # Errors
    /// Returns [`SchemeError::OddOrder`] unless p is even and at least 2.
    pub fn suzuki(order: usize) -> Result<Self, SchemeError> {
        require_even("Suzuki's fractal", order)?;
        Ok(Self::jump(2, order))
    }

    /// Creates m substeps forwards, one backwards and m forwards: order p + 2 over a symmetric method of order p ≥ 2.
    ///
    /// With r = (2m)^(1/(p+1)) they satisfy 2m γᵖ⁺¹ = rᵖ⁺¹ γᵖ⁺¹.
    pub(crate) fn jump(forwards: usize, order: usize) -> Self {
        let count = 2.0 * forwards as f64;
        let root = count.powf(1.0 / (order as f64 + 1.0));
        let outer = 1.0 / (count - root);
        let mut fractions = vec![outer; 2 * forwards + 1];
        fractions[forwards] = -root * outer;
        Self { fractions }
    }

    /// Creates the substeps γ₁, …, γ_m, …, γ₁ from the first half and the middle one.
    pub(crate) fn palindrome(half: &[f64]) -> Self {
        let mirrored = half.iter().rev().skip(1);
        Self { fractions: half.iter().chain(mirrored).copied().collect() }
    }
}

fn require_even(family: &'static str, order: usize) -> Result<(), SchemeError> {
    if order >= 2 && order.is_multiple_of(2) {
        Ok(())
    } else {
        Err(SchemeError::OddOrder { family, order })
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
        for order in [2, 4, 6, 8, 10, 14, 24, 100, 1000, 10_000] {
            let jumps = [Substeps::triple_jump, Substeps::suzuki].map(|jump| {
                let over = |p: usize| jump(p).map(|substeps| substeps.order_over(order, true));
                (over(order), over(order + 2))
            });
            let expected = (Ok(order + 2), Ok(order));
            assert_eq!(jumps, [expected.clone(), expected]);
        }
    }

    #[test]
    fn orders_that_symmetric_methods_do_not_have_are_refused() {
        for order in [0, 1, 3, 15, usize::MAX] {
            let families = [Substeps::triple_jump(order), Substeps::suzuki(order)];
            for jump in families {
                assert!(matches!(jump, Err(SchemeError::OddOrder { order: o, .. }) if o == order));
            }
        }
        for order in [2, 1 << 20, usize::MAX - 1] {
            let jump = Substeps::triple_jump(order);
            assert!(jump.is_ok_and(|s| Substeps::new(s.fractions()) == Ok(s)), "{order}");
        }
    }

    /// A composition over a method of any order, however high, has at least the order of the base if the fractions add
    /// up to 1.
    #[test]
    fn orders_over_any_base() {
        let halves = Substeps { fractions: vec![0.5, 0.5] };
        let short = Substeps { fractions: vec![0.5, 0.4] };
        for order in [1, 12, 13, 1000, i32::MAX as usize, 1 << 40, usize::MAX - 1, usize::MAX] {
            for symmetric in [true, false] {
                for substeps in [&halves, &Substeps::kahan_li8(), &Substeps::yoshida4()] {
                    let found = substeps.order_over(order, symmetric);
                    // a symmetric method has an even order
                    let least = order.saturating_add(usize::from(symmetric && order % 2 == 1));
                    assert!(found == least || order < 12 && found > order, "{order}: {found}");
                }
                assert_eq!(short.order_over(order, symmetric), 0);
            }
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
        let sum = f64::INFINITY;
        assert_eq!(Substeps::new(&[1e308, 1e308]), Err(SchemeError::SubstepSum { sum }));
        // Large fractions cancel, but not to anything but 1.
        assert!(Substeps::new(&[1e5, 1.0 - 1e5]).is_ok());
        let cancelled = Substeps::new(&[1e20, 0.5, -1e20]);
        assert!(matches!(cancelled, Err(SchemeError::SubstepSum { .. })));
        assert!(Substeps::new(&[0.25, 0.75]).is_ok_and(|s| !s.is_symmetric()));
    }
}
