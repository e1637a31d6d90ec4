//! The arrays of a run, with the system that it followed: [`RunArrays`].

use crate::configuration::Config;
use crate::errors::{Error, FieldFileError, SystemTableError};
use crate::fields::archive::Archive;
use crate::fields::field_file::failed;
use crate::pictures::caption;
use lie_poisson_runs::ArraySystem;
use std::path::{Path, PathBuf};

/// An archive of `simulate`, the system in it, and the configuration of its run.
pub(super) struct RunArrays {
    path: PathBuf,
    archive: Archive,
    pub(super) config: Config,
    pub(super) system: ArraySystem,
    /// The times of the samples.
    pub(super) times: Vec<f64>,
}

impl RunArrays {
    /// Opens the archive of a run of a system of arrays.
    ///
    /// # Errors
    /// If it cannot be read, or is of another run.
    pub(super) fn open(path: &Path) -> Result<Self, Error> {
        let read = |error| failed(path, error);
        let foreign = || read(FieldFileError::Format("it is no archive of simulate".into()));
        let mut archive = Archive::open(path).map_err(read)?;
        let metadata = archive.text("metadata").ok_or_else(foreign)?;
        let metadata: serde_json::Value = serde_json::from_str(&metadata).map_err(|_| foreign())?;
        let text = metadata.get("configuration").and_then(|text| text.as_str());
        let config: Config = toml::from_str(text.ok_or_else(foreign)?).map_err(|_| foreign())?;
        let Some(system) =
            config.system.as_ref().map(|table| table.array_system()).transpose()?.flatten()
        else {
            return Err(SystemTableError::NoArrays.into());
        };
        let times = archive.numbers("t").map_err(read)?;
        if times.is_empty() {
            return Err(read(FieldFileError::Format("it has no samples".into())));
        }
        Ok(Self { path: path.into(), archive, config, system, times })
    }

    /// Returns the name and the shape of the first array.
    pub(super) fn first(&self) -> (&'static str, Vec<usize>) {
        self.system.arrays().into_iter().next().unwrap_or(("", Vec::new()))
    }

    /// Passes the samples of the first array to a function, each with its number, until it has enough.
    ///
    /// # Errors
    /// If they cannot be read.
    pub(super) fn each(
        &mut self,
        mut visit: impl FnMut(usize, &[f64]) -> bool,
    ) -> Result<(), Error> {
        let (name, shape) = self.first();
        let path = self.path.clone();
        let (header, mut file) = self.archive.array(name).map_err(|error| failed(&path, error))?;
        let expected = [&[self.times.len()], &shape[..]].concat();
        if header.shape != expected {
            let (name, found) = (name.into(), header.shape);
            return Err(failed(&path, FieldFileError::Shape { name, expected, found }));
        }
        let mut numbers = vec![0.0; shape.iter().product()];
        for number in 0..self.times.len() {
            let filled = header.fill(&mut file, &mut numbers);
            filled.map_err(|error| failed(&path, error.into()))?;
            if !numbers.iter().all(|x: &f64| x.is_finite()) {
                let text = format!("sample {number} of {name} has numbers that are not finite");
                return Err(failed(&path, FieldFileError::Format(text)));
            }
            if !visit(number, &numbers) {
                break;
            }
        }
        Ok(())
    }

    /// Returns a sample of the first array.
    ///
    /// # Errors
    /// If it cannot be read.
    pub(super) fn sample(&mut self, number: usize) -> Result<Vec<f64>, Error> {
        let mut found = Vec::new();
        self.each(|at, numbers| {
            if at == number {
                found = numbers.to_vec();
            }
            at < number
        })?;
        Ok(found)
    }

    /// Returns the parts of a caption: what the system is, and the method.
    pub(super) fn caption(&self, what: String) -> Vec<String> {
        let integrator = self.config.integrator;
        let formulation = integrator.formulation.or(self.system.formulations().first().copied());
        let scheme = integrator.scheme.unwrap_or_default();
        let step = integrator.step.unwrap_or(crate::configuration::Integration::default().step);
        vec![
            self.system.about().to_owned(),
            caption::method(formulation.unwrap_or_default(), scheme, step),
            what,
        ]
    }
}
