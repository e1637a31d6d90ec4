//! What the tables of open systems say.

use super::element::{Element, parts};
use super::input_config::failed;
use crate::configuration::{Config, SystemConfig};
use crate::errors::{Error, SystemTableError};
use lie_poisson_formula_systems::{NamedInputs, OpenNames, OpenSystemError, OpenTerms};
use lie_poisson_formulas::Formula;
use std::path::{Path, PathBuf};

impl Config {
    /// Returns the name of a table of open systems that the configuration has.
    #[must_use]
    pub(crate) fn open_table(&self) -> Option<&'static str> {
        self.open_tables().next()
    }

    /// Returns the names of the tables of open systems that the configuration has.
    pub(super) fn open_tables(&self) -> impl Iterator<Item = &'static str> {
        let tables = [
            ("inputs", self.inputs.is_some()),
            ("drive", self.drive.is_some()),
            ("damping", self.damping.is_some()),
            ("noise", self.noise.is_some()),
            ("torque", self.torque.is_some()),
        ];
        tables.into_iter().filter_map(|(name, is_there)| is_there.then_some(name))
    }

    /// Returns what drives, damps, shakes or forces the system, in words of a caption.
    pub(crate) fn forces(&self) -> Option<String> {
        let (damping, noise) = (self.damping.as_ref(), self.noise.as_ref());
        let words = [
            self.drive.as_ref().map(|_| "driven".into()),
            damping.and_then(|damping| Some(format!("friction {}", damping.friction?))),
            damping.and_then(|damping| Some(format!("viscosity {}", damping.viscosity?))),
            damping.and_then(|damping| Some(format!("drag {}", damping.drag?))),
            noise.map(|noise| format!("noise of seed {}, path {}", noise.seed, noise.path)),
            self.torque.as_ref().map(|_| "under a torque".into()),
        ];
        let words: Vec<String> = words.into_iter().flatten().collect();
        (!words.is_empty()).then(|| words.join(", "))
    }

    /// Checks that a command which follows closed systems alone has no table of open ones.
    ///
    /// # Errors
    /// If it has one.
    pub(crate) fn require_closed(&self) -> Result<(), SystemTableError> {
        self.open_table().map_or(Ok(()), |table| Err(SystemTableError::OpenTable { table }))
    }

    /// Returns the inputs of `[inputs]`, and those of the orbit of `[system]`.
    ///
    /// # Errors
    /// If one is no table, or there is no such orbit.
    pub(crate) fn named_inputs(&self) -> Result<NamedInputs, Error> {
        let inputs = self
            .inputs
            .iter()
            .flatten()
            .map(|(name, input)| Ok((name.clone(), input.table(name)?)));
        let orbit = self.system.as_ref().map_or(Ok(None), SystemConfig::orbit)?;
        Ok(NamedInputs::new(inputs.collect::<Result<_, Error>>()?).with_orbit(orbit))
    }

    /// Makes the paths of the files of `[inputs]`, which are relative to a folder, absolute ones, notes the checksums of the
    /// files, and returns the paths.
    ///
    /// # Errors
    /// If a file cannot be read.
    pub(crate) fn find_input_files(&mut self, folder: &Path) -> Result<Vec<PathBuf>, Error> {
        let inputs = self.inputs.iter_mut().flatten();
        let paths = inputs.map(|(name, input)| input.find_file(name, folder));
        Ok(paths.collect::<Result<Vec<_>, _>>()?.into_iter().flatten().collect())
    }

    /// Replaces the files of `[inputs]` by the times and values in them, for many runs with the same tables.
    ///
    /// # Errors
    /// If a file cannot be read, or has no such table.
    pub(crate) fn read_inputs(&mut self) -> Result<(), Error> {
        self.inputs.iter_mut().flatten().try_for_each(|(name, input)| input.read_file(name))
    }

    /// Checks that the inputs reach from 0 to the end of a run.
    ///
    /// # Errors
    /// If one does not; the error names its file, if it has one.
    pub(crate) fn require_inputs(&self, inputs: &NamedInputs, end: f64) -> Result<(), Error> {
        inputs.require_until(end).map_err(|error| match &error {
            OpenSystemError::Input { name, reason } => {
                let input = self.inputs.as_ref().and_then(|inputs| inputs.get(name));
                match input.and_then(|input| input.file.as_ref()) {
                    Some(file) => failed(name, Path::new(file), (*reason).into()),
                    None => error.into(),
                }
            }
            _ => error.into(),
        })
    }

    /// Returns what makes a system on an algebra an open one, with its Hamiltonian if that depends on the time.
    ///
    /// # Errors
    /// If a table does not fit the algebra.
    pub(super) fn open_terms(
        &self,
        (names, dimension): (&OpenNames, usize),
        inputs: NamedInputs,
        hamiltonian: Option<Formula>,
    ) -> Result<OpenTerms, Error> {
        let element = |what: &'static str, element: &Option<Element>| match element {
            None => Ok(None),
            Some(none) if none.is_empty() => Err(SystemTableError::NoForces { table: what }.into()),
            Some(element) => Ok::<_, Error>(Some(names.element(what, parts(element))?)),
        };
        let damping =
            self.damping.as_ref().map(|damping| damping.damping(names, dimension)).transpose()?;
        let noise = self.noise.as_ref();
        let noise =
            noise.map(|noise| noise.terms(names, dimension, damping.as_ref())).transpose()?;
        let (drive, torque) = (element("drive", &self.drive)?, element("torque", &self.torque)?);
        torque.iter().try_for_each(|torque| names.require_torque(torque))?;
        Ok(OpenTerms { inputs, hamiltonian, drive, damping, noise, torque })
    }
}
