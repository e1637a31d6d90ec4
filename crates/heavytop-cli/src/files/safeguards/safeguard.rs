//! The safeguard of a command: the files that its outputs must not replace.

use super::kind::Kind;
use crate::errors::Error;
use crate::files::lock;
use crate::files::place::Place;
use same_file::Handle;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Something that a command reads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Input {
    /// The file with this path.
    File(PathBuf),
    /// Standard input, which may be a file.
    StandardInput,
}

/// The safeguard of the files of a user: what the outputs of a command may replace.
///
/// An output, and every file that a command writes or removes underway, is none of the files that the command reads, by
/// whatever name or link. An existing file is replaced if it is empty, or of the kind of the output: the program has
/// written it before. Any other file is replaced only by force.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Safeguard {
    inputs: Vec<Input>,
    force: bool,
}

impl Safeguard {
    /// The safeguard of a command that reads no file.
    pub const OWN_FILES: &'static Self = &Self { inputs: Vec::new(), force: false };

    /// Creates the safeguard of a command that reads these inputs. With `force` it lets existing files be replaced, but
    /// no input.
    #[must_use]
    pub fn new(inputs: Vec<Input>, force: bool) -> Self {
        Self { inputs, force }
    }

    /// Returns the safeguard of a command that also reads this input.
    pub(crate) fn and(&self, input: Input) -> Self {
        let inputs = self.inputs.iter().cloned().chain([input]).collect();
        Self { inputs, force: self.force }
    }

    /// Checks that an output may be written, and the unfinished file beside it.
    ///
    /// # Errors
    /// If one of the two is an input, or exists and is not of this kind. If `path` is a folder.
    pub(crate) fn require(&self, path: &Path, kind: &Kind<'_>) -> Result<(), Error> {
        let place = Place::of(path)?;
        if place.is_standard_output() {
            return match Handle::stdout() {
                Ok(stdout) if stdout.as_file().metadata().is_ok_and(|found| found.is_file()) => {
                    self.require_no_input(path, Ok(stdout))
                }
                // A terminal or a pipe is not replaced, nor is what is closed.
                _ => Ok(()),
            };
        }
        self.require_at(path, &place.path, |found| kind.is_of(found), kind.name)?;
        if place.is_device {
            Ok(())
        } else {
            self.require_unfinished(&place.beside("partial"), kind)
        }
    }

    /// Checks that an output may be written whose unfinished file is continued, and is recognised by its checksum.
    ///
    /// # Errors
    /// Those of [`Self::require`].
    pub(crate) fn require_resumed(&self, path: &Path, kind: &Kind<'_>) -> Result<(), Error> {
        let place = Place::of(path)?;
        self.require_at(path, &place.path, |found| kind.is_of(found), kind.name)?;
        self.require_other(&place.beside("partial"))
    }

    /// Checks the files of a folder, each with its kind.
    ///
    /// # Errors
    /// Those of [`Self::require`].
    pub(crate) fn require_all(
        &self,
        folder: &Path,
        files: &[(&str, &Kind<'_>)],
    ) -> Result<(), Error> {
        files.iter().try_for_each(|(name, kind)| self.require(&folder.join(name), kind))
    }

    /// Checks that a file may be written or removed that is an unfinished one of this kind. What another run is writing is
    /// refused, with that reason, by whoever takes its lock.
    ///
    /// # Errors
    /// If it is an input, or exists and is not of this kind.
    pub(crate) fn require_unfinished(&self, path: &Path, kind: &Kind<'_>) -> Result<(), Error> {
        let name = format!("unfinished {}", kind.name);
        let is_own = |found: &Path| Ok(lock::is_held(found) || kind.may_become(found)?);
        self.require_at(path, path, is_own, &name)
    }

    /// Checks that a file may be written or removed, whatever it is.
    ///
    /// # Errors
    /// If it is an input.
    pub(crate) fn require_other(&self, path: &Path) -> Result<(), Error> {
        self.require_at(path, path, |_| Ok(true), "")
    }

    /// Checks that a file may be removed that is always empty.
    ///
    /// # Errors
    /// If it is an input, or is not empty. `name` is its kind in messages.
    pub(crate) fn require_empty(&self, path: &Path, name: &str) -> Result<(), Error> {
        self.require_at(path, path, |_| Ok(false), name)
    }

    fn require_at(
        &self,
        named: &Path,
        at: &Path,
        is_own: impl FnOnce(&Path) -> io::Result<bool>,
        kind: &str,
    ) -> Result<(), Error> {
        let refused = |source| Error::Create { path: named.into(), source };
        let existing = match fs::metadata(at) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(()),
            existing => existing.map_err(refused)?,
        };
        // A folder or a device is not replaced.
        if !existing.is_file() {
            return Ok(());
        }
        self.require_no_input(named, Handle::from_path(at))?;
        if self.force || existing.len() == 0 || is_own(at).map_err(refused)? {
            return Ok(());
        }
        Err(Error::Exists { path: named.into(), kind: kind.into() })
    }

    fn require_no_input(&self, named: &Path, file: io::Result<Handle>) -> Result<(), Error> {
        let file = file.map_err(|source| Error::Create { path: named.into(), source })?;
        match self.inputs.iter().find(|input| input.is(&file)) {
            Some(input) => Err(Error::OutputIsInput { path: named.into(), input: input.name() }),
            None => Ok(()),
        }
    }
}

impl Input {
    /// Returns whether the input is this file. An input that is gone is no file.
    fn is(&self, file: &Handle) -> bool {
        let own = match self {
            // A pipe must not be opened again: that waits for a writer.
            Self::File(path) if fs::metadata(path).is_ok_and(|found| found.is_file()) => {
                Handle::from_path(path)
            }
            Self::File(_) => return false,
            Self::StandardInput => Handle::stdin(),
        };
        own.is_ok_and(|own| own == *file)
    }

    fn name(&self) -> String {
        match self {
            Self::File(path) => path.display().to_string(),
            Self::StandardInput => "standard input".into(),
        }
    }
}
