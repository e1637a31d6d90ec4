//! Points near the origin on the fibres of quadratic momenta: [`QuadraticMomenta::recentred`].

use crate::realisations::quadratic_momenta::QuadraticMomenta;
use momentum_map::LiftError;
use nalgebra::{DMatrix, DVector};

/// The number of iterations that move z, each of which halves the remaining distance along the fibre.
const PULLS: usize = 8;

/// The number of iterations that only restore J(z), each of which squares its error.
const CORRECTIONS: usize = 6;

/// The number added to the diagonal of A Aᵀ, whose entries there are 1. J may reach only a part of 𝔤∗.
const DAMPING: f64 = 1e-12;

/// The singular value of the rows, which have the length 1, below which J has no differential. J may reach only a part of 𝔤∗.
const SINGULAR: f64 = 1e-14;

/// Returns A⁺ r for a matrix A with rows of the length 1.
type PseudoInverse = fn(&DMatrix<f64>, &DVector<f64>) -> Option<DVector<f64>>;

/// The part of |z|² that is left where a move is worthwhile: four fifths of the length.
const SHORTER: f64 = 0.64;

/// The greatest change of a momentum, relative to the sum of the sizes of its terms at z, to which it is known.
const ROUNDINGS: f64 = 16.0 * f64::EPSILON;

/// What the iteration comes to.
enum Pulled {
    /// A point that is shorter.
    Shorter(Vec<f64>),
    /// A point that is about as long as the first.
    AsLong,
    /// None with the same momenta.
    Lost,
}

impl QuadraticMomenta {
    /// Returns a point z with J(z) = μ, the shortest on its fibre if that is found.
    ///
    /// # Errors
    /// Returns [`LiftError`] if no point is found.
    pub(crate) fn short_lift(&self, mu: &[f64]) -> Result<Vec<f64>, LiftError> {
        let lift = self.lift(mu)?;
        Ok(self.recentred(&lift).unwrap_or(lift))
    }

    /// Returns a point with the momenta of z some part of which is shorter by a fifth or more, or `None` if none is found.
    ///
    /// Along a motion z may grow by orders of magnitude while J(z) keeps its size, which then loses digits by cancellation. The
    /// iteration minimises |z|² at constant J(z), by the changes
    ///
    /// ```text
    /// δz = −τ z + A⁺ (τ A z + μ − J(z)),    A = T_z J,  A z = 2 J(z),  A⁺ the pseudo-inverse,  τ = ½, then 0
    /// ```
    pub(crate) fn recentred(&self, z: &[f64]) -> Option<Vec<f64>> {
        let mut moved = z.to_vec();
        let mut is_moved = false;
        for part in self.parts() {
            let point = part.point_of(z);
            let mut pulled = part.momenta.pulled(&point, by_products);
            if matches!(pulled, Pulled::Lost) {
                pulled = part.momenta.pulled(&point, by_singular_values);
            }
            if let Pulled::Shorter(point) = pulled {
                part.write(&point, &mut moved);
                is_moved = true;
            }
        }
        is_moved.then_some(moved)
    }

    /// Iterates from a point, for momenta that do not fall into parts.
    fn pulled(&self, z: &[f64], pseudo_inverse: PseudoInverse) -> Pulled {
        let start = DVector::from_column_slice(z);
        let mu = self.values_at(&start);
        let mut moved = start.clone();
        for iteration in 0..PULLS + CORRECTIONS {
            let pull = if iteration < PULLS { 0.5 } else { 0.0 };
            moved = match self.pull(moved, &mu, pull, pseudo_inverse) {
                Some(moved) => moved,
                None => return Pulled::Lost,
            };
        }
        let change = self.values_at(&moved) - mu;
        let is_same = |(x, y): (&f64, &f64)| x.abs() <= ROUNDINGS * y;
        if !change.iter().zip(&self.terms_at(&start)).all(is_same) {
            return Pulled::Lost;
        }
        match moved.norm_squared() < SHORTER * start.norm_squared() {
            true => Pulled::Shorter(moved.as_slice().to_vec()),
            false => Pulled::AsLong,
        }
    }

    /// Performs one iteration. Each row of A is divided by its length, so that the units of the momenta do not matter.
    fn pull(
        &self,
        z: DVector<f64>,
        mu: &DVector<f64>,
        pull: f64,
        pseudo_inverse: PseudoInverse,
    ) -> Option<DVector<f64>> {
        let (mut rows, values) = (self.rows(&z), self.values_at(&z));
        // The singular values of what is not finite are looked for without end.
        if !rows.iter().chain(&values).all(|x| x.is_finite()) {
            return None;
        }
        let mut right = mu - &values + values * (2.0 * pull);
        for (mut row, right) in rows.row_iter_mut().zip(right.iter_mut()) {
            let length = row.norm();
            if length > 0.0 {
                row /= length;
                *right /= length;
            }
        }
        Some(z * (1.0 - pull) + pseudo_inverse(&rows, &right)?)
    }

    /// Returns the momenta J(z).
    pub(super) fn values_at(&self, z: &DVector<f64>) -> DVector<f64> {
        let mut values = DVector::zeros(self.count());
        self.values(z.as_slice(), values.as_mut_slice());
        values
    }

    /// Returns the sums of the sizes of the terms of J(z).
    fn terms_at(&self, z: &DVector<f64>) -> DVector<f64> {
        let mut terms = DVector::zeros(self.count());
        for &(a, i, j, value) in self.terms() {
            terms[a] += (value * z[i] * z[j]).abs();
        }
        terms
    }
}

/// Returns Aᵀ (A Aᵀ + δ)⁻¹ r. The product with Aᵀ keeps the digits of coordinates that are much smaller than others.
fn by_products(rows: &DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    let identity = DMatrix::identity(rows.nrows(), rows.nrows());
    let gram = rows * rows.transpose() + identity * DAMPING;
    Some(rows.tr_mul(&gram.cholesky()?.solve(right)))
}

/// Returns A⁺ r by singular values, also for rows that are so nearly dependent that their products do not tell.
fn by_singular_values(rows: &DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    rows.clone().svd(true, true).solve(right, SINGULAR).ok()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::algebras::system_algebra::SystemAlgebra;

    /// (aq, p/a) has the momenta of (q, p), in all units, and so has what it is moved to.
    #[test]
    fn a_long_point_is_moved_and_a_short_one_is_not() {
        for (name, unit) in [("sl(2)", 1.0), ("se(2)", 1e-30), ("heisenberg(1)", 1e30)] {
            let algebra = SystemAlgebra::named(name).unwrap();
            let momenta = QuadraticMomenta::clebsch(algebra.table()).unwrap();
            let mu: Vec<f64> = [0.4, 0.3, -0.5].map(|x| x * unit).to_vec();
            let short = momenta.short_lift(&mu).unwrap();
            assert_eq!(momenta.recentred(&short), None, "{name}");
            let half = momenta.size() / 2;
            let stretched = short.iter().enumerate();
            let long: Vec<f64> =
                stretched.map(|(i, x)| if i < half { 8.0 * x } else { x / 8.0 }).collect();
            let moved = momenta.recentred(&long).unwrap();
            let length = |z: &[f64]| z.iter().map(|x| x * x).sum::<f64>();
            assert!(length(&moved) < 1.1 * length(&short), "{name}");
            let mut found = [0.0; 3];
            momenta.values(&moved, &mut found);
            // Some roundings of the terms at the long point.
            for (x, y) in found.iter().zip(&mu) {
                assert!((x - y).abs() < 1e-14 * unit, "{name}: {found:?}");
            }
        }
    }

    /// The origin is the shortest point that there is, and what is not finite has no momenta.
    #[test]
    fn no_point_is_shorter_than_the_origin_or_than_what_is_not_finite() {
        let algebra = SystemAlgebra::named("sl(2)").unwrap();
        let momenta = QuadraticMomenta::clebsch(algebra.table()).unwrap();
        for entry in [0.0, f64::NAN, f64::INFINITY, f64::MAX] {
            assert_eq!(momenta.recentred(&vec![entry; momenta.size()]), None, "{entry}");
        }
    }
}
