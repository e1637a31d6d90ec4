//! Files that appear under their name only when they are complete.

use crate::Error;
use crate::lock;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// Where an output shall be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The file; if a symbolic link was asked for, that which it leads to, so that the link stays.
    pub path: PathBuf,
    /// Whether it is there and no regular file, such as `/dev/stdout`.
    pub is_device: bool,
}

impl Place {
    /// The place of the output that shall be at `path`.
    ///
    /// # Errors
    /// If that is a folder, or a symbolic link that leads nowhere.
    pub fn of(path: &Path) -> Result<Self, Error> {
        let refused = |source| Error::Create { path: path.into(), source };
        match fs::metadata(path) {
            Ok(existing) if existing.is_dir() => Err(refused(io::ErrorKind::IsADirectory.into())),
            Ok(existing) => {
                let path = fs::canonicalize(path).unwrap_or_else(|_| path.into());
                Ok(Self { path, is_device: !existing.is_file() })
            }
            Err(_) => Ok(Self { path: end_of_links(path).map_err(refused)?, is_device: false }),
        }
    }

    /// The file `NAME.ENDING` beside it.
    #[must_use]
    pub fn beside(&self, ending: &str) -> PathBuf {
        let mut name = self.path.clone().into_os_string();
        name.push(".");
        name.push(ending);
        name.into()
    }

    /// Opens a file for it that no other run may open until it is closed, and makes it if it is not
    /// there; or opens the device, which is anybody's.
    ///
    /// # Errors
    /// If that cannot be, or another run has the file; the error names the place.
    pub(crate) fn open(&self, file: &Path) -> Result<File, Error> {
        let opened = match self.is_device {
            true => File::options().write(true).open(file),
            false => lock::open(file, true),
        };
        opened.map_err(|source| Error::Create { path: self.path.clone(), source })
    }
}

/// Where symbolic links lead, from one to the next, if there is nothing at their end; what is no link
/// stays where it is.
fn end_of_links(path: &Path) -> io::Result<PathBuf> {
    let mut path = path.to_path_buf();
    for _ in 0..MOST_LINKS {
        match fs::read_link(&path) {
            // A relative one is meant from where the link is.
            Ok(to) => path = path.parent().unwrap_or(Path::new("")).join(to),
            Err(_) => return Ok(path),
        }
    }
    Err(io::Error::other("too many levels of symbolic links"))
}

/// So many links are followed from one to the next, as by Linux.
const MOST_LINKS: u32 = 40;

/// Checks that no folder is where these files shall be, before there is any work.
///
/// # Errors
/// If one is.
pub(crate) fn require_no_folders(out: &Path, names: &[&str]) -> Result<(), Error> {
    names.iter().try_for_each(|name| Place::of(&out.join(name)).map(|_| ()))
}

/// A file that is written as `NAME.partial` beside its place and then renamed; until then the partial
/// file is locked, so that no other run writes to it.
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
    /// If the partial file cannot be created, another run is writing it, or `path` is a folder.
    pub fn create(path: &Path) -> Result<Self, Error> {
        let place = Place::of(path)?;
        let partial = (!place.is_device).then(|| place.beside("partial"));
        let file = place.open(partial.as_deref().unwrap_or(&place.path))?;
        if partial.is_some() {
            // What a run left that was killed.
            file.set_len(0).map_err(|source| Error::Create { path: path.into(), source })?;
        }
        Ok(Self { path: place.path, partial, writer: BufWriter::new(file) })
    }

    /// Writes a whole file at the end of a run.
    ///
    /// # Errors
    /// [`Error::Write`] if it cannot be created or written: at the end it is too late to refuse.
    pub fn whole(path: &Path, contents: &[u8]) -> Result<(), Error> {
        let mut output = Self::create(path).map_err(Error::too_late)?;
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
    pub fn conclude<T>(self, outcome: Result<T, Error>) -> Result<T, Error> {
        match outcome {
            Ok(value) => self.complete().map(|()| value),
            Err(failure) if failure.exit_code() == 1 => {
                let partial = self.partial.clone();
                // What cannot be written any more is lost; the failure says what came first.
                let _ = self.keep();
                Err(match partial {
                    Some(partial) => Error::Kept { partial, source: Box::new(failure) },
                    None => failure,
                })
            }
            Err(refusal) => Err(refusal),
        }
    }

    /// Leaves the file as `NAME.partial`.
    ///
    /// # Errors
    /// If the last bytes cannot be written.
    pub fn keep(mut self) -> Result<(), Error> {
        self.partial = None;
        self.write(Write::flush)
    }

    /// That it cannot be written.
    pub(crate) fn failed(&self, source: io::Error) -> Error {
        Error::Write { path: self.path.clone(), source }
    }
}

/// For what writes by itself; errors do not name the file.
impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.writer.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.writer.flush()
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
