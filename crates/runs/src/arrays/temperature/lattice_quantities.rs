//! The energy, the total spin and the lengths of a lattice: [`LatticeQuantities`].

use crate::arrays::sites::open_lattice::OpenLattice;
use crate::arrays::sites::sites_system::{momenta, total};
use crate::models::conserved::Conserved;
use lie_poisson::SitesHamiltonian;
use nalgebra::Vector3;

/// The name of the sum of the squares of all lengths, which alone is kept.
const LENGTHS: &str = "C";

/// h, the total spin M and C = Σ |s_i|² of a lattice with friction or noise, of which C is kept.
pub(super) struct LatticeQuantities<'a>(pub(super) &'a OpenLattice);

impl Conserved for LatticeQuantities<'_> {
    fn names(&self) -> Vec<String> {
        ["h", "M1", "M2", "M3", LENGTHS].map(str::to_owned).to_vec()
    }

    fn is_kept(&self, name: &str) -> bool {
        name == LENGTHS
    }

    /// h is NaN for a state of another dimension.
    fn append(&self, _time: f64, momentum: &[f64], values: &mut Vec<f64>) {
        let spins = momenta(momentum);
        values.push(self.0.value(&spins));
        values.extend(total(&spins.0).iter());
        values.push(spins.0.iter().map(Vector3::norm_squared).sum());
    }

    fn without_value(&self, time: f64, momentum: &[f64]) -> String {
        let (mut values, names) = (Vec::new(), self.names());
        self.append(time, momentum, &mut values);
        let found = names.iter().zip(&values).find(|(_, value)| !value.is_finite());
        found.map_or("a quantity has no value".into(), |(name, value)| format!("{name} is {value}"))
    }
}
