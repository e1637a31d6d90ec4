//! The measurements along a motion of a system.

use super::measured_motion::Gauge;
use crate::configuration::Observable;
use collective_integrators::diagnostics::InvariantSize;
use lie_poisson::larger;
use lie_poisson_formula_systems::FormulaSystem;
use lie_poisson_formulas::Formula;
use std::cell::RefCell;

/// The deviations of h and of the Casimirs of a system.
pub(super) struct SystemGauge<'a> {
    /// h and the Casimir of each column, if the system has one for it.
    invariants: Vec<Option<&'a Formula>>,
    initial: Vec<f64>,
    drift: Vec<f64>,
    /// The sizes of the invariants along the motion; none if no observable is relative to them.
    sizes: Vec<InvariantSize>,
    /// The coordinates of the momentum that was observed last.
    state: Vec<f64>,
    /// The first state at which an invariant has no finite value.
    undefined: &'a RefCell<Option<Vec<f64>>>,
}

impl<'a> SystemGauge<'a> {
    /// Creates the gauge of a system whose Casimirs stand in columns for Casimirs of these degrees, with the sizes of the
    /// invariants if they are wanted. The first state at which an invariant has no finite value is put in `undefined`.
    pub fn new(
        system: &'a FormulaSystem,
        (start, wants_sizes): (&[f64], bool),
        columns: &[u8],
        undefined: &'a RefCell<Option<Vec<f64>>>,
    ) -> Self {
        let casimirs = in_columns(system.casimir_degrees(), columns);
        let casimirs = casimirs.into_iter().map(|place| system.casimirs().get(place?));
        let invariants: Vec<Option<&Formula>> =
            std::iter::once(Some(system.hamiltonian())).chain(casimirs).collect();
        let value = |invariant: &Option<&Formula>| invariant.map_or(0.0, |f| f.value_at(start));
        let initial = invariants.iter().map(value).collect();
        let drift = vec![0.0; invariants.len()];
        let blocks = || system.algebra().coordinates().groups().map(|(_, places)| places);
        let sized = if wants_sizes { invariants.len() } else { 0 };
        let sizes = (0..sized).map(|_| InvariantSize::new(blocks())).collect();
        let mut gauge =
            Self { invariants, initial, drift, sizes, state: start.to_vec(), undefined };
        gauge.include_sizes();
        gauge
    }

    /// Raises the sizes of the invariants to those at the state.
    fn include_sizes(&mut self) {
        for (size, invariant) in self.sizes.iter_mut().zip(&self.invariants) {
            if let Some(invariant) = invariant {
                size.include(&self.state, &invariant.differential_at(&self.state));
            }
        }
    }
}

impl Gauge for SystemGauge<'_> {
    fn observe(&mut self, _: f64, momentum: &[f64]) {
        let Self { invariants, initial, drift, state, undefined, .. } = self;
        state.iter_mut().zip(momentum).for_each(|(x, value)| *x = *value);
        for ((drift, initial), invariant) in drift.iter_mut().zip(initial).zip(invariants) {
            if let Some(invariant) = invariant {
                let value = invariant.value_at(state);
                if !value.is_finite() {
                    undefined.borrow_mut().get_or_insert_with(|| state.clone());
                }
                *drift = larger(*drift, (value - *initial).abs());
            }
        }
        self.include_sizes();
    }

    fn values(&self, observable: Observable, end: &[f64]) -> Vec<Option<f64>> {
        match observable {
            Observable::FinalState => end.iter().copied().map(Some).collect(),
            Observable::InvariantDrift => {
                let drifts = self.invariants.iter().zip(&self.drift);
                drifts.map(|(invariant, drift)| invariant.map(|_| *drift)).collect()
            }
            Observable::RelativeDrift => {
                let drifts = self.sizes.iter().zip(&self.drift).zip(&self.invariants);
                let relative =
                    |((size, drift), invariant): ((&InvariantSize, &f64), &Option<_>)| {
                        invariant.map(|_: &Formula| size.relative(*drift))
                    };
                drifts.map(relative).collect()
            }
            _ => Vec::new(),
        }
    }
}

/// Returns for each column the place of a Casimir of the column's degree: the n-th Casimir of a degree stands in the n-th
/// column of this degree. If there are as many Casimirs as columns, they stand in their order.
fn in_columns(degrees: &[u8], columns: &[u8]) -> Vec<Option<usize>> {
    if degrees.len() == columns.len() {
        return (0..columns.len()).map(Some).collect();
    }
    let of_degree = |degree: u8, n: usize| {
        degrees.iter().enumerate().filter(|(_, own)| **own == degree).map(|(place, _)| place).nth(n)
    };
    let place = |(column, &degree): (usize, &u8)| {
        let before = columns.iter().take(column).filter(|other| **other == degree).count();
        of_degree(degree, before)
    };
    columns.iter().enumerate().map(place).collect()
}

#[cfg(test)]
mod tests {
    use super::in_columns;

    #[test]
    fn casimirs_stand_in_columns_of_their_degrees() {
        assert_eq!(in_columns(&[1, 2], &[1, 2]), [Some(0), Some(1)]);
        assert_eq!(in_columns(&[1], &[2]), [Some(0)]);
        assert_eq!(in_columns(&[2], &[1, 2]), [None, Some(0)]);
        assert_eq!(in_columns(&[2, 2, 3], &[2, 3]), [Some(0), Some(2)]);
        assert_eq!(in_columns(&[2, 2], &[2, 2, 2]), [Some(0), Some(1), None]);
        assert_eq!(in_columns(&[], &[2]), [None]);
    }
}
