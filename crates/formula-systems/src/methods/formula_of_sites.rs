//! A formula of many spins as a Hamiltonian: [`FormulaOfSites`].

use lie_poisson::{Covector, Real, Sites, SitesHamiltonian, State};
use lie_poisson_formulas::Formula;
use nalgebra::Vector3;

/// A formula in the components of N vectors, on (so(3)∗)ᴺ.
pub(super) struct FormulaOfSites(pub(super) Formula);

impl<T: Real> SitesHamiltonian<Vector3<T>> for FormulaOfSites {
    fn value(&self, m: &Covector<Sites<Vector3<T>>>) -> T {
        self.0.value_of(m.dimension(), |i| m.0[i / 3][i % 3])
    }

    /// Writes the differential, or NaN for another number of vectors.
    fn differential_into(&self, m: &Covector<Sites<Vector3<T>>>, dh: &mut Sites<Vector3<T>>) {
        let at = |i: usize| m.0[i / 3][i % 3];
        self.0.with_differential(m.dimension(), at, |slopes| {
            let slope = |i: usize| slopes.get(i).copied();
            dh.set_coordinates(|i| slope(i).unwrap_or_else(|| T::from_f64(f64::NAN)));
        });
    }
}
