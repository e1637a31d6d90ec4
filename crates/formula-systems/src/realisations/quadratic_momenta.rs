//! Quadratic momenta on a symplectic vector space: [`QuadraticMomenta`].

use crate::error::FormulaSystemError;
use lie_poisson::Real;
use nalgebra::{DMatrix, DVector};

/// Momenta J_a(z) = ½ z·S_a z on R²ᵐ with z = (q, p) and {q, p} = 1, one for each coordinate of 𝔤∗.
///
/// They are given by their matrices S_a, or by matrices ρ_a of a representation on Rᵐ, of which they are the momenta
/// J_a = p·ρ_a q. The dimensions are known only when the program runs. [`verdict`](Self::verdict) says whether they make a
/// Poisson map to 𝔤∗.
///
/// Source: R. I. McLachlan, K. Modin & O. Verdier, *Collective symplectic integrators*, Nonlinearity 27 (2014), for the
/// integrators that they make.
///
/// # Example
/// The momenta L = q × p of so(3) on R³, by its matrices:
/// ```
/// use lie_poisson_formula_systems::{FormulaSystem, QuadraticMomenta, SystemAlgebra};
/// use lie_poisson_formulas::Parameters;
/// use nalgebra::DMatrix;
/// let so3 = SystemAlgebra::named("so(3)")?;
/// let hat = |i: usize| DMatrix::from_fn(3, 3, |r, c| match (r, c) {
///     _ if r == (i + 2) % 3 && c == (i + 1) % 3 => 1.0,
///     _ if r == (i + 1) % 3 && c == (i + 2) % 3 => -1.0,
///     _ => 0.0,
/// });
/// let momenta = QuadraticMomenta::of_representation(&[hat(0), hat(1), hat(2)])?;
/// let verdict = momenta.verdict(so3.table(), so3.coordinates())?;
/// assert!(verdict.is_plus && verdict.defect < 1e-15 && verdict.descends());
/// let mut values = [0.0; 3];
/// momenta.values(&[1.0, 0.0, 0.0, 0.0, 2.0, 0.0], &mut values);
/// assert_eq!(values, [0.0, 0.0, 2.0]); // e₁ × 2e₂
///
/// // The collective integrator along this map
/// let own = so3.with_realisation(momenta)?;
/// let body = FormulaSystem::new(own, "(Pi1^2 + Pi2^2/2 + Pi3^2/4)/2", &Parameters::new())?;
/// let method = body.algebra().method("collective".parse()?, "gauss-8".parse()?, 0.0)?;
/// assert!(body.tangent_integrator(&method, &[1.0, 2.0, 0.5]).is_ok());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct QuadraticMomenta {
    /// The number m of degrees of freedom.
    freedoms: usize,
    /// The number of momenta.
    count: usize,
    /// The terms of the momenta, in the order of their numbers.
    terms: Vec<Term>,
}

/// The numbers a, i ≤ j and the coefficient of the term value z_i z_j of a momentum J_a.
pub(crate) type Term = (usize, usize, usize, f64);

/// Returns matrices by their rows.
///
/// # Errors
/// Returns [`FormulaSystemError::Realisation`] if rows of a matrix have different lengths.
pub fn matrices_of_rows(
    matrices: &[Vec<Vec<f64>>],
) -> Result<Vec<DMatrix<f64>>, FormulaSystemError> {
    let matrix = |(a, rows): (usize, &Vec<Vec<f64>>)| {
        let columns = rows.first().map_or(0, Vec::len);
        if rows.iter().any(|row| row.len() != columns) {
            return Err(wrong(format!("the rows of matrix {a} have different lengths")));
        }
        Ok(DMatrix::from_row_iterator(rows.len(), columns, rows.iter().flatten().copied()))
    };
    (1..).zip(matrices).map(matrix).collect()
}

impl QuadraticMomenta {
    /// Creates the momenta J_a = ½ z·S_a z of symmetric matrices of 2m rows.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::Realisation`] if there is no matrix, if one is not square, has another size than the
    /// first, an odd number of rows, an entry that is not finite, or is not symmetric.
    pub fn new(forms: Vec<DMatrix<f64>>) -> Result<Self, FormulaSystemError> {
        let size = sizes(&forms)?;
        if size % 2 == 1 {
            return Err(wrong(format!("the matrices of momenta have {size} rows, an odd number")));
        }
        for (a, form) in (1..).zip(&forms) {
            let asymmetry = (form - form.transpose()).amax();
            if asymmetry > 4.0 * f64::EPSILON * form.amax() {
                let problem = format!(
                    "matrix {a} is not symmetric: it differs from its transpose by {asymmetry:e}"
                );
                return Err(wrong(problem));
            }
        }
        let terms = forms.iter().enumerate().flat_map(|(a, form)| {
            let places = (0..size).flat_map(move |i| (i..size).map(move |j| (i, j)));
            places.map(move |(i, j)| match i == j {
                true => (a, i, i, 0.5 * form[(i, i)]),
                false => (a, i, j, 0.5 * (form[(i, j)] + form[(j, i)])),
            })
        });
        let terms = terms.filter(|(.., value)| *value != 0.0).collect();
        Ok(Self { freedoms: size / 2, count: forms.len(), terms })
    }

    /// Creates the momenta J_a = p·ρ_a q of the matrices of a representation on Rᵐ.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::Realisation`] if there is no matrix, or if one is not square, has another size than the
    /// first, or an entry that is not finite.
    pub fn of_representation(matrices: &[DMatrix<f64>]) -> Result<Self, FormulaSystemError> {
        Self::of_copies(matrices, 1)
    }

    /// Creates the momenta of matrices by rows: of those of a representation, or of the forms S_a.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::Realisation`] as [`new`](Self::new) does, and if rows of a matrix have different lengths.
    ///
    /// # Example
    /// ```
    /// use lie_poisson_formula_systems::QuadraticMomenta;
    /// let rotation = vec![vec![0.0, -1.0], vec![1.0, 0.0]];
    /// assert!(QuadraticMomenta::of_rows(&[rotation], true).is_ok());
    /// assert!(QuadraticMomenta::of_rows(&[vec![vec![0.0, -1.0], vec![1.0]]], true).is_err());
    /// ```
    pub fn of_rows(
        matrices: &[Vec<Vec<f64>>],
        is_representation: bool,
    ) -> Result<Self, FormulaSystemError> {
        let matrices = matrices_of_rows(matrices)?;
        match is_representation {
            true => Self::of_representation(&matrices),
            false => Self::new(matrices),
        }
    }

    /// Creates the momenta of so many copies of a representation.
    pub(crate) fn of_copies(
        matrices: &[DMatrix<f64>],
        copies: usize,
    ) -> Result<Self, FormulaSystemError> {
        let m = sizes(matrices)?;
        let freedoms = copies * m;
        let mut terms = Vec::new();
        for (a, matrix) in matrices.iter().enumerate() {
            let places = (0..m).flat_map(|i| (0..m).map(move |j| (i, j)));
            for (i, j) in places.filter(|place| matrix[*place] != 0.0) {
                for first in (0..copies).map(|copy| copy * m) {
                    terms.push((a, first + j, freedoms + first + i, matrix[(i, j)]));
                }
            }
        }
        Ok(Self::of_terms(matrices.len(), freedoms, terms))
    }

    /// Creates so many momenta of their terms.
    pub(crate) fn of_terms(count: usize, freedoms: usize, mut terms: Vec<Term>) -> Self {
        terms.sort_unstable_by_key(|&(a, i, j, _)| (a, i, j));
        Self { freedoms, count, terms }
    }

    /// Returns the number 2m of coordinates of z.
    #[must_use]
    pub fn size(&self) -> usize {
        2 * self.freedoms
    }

    /// Returns the number of momenta.
    #[must_use]
    pub fn count(&self) -> usize {
        self.count
    }

    /// Returns the terms of the momenta.
    pub(super) fn terms(&self) -> &[Term] {
        &self.terms
    }

    /// Returns the matrices S_a.
    pub(super) fn forms(&self) -> Vec<DMatrix<f64>> {
        let mut forms = vec![DMatrix::zeros(self.size(), self.size()); self.count];
        for &(a, i, j, value) in &self.terms {
            if let Some(form) = forms.get_mut(a) {
                form[(i, j)] += value;
                form[(j, i)] += value;
            }
        }
        forms
    }

    /// Returns the matrix with the rows S_a z.
    pub(super) fn rows(&self, z: &DVector<f64>) -> DMatrix<f64> {
        let mut rows = DMatrix::zeros(self.count, self.size());
        for &(a, i, j, value) in &self.terms {
            rows[(a, i)] += value * z[j];
            rows[(a, j)] += value * z[i];
        }
        rows
    }

    /// Returns the largest entry of each matrix S_a.
    pub(super) fn largest(&self) -> Vec<f64> {
        let mut largest = vec![0.0_f64; self.count];
        for &(a, i, j, value) in &self.terms {
            let entry = if i == j { 2.0 * value } else { value };
            if let Some(most) = largest.get_mut(a) {
                *most = most.max(entry.abs());
            }
        }
        largest
    }

    /// Writes the momenta J_a(z). Those for which there is no room are left out.
    #[cfg_attr(optimised, inline(always))]
    pub fn values<T: Real>(&self, z: &[T], momenta: &mut [T]) {
        momenta.fill(T::zero());
        for &(a, i, j, value) in &self.terms {
            if let (Some(x), Some(y), Some(momentum)) = (z.get(i), z.get(j), momenta.get_mut(a)) {
                *momentum += *x * *y * value;
            }
        }
    }

    /// Writes the Hamiltonian vector of Σ ξ_a J_a at z: (∂/∂p, −∂/∂q).
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn generator<T: Real>(&self, xi: &[T], z: &[T], vector: &mut [T]) {
        vector.fill(T::zero());
        let m = self.freedoms;
        let mut add = |i: usize, slope: T| match i < m {
            true => vector[m + i] -= slope,
            false => vector[i - m] += slope,
        };
        for &(a, i, j, value) in &self.terms {
            let (Some(xi), Some(x), Some(y)) = (xi.get(a), z.get(i), z.get(j)) else { continue };
            let xi = *xi * value;
            add(i, xi * *y);
            add(j, xi * *x);
        }
    }
}

/// Returns the common number of rows of square matrices.
fn sizes(matrices: &[DMatrix<f64>]) -> Result<usize, FormulaSystemError> {
    let Some(first) = matrices.first() else { return Err(wrong("there is no matrix".into())) };
    let size = first.nrows();
    for (a, matrix) in (1..).zip(matrices) {
        if matrix.shape() != (size, size) || size == 0 {
            let (rows, columns) = matrix.shape();
            return Err(wrong(format!(
                "matrix {a} has the shape {rows} × {columns}; {size} × {size} is needed"
            )));
        }
        if let Some(value) = matrix.iter().find(|value| !value.is_finite()) {
            return Err(wrong(format!("matrix {a} has the entry {value}")));
        }
    }
    Ok(size)
}

/// Returns the error of a realisation.
pub(super) fn wrong(problem: String) -> FormulaSystemError {
    FormulaSystemError::Realisation { problem }
}
