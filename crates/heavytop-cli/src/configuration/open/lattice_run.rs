//! The run of a lattice of spins with friction, also at a temperature.

use super::damping_config::{DampingConfig, DampingForm};
use super::noise_config::{NoiseConfig, Rule};
use crate::configuration::{Config, Integration};
use crate::errors::{Error, SystemTableError};
use crate::runs::{Experiment, Pace, Schedule};
use lie_poisson_runs::step_angle::require_run;
use lie_poisson_runs::{ArrayKind, LatticeNoise, LatticeTerms, SpinDamping, ThermalLattice};

/// The kind of arrays that may have friction and noise.
const LATTICE: &str = "spin-lattice";

impl Config {
    /// Returns whether the configuration is of a lattice of spins with friction or noise.
    pub(crate) fn is_thermal_lattice(&self) -> bool {
        let kind = self.system.as_ref().and_then(|system| system.array_kind());
        kind.is_some_and(|kind| kind.name == LATTICE) && self.open_table().is_some()
    }

    /// Returns the run of the lattice of spins with friction or noise that the configuration asks for; `None` if it asks for
    /// arrays that have neither.
    ///
    /// # Errors
    /// If there is no such run.
    pub(crate) fn thermal_lattice(
        &self,
        kind: &ArrayKind,
    ) -> Result<Option<Experiment<ThermalLattice>>, Error> {
        let Some(terms) = self.lattice_terms(kind)? else { return Ok(None) };
        let system = self.system()?.ok_or(SystemTableError::Missing("system"))?;
        let lattice = system.array_system()?.ok_or(SystemTableError::Missing("kind"))?;
        let start = system.array_start(&lattice)?;
        let integrator = self.integrator;
        let Integration { step, end, tolerance, .. } = integrator.or(Integration::default());
        let model = ThermalLattice::new(lattice, terms, step)?;
        let method = model.method(integrator.formulation, integrator.scheme, tolerance)?;
        require_run(&model, &method, (&start, step))?;
        let pace = Pace { schedule: Schedule::new(step, end)?, every: self.output.every };
        Ok(Some(Experiment { model, start, method, pace, attitude: false }))
    }

    /// Returns the friction and the noise of a lattice of spins, if there is one of the tables of forces.
    fn lattice_terms(&self, kind: &ArrayKind) -> Result<Option<LatticeTerms>, Error> {
        let Some(first) = self.open_table() else { return Ok(None) };
        let others = [
            ("inputs", self.inputs.is_some()),
            ("drive", self.drive.is_some()),
            ("torque", self.torque.is_some()),
        ];
        let other = others.into_iter().find_map(|(table, is_there)| is_there.then_some(table));
        let refused = if kind.name == LATTICE { other } else { Some(first) };
        if let Some(table) = refused {
            return Err(SystemTableError::OpenTable { table }.into());
        }
        let damping = self.damping.as_ref().map(DampingConfig::of_spins).transpose()?;
        let noise = self.noise.as_ref().map(NoiseConfig::of_spins).transpose()?;
        Ok(Some(LatticeTerms { damping, noise }))
    }
}

impl DampingConfig {
    /// Returns the damping of spins.
    fn of_spins(&self) -> Result<SpinDamping, SystemTableError> {
        if self.inner_product.is_some() {
            return Err(SystemTableError::KeyOfFormulas { key: "damping.inner_product" });
        }
        let friction = self.required_friction()?;
        Ok(match self.form.unwrap_or_default() {
            DampingForm::LandauLifshitz => SpinDamping::LandauLifshitz(friction),
            DampingForm::Gilbert => SpinDamping::Gilbert(friction),
        })
    }
}

impl NoiseConfig {
    /// Returns the noise of a temperature of spins.
    fn of_spins(&self) -> Result<LatticeNoise, SystemTableError> {
        let others = [
            ("noise.strength", self.strength.is_some()),
            ("noise.inner_product", self.inner_product.is_some()),
            ("noise.fields", !self.fields.is_empty()),
            ("noise.rule", self.rule != Rule::Together),
        ];
        if let Some((key, _)) = others.into_iter().find(|(_, is_there)| *is_there) {
            return Err(SystemTableError::KeyOfFormulas { key });
        }
        let missing = || SystemTableError::MissingKey { table: "noise".into(), key: "temperature" };
        let temperature = self.temperature.ok_or_else(missing)?;
        let Self { seed, path, interval, bound, .. } = *self;
        Ok(LatticeNoise { temperature, seed, path, interval, bound })
    }
}
