//! Runge–Kutta methods that have a name.

use crate::error::SchemeError;
use crate::schemes::runge_kutta::RungeKutta;
use crate::step_fractions::substeps::Substeps;
use crate::tableaux::dop853;
use crate::tableaux::tableau::Tableau;

impl RungeKutta {
    /// Creates the implicit midpoint rule z₁ = z + h X((z + z₁)/2): order 2, symplectic, symmetric.
    #[must_use]
    pub fn implicit_midpoint() -> Self {
        Self::literal(&[0.5], &[1.0])
    }

    /// Creates Runge's explicit midpoint rule z₁ = z + h X(z + (h/2) X(z)): order 2.
    #[must_use]
    pub fn explicit_midpoint() -> Self {
        Self::literal(&[0.0, 0.0, 0.5, 0.0], &[0.0, 1.0])
    }

    /// Creates the classical fourth-order method of Runge and Kutta:
    ///
    /// ```text
    /// z₁ = z + (h/6) (k₁ + 2k₂ + 2k₃ + k₄),
    /// k₁ = X(z),  k₂ = X(z + (h/2) k₁),  k₃ = X(z + (h/2) k₂),  k₄ = X(z + h k₃)
    /// ```
    ///
    /// Source: Kutta, *Beitrag zur näherungsweisen Integration totaler Differentialgleichungen*, Z. Math. Phys. 46 (1901).
    #[must_use]
    #[rustfmt::skip]
    pub fn rk4() -> Self {
        let (third, sixth) = (1.0 / 3.0, 1.0 / 6.0);
        Self::literal(
            &[0.0, 0.0, 0.0, 0.0,
              0.5, 0.0, 0.0, 0.0,
              0.0, 0.5, 0.0, 0.0,
              0.0, 0.0, 1.0, 0.0],
            &[sixth, third, third, sixth],
        )
    }

    /// Creates the explicit method of order 8 of Dormand and Prince, with 12 stages and a fixed step.
    ///
    /// It is the method that the code DOP853 propagates, without its error estimate. It serves as a reference for runs
    /// in which structure does not matter.
    ///
    /// Source: Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, 2nd ed.
    /// (1993), §II.5 and Appendix.
    #[must_use]
    pub fn dop853() -> Self {
        let stages = dop853::B.len();
        let mut a = vec![0.0; stages * stages];
        for (row, entries) in a.chunks_exact_mut(stages).skip(1).zip(dop853::A) {
            row[..entries.len()].copy_from_slice(entries);
        }
        Self::literal(&a, &dop853::B)
    }

    /// Creates the symplectic diagonally implicit method with weights b: see [`Tableau::symplectic_dirk`].
    ///
    /// Its stages are solved together. The [`Composition`](crate::Composition) of midpoint rules is the same map, but
    /// solves one stage after the other.
    ///
    /// # Errors
    /// Returns [`SchemeError::NoStages`] if there is no weight, or [`SchemeError::NotFinite`] if one is not finite.
    pub fn symplectic_dirk(b: &[f64]) -> Result<Self, SchemeError> {
        Tableau::symplectic_dirk(b).map(Self::new)
    }

    /// Creates the symplectic diagonally implicit method of Qin and Zhang: order 2, 2 stages, b = (½, ½).
    ///
    /// Source: Qin & Zhang, *Symplectic Runge–Kutta schemes for Hamiltonian systems*, J. Comput.
    /// Math. 10 (1992).
    #[must_use]
    pub fn qin_zhang() -> Self {
        Self::literal(&[0.25, 0.0, 0.5, 0.25], &[0.5, 0.5])
    }

    /// Creates the symplectic diagonally implicit method of Sanz-Serna and Abia: order 4, 3 stages.
    ///
    /// It has the weights of the [triple jump](crate::Substeps::triple_jump).
    ///
    /// Source: Sanz-Serna & Abia, SIAM J. Numer. Anal. 28 (1991).
    #[must_use]
    pub fn sanz_serna_abia() -> Self {
        let substeps = Substeps::yoshida4();
        let (b1, b2) = (substeps.fractions()[0], substeps.fractions()[1]);
        let a = [0.5 * b1, 0.0, 0.0, b1, 0.5 * b2, 0.0, b1, b2, 0.5 * b1];
        Self::literal(&a, &[b1, b2, b1])
    }

    /// Creates Gauss–Legendre collocation with `stages` stages: order 2s, symplectic, symmetric.
    ///
    /// Source: Hairer, Lubich & Wanner, *Geometric Numerical Integration*, 2nd ed. (2006), §II.1.3 and Theorem VI.4.2.
    ///
    /// # Errors
    /// Returns [`SchemeError::NoStages`] if `stages` is 0.
    pub fn gauss(stages: usize) -> Result<Self, SchemeError> {
        Tableau::gauss(stages).map(Self::new)
    }

    fn literal(a: &[f64], b: &[f64]) -> Self {
        Self::new(Tableau::literal(a, b))
    }
}
