//! The coefficients a, b of splittings into two parts: [`AlternatingSubsteps`].

use crate::error::SchemeError;
use crate::step_fractions::alternating_conditions::{nystrom_order, order_of_words};
use crate::step_fractions::substeps::{COEFFICIENT_TOLERANCE, Substeps, require_unit_sum};

/// The fractions of a step for which the flows φ_1 and φ_2 of two parts alternate:
///
/// ```text
/// Ψ(h) = φ_2(b_m h) ∘ φ_1(a_m h) ∘ … ∘ φ_2(b_1 h) ∘ φ_1(a_1 h),    Σ a_i = Σ b_i = 1
/// ```
///
/// The first or the last fraction may be zero. With b_m = 0 a step begins and ends with part 1, and with a_1 = 0 it
/// begins and ends with part 2.
///
/// If the part h₁ is quadratic in the momenta and h₂ does not depend on them, brackets such as {h₂,{h₂,{h₂,h₁}}}
/// vanish, and many error terms with them. Such a splitting is a Runge–Kutta–Nyström method, for which the two sets of
/// Blanes and Moan are designed. The momenta are p for h = ½|p|² + V(q). They are Π for a top with kinetic energy
/// ½Π·I⁻¹Π and weight m g l Γ·c.
///
/// Source: McLachlan & Quispel, *Splitting methods*, Acta Numer. 11 (2002).
///
/// # Example
/// ```
/// use collective_integrators::AlternatingSubsteps;
/// let sets = AlternatingSubsteps::blanes_moan6();
/// assert_eq!((sets.nystrom_order(), sets.order()), (6, 4)); // less for any two parts
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct AlternatingSubsteps {
    first: Vec<f64>,
    second: Vec<f64>,
}

impl AlternatingSubsteps {
    /// Creates the sequence from the fractions a and b, in the order in which the flows run.
    ///
    /// # Errors
    /// Returns [`SchemeError::NoStages`] if there are no fractions, [`SchemeError::Stages`] if a and b differ in
    /// number, [`SchemeError::NotFinite`] if one is not finite, and [`SchemeError::SubstepSum`] if a or b does not add
    /// up to 1 to within 1e-14 Σ|a_i|, and to within 1e-8.
    pub fn new(first: &[f64], second: &[f64]) -> Result<Self, SchemeError> {
        if first.len() != second.len() {
            return Err(SchemeError::Stages { q: first.len(), p: second.len() });
        }
        if first.is_empty() {
            return Err(SchemeError::NoStages);
        }
        if first.iter().chain(second).any(|x| !x.is_finite()) {
            return Err(SchemeError::NotFinite);
        }
        require_unit_sum(first)?;
        require_unit_sum(second)?;
        Ok(Self { first: first.to_vec(), second: second.to_vec() })
    }

    /// Creates the sequence of a composition of Strang's splitting.
    ///
    /// Each substep of γ h runs part 2 for γh/2, part 1 for γh and part 2 for γh/2. Neighbouring flows of part 2 are
    /// merged. Part 1 runs once per substep, and should be the more expensive one.
    #[must_use]
    pub fn composed(substeps: &Substeps) -> Self {
        let gamma = substeps.fractions();
        let ends = |i: usize| i.checked_sub(1).and_then(|i| gamma.get(i)).copied().unwrap_or(0.0);
        Self {
            first: core::iter::once(0.0).chain(gamma.iter().copied()).collect(),
            second: (0..=gamma.len())
                .map(|i| 0.5 * (ends(i) + gamma.get(i).copied().unwrap_or(0.0)))
                .collect(),
        }
    }

    /// Creates the set SRKN₆ᵇ of order 4 for Runge–Kutta–Nyström systems: 6 stages, beginning and ending with part 2.
    ///
    /// Source: Blanes & Moan, *Practical symplectic partitioned Runge–Kutta and
    /// Runge–Kutta–Nyström methods*, J. Comput. Appl. Math. 142 (2002), Table 3.
    #[must_use]
    pub fn blanes_moan4() -> Self {
        let a = [0.245_298_957_184_271, 0.604_872_665_711_08];
        let b = [0.082_984_406_417_405_2, 0.396_309_801_498_368, -0.039_056_304_922_348_6];
        let (a3, b4) = (0.5 - a[0] - a[1], 1.0 - 2.0 * (b[0] + b[1] + b[2]));
        Self {
            first: vec![0.0, a[0], a[1], a3, a3, a[1], a[0]],
            second: vec![b[0], b[1], b[2], b4, b[2], b[1], b[0]],
        }
    }

    /// Creates the set SRKN₁₄ᵃ of order 6 for Runge–Kutta–Nyström systems: 14 stages, beginning and ending with part 1.
    ///
    /// Source: Blanes & Moan, J. Comput. Appl. Math. 142 (2002), Table 3.
    #[must_use]
    pub fn blanes_moan6() -> Self {
        let a = [
            0.037_859_319_840_611_6,
            0.102_635_633_102_435,
            -0.025_867_888_266_558_7,
            0.314_241_403_071_447,
            -0.130_144_459_517_415,
            0.106_417_700_369_543,
            -0.008_794_243_128_510_58,
        ];
        let b = [
            0.091_719_152_624_461_65,
            0.183_983_170_005_006,
            -0.056_534_365_832_888_27,
            0.004_914_688_774_712_854,
            0.143_761_127_168_358,
            0.328_567_693_746_804,
        ];
        let middle = 1.0 - 2.0 * a.iter().sum::<f64>();
        let b7 = 0.5 - b.iter().sum::<f64>();
        let backwards = |x: &[f64]| x.iter().rev().copied().collect::<Vec<f64>>();
        Self {
            first: [&a[..], &[middle], &backwards(&a)].concat(),
            second: [&b[..], &[b7, b7], &backwards(&b), &[0.0]].concat(),
        }
    }

    /// Returns the fractions a₁, …, a_m of part 1.
    #[must_use]
    pub fn first(&self) -> &[f64] {
        &self.first
    }

    /// Returns the fractions b₁, …, b_m of part 2.
    #[must_use]
    pub fn second(&self) -> &[f64] {
        &self.second
    }

    /// Returns whether the sequence of the nonzero fractions is the same in reverse.
    ///
    /// The splitting is then symmetric in time, Φ₋ₕ ∘ Φₕ = id, for any two parts.
    #[must_use]
    pub fn is_symmetric(&self) -> bool {
        let pairs = self.first.iter().zip(&self.second);
        let runs: Vec<_> =
            pairs.flat_map(|(&a, &b)| [(1, a), (2, b)]).filter(|&(_, x)| x != 0.0).collect();
        let same = |((i, x), (j, y)): (&(u8, f64), &(u8, f64))| {
            i == j && (x - y).abs() <= COEFFICIENT_TOLERANCE
        };
        runs.iter().zip(runs.iter().rev()).all(same)
    }

    /// Computes the order of the splitting of a vector field A + B, whatever A and B are.
    ///
    /// The product of exponentials is compared with exp h(A + B) word by word in two letters. Orders above 12 are not
    /// tested.
    #[must_use]
    pub fn order(&self) -> usize {
        order_of_words(&self.first, &self.second)
    }

    /// Computes the order for h₁ quadratic in the momenta and h₂ independent of them.
    ///
    /// The conditions of all Nyström trees are tested, up to order 12.
    ///
    /// Source: Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, 2nd ed.,
    /// Thm. II.14.10; the trees suffice for any such h₁ and h₂: McLachlan & Ryland, *The algebraic
    /// entropy of classical mechanics*, J. Math. Phys. 44 (2003).
    #[must_use]
    pub fn nystrom_order(&self) -> usize {
        nystrom_order(&self.first, &self.second)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_orders_of_the_literature_come_out() {
        let strang = Substeps::new(&[1.0]).map(|one| AlternatingSubsteps::composed(&one));
        assert_eq!(strang.clone().map(|s| (s.order(), s.nystrom_order())), Ok((2, 2)));
        assert_eq!(strang, AlternatingSubsteps::new(&[0.0, 1.0], &[0.5, 0.5]));
        let sets = [
            (AlternatingSubsteps::blanes_moan4(), 6, 4, 4),
            (AlternatingSubsteps::blanes_moan6(), 14, 6, 4),
            (AlternatingSubsteps::composed(&Substeps::mclachlan4()), 5, 4, 4),
            (AlternatingSubsteps::composed(&Substeps::kahan_li8()), 17, 8, 8),
            (AlternatingSubsteps::composed(&Substeps::sofroniou_spaletta10()), 35, 10, 10),
        ];
        for (substeps, stages, nystrom, order) in sets {
            assert_eq!(substeps.nystrom_order(), nystrom, "{substeps:?}");
            assert_eq!(substeps.order(), order, "{substeps:?}");
            assert!(substeps.is_symmetric(), "{substeps:?}");
            let runs = |part: &[f64]| part.iter().filter(|&&x| x != 0.0).count();
            assert_eq!(runs(substeps.first()).min(runs(substeps.second())), stages);
            let again = AlternatingSubsteps::new(substeps.first(), substeps.second());
            assert_eq!(again, Ok(substeps));
        }
    }

    #[test]
    fn a_wrong_coefficient_costs_order() {
        for (substeps, order) in
            [(AlternatingSubsteps::blanes_moan4(), 4), (AlternatingSubsteps::blanes_moan6(), 6)]
        {
            for part in [0, 1] {
                let mut parts = [substeps.first().to_vec(), substeps.second().to_vec()];
                parts[part][1] += 1e-9;
                parts[part][2] -= 1e-9;
                let wrong = AlternatingSubsteps::new(&parts[0], &parts[1]);
                assert!(wrong.is_ok_and(|w| w.nystrom_order() < order), "{order} {part}");
            }
        }
        let one_way = AlternatingSubsteps::new(&[1.0], &[1.0]);
        assert!(one_way.is_ok_and(|s| !s.is_symmetric() && s.order() == 1));
        assert_eq!(AlternatingSubsteps::new(&[], &[]), Err(SchemeError::NoStages));
        let uneven = AlternatingSubsteps::new(&[1.0], &[0.5, 0.5]);
        assert_eq!(uneven, Err(SchemeError::Stages { q: 1, p: 2 }));
        let short = AlternatingSubsteps::new(&[1.0], &[0.5]);
        assert_eq!(short, Err(SchemeError::SubstepSum { sum: 0.5 }));
        let huge = AlternatingSubsteps::new(&[1e308, 1e308], &[0.5, 0.5]);
        assert_eq!(huge, Err(SchemeError::SubstepSum { sum: f64::INFINITY }));
        let nan = AlternatingSubsteps::new(&[1.0], &[f64::NAN]);
        assert_eq!(nan, Err(SchemeError::NotFinite));
    }
}
