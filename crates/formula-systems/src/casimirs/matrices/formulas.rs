//! The formulas of the invariants of one matrix: [`InvariantFormulas`].

use super::expression_matrix::{ExpressionMatrix, scaled};
use super::invariant::Invariant;
use super::matrix_algebra::{MatrixAlgebra, Structure};
use super::pfaffian::Pfaffians;
use lie_poisson_formulas::{Expression, Expressions, Formula, Vocabulary};
use nalgebra::DMatrix;

/// The largest number of products of a formula that is tried; longer ones are computed from matrices. Of those of so(n), sp(2n, R), su(n) and gl(n) the largest that
/// fits has 6860, tr X¹² of so(14), and the smallest that does not 8000, tr JX⁹ of su(10).
const MOST_PRODUCTS: usize = 7500;

/// The largest number of rows of a Pfaffian. With 16 there are more minors than a formula may have.
const MOST_ROWS: usize = 14;

/// The matrix X = Σ_a μ_a E^a as expressions, with its powers as far as they were needed.
pub(crate) struct InvariantFormulas<'a> {
    algebra: &'a MatrixAlgebra,
    names: &'a Vocabulary,
    parts: Expressions,
    /// The number c such that most entries of X/c are coordinates or their negatives.
    unit: f64,
    /// The powers of X/c, from the first.
    powers: Vec<ExpressionMatrix>,
}

impl<'a> InvariantFormulas<'a> {
    pub(crate) fn new(
        algebra: &'a MatrixAlgebra,
        duals: &[DMatrix<f64>],
        names: &'a Vocabulary,
    ) -> Self {
        let (mut parts, unit) = (Expressions::new(), middle(duals));
        let own = names.coordinates().names().skip(algebra.places().start);
        let own: Vec<Expression> =
            own.take(algebra.places().len()).map(|name| parts.name(&name)).collect();
        let in_units: Vec<DMatrix<f64>> = duals.iter().map(|dual| dual / unit).collect();
        let powers =
            vec![ExpressionMatrix::linear(&mut parts, &own, &in_units, &algebra.structure)];
        Self { algebra, names, parts, unit, powers }
    }

    /// Returns the formula of an invariant, or `None` if it is larger than a formula may be.
    pub(crate) fn formula(&mut self, invariant: Invariant) -> Option<Formula> {
        let degree = invariant.degree();
        if !self.is_feasible(invariant) {
            return None;
        }
        let value = match (invariant, &self.algebra.structure) {
            (Invariant::Pfaffian(_), Structure::Form(form)) => {
                Pfaffians::with_form(self.powers.first()?, form).of_all(&mut self.parts)
            }
            _ => {
                // Xᵏ = Xᵃ Xᵇ with a = ⌈k/2⌉
                let higher = degree.div_ceil(2);
                self.compute(higher);
                let left = self.powers.get(higher.checked_sub(1)?)?.clone();
                let parts = &mut self.parts;
                let is_turned = matches!(invariant, Invariant::TurnedTrace(_));
                let left = if is_turned { left.times_i(parts) } else { left };
                match (degree - higher).checked_sub(1) {
                    Some(lower) => left.trace_with(self.powers.get(lower)?, parts),
                    None => left.trace(parts),
                }
            }
        }?;
        let value = scaled(&mut self.parts, self.unit.powi(degree as i32), value);
        let formula = Formula::of_expressions(&self.parts, value, self.names).ok()?;
        Some(formula.printed_as(&self.text(invariant)))
    }

    /// Returns the text that says what an invariant is.
    pub(crate) fn text(&self, invariant: Invariant) -> String {
        invariant.text(&self.matrix_text())
    }

    /// Returns whether a formula may be small enough. To build one that is not would take as long as all others.
    fn is_feasible(&self, invariant: Invariant) -> bool {
        let size = self.algebra.size();
        let shared = match self.algebra.structure {
            Structure::Real => 1,
            Structure::Form(_) | Structure::Symplectic => 2,
            Structure::Complex => 4,
        };
        match invariant {
            Invariant::Pfaffian(_) => size <= MOST_ROWS,
            Invariant::Trace(k) | Invariant::TurnedTrace(k) => {
                k.div_ceil(2).saturating_sub(1) * size.pow(3) / shared <= MOST_PRODUCTS
            }
        }
    }

    /// Computes the powers up to one.
    fn compute(&mut self, power: usize) {
        while let (Some(first), Some(last)) = (self.powers.first(), self.powers.last())
            && self.powers.len() < power
        {
            let next = first.times(last, &mut self.parts);
            self.powers.push(next);
        }
    }

    /// Returns the text of X: with its coordinates if there are others beside them.
    pub(crate) fn matrix_text(&self) -> String {
        let (all, places) = (self.names.coordinates(), self.algebra.places());
        if places.len() == all.dimension() {
            return "X".into();
        }
        let own = all.groups().filter(|(_, group)| places.contains(&group.start));
        match own.map(|(name, _)| name).collect::<Vec<_>>()[..] {
            [name] => format!("X({name})"),
            [first, ..] => format!("X({first}, …)"),
            [] => "X".into(),
        }
    }
}

/// Returns the middle size of the entries of matrices that are not zero.
fn middle(matrices: &[DMatrix<f64>]) -> f64 {
    let entries = matrices.iter().flat_map(|matrix| matrix.iter().map(|x| x.abs()));
    let mut sizes: Vec<f64> = entries.filter(|size| *size > 0.0).collect();
    sizes.sort_by(f64::total_cmp);
    sizes.get(sizes.len() / 2).copied().unwrap_or(1.0)
}
