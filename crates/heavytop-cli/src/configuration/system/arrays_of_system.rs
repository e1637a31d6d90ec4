//! The table `[system]` of a system whose states are arrays.

use super::numbers::Numbers;
use super::system_config::SystemConfig;
use crate::configuration::{Integration, IntegratorConfig};
use crate::errors::{Error, FieldFileError, SystemTableError};
use crate::fields::field_file::{checksum, failed, last};
use crate::runs::{Experiment, Pace, Schedule};
use lie_poisson_runs::step_angle::require_sane_step;
use lie_poisson_runs::{Arguments, ArrayKind, ArraySystem};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The largest number of vortices that are a system by formula, which all commands follow.
const VORTICES_BY_FORMULA: usize = 48;

impl SystemConfig {
    /// Returns the kind of system of arrays that the table names, or `None` if it is a system by formula.
    pub(crate) fn array_kind(&self) -> Option<&'static ArrayKind> {
        let kind = ArrayKind::named(self.kind.as_deref()?)?;
        let vortices = self.parameters.get("strengths").map_or(0, |numbers| numbers.values().len());
        (kind.name != "vortices" || vortices > VORTICES_BY_FORMULA).then_some(kind)
    }

    /// Returns the run of a system of arrays, with the keys of `[integrator]` and the n of which every n-th step is written;
    /// `None` if the table is not of such a system.
    ///
    /// # Errors
    /// If there is no such run.
    pub(crate) fn array_experiment(
        &self,
        integrator: IntegratorConfig,
        every: u64,
    ) -> Result<Option<Experiment<ArraySystem>>, Error> {
        let Some(model) = self.array_system()? else { return Ok(None) };
        let start = self.array_start(&model)?;
        let Integration { scheme, step, end, tolerance, .. } =
            integrator.or(Integration::default());
        let method = model.method(integrator.formulation, scheme, tolerance)?;
        require_sane_step(&model, &start, step)?;
        let pace = Pace { schedule: Schedule::new(step, end)?, every };
        Ok(Some(Experiment { model, start, method, pace, attitude: false }))
    }

    /// Returns the start of a system of arrays, in the coordinates of the computation.
    ///
    /// # Errors
    /// If there is no such start.
    pub(crate) fn array_start(&self, model: &ArraySystem) -> Result<Vec<f64>, Error> {
        let given = match &self.initial_file {
            None => arguments(&self.initial),
            Some(file) if self.initial.is_empty() => self.in_file(file, model)?,
            Some(_) => return Err(SystemTableError::TwoStarts.into()),
        };
        Ok(lie_poisson_runs::Model::start(model, &model.start_of(&given)?)?)
    }

    /// Returns the system of arrays that the table describes; `None` if it is a system by formula.
    ///
    /// # Errors
    /// If there is no such system.
    pub(crate) fn array_system(&self) -> Result<Option<ArraySystem>, Error> {
        let Some(kind) = self.array_kind() else { return Ok(None) };
        if self.is_described() {
            return Err(SystemTableError::TwoSystems.into());
        }
        Ok(Some(kind.system(&arguments(&self.parameters))?))
    }

    /// Makes the path of the file of the start an absolute one, notes the checksum of the file, and
    /// returns the path.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub(crate) fn find_initial_file(&mut self, folder: &Path) -> Result<Option<PathBuf>, Error> {
        let Some(file) = &mut self.initial_file else { return Ok(None) };
        // From another folder a run is resumed, too.
        let path = std::path::absolute(folder.join(&*file));
        let path = path.map_err(|error| failed(Path::new(file), error.into()))?;
        let Some(text) = path.to_str() else {
            let reason = FieldFileError::Format("its path is no text in UTF-8".into());
            return Err(failed(&path, reason));
        };
        *file = text.to_owned();
        self.initial_checksum = Some(checksum(&path)?);
        Ok(Some(path))
    }

    /// Returns the start in a file: the last sample of each array of the system.
    fn in_file(&self, file: &str, model: &ArraySystem) -> Result<Arguments, Error> {
        let path = Path::new(file);
        let now = checksum(path)?;
        if self.initial_checksum.is_some_and(|before| before != now) {
            return Err(SystemTableError::OtherStart { path: path.into() }.into());
        }
        let mut given = Arguments::new();
        for (name, shape) in model.arrays() {
            given = given.list(name, last(path, name, &shape)?);
        }
        Ok(given)
    }
}

fn arguments(numbers: &BTreeMap<String, Numbers>) -> Arguments {
    numbers.iter().fold(Arguments::new(), |all, (name, numbers)| match numbers {
        Numbers::One(value) => all.number(name, *value),
        Numbers::Many(values) => all.list(name, values.clone()),
    })
}
