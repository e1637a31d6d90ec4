//! Finished parts of a run that outlast it.

use super::tiled_run::{RESUME, TileOptions};
use crate::Error;
use crate::configuration::Config;
use crate::errors::CheckpointError;
use crate::files::sealed::{self, damaged, of_this_version, open, seal};
use crate::files::{Output, lock};
use serde::{Deserialize, Serialize};
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

/// The file that says of which run the tiles are,
const IDENTITY: &str = "identity";

/// and its first word.
const TITLE: &str = "heavytop-tiles ";

/// The file that is locked while a run has the folder.
const LOCK: &str = "lock";

/// The folder of finished tiles, one file for each; it is there while the run is not finished.
///
/// A tile is a part of a run that does not depend on the others. Its file is there whole or not at
/// all, and says which tile of which configuration it is.
#[derive(Debug)]
pub(crate) struct Tiles {
    folder: PathBuf,
    config: Config,
    identity: String,
    /// The first line of each tile begins with it.
    title: String,
}

/// The folder of tiles while it is this run's alone.
#[derive(Debug)]
#[must_use]
pub(crate) struct Held {
    path: PathBuf,
    _file: File,
}

/// Nobody else has the lock as long as the file is open: it is this run's to be removed.
impl Drop for Held {
    fn drop(&mut self) {
        // That it stays does no harm.
        let _ = fs::remove_file(&self.path);
    }
}

/// What decides about the numbers.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Identity {
    version: String,
    configuration: Config,
}

impl Tiles {
    /// The tiles of the configuration, in which nothing that plays a part is left out.
    ///
    /// # Errors
    /// As [`Config::to_toml`].
    pub fn new(folder: PathBuf, config: &Config) -> Result<Self, Error> {
        let version = env!("CARGO_PKG_VERSION").into();
        let identity = Identity { version, configuration: config.clone() };
        let identity = seal(TITLE, &toml::to_string(&identity).map_err(Error::Unwritable)?);
        let title = format!("heavytop-tile {:08x}", crc32fast::hash(identity.as_bytes()));
        Ok(Self { folder, config: config.clone(), identity, title })
    }

    /// Makes the folder, or sees that its tiles are of this run; or discards them.
    ///
    /// # Errors
    /// If another run has the folder, or there are tiles which shall not be used, or which are of
    /// another run; then nothing is changed.
    pub fn prepare(&self, options: &TileOptions<'_>) -> Result<Held, Error> {
        let folder = || self.folder.clone();
        let refused = |source| Error::Create { path: folder(), source };
        fs::create_dir_all(&self.folder).map_err(refused)?;
        let path = self.folder.join(LOCK);
        let file = lock::open(&path, true).map_err(|source| {
            // One that was made for this is empty.
            let _ = fs::remove_dir(&self.folder);
            refused(source)
        })?;
        let held = Held { path, _file: file };
        let identity = self.identity_file();
        if options.restart {
            self.empty()?;
        }
        match sealed::read(&identity) {
            Err(CheckpointError::Read(error)) if error.kind() == io::ErrorKind::NotFound => {
                if let Err(error) = Output::whole(&identity, self.identity.as_bytes()) {
                    drop(held);
                    // Nothing was begun. That it stays if there is something in it is right.
                    let _ = fs::remove_dir(&self.folder);
                    return Err(error);
                }
            }
            Err(CheckpointError::Read(source)) => {
                return Err(Error::Tile { path: identity, source });
            }
            _ if !options.resume => {
                return Err(Error::Unfinished { path: folder(), resume: RESUME.into() });
            }
            found => found
                .and_then(|found| self.require(&found))
                .map_err(|source| Error::Checkpoint { path: folder(), source })?,
        }
        Ok(held)
    }

    fn identity_file(&self) -> PathBuf {
        self.folder.join(IDENTITY)
    }

    /// Checks that the identity is this one.
    fn require(&self, found: &str) -> Result<(), CheckpointError> {
        if found == self.identity {
            return Ok(());
        }
        let table = of_this_version(open(TITLE, found)?)?;
        let Identity { configuration, .. } = table.try_into().map_err(damaged)?;
        let differences = configuration.differences(&self.config);
        let differences = differences.map_err(|e| CheckpointError::Damaged(e.to_string()))?;
        Err(CheckpointError::Configuration(differences))
    }

    fn file(&self, tile: u64) -> PathBuf {
        self.folder.join(format!("{tile:07}"))
    }

    /// The first line of a tile, before the checksum: which it is, of which run.
    fn title(&self, tile: u64) -> String {
        format!("{} {tile:07} ", self.title)
    }

    /// Keeps a tile.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn write(&self, tile: u64, contents: &str) -> Result<(), Error> {
        Output::whole(&self.file(tile), seal(&self.title(tile), contents).as_bytes())
    }

    /// What is in a tile; nothing if it is not finished, or not whole, or another one, or of another
    /// run.
    ///
    /// # Errors
    /// If it cannot be read.
    pub fn read(&self, tile: u64) -> Result<Option<String>, Error> {
        let path = self.file(tile);
        match fs::read_to_string(&path) {
            // What is damaged has to be made again.
            Ok(text) => Ok(open(&self.title(tile), &text).ok().map(String::from)),
            Err(error)
                if [io::ErrorKind::NotFound, io::ErrorKind::InvalidData]
                    .contains(&error.kind()) =>
            {
                Ok(None)
            }
            Err(source) => Err(Error::Tile { path, source }),
        }
    }

    /// That a tile is not there which must be.
    pub fn missing(&self, tile: u64) -> Error {
        Error::MissingTile { tile, folder: self.folder.clone() }
    }

    /// Removes the folder, which is this run's: the run is finished.
    ///
    /// # Errors
    /// If it cannot be removed.
    pub fn remove(&self, held: Held) -> Result<(), Error> {
        self.empty()?;
        drop(held);
        match fs::remove_dir(&self.folder) {
            // Another run has begun in it, or is done with it, too.
            Err(error)
                if [io::ErrorKind::DirectoryNotEmpty, io::ErrorKind::NotFound]
                    .contains(&error.kind()) =>
            {
                Ok(())
            }
            removed => removed.map_err(|source| unwritten(&self.folder, source)),
        }
    }

    /// Removes all files of the folder but the lock.
    fn empty(&self) -> Result<(), Error> {
        let remove = |path: &Path| match fs::remove_file(path) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => Err(unwritten(path, error)),
            _ => Ok(()),
        };
        // First, since tiles without an identity are in nobody's way, should it end in between.
        remove(&self.identity_file())?;
        let entries = fs::read_dir(&self.folder).map_err(|e| unwritten(&self.folder, e))?;
        for entry in entries {
            let entry = entry.map_err(|e| unwritten(&self.folder, e))?;
            if entry.file_name() != LOCK {
                remove(&entry.path())?;
            }
        }
        Ok(())
    }
}

fn unwritten(path: &Path, source: io::Error) -> Error {
    Error::Write { path: path.into(), source }
}
