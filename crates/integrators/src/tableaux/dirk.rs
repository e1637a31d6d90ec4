//! Symplectic diagonally implicit Runge–Kutta methods.

use crate::error::SchemeError;
use crate::tableaux::tableau::Tableau;

impl Tableau {
    /// Creates the symplectic diagonally implicit method with weights b:
    ///
    /// ```text
    /// a_ij = b_j for j < i,    a_ii = b_i/2,    a_ij = 0 for j > i
    /// ```
    ///
    /// It is the composition of midpoint rules with steps b_1 h, …, b_s h. Every symplectic diagonally implicit method
    /// without a zero weight is of this form.
    ///
    /// Source: Sanz-Serna & Abia, *Order conditions for canonical Runge–Kutta schemes*, SIAM J.
    /// Numer. Anal. 28 (1991); Hairer, Lubich & Wanner, *Geometric Numerical Integration*, Thm.
    /// VI.4.4.
    ///
    /// # Errors
    /// Returns [`SchemeError::NoStages`] if there is no weight, or [`SchemeError::NotFinite`] if one is not finite.
    pub fn symplectic_dirk(b: &[f64]) -> Result<Self, SchemeError> {
        let s = b.len();
        let entry = |i: usize, j: usize| match j.cmp(&i) {
            core::cmp::Ordering::Less => b[j],
            core::cmp::Ordering::Equal => 0.5 * b[j],
            core::cmp::Ordering::Greater => 0.0,
        };
        let a: Vec<f64> = (0..s * s).map(|n| entry(n / s, n % s)).collect();
        Self::new(&a, b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::step_fractions::substeps::Substeps;

    #[test]
    fn two_computations_of_the_order_agree() {
        let sets = [
            Substeps::yoshida4(),
            Substeps::suzuki4(),
            Substeps::mclachlan4(),
            Substeps::yoshida6(),
            Substeps::mclachlan6(),
            Substeps::kahan_li6(),
            Substeps::mclachlan8(),
            Substeps::kahan_li8(),
        ];
        for substeps in sets {
            let tableau = Tableau::symplectic_dirk(substeps.fractions());
            let properties = tableau.map(|t| (t.order(), t.is_symplectic(), t.is_symmetric()));
            assert_eq!(properties, Ok((substeps.order_over(2, true), true, true)));
        }
        assert_eq!(Tableau::symplectic_dirk(&[]), Err(SchemeError::NoStages));
        let lopsided = Tableau::symplectic_dirk(&[0.3, 0.7]);
        let properties = lopsided.map(|t| (t.order(), t.is_symplectic(), t.is_symmetric()));
        assert_eq!(properties, Ok((2, true, false)));
    }
}
