//! The run of a system of arrays with friction, forces, noise or a field in time.

use super::damping_config::{DampingConfig, DampingForm};
use super::element::Formulas;
use super::noise_config::{NoiseConfig, ShellConfig};
use crate::configuration::{Config, Integration};
use crate::errors::{Error, SystemTableError};
use crate::runs::{Experiment, Pace, Schedule};
use heavytop::methods::Formulation;
use lie_poisson_runs::step_angle::require_run;
use lie_poisson_runs::{
    ArrayKind, ArrayTerms, FluidNoise, FluidTerms, LatticeField, LatticeNoise, LatticeTerms,
    NoisePaths, OpenArrays, SpinDamping, directed_step,
};

/// The tables of forces of a kind of arrays.
struct Forces {
    kind: &'static str,
    tables: &'static [&'static str],
    /// The keys of the tables, but for those that every noise has.
    keys: &'static [&'static str],
    has: &'static str,
}

const LATTICE: Forces = Forces {
    kind: LatticeTerms::KIND,
    tables: &["inputs", "drive", "damping", "noise"],
    keys: &["drive.field", "damping.friction", "damping.form", "noise.temperature"],
    has: "a spin-lattice has friction and form in [damping], field in [drive], with [inputs], and temperature, seed, path, \
          interval and bound in [noise]",
};

const FLUID: Forces = Forces {
    kind: FluidTerms::KIND,
    tables: &["damping", "noise", "torque"],
    keys: &[
        "damping.viscosity",
        "damping.power",
        "damping.drag",
        "noise.transport",
        "noise.stirring",
    ],
    has: "a sphere-fluid has viscosity, power and drag in [damping], coefficients in [torque], and transport, stirring, \
          seed, path, interval and bound in [noise]",
};

impl Config {
    /// Returns the formulation of the arrays with friction, forces or noise that the configuration asks for; `None` if
    /// it asks for something else.
    pub(crate) fn opened_formulation(&self) -> Option<Formulation> {
        self.open_table()?;
        self.system.as_ref()?.array_kind()?.opened
    }

    /// Returns the run of the arrays with friction, forces or noise that the configuration asks for; `None` if it asks
    /// for arrays that have none of them.
    ///
    /// # Errors
    /// If there is no such run.
    pub(crate) fn open_arrays(
        &self,
        kind: &ArrayKind,
    ) -> Result<Option<Experiment<OpenArrays>>, Error> {
        let Some(terms) = self.array_terms(kind)? else { return Ok(None) };
        let system = self.system()?.ok_or(SystemTableError::Missing("system"))?;
        let arrays = system.array_system()?.ok_or(SystemTableError::Missing("kind"))?;
        let start = system.array_start(&arrays)?;
        let integrator = self.integrator;
        let Integration { step, end, tolerance, .. } = integrator.or(Integration::default());
        let step = directed_step(step, end)?;
        if let Some(inputs) = terms.inputs() {
            self.require_inputs(inputs, end)?;
        }
        let model = OpenArrays::new(arrays, terms, step)?;
        let method = model.method(integrator.formulation, integrator.scheme, tolerance)?;
        require_run(&model, &method, (&start, step))?;
        let pace = Pace { schedule: Schedule::new(step, end)?, every: self.output.every };
        Ok(Some(Experiment { model, start, method, pace, attitude: false }))
    }

    /// Returns what the tables of forces say of a system of arrays, if there is one of them.
    fn array_terms(&self, kind: &ArrayKind) -> Result<Option<ArrayTerms>, Error> {
        let of_kind = [LATTICE, FLUID].into_iter().find(|of| of.kind == kind.name);
        let known = of_kind.as_ref().map_or(&[][..], |of| of.tables);
        if let Some(table) = self.open_tables().find(|table| !known.contains(table)) {
            return Err(SystemTableError::OpenTable { table }.into());
        }
        let (Some(_), Some(Forces { keys, has, .. })) = (self.open_table(), of_kind) else {
            return Ok(None);
        };
        let (damping, noise) = (self.damping.as_ref(), self.noise.as_ref());
        damping.map_or(Ok(()), |damping| damping.require_only(keys, has))?;
        noise.map_or(Ok(()), |noise| noise.require_only(keys, has))?;
        if kind.name == FLUID.kind {
            return Ok(Some(self.fluid_terms()?.into()));
        }
        let damping = damping.map(DampingConfig::of_spins).transpose()?;
        let noise = noise.map(NoiseConfig::of_spins).transpose()?;
        Ok(Some(LatticeTerms { field: self.lattice_field()?, damping, noise }.into()))
    }

    /// Returns the uniform field B(t) of a lattice of spins, if there is one.
    fn lattice_field(&self) -> Result<Option<LatticeField>, Error> {
        let (key, table) = ("field", "drive".to_owned());
        let Some(drive) = &self.drive else {
            self.require_named_inputs()?;
            return Ok(None);
        };
        if let Some(other) = drive.keys().find(|other| *other != key) {
            let key = format!("drive.{other}");
            return Err(SystemTableError::OtherKey { key, has: LATTICE.has }.into());
        }
        let field = drive.get(key).ok_or(SystemTableError::MissingKey { table, key })?;
        let field = LatticeField::new(self.named_inputs()?, &field.texts())?;
        self.require_named_inputs()?;
        Ok(Some(field))
    }

    /// Returns the viscosity, the drag, the force and the noise of a fluid.
    fn fluid_terms(&self) -> Result<FluidTerms, SystemTableError> {
        let mut terms = FluidTerms::default();
        if let Some(DampingConfig { viscosity, power, drag, .. }) = self.damping {
            if viscosity.is_none() && (drag.is_none() || power.is_some()) {
                let key = if power.is_some() { "viscosity" } else { "viscosity or drag" };
                return Err(SystemTableError::MissingKey { table: "damping".into(), key });
            }
            terms.viscosity = viscosity.unwrap_or_default();
            terms.power = power.unwrap_or(terms.power);
            terms.drag = drag.unwrap_or_default();
        }
        if let Some(torque) = &self.torque {
            if let Some(other) = torque.keys().find(|key| *key != "coefficients") {
                let key = format!("torque.{other}");
                return Err(SystemTableError::OtherKey { key, has: FLUID.has });
            }
            let Some(Formulas::Rows(rows)) = torque.get("coefficients") else {
                let key = "coefficients, of rows [l, m, re, im],";
                return Err(SystemTableError::MissingKey { table: "torque".into(), key });
            };
            terms.force.clone_from(rows);
        }
        terms.noise = self.noise.as_ref().map(NoiseConfig::of_fluid).transpose()?;
        Ok(terms)
    }
}

impl DampingConfig {
    /// Returns the damping of spins.
    fn of_spins(&self) -> Result<SpinDamping, SystemTableError> {
        let friction = self.required_friction()?;
        Ok(match self.form.unwrap_or_default() {
            DampingForm::LandauLifshitz => SpinDamping::LandauLifshitz(friction),
            DampingForm::Gilbert => SpinDamping::Gilbert(friction),
        })
    }
}

impl NoiseConfig {
    const fn paths(&self) -> NoisePaths {
        let Self { seed, path, interval, bound, .. } = *self;
        NoisePaths { seed, path, interval, bound }
    }

    /// Returns the noise of a temperature of spins.
    fn of_spins(&self) -> Result<LatticeNoise, SystemTableError> {
        let missing = || SystemTableError::MissingKey { table: "noise".into(), key: "temperature" };
        let temperature = self.temperature.ok_or_else(missing)?;
        Ok(LatticeNoise { temperature, paths: self.paths() })
    }

    /// Returns the noise of a fluid.
    fn of_fluid(&self) -> Result<FluidNoise, SystemTableError> {
        if self.transport.is_none() && self.stirring.is_none() {
            let key = "transport or stirring";
            return Err(SystemTableError::MissingKey { table: "noise".into(), key });
        }
        let shells = |table, config: &Option<ShellConfig>| {
            config.as_ref().map_or(Ok(Vec::new()), |config| config.shells(table))
        };
        let transport = shells("noise.transport", &self.transport)?;
        let stirring = shells("noise.stirring", &self.stirring)?;
        Ok(FluidNoise { transport, stirring, paths: self.paths() })
    }
}
