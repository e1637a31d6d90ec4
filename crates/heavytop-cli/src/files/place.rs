//! The place of an output: its path, and whether it is a device or standard output.

use super::lock;
use crate::errors::Error;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

/// The name of an output that stands for standard output.
const STANDARD_OUTPUT: &str = "-";

/// The place of an output.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The path of the file; for a symbolic link, the path to which it leads, so that the link stays.
    pub path: PathBuf,
    /// Whether it is standard output, or exists and is no regular file, such as `/dev/stdout`.
    pub is_device: bool,
}

impl Place {
    /// Returns the place of the output `path`; `-` is standard output.
    ///
    /// # Errors
    /// If `path` is a folder, or symbolic links that never end.
    pub fn of(path: &Path) -> Result<Self, Error> {
        let refused = |source| Error::Create { path: path.into(), source };
        if path == Path::new(STANDARD_OUTPUT) {
            return Ok(Self { path: path.into(), is_device: true });
        }
        match fs::metadata(path) {
            Ok(existing) if existing.is_dir() => Err(refused(io::ErrorKind::IsADirectory.into())),
            Ok(existing) => {
                let path = fs::canonicalize(path).unwrap_or_else(|_| path.into());
                Ok(Self { path, is_device: !existing.is_file() })
            }
            Err(_) => Ok(Self { path: end_of_links(path).map_err(refused)?, is_device: false }),
        }
    }

    /// Returns whether the output is standard output.
    #[must_use]
    pub fn is_standard_output(&self) -> bool {
        self.is_device && self.path == Path::new(STANDARD_OUTPUT)
    }

    /// Returns the path of the file `NAME.ENDING` beside the output.
    #[must_use]
    pub fn beside(&self, ending: &str) -> PathBuf {
        let mut name = self.path.clone().into_os_string();
        name.push(".");
        name.push(ending);
        name.into()
    }

    /// Opens a file of this output, and takes its lock.
    ///
    /// The file is created if it does not exist. A device is opened without a lock, since anybody may write to it.
    ///
    /// # Errors
    /// If the file cannot be opened, or another run has its lock; the error names the place.
    pub(crate) fn open(&self, file: &Path) -> Result<File, Error> {
        let opened = match self.is_device {
            true if self.is_standard_output() => standard_output(),
            true => File::options().write(true).open(file),
            false => lock::open(file, true),
        };
        opened.map_err(|source| Error::Create { path: self.path.clone(), source })
    }
}

/// Returns the name of an output in summaries.
pub(crate) fn shown(out: &Path) -> String {
    match out == Path::new(STANDARD_OUTPUT) {
        true => "standard output".into(),
        false => out.display().to_string(),
    }
}

/// Follows symbolic links, from one to the next, to a path that is no link; there need not be a file at that path.
fn end_of_links(path: &Path) -> io::Result<PathBuf> {
    let mut path = path.to_path_buf();
    for _ in 0..MOST_LINKS {
        match fs::read_link(&path) {
            // A relative link is relative to the folder of the link.
            Ok(to) => path = path.parent().unwrap_or(Path::new("")).join(to),
            Err(_) => return Ok(path),
        }
    }
    Err(io::Error::other("too many levels of symbolic links"))
}

/// The largest number of links that are followed, as on Linux.
const MOST_LINKS: u32 = 40;

/// Returns standard output, as a file of its own with the place in it that the process has.
#[cfg(unix)]
fn standard_output() -> io::Result<File> {
    use std::os::fd::AsFd;
    io::stdout().as_fd().try_clone_to_owned().map(File::from)
}

/// Returns standard output, as a file of its own with the place in it that the process has.
#[cfg(windows)]
fn standard_output() -> io::Result<File> {
    use std::os::windows::io::AsHandle;
    io::stdout().as_handle().try_clone_to_owned().map(File::from)
}

/// Checks that the folder of an output is not `-`.
///
/// # Errors
/// [`Error::FolderIsStream`] if it is.
pub(crate) fn require_folder(out: &Path) -> Result<(), Error> {
    match out == Path::new(STANDARD_OUTPUT) {
        true => Err(Error::FolderIsStream),
        false => Ok(()),
    }
}

/// Checks that the name of a table ends in `.csv`, or that it is `-`, which is standard output, or a device.
///
/// # Errors
/// If it has another ending.
pub(crate) fn require_csv(out: &Path) -> Result<(), Error> {
    let is_csv = out.extension().is_some_and(|e| e.eq_ignore_ascii_case("csv"));
    let is_device = Place::of(out).is_ok_and(|place| place.is_device);
    if is_csv || is_device { Ok(()) } else { Err(Error::NoTable { path: out.into() }) }
}
