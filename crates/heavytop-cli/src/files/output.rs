//! Output files that appear under their names only when they are complete.

use super::place::Place;
use super::safeguards::kind::Kind;
use super::torn_line::cut_torn_line;
use crate::errors::Error;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// A file that is written as `NAME.partial` beside its place and then renamed.
///
/// The partial file is locked, so that no other run writes to it.
///
/// The partial file is removed unless the output is completed or concluded. A place that is no regular file, such as
/// `/dev/stdout`, is written directly, since it must not be replaced.
#[derive(Debug)]
pub struct Output {
    path: PathBuf,
    partial: Partial,
    writer: BufWriter<File>,
}

/// The path of a partial file, which is removed when this is dropped; `None` once the file is complete or kept, or if the
/// place is written directly.
#[derive(Debug)]
struct Partial(Option<PathBuf>);

impl Drop for Partial {
    fn drop(&mut self) {
        if let Some(path) = &self.0 {
            // The error that matters has been reported already.
            let _ = fs::remove_file(path);
        }
    }
}

impl Output {
    /// Opens the output for the file `path`.
    ///
    /// # Errors
    /// If the partial file cannot be created, another run is writing it, or `path` is a folder.
    pub fn create(path: &Path) -> Result<Self, Error> {
        let place = Place::of(path)?;
        let partial = (!place.is_device).then(|| place.beside("partial"));
        let file = place.open(partial.as_deref().unwrap_or(&place.path))?;
        if partial.is_some() {
            // Discards what a killed run left.
            file.set_len(0).map_err(|source| Error::Create { path: path.into(), source })?;
        }
        Ok(Self { path: place.path, partial: Partial(partial), writer: BufWriter::new(file) })
    }

    /// Writes a whole file at once, at the end of a run.
    ///
    /// # Errors
    /// [`Error::Write`] if the file cannot be created or written: at the end it is too late to refuse the request.
    pub fn whole(path: &Path, contents: &[u8]) -> Result<(), Error> {
        let mut output = Self::create(path).map_err(Error::too_late)?;
        output.write(|writer| writer.write_all(contents))?;
        output.complete()
    }

    /// Runs `write` on the buffered writer of the file.
    ///
    /// # Errors
    /// The I/O error, with the path of the file.
    pub fn write<F>(&mut self, write: F) -> Result<(), Error>
    where
        F: FnOnce(&mut BufWriter<File>) -> io::Result<()>,
    {
        write(&mut self.writer).map_err(|source| self.failed(source))
    }

    /// Completes the file and gives it its name.
    ///
    /// # Errors
    /// If the last bytes cannot be written, or the file cannot be renamed.
    pub fn complete(mut self) -> Result<(), Error> {
        self.finish()?;
        if let Some(partial) = &self.partial.0 {
            fs::rename(partial, &self.path).map_err(|e| self.failed(e))?;
        }
        self.partial.0 = None;
        Ok(())
    }

    /// Completes the file and gives it its name, unless there is a file of this name, even if it appeared at this moment.
    ///
    /// # Errors
    /// [`Error::Exists`] if there is one. The errors of [`Self::complete`].
    pub(crate) fn complete_new(mut self, kind: &Kind<'_>) -> Result<(), Error> {
        self.finish()?;
        let Some(partial) = &self.partial.0 else { return Ok(()) };
        match fs::hard_link(partial, &self.path) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                Err(Error::Exists { path: self.path.clone(), kind: kind.name.into() })
            }
            // Some file systems have no hard links.
            Err(_) => self.complete(),
            // The other name of the file is removed.
            Ok(()) => Ok(()),
        }
    }

    /// Writes the last bytes, and makes all of them outlast a power cut; the file does not have its name yet.
    ///
    /// So the name never stands for an incomplete file, and a full disk is found while the old file is still there.
    ///
    /// # Errors
    /// If the last bytes cannot be written.
    pub fn finish(&mut self) -> Result<(), Error> {
        self.write(Write::flush)?;
        match self.partial.0 {
            Some(_) => self.writer.get_ref().sync_all().map_err(|e| self.failed(e)),
            None => Ok(()),
        }
    }

    /// Completes the file if the run that wrote it succeeded.
    ///
    /// If the run failed underway, the lines that it wrote are kept as `NAME.partial`. If it was refused, nothing is kept.
    ///
    /// # Errors
    /// The reason why the run or the completion failed, and the path of the partial file.
    pub fn conclude<T>(self, outcome: Result<T, Error>) -> Result<T, Error> {
        match outcome {
            Ok(value) => self.complete().map(|()| value),
            Err(failure) if failure.exit_code() == 1 => Err(match self.keep_lines() {
                Some(partial) => Error::Kept { partial, source: Box::new(failure) },
                None => failure,
            }),
            Err(refusal) => Err(refusal),
        }
    }

    /// Leaves the file as `NAME.partial`, and closes it.
    ///
    /// # Errors
    /// If the last bytes cannot be written: then the partial file is removed.
    pub fn keep(mut self) -> Result<(), Error> {
        self.write(Write::flush)?;
        self.partial.0 = None;
        Ok(())
    }

    /// Leaves those lines as `NAME.partial` for which there is room, and returns its path; a device has none.
    fn keep_lines(mut self) -> Option<PathBuf> {
        let flushed = self.writer.flush();
        let partial = self.partial.0.take()?;
        // Without its parts, the writer would try to write the rest when it is dropped.
        let (mut file, _) = self.writer.into_parts();
        if flushed.is_err() {
            // The error reports the first failure.
            let _ = cut_torn_line(&mut file);
        }
        Some(partial)
    }

    /// Returns the error that the output cannot be written.
    pub(crate) fn failed(&self, source: io::Error) -> Error {
        Error::Write { path: self.path.clone(), source }
    }
}

/// Passes bytes to the buffered writer; its errors do not name the file.
impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.writer.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.writer.flush()
    }
}
