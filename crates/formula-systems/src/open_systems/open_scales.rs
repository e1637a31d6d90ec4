//! The scales of an open system, which are those of its Hamiltonian at the time 0.

use super::open_system::OpenSystem;
use collective_integrators::diagnostics::SystemScales;
use core::ops::Range;

impl SystemScales for OpenSystem {
    fn blocks(&self) -> Vec<Range<usize>> {
        self.base().blocks()
    }

    fn differential(&self, mu: &[f64]) -> Vec<f64> {
        self.base().differential(mu)
    }

    fn fastest_rate(&self, mu: &[f64]) -> f64 {
        self.base().fastest_rate(mu)
    }
}
