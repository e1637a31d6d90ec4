//! The semiexplicit method of Jayawardana and Ohsawa, in its form as a Runge–Kutta method.

use crate::error::SchemeError;
use crate::step_fractions::substeps::Substeps;
use crate::tableaux::tableau::Tableau;

impl Tableau {
    /// Creates the semiexplicit symplectic method for Hamiltonians that do not separate.
    ///
    /// The phase space is doubled, with the Hamiltonian H(q, y) + H(x, p). In terms of u = (q, y) and v = (x, p) its
    /// equations are du/dt = X(v), dv/dt = X(u), in which q and p are not split. A step starts from a copy u = v = z,
    /// leaves the diagonal by ν, makes Strang's steps of sizes γ_i h,
    ///
    /// ```text
    /// u = z + ν,  v = z − ν;    v += ½γ_i h X(u),  u += γ_i h X(v),  v += ½γ_i h X(u)
    /// ```
    ///
    /// and returns by the same ν, u + ν = v − ν. The elimination of ν, which is linear in the values of X, leaves a
    /// Runge–Kutta method of 2s + 1 stages for s substeps. For one substep it is
    ///
    /// ```text
    ///   1/8  −1/4   1/8
    ///   3/8   1/4  −1/8
    ///   1/8   3/4   1/8
    ///  ────────────────
    ///   1/4   1/2   1/4
    /// ```
    ///
    /// It meets the condition for symplecticity, so that it conserves quadratic invariants. It descends to 𝔤∗ as every
    /// Runge–Kutta method does. Here all stages are iterated; the authors iterate on ν alone, which gives the same map.
    ///
    /// Source: Jayawardana & Ohsawa, *Semiexplicit symplectic integrators for non-separable
    /// Hamiltonian systems*, Math. Comp. 92 (2023); Ohsawa, *Preservation of quadratic invariants by
    /// semiexplicit symplectic integrators for nonseparable Hamiltonian systems*, SIAM J. Numer.
    /// Anal. 61 (2023); Pihajoki, Celest. Mech. Dyn. Astron. 121 (2015).
    ///
    /// # Errors
    /// Returns no [`SchemeError`] for valid [`Substeps`].
    ///
    /// # Example
    /// ```
    /// use collective_integrators::{RungeKutta, Scheme, Substeps, Tableau};
    /// let method = RungeKutta::new(Tableau::semiexplicit(&Substeps::yoshida4())?);
    /// assert!(method.is_symplectic() && method.is_symmetric() && method.order() == 4);
    /// # Ok::<(), collective_integrators::SchemeError>(())
    /// ```
    pub fn semiexplicit(substeps: &Substeps) -> Result<Self, SchemeError> {
        let stages = 2 * substeps.fractions().len() + 1;
        // u = z + ν + h Σ α_j k_j and v = z − ν + h Σ β_j k_j at the current point of the step.
        let (mut alpha, mut beta) = (vec![0.0; stages], vec![0.0; stages]);
        let mut rows = vec![alpha.clone()];
        for (i, gamma) in substeps.fractions().iter().enumerate() {
            beta[2 * i] += 0.5 * gamma;
            rows.push(beta.clone());
            alpha[2 * i + 1] += gamma;
            rows.push(alpha.clone());
            beta[2 * i + 2] += 0.5 * gamma;
        }
        // ν = (h/4) Σ (β_j − α_j) k_j at the end, with + in rows of u and − in rows of v.
        for (row, sign) in rows.iter_mut().zip([0.25, -0.25].into_iter().cycle()) {
            for ((entry, alpha), beta) in row.iter_mut().zip(&alpha).zip(&beta) {
                *entry += sign * (beta - alpha);
            }
        }
        let b: Vec<f64> =
            alpha.iter().zip(&beta).map(|(alpha, beta)| 0.5 * (alpha + beta)).collect();
        Self::new(&rows.concat(), &b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn semiexplicit_methods_are_symplectic_runge_kutta_methods() {
        let once = Substeps::new(&[1.0]).and_then(|one| Tableau::semiexplicit(&one));
        let printed = [1.0, -2.0, 1.0, 3.0, 2.0, -1.0, 1.0, 6.0, 1.0].map(|x| x / 8.0);
        assert_eq!(once, Tableau::new(&printed, &[0.25, 0.5, 0.25]));
        assert!(once.is_ok_and(|t| t.order() == 2 && t.is_symplectic() && t.is_symmetric()));
        for (substeps, order) in [
            (Substeps::yoshida4(), 4),
            (Substeps::suzuki4(), 4),
            (Substeps::kahan_li6(), 6),
            (Substeps::kahan_li8(), 8),
        ] {
            let tableau = Tableau::semiexplicit(&substeps);
            let properties = tableau.map(|t| (t.order(), t.is_symplectic(), t.is_symmetric()));
            assert_eq!(properties, Ok((order, true, true)));
        }
    }
}
