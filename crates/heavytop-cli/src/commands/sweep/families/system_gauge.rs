//! The measurements along a motion of a system.

use super::measured_motion::Gauge;
use crate::configuration::Observable;
use lie_poisson::{Vector, larger};
use lie_poisson_formula_systems::FormulaSystem;
use lie_poisson_formulas::Formula;

/// The deviations of h and of the Casimirs of a system.
pub(super) struct SystemGauge<'a> {
    invariants: Vec<&'a Formula>,
    initial: Vec<f64>,
    drift: Vec<f64>,
    /// The coordinates of the momentum that was observed last.
    state: Vec<f64>,
}

impl<'a> SystemGauge<'a> {
    pub fn new(system: &'a FormulaSystem, start: &[f64]) -> Self {
        let invariants: Vec<&Formula> =
            std::iter::once(system.hamiltonian()).chain(system.casimirs()).collect();
        let initial = invariants.iter().map(|invariant| invariant.value_at(start)).collect();
        let drift = vec![0.0; invariants.len()];
        Self { invariants, initial, drift, state: start.to_vec() }
    }
}

impl<M: Vector<Scalar = f64>> Gauge<M> for SystemGauge<'_> {
    fn observe(&mut self, _: f64, momentum: &M) {
        let Self { invariants, initial, drift, state } = self;
        state.iter_mut().enumerate().for_each(|(i, x)| *x = momentum.coordinate(i));
        for ((drift, initial), invariant) in drift.iter_mut().zip(initial).zip(invariants) {
            *drift = larger(*drift, (invariant.value_at(state) - *initial).abs());
        }
    }

    fn values(&self, observable: Observable, end: &M) -> Vec<Option<f64>> {
        match observable {
            Observable::FinalState => {
                (0..self.state.len()).map(|i| Some(end.coordinate(i))).collect()
            }
            Observable::InvariantDrift => self.drift.iter().copied().map(Some).collect(),
            _ => Vec::new(),
        }
    }
}
