//! A lattice of spins with friction, at a temperature, and in a field that depends on the time: [`OpenedLattice`].

use super::array_terms::LatticeTerms;
use super::lattice_field::LatticeField;
use super::noise_paths::NoisePaths;
use super::on_path::OnPath;
use super::opened::{Opened, Opening};
use crate::arrays::sites::open_lattice::OpenLattice;
use crate::arrays::sites::sites_system::{Momenta, momenta, numbers, total};
use collective_integrators::{AnyIntegrator, StageSolver};
use lie_poisson::{Sites, SitesHamiltonian, State, larger, thermal_strength};
use lie_poisson_formula_systems::{FormulaSystemError, OpenSystemError};
use lie_poisson_systems::{FieldInTime, LangevinSpins, SpinDamping};
use nalgebra::Vector3;

/// The name of the sum of the squares of all lengths, which alone is kept.
const LENGTHS: &str = "C";

/// A lattice by the stochastic midpoint rule of [`LangevinSpins`]: h, the total spin and Σ |s_i|², of which the last is
/// kept.
#[derive(Debug)]
pub(in crate::arrays) struct OpenedLattice {
    langevin: LangevinSpins<OpenLattice, Option<LatticeField>>,
    damping: SpinDamping,
    temperature: f64,
}

impl OpenedLattice {
    /// Returns the lattice with its terms, for runs with steps of a size, s.
    ///
    /// # Errors
    /// If a number is not what it must be, a temperature has no damping, or steps at one would go back in time.
    pub(in crate::arrays) fn of(lattice: &OpenLattice, terms: &LatticeTerms, step: f64) -> Opening {
        let damping = terms.damping.unwrap_or(SpinDamping::LandauLifshitz(0.0));
        let (SpinDamping::LandauLifshitz(friction) | SpinDamping::Gilbert(friction)) = damping;
        OpenSystemError::require_thermal(friction, 0.0)?;
        if terms.noise.is_some() && terms.damping.is_none() {
            return Err(OpenSystemError::TemperatureAlone.into());
        }
        let temperature = terms.noise.map_or(0.0, |noise| noise.temperature);
        OpenSystemError::require_thermal(friction, temperature)?;
        if temperature > 0.0 {
            OpenSystemError::require_forward(friction, step)?;
        }
        let paths = terms.noise.map(|noise| noise.paths);
        let paths = NoisePaths::brownian_of(paths.as_ref(), step)?;
        let langevin = LangevinSpins::new(lattice.clone(), damping, temperature, paths);
        let langevin = langevin.map_err(|error| FormulaSystemError::KindValue {
            kind: LatticeTerms::KIND,
            name: "damping",
            needed: format!("possible: {error}"),
        })?;
        let langevin = langevin.with_field(terms.field.clone());
        Ok(Box::new(Self { langevin, damping, temperature }))
    }
}

impl Opened for OpenedLattice {
    fn quantities(&self) -> Vec<String> {
        ["h", "M1", "M2", "M3", LENGTHS].map(str::to_owned).to_vec()
    }

    /// h, with the field of the time, is NaN for a state of another dimension, and where the field has no value.
    fn append(&self, time: f64, state: &[f64], values: &mut Vec<f64>) {
        let spins = momenta(state);
        let (sum, uniform) = (total(&spins.0), self.langevin.field().at(time));
        values.push(self.langevin.hamiltonian().value(&spins) - uniform.dot(&sum));
        values.extend(sum.iter());
        values.push(spins.0.iter().map(Vector3::norm_squared).sum());
    }

    fn keeps(&self, quantity: &str) -> bool {
        quantity == LENGTHS
    }

    fn rate(&self, time: f64, state: &[f64]) -> Vec<f64> {
        let uniform = self.langevin.field().at(time);
        let spins = momenta(state);
        let mut dh: Sites<Vector3<f64>> = State::zeros_of(&spins.0.len());
        self.langevin.hamiltonian().differential_into(&spins, &mut dh);
        let rates = spins
            .0
            .iter()
            .zip(dh.iter())
            .map(|(spin, dh)| self.damping.rate(spin, &(uniform - dh)));
        numbers(&rates.collect::<Vec<_>>())
    }

    fn rate_of_drive(&self) -> f64 {
        self.langevin.field().as_ref().map_or(0.0, LatticeField::size)
    }

    /// The largest of all spins: with Gilbert's damping short spins turn more.
    fn noise_angle(&self, state: &[f64], step: f64) -> f64 {
        let friction = |spin: &Vector3<f64>| self.damping.friction(spin.norm());
        let friction = momenta(state).0.iter().map(friction).fold(0.0, larger);
        thermal_strength(friction, self.temperature) * step.abs().sqrt()
    }

    fn integrator(&self, tolerance: f64, path: u64) -> AnyIntegrator {
        let solver = StageSolver { tolerance, ..StageSolver::default() };
        let integrator = self.langevin.clone().with_solver(solver);
        let axes = self.langevin.hamiltonian().axes().iter();
        let spins: Momenta = State::zeros_of(&axes.map(|(count, _)| count).product());
        OnPath { integrator, path }.erased(&spins)
    }
}
