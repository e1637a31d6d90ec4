//! The arrays of a run, with what it is of: [`RunArrays`].

use super::run_subject::RunSubject;
use crate::configuration::Config;
use crate::errors::{Error, FieldFileError};
use crate::fields::archive::Archive;
use crate::fields::field_file::failed;
use std::path::{Path, PathBuf};

/// The bytes of all arrays together that are read ahead.
const AHEAD: usize = 1 << 22;

/// An archive of `simulate`, what its run is of, and the configuration of the run.
pub(super) struct RunArrays {
    path: PathBuf,
    names: Vec<String>,
    pub(super) config: Config,
    pub(super) subject: RunSubject,
    /// The times of the samples.
    pub(super) times: Vec<f64>,
}

impl RunArrays {
    /// Opens the archive of a run.
    ///
    /// # Errors
    /// If it cannot be read, or is of no run.
    pub(super) fn open(path: &Path) -> Result<Self, Error> {
        let read = |error| failed(path, error);
        let foreign = || read(FieldFileError::Format("it is no archive of simulate".into()));
        let mut archive = Archive::open(path).map_err(read)?;
        let metadata = archive.text("metadata").ok_or_else(foreign)?;
        let metadata: serde_json::Value = serde_json::from_str(&metadata).map_err(|_| foreign())?;
        let text = metadata.get("configuration").and_then(|text| text.as_str());
        let table = toml::from_str(text.ok_or_else(foreign)?).map_err(|_| foreign())?;
        let config = Config::of_table(table).map_err(|_| foreign())?;
        let subject = RunSubject::new(&config)?;
        let times = archive.numbers("t").map_err(read)?;
        if times.is_empty() {
            return Err(read(FieldFileError::Format("it has no samples".into())));
        }
        Ok(Self { path: path.into(), names: archive.names(), config, subject, times })
    }

    /// Returns the error of the archive.
    pub(super) fn failed(&self, error: FieldFileError) -> Error {
        failed(&self.path, error)
    }

    /// Returns whether the archive has an array of this name.
    pub(super) fn has(&self, name: &str) -> bool {
        self.names.iter().any(|own| own == name)
    }

    /// Returns the time of a sample.
    pub(super) fn time(&self, sample: usize) -> f64 {
        self.times.get(sample).copied().unwrap_or_default()
    }

    /// Passes the samples of some arrays to a function, those of one time one after the other and with their number, until
    /// it returns that it has enough. One sample is in memory at a time.
    ///
    /// # Errors
    /// If they cannot be read, or the error of the function.
    pub(super) fn each(
        &self,
        arrays: &[(String, Vec<usize>)],
        mut visit: impl FnMut(usize, &[f64]) -> Result<bool, Error>,
    ) -> Result<(), Error> {
        let read = |error| failed(&self.path, error);
        // The arrays are one after the other in the archive, and are read side by side.
        let ahead = AHEAD / arrays.len().max(1);
        let opened = arrays.iter().map(|_| Archive::open_ahead(&self.path, ahead));
        let mut archives = opened.collect::<Result<Vec<_>, _>>().map_err(read)?;
        let mut open = Vec::new();
        for (archive, (name, shape)) in archives.iter_mut().zip(arrays) {
            let (header, file) = archive.array(name).map_err(read)?;
            let expected = [&[self.times.len()], &shape[..]].concat();
            if header.shape != expected {
                let (name, found) = (name.clone(), header.shape);
                return Err(read(FieldFileError::Shape { name, expected, found }));
            }
            open.push((name, vec![0.0; shape.iter().product()], header, file));
        }
        let mut sample = Vec::new();
        for number in 0..self.times.len() {
            sample.clear();
            for (name, numbers, header, file) in &mut open {
                header.fill(file, numbers).map_err(|error| read(error.into()))?;
                if !numbers.iter().all(|x: &f64| x.is_finite()) {
                    let text = format!("sample {number} of {name} has numbers that are not finite");
                    return Err(read(FieldFileError::Format(text)));
                }
                sample.extend_from_slice(numbers);
            }
            if !visit(number, &sample)? {
                break;
            }
        }
        Ok(())
    }

    /// Returns the parts of a caption: what the run is of, the method, and this.
    pub(super) fn caption(&self, what: String) -> Vec<String> {
        self.subject.caption(&self.config).into_iter().chain([what]).collect()
    }
}
