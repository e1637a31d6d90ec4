//! The scales of an open system, with the inputs at all times of their tables.

use super::open_system::OpenSystem;
use collective_integrators::diagnostics::SystemScales;
use core::ops::Range;
use lie_poisson::larger;

/// The largest number of times at which a rate is computed, and of entries of all their matrices.
const MOST_TIMES: usize = 64;
const MOST_ENTRIES: usize = 1 << 12;

/// The blocks and the differential are those of the Hamiltonian at the time 0. The fastest rate is that along the element of
/// the algebra with which the momentum moves, without noise, at the time 0 and at those of the tables of the inputs, before 0 and
/// after it, whether a run comes there or not.
impl SystemScales for OpenSystem {
    fn blocks(&self) -> Vec<Range<usize>> {
        self.base().blocks()
    }

    fn differential(&self, mu: &[f64]) -> Vec<f64> {
        self.base().differential(mu)
    }

    fn fastest_rate(&self, mu: &[f64]) -> f64 {
        let rate = |time: f64| self.base().rate_of_element(&self.element(mu, time));
        self.times_of_inputs().into_iter().map(rate).fold(0.0, larger)
    }
}

impl OpenSystem {
    /// Returns 0 and the times of the tables, or some of many.
    fn times_of_inputs(&self) -> Vec<f64> {
        let dimension = self.base().algebra().dimension().max(1);
        let most = (MOST_ENTRIES / (dimension * dimension)).clamp(1, MOST_TIMES);
        let times: Vec<f64> = self.terms().inputs.times().collect();
        let stride = times.len().div_ceil(most).max(1);
        [0.0].into_iter().chain(times.into_iter().step_by(stride)).collect()
    }
}
