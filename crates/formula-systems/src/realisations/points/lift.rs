//! Points with given quadratic momenta.

use crate::realisations::generic_point::generic;
use crate::realisations::quadratic_momenta::QuadraticMomenta;
use momentum_map::LiftError;
use nalgebra::DVector;

/// The largest number of Newton's steps, and of points from which they start.
const STEPS: usize = 60;
const STARTS: usize = 6;

/// The distance of the momenta from the given ones, relative to these, at which a point is found.
const CLOSE: f64 = 4.0 * f64::EPSILON;

impl QuadraticMomenta {
    /// Returns a point z with J(z) = μ: the first that Newton's iteration finds, with the shortest steps, from points that are
    /// the same in every run.
    ///
    /// # Errors
    /// Returns [`LiftError`] if none is found.
    pub(crate) fn lift(&self, mu: &[f64]) -> Result<Vec<f64>, LiftError> {
        let mut z = vec![0.0; self.size()];
        for part in self.parts() {
            part.write(&part.momenta.lift_of_part(&part.momenta_of(mu))?, &mut z);
        }
        // What is no part, since it is zero everywhere.
        match mu.iter().zip(self.largest()).find(|(mu, largest)| **mu != 0.0 && *largest == 0.0) {
            Some((mu, _)) => Err(not_reached(mu.abs())),
            None => Ok(z),
        }
    }

    /// Returns a point z with J(z) = μ of momenta that do not fall into parts.
    fn lift_of_part(&self, mu: &[f64]) -> Result<Vec<f64>, LiftError> {
        // Each coordinate in the unit of its matrix. The size is that of the largest, whose square neither overflows nor
        // underflows.
        let weights: Vec<f64> = self.largest().into_iter().map(inverse).collect();
        let mu: Vec<f64> = mu.iter().zip(&weights).map(|(x, weight)| x * weight).collect();
        let size = mu.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        if size == 0.0 {
            return Ok(vec![0.0; self.size()]);
        }
        // In units in which the largest coordinate is 1, of which z has the square root.
        let unit = DVector::from_iterator(mu.len(), mu.iter().map(|x| x / size));
        let found = (0..STARTS)
            .find_map(|start| self.newton(generic(self.size(), start + 1), &unit, &weights));
        let lifted = found.map(|z| z.iter().map(|x| x * size.sqrt()).collect());
        lifted.ok_or_else(|| not_reached(size))
    }

    /// Solves w_a J_a(z) = μ_a with the weights w.
    fn newton(
        &self,
        mut z: DVector<f64>,
        mu: &DVector<f64>,
        weights: &[f64],
    ) -> Option<DVector<f64>> {
        let momenta = |z: &DVector<f64>| {
            let mut values = self.values_at(z);
            values.iter_mut().zip(weights).for_each(|(value, weight)| *value *= weight);
            values
        };
        let values = momenta(&z);
        let length = values.norm();
        if length == 0.0 || !length.is_finite() {
            return None;
        }
        z *= (mu.norm() / length).sqrt();
        let mut before = f64::INFINITY;
        for _ in 0..STEPS {
            let rest = mu - momenta(&z);
            let distance = rest.norm();
            // Rounding alone is left when a step no longer comes closer.
            if !distance.is_finite() {
                return None;
            }
            if distance <= CLOSE || (distance < 1e-12 && distance >= 0.5 * before) {
                return Some(z);
            }
            before = distance;
            let mut rows = self.rows(&z);
            rows.row_iter_mut().zip(weights).for_each(|(mut row, w)| row *= *w);
            let step = rows.svd(true, true).solve(&rest, 1e-10).ok()?;
            // A step longer than the point leaves the region in which the linear equations say something.
            let most = 0.5 * z.norm();
            z += &step * (most / step.norm().max(most));
        }
        None
    }
}

/// Returns the error for a momentum of a size.
fn not_reached(value: f64) -> LiftError {
    let reason = "no point with this momentum was found: it is not in the image of the realisation";
    LiftError { quantity: "μ", value, reason }
}

/// Returns the reciprocal of a size, or 1 for zero.
fn inverse(size: f64) -> f64 {
    if size > 0.0 { size.recip() } else { 1.0 }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    /// Each spin has the digits of its own size; all of them together would have those of the largest.
    #[test]
    fn parts_are_lifted_in_their_own_units() {
        let momenta = QuadraticMomenta::of_rotations(3);
        let sizes = [1e-30, 1.0, 1e30];
        let mu: Vec<f64> = sizes.iter().flat_map(|s| [0.6, -0.5, 0.4].map(|x| x * s)).collect();
        let error = |z: &[f64]| {
            let found = momenta.values_at(&DVector::from_column_slice(z));
            found.iter().zip(&mu).map(|(x, y)| (x / y - 1.0).abs()).fold(0.0, f64::max)
        };
        // Roundings of the few terms of a momentum, of which none is much larger than the sum.
        assert!(error(&momenta.lift(&mu).unwrap()) < 1e-14);
        assert!(momenta.lift_of_part(&mu).map_or(f64::INFINITY, |z| error(&z)) > 1.0);
    }
}
