//! Predictions of generators from the earlier steps: [`GeneratorHistory`].

use crate::matrices::skew_hermitian::LargeSkewHermitian;
use collective_integrators::lagrange_polynomial;
use lie_poisson::State;

/// The generators of the last steps of equal size, and predictions from them by a polynomial in time.
///
/// Generators are predicted, and not the rates dW/dt: B = Δ⁻¹W is smoother in time than W, whose high degrees move
/// fast, so that a polynomial through their rates is of no use.
#[derive(Clone, Debug)]
pub(crate) struct GeneratorHistory {
    /// The weights of the remembered generators for each stage, for 1, 2, … remembered steps.
    weights: Vec<Vec<Vec<f64>>>,
    stages: usize,
    /// The generators of the remembered steps, oldest first, and storage for more.
    past: Vec<LargeSkewHermitian>,
    /// The number of remembered steps.
    steps: usize,
    /// The end of the last step and its size.
    end: Option<LargeSkewHermitian>,
    size: f64,
}

impl GeneratorHistory {
    /// Creates an empty history for stages at the times c, in steps, that remembers `steps` steps.
    pub(crate) fn new(nodes: &[f64], steps: usize) -> Self {
        let past = |count: usize| -> Vec<f64> {
            (1..=count).rev().flat_map(|n| nodes.iter().map(move |c| c - n as f64)).collect()
        };
        let row = |past: &[f64], c: f64| -> Vec<f64> {
            (0..past.len()).map(|j| lagrange_polynomial(past, j, c)).collect()
        };
        let weights = (1..=steps)
            .map(|count| nodes.iter().map(|c| row(&past(count), *c)).collect())
            .collect();
        Self { weights, stages: nodes.len(), past: Vec::new(), steps: 0, end: None, size: 0.0 }
    }

    /// Forgets the earlier steps.
    pub(crate) fn forget(&mut self) {
        self.steps = 0;
    }

    /// Writes predictions for a step of the given size from W. Returns whether there are any.
    pub(crate) fn predict(
        &mut self,
        w: &LargeSkewHermitian,
        size: f64,
        generators: &mut [LargeSkewHermitian],
    ) -> bool {
        if self.size != size || self.end.as_ref() != Some(w) {
            self.steps = 0;
        }
        let Some(weights) = self.steps.checked_sub(1).and_then(|last| self.weights.get(last))
        else {
            return false;
        };
        for (generator, row) in generators.iter_mut().zip(weights) {
            generator.set_zero();
            generator.add_combination(row, &self.past);
        }
        true
    }

    /// Remembers the generators of a step of the given size that ended at W.
    pub(crate) fn remember(
        &mut self,
        generators: &[LargeSkewHermitian],
        size: f64,
        w: &LargeSkewHermitian,
    ) {
        if self.steps == self.weights.len() {
            // The oldest storage becomes the newest.
            let first = self.stages.min(self.past.len());
            self.past.rotate_left(first);
            self.steps -= 1;
        }
        for (i, generator) in (self.steps * self.stages..).zip(generators) {
            match self.past.get_mut(i) {
                Some(past) => past.assign(generator),
                None => self.past.push(generator.clone()),
            }
        }
        self.steps += 1;
        self.size = size;
        match &mut self.end {
            Some(end) => end.assign(w),
            None => self.end = Some(w.clone()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Steps of size 1 whose generators are a polynomial in time. From n steps with s stages, a polynomial of degree
    /// n s − 1 is predicted exactly, also after the storage of old steps has been used again.
    #[test]
    fn polynomials_are_predicted() {
        let (nodes, steps) = ([0.2, 0.7], 3);
        let mut history = GeneratorHistory::new(&nodes, steps);
        let matrix = |x: f64| {
            let mut matrix = LargeSkewHermitian::zeros(2);
            matrix.set_coordinates(|i| x * (1.0 + i as f64));
            matrix
        };
        let value = |t: f64, degree: i32| 1.0 + 0.5 * t + (0.1 * t).powi(degree);
        let at = |step: i32, degree| nodes.map(|c| matrix(value(f64::from(step) + c, degree)));
        let end = |step: i32| matrix(f64::from(step));
        for (degree, exact) in [(9, false), (5, true)] {
            history.forget();
            let mut predicted = nodes.map(|_| matrix(0.0));
            assert!(!history.predict(&end(0), 1.0, &mut predicted), "nothing is known yet");
            for step in 0..10 {
                history.remember(&at(step, degree), 1.0, &end(step + 1));
                assert!(history.predict(&end(step + 1), 1.0, &mut predicted));
                for (found, expected) in predicted.iter().zip(at(step + 1, degree)) {
                    let error = (found.coordinate(0) - expected.coordinate(0)).abs();
                    if step >= 2 {
                        // The weights of the extrapolation add up to a few hundred.
                        assert_eq!(error < 1e-12, exact, "{degree} {step} {error:e}");
                    }
                }
            }
            assert!(!history.predict(&end(3), 1.0, &mut predicted), "another start");
            assert!(!history.predict(&end(10), 0.5, &mut predicted), "another step size");
        }
    }
}
