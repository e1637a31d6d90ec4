//! Motions along a coadjoint orbit, and points of it at which functions have given values: [`Orbit`].

use super::level_set::{Constraint, Level, least_step, settled};
use lie_poisson_formulas::StructureEntry;
use nalgebra::{DMatrix, DVector};

/// The largest number of Newton steps.
const MOST_STEPS: usize = 60;

/// The longest Newton step, in units in which 1 changes a state by its own size.
const LONGEST: f64 = 1.0;

/// The smallest singular value, relative to the largest, of a direction in which an orbit extends.
const DIRECTION: f64 = 1e-10;

/// The coadjoint orbits of an algebra. A state moves by μ ↦ exp(ad∗_ξ) μ, which keeps it on its orbit, whatever the
/// Casimirs are.
#[derive(Clone, Debug)]
pub(crate) struct Orbit {
    /// The matrix of ad∗_ξ for each basis vector ξ = w_i e_i, in coordinates that are divided by their sizes; w_i is
    /// such that the matrix has the norm 1, or is 0 for a central vector.
    generators: Vec<DMatrix<f64>>,
    scales: Vec<f64>,
}

impl Orbit {
    /// Creates the orbits of an algebra, with the sizes of the coordinates.
    pub(crate) fn new(entries: &[StructureEntry], scales: &[f64]) -> Self {
        let n = scales.len();
        let mut generators = vec![DMatrix::<f64>::zeros(n, n); n];
        for &StructureEntry { i, j, k, value } in entries {
            for (i, j, value) in [(i, j, value), (j, i, -value)] {
                // dμ_j/dt = Σ c_ijk ξ_i μ_k
                if let (Some(matrix), Some(sj), Some(sk)) =
                    (generators.get_mut(i), scales.get(j), scales.get(k))
                {
                    matrix[(j, k)] += value * (sk / sj);
                }
            }
        }
        for matrix in &mut generators {
            let norm = matrix.norm();
            if norm > 0.0 {
                *matrix /= norm;
            }
        }
        Self { generators, scales: scales.to_vec() }
    }

    /// Returns the state after a motion with the coefficients u_i of the generators.
    pub(crate) fn moved(&self, state: &[f64], u: &[f64]) -> Vec<f64> {
        let n = self.scales.len();
        let mut matrix = DMatrix::zeros(n, n);
        for (generator, u) in self.generators.iter().zip(u) {
            matrix += generator * *u;
        }
        let parts = matrix.norm().ceil().clamp(1.0, 1e6);
        let matrix = matrix / parts;
        let mut point = self.relative(state);
        for _ in 0..parts as u32 {
            let (mut term, mut order) = (point.clone(), 1.0);
            // The terms of the exponential of a matrix of norm 1, until they are below rounding.
            while order < 20.0 {
                term = &matrix * term / order;
                point += &term;
                order += 1.0;
            }
        }
        point.iter().zip(&self.scales).map(|(x, scale)| x * scale).collect()
    }

    /// Returns a point of the orbit of `guess` at which formulas have these values, or `None` if it cannot be found.
    pub(crate) fn project(&self, guess: Vec<f64>, levels: &[Level<'_>]) -> Option<Vec<f64>> {
        let mut point = guess;
        for _ in 0..MOST_STEPS {
            let (step, residual) = self.step(&point, levels)?;
            point = self.moved(&point, step.as_slice());
            if point.iter().any(|x| !x.is_finite()) {
                return None;
            }
            if settled(step.amax(), residual) {
                let (last, _) = self.step(&point, levels)?;
                point = self.moved(&point, last.as_slice());
                return point.iter().all(|x| x.is_finite()).then_some(point);
            }
        }
        None
    }

    /// Returns the dimension of the orbit through a state.
    pub(crate) fn dimension(&self, state: &[f64]) -> usize {
        let directions = self.directions(state);
        let values = directions.singular_values();
        let largest = values.iter().copied().fold(0.0, f64::max);
        values.iter().filter(|value| **value > DIRECTION * largest).count()
    }

    /// Returns the coefficients of the Newton step of least length, and the largest residual relative to the slopes.
    fn step(&self, state: &[f64], levels: &[Level<'_>]) -> Option<(DVector<f64>, f64)> {
        let directions = self.directions(state);
        let constraints = levels.iter().map(|level| {
            let slopes = level.function.differential_at(state);
            let slopes = slopes.iter().zip(&self.scales).map(|(slope, scale)| slope * scale);
            let slopes = DVector::from_iterator(self.scales.len(), slopes);
            let slopes = directions.tr_mul(&slopes).as_slice().to_vec();
            Constraint { slopes, difference: level.difference(state), value: level.value }
        });
        let (step, residual) = least_step(&constraints.collect::<Vec<_>>())?;
        let (step, length) = (-&step, step.norm());
        Some((if length > LONGEST { step * (LONGEST / length) } else { step }, residual))
    }

    /// Returns the rates of the state under each generator, one in each column, in sizes of the coordinates.
    fn directions(&self, state: &[f64]) -> DMatrix<f64> {
        let point = self.relative(state);
        let rates = self.generators.iter().map(|generator| generator * &point);
        DMatrix::from_columns(&rates.collect::<Vec<_>>())
    }

    /// Returns a state in sizes of its coordinates.
    fn relative(&self, state: &[f64]) -> DVector<f64> {
        let relative = state.iter().zip(&self.scales).map(|(x, scale)| x / scale);
        DVector::from_iterator(self.scales.len(), relative)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// [e₀, e₁] = e₁ and [e₀, e₂] = 2 e₂: the orbits are the curves of y/x², times a line.
    fn dilations(scale: f64) -> Orbit {
        let entry = |j, value| StructureEntry { i: 0, j, k: j, value };
        Orbit::new(&[entry(1, 1.0), entry(2, 2.0)], &[scale; 3])
    }

    #[test]
    fn motions_stay_on_orbits_in_all_units() {
        for scale in [1.0, 1e30, 1e-30] {
            let orbit = dilations(scale);
            let state = [0.3, 0.5, -0.7].map(|x| x * scale);
            assert_eq!(orbit.dimension(&state), 2);
            assert_eq!(orbit.dimension(&[scale, 0.0, 0.0]), 0);
            let moved = orbit.moved(&state, &[2.5, 0.4, -1.0]);
            assert!((moved[1] / scale - 0.5).abs() > 0.1, "{moved:?}");
            let casimir = |x: &[f64]| (x[2] / scale) / (x[1] / scale).powi(2);
            // Rounding errors of some sixty terms.
            assert!((casimir(&moved) / casimir(&state) - 1.0).abs() < 1e-13);
        }
    }
}
