//! Where an output is to be.

use super::lock;
use crate::Error;
use std::fs::{self, File};
use std::io;
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
