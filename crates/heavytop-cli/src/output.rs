//! Files that appear under their name only when they are complete.

use crate::Error;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// A file that is written as `NAME.partial` beside its place and then renamed.
///
/// Unless it is completed or concluded, the partial file is removed. A place that is no regular file,
/// such as `/dev/stdout`, is written to directly: to replace it would be no favour.
#[derive(Debug)]
pub struct Output {
    path: PathBuf,
    /// The partial file; none once it is complete or kept, or if the place is written directly.
    partial: Option<PathBuf>,
    writer: BufWriter<File>,
}

impl Output {
    /// Opens the output that shall be at `path`.
    ///
    /// # Errors
    /// If the partial file cannot be created, or `path` is a folder.
    pub fn create(path: &Path) -> Result<Self, Error> {
        let refused = |source| Error::Create { path: path.into(), source };
        // A symbolic link stays, and the file that it points to is replaced.
        let place = fs::canonicalize(path).unwrap_or_else(|_| path.into());
        let (file, partial) = match fs::metadata(&place) {
            Ok(existing) if existing.is_dir() => {
                return Err(refused(io::ErrorKind::IsADirectory.into()));
            }
            Ok(existing) if !existing.is_file() => {
                (File::options().write(true).open(&place).map_err(refused)?, None)
            }
            _ => {
                let mut name = place.clone().into_os_string();
                name.push(".partial");
                (File::create(&name).map_err(refused)?, Some(PathBuf::from(name)))
            }
        };
        Ok(Self { path: place, partial, writer: BufWriter::new(file) })
    }

    /// Writes a whole file at the end of a run.
    ///
    /// # Errors
    /// [`Error::Write`] if it cannot be created or written: at the end it is too late to refuse.
    pub fn whole(path: &Path, contents: &[u8]) -> Result<(), Error> {
        let mut output = Self::create(path).map_err(|error| match error {
            Error::Create { path, source } => Error::Write { path, source },
            other => other,
        })?;
        output.write(|writer| writer.write_all(contents))?;
        output.complete()
    }

    /// Writes with the file's buffered writer.
    ///
    /// # Errors
    /// The I/O error, with the file's name.
    pub fn write<F>(&mut self, write: F) -> Result<(), Error>
    where
        F: FnOnce(&mut BufWriter<File>) -> io::Result<()>,
    {
        write(&mut self.writer).map_err(|source| self.failed(source))
    }

    /// Gives the file its name.
    ///
    /// # Errors
    /// If the last bytes cannot be written, or the file cannot be renamed.
    pub fn complete(mut self) -> Result<(), Error> {
        self.write(Write::flush)?;
        if let Some(partial) = &self.partial {
            // So that the name never stands for less than the whole, even after a power cut.
            let renamed = self.writer.get_ref().sync_all();
            renamed.and_then(|()| fs::rename(partial, &self.path)).map_err(|e| self.failed(e))?;
        }
        self.partial = None;
        Ok(())
    }

    /// Completes the file if the run that wrote it did well. If it failed underway, what there is
    /// is kept as `NAME.partial`; if it was refused, nothing is.
    ///
    /// # Errors
    /// Why the run or the completion failed, and where the partial file is.
    pub fn conclude<T>(mut self, outcome: Result<T, Error>) -> Result<T, Error> {
        match outcome {
            Ok(value) => self.complete().map(|()| value),
            Err(failure) if failure.exit_code() == 1 => {
                // What cannot be written any more is lost; the failure says what came first.
                let _ = self.writer.flush();
                Err(match self.partial.take() {
                    Some(partial) => Error::Kept { partial, source: Box::new(failure) },
                    None => failure,
                })
            }
            Err(refusal) => Err(refusal),
        }
    }

    fn failed(&self, source: io::Error) -> Error {
        Error::Write { path: self.path.clone(), source }
    }
}

impl Drop for Output {
    fn drop(&mut self) {
        if let Some(partial) = &self.partial {
            // Nothing is left to tell: an error is on its way already.
            let _ = fs::remove_file(partial);
        }
    }
}
