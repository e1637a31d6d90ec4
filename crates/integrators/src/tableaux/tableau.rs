//! Butcher tableaux: [`Tableau`].

use crate::error::SchemeError;
use crate::tableaux::order_conditions::order_of;

/// The largest value of a computed algebraic condition on rounded coefficients that counts as zero.
///
/// A condition sums up to s² products of coefficients of size 1, each rounded to 2⁻⁵³.
pub(crate) const COEFFICIENT_TOLERANCE: f64 = 1e-13;

/// The coefficients of a Runge–Kutta method:
///
/// ```text
/// k_i = X(z + h Σ_j a_ij k_j),    z₁ = z + h Σ_i b_i k_i,    c_i = Σ_j a_ij
/// ```
///
/// All properties are computed from the coefficients.
///
/// Source: Hairer, Lubich & Wanner, *Geometric Numerical Integration*, 2nd ed. (2006), Def. II.1.1.
///
/// # Example
/// ```
/// use collective_integrators::Tableau;
/// let midpoint = Tableau::new(&[0.5], &[1.0]).unwrap();
/// assert_eq!(midpoint.order(), 2);
/// assert!(midpoint.is_symplectic() && midpoint.is_symmetric() && !midpoint.is_explicit());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Tableau {
    a: Vec<f64>,
    b: Vec<f64>,
    c: Vec<f64>,
    order: usize,
    /// The rounding errors of a and b; empty if they are exact, or if none were given.
    a_low: Vec<f64>,
    b_low: Vec<f64>,
}

impl Tableau {
    /// Creates a tableau from the matrix a, row by row, and the weights b.
    ///
    /// # Errors
    /// Returns [`SchemeError::NoStages`] if there is no stage, [`SchemeError::Shape`] if a does not have s² entries for
    /// s weights b, and [`SchemeError::NotFinite`] if a coefficient is not finite.
    pub fn new(a: &[f64], b: &[f64]) -> Result<Self, SchemeError> {
        let stages = b.len();
        if stages == 0 {
            return Err(SchemeError::NoStages);
        }
        check_coefficients(stages, a, b)?;
        let c: Vec<f64> = a.chunks_exact(stages).map(|row| row.iter().sum()).collect();
        let order = order_of(a, b, &c);
        let (a, b) = (a.to_vec(), b.to_vec());
        Ok(Self { a, b, c, order, a_low: Vec::new(), b_low: Vec::new() })
    }

    /// Returns the tableau with the low parts of its coefficients, which have a relative size of 2⁻⁵³ or less.
    ///
    /// The sums a + a_low and b + b_low are the coefficients to twice the precision. A step that uses the low parts
    /// avoids the error of rounded coefficients, which is the same in every step.
    ///
    /// Source: Hairer, McLachlan & Razakarivony, *Achieving Brouwer's law with implicit Runge–Kutta
    /// methods*, BIT 48 (2008), §2.
    ///
    /// # Errors
    /// Returns [`SchemeError::Shape`] unless a_low has s² numbers and b_low has s, and [`SchemeError::NotFinite`] if
    /// one of them is not finite.
    ///
    /// # Example
    /// ```
    /// use collective_integrators::{SchemeError, Tableau};
    /// let third = 1.0 / 3.0; // 1/3 − 2⁻⁵⁴/3
    /// let low = 2.0_f64.powi(-54) / 3.0;
    /// let tableau = Tableau::new(&[third], &[1.0])?;
    /// assert!(tableau.clone().with_low_parts(&[low], &[0.0]).is_ok());
    /// let none_for_b = tableau.with_low_parts(&[low], &[]);
    /// assert_eq!(none_for_b, Err(SchemeError::Shape { stages: 1, a: 1, b: 0 }));
    /// # Ok::<(), SchemeError>(())
    /// ```
    pub fn with_low_parts(self, a_low: &[f64], b_low: &[f64]) -> Result<Self, SchemeError> {
        check_coefficients(self.stages(), a_low, b_low)?;
        Ok(Self { a_low: a_low.to_vec(), b_low: b_low.to_vec(), ..self })
    }

    /// Returns the low parts of a row of a; empty if there are none.
    #[inline]
    pub(crate) fn row_low(&self, i: usize) -> &[f64] {
        part(&self.a_low, i, self.b.len())
    }

    /// Returns the low parts of b; empty if there are none.
    #[inline]
    pub(crate) fn weights_low(&self) -> &[f64] {
        &self.b_low
    }

    /// Returns the number s of stages.
    #[must_use]
    pub fn stages(&self) -> usize {
        self.b.len()
    }

    /// Returns the rows (a_i1, …, a_is) of the matrix.
    pub fn rows(&self) -> impl Iterator<Item = &[f64]> {
        self.a.chunks_exact(self.stages())
    }

    /// Returns the row (a_i1, …, a_is); empty for i ≥ s.
    #[inline]
    #[must_use]
    pub fn row(&self, i: usize) -> &[f64] {
        part(&self.a, i, self.b.len())
    }

    /// Returns the weights b of the method.
    #[must_use]
    pub fn weights(&self) -> &[f64] {
        &self.b
    }

    /// Returns the nodes c of the method.
    #[must_use]
    pub fn nodes(&self) -> &[f64] {
        &self.c
    }

    /// Returns the order of convergence, from the order conditions; 0 if the method is not consistent.
    #[must_use]
    pub fn order(&self) -> usize {
        self.order
    }

    /// Returns whether a is strictly lower triangular, so that each stage follows from the earlier ones.
    #[must_use]
    pub fn is_explicit(&self) -> bool {
        self.rows().enumerate().all(|(i, row)| row[i..].iter().all(|&x| x == 0.0))
    }

    /// Returns whether the method is symplectic, b_i a_ij + b_j a_ji = b_i b_j. It then conserves every quadratic
    /// invariant.
    ///
    /// Source: Hairer, Lubich & Wanner, Thm. IV.2.2 and Thm. VI.4.3.
    #[must_use]
    pub fn is_symplectic(&self) -> bool {
        self.all_pairs(|i, j| {
            let (b, s) = (&self.b, self.stages());
            b[i] * self.a[i * s + j] + b[j] * self.a[j * s + i] - b[i] * b[j]
        })
    }

    /// Returns whether the method is symmetric: it is its own adjoint, Φ₋ₕ ∘ Φₕ = id.
    ///
    /// The condition is a_mn + a_ij = b_j for m = s + 1 − i and n = s + 1 − j.
    ///
    /// Source: Hairer, Lubich & Wanner, Thm. V.2.3.
    #[must_use]
    pub fn is_symmetric(&self) -> bool {
        self.all_pairs(|i, j| {
            let s = self.stages();
            self.a[(s - 1 - i) * s + (s - 1 - j)] + self.a[i * s + j] - self.b[j]
        })
    }

    /// Returns the tableau (â, b) that makes the pair of a and â a symplectic partitioned method:
    ///
    /// ```text
    /// â_ij = b_j − b_j a_ji / b_i
    /// ```
    ///
    /// The weights b are the same. The conjugate of the conjugate is the original tableau, and symplectic tableaux are
    /// conjugate to themselves.
    ///
    /// Source: Hairer, Lubich & Wanner, Thm. VI.4.6.
    ///
    /// # Errors
    /// Returns [`SchemeError::NotFinite`] if a weight is zero.
    pub fn symplectic_conjugate(&self) -> Result<Self, SchemeError> {
        let (b, s) = (&self.b, self.stages());
        let entry = |n: usize| {
            let (i, j) = (n / s, n % s);
            b[j] - b[j] * self.a[j * s + i] / b[i]
        };
        Self::new(&(0..s * s).map(entry).collect::<Vec<f64>>(), b)
    }

    /// Creates a tableau from coefficients in this crate, whose shape is evident at the call.
    #[allow(clippy::expect_used)]
    pub(crate) fn literal(a: &[f64], b: &[f64]) -> Self {
        Self::new(a, b).expect("s² finite coefficients and s weights")
    }

    /// Returns the matrix a, row by row.
    pub(crate) fn matrix(&self) -> &[f64] {
        &self.a
    }

    fn all_pairs(&self, defect: impl Fn(usize, usize) -> f64) -> bool {
        let s = self.stages();
        (0..s).all(|i| (0..s).all(|j| defect(i, j).abs() <= COEFFICIENT_TOLERANCE))
    }
}

/// Checks that there are s² finite numbers for a and s for b.
fn check_coefficients(stages: usize, a: &[f64], b: &[f64]) -> Result<(), SchemeError> {
    if a.len() != stages * stages || b.len() != stages {
        return Err(SchemeError::Shape { stages, a: a.len(), b: b.len() });
    }
    if a.iter().chain(b).any(|x| !x.is_finite()) {
        return Err(SchemeError::NotFinite);
    }
    Ok(())
}

/// Returns the entries i s, …, i s + s − 1, or none, without the division of `chunks_exact`.
#[inline]
fn part(entries: &[f64], i: usize, stages: usize) -> &[f64] {
    let rest = entries.get(i.saturating_mul(stages)..);
    rest.and_then(|rest| rest.get(..stages)).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use crate::error::SchemeError;
    use crate::tableaux::tableau::Tableau;

    #[test]
    fn low_parts_of_another_shape_are_refused() {
        let tableau = || Tableau::literal(&[0.25, 0.0, 0.5, 0.25], &[0.5, 0.5]);
        for (a, b) in [(0, 0), (3, 2), (5, 2), (4, 1), (4, 3), (2, 4)] {
            let refused = tableau().with_low_parts(&[0.0; 5][..a], &[0.0; 5][..b]);
            assert_eq!(refused, Err(SchemeError::Shape { stages: 2, a, b }));
        }
        let infinite = tableau().with_low_parts(&[0.0; 4], &[0.0, f64::INFINITY]);
        assert_eq!(infinite, Err(SchemeError::NotFinite));
        assert!(tableau().with_low_parts(&[0.0; 4], &[0.0; 2]).is_ok());
        let message = SchemeError::Shape { stages: 2, a: 3, b: 2 }.to_string();
        assert!(message.contains("2×2 coefficients a") && message.contains("got 3 and 2"));
    }

    #[test]
    fn there_is_no_row_beyond_the_last() -> Result<(), SchemeError> {
        let a = [0.25, 0.0, 0.5, 0.25];
        let tableau = Tableau::literal(&a, &[0.5, 0.5]).with_low_parts(&a, &[0.5, 0.5])?;
        assert!(tableau.rows().eq([0, 1].map(|i| tableau.row(i))));
        assert_eq!(tableau.row_low(1), [0.5, 0.25]);
        assert!([2, usize::MAX].iter().all(|&i| tableau.row(i).is_empty()));
        assert!(Tableau::literal(&a, &[0.5, 0.5]).row_low(0).is_empty());
        Ok(())
    }
}
