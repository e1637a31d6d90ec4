//! The place of an output: its path, and whether it is a device.

use super::lock;
use crate::Error;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

/// The place of an output.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The path of the file; for a symbolic link, the path to which it leads, so that the link stays.
    pub path: PathBuf,
    /// Whether it exists and is no regular file, such as `/dev/stdout`.
    pub is_device: bool,
}

impl Place {
    /// Returns the place of the output `path`.
    ///
    /// # Errors
    /// If `path` is a folder, or symbolic links that never end.
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
            true => File::options().write(true).open(file),
            false => lock::open(file, true),
        };
        opened.map_err(|source| Error::Create { path: self.path.clone(), source })
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

/// Checks, before there is any work, that no folder has the name of one of these files.
///
/// # Errors
/// If a folder has such a name.
pub(crate) fn require_no_folders(out: &Path, names: &[&str]) -> Result<(), Error> {
    names.iter().try_for_each(|name| Place::of(&out.join(name)).map(|_| ()))
}
