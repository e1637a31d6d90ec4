//! Finished parts of a run that outlast it.

use crate::Error;
use crate::config::Config;
use crate::output::Output;
use crate::sealed::{CheckpointError, damaged, of_this_version, open, seal};
use serde::{Deserialize, Serialize};
use std::fs;
use std::io;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

/// The first word of the file that says of which run the tiles are.
const IDENTITY: &str = "heavytop-tiles ";

/// How a run in tiles is accompanied.
#[derive(Clone, Copy, Debug)]
pub struct Options<'a> {
    /// Whether it goes on from the finished tiles of an interrupted run.
    pub resume: bool,
    /// Once this is true the run ends; what is finished is kept.
    pub stop: Option<&'a AtomicBool>,
    /// Whether to show no progress bar.
    pub quiet: bool,
}

/// From the start, and quietly.
impl Default for Options<'_> {
    fn default() -> Self {
        Self { resume: false, stop: None, quiet: true }
    }
}

impl Options<'_> {
    /// Whether the run shall end.
    pub(crate) fn stopped(&self) -> bool {
        self.stop.is_some_and(|stop| stop.load(Ordering::Relaxed))
    }
}

/// The folder of finished tiles, one file for each; it is there while the run is not finished.
///
/// A tile is a part of a run that does not depend on the others. Its file is there whole or not at
/// all, and says that it belongs to the configuration.
#[derive(Debug)]
pub(crate) struct Tiles {
    folder: PathBuf,
    config: Config,
    identity: String,
    /// The first line of each tile.
    title: String,
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
        let identity = seal(IDENTITY, &toml::to_string(&identity).map_err(Error::Unwritable)?);
        let title = format!("heavytop-tile {:08x} ", crc32fast::hash(identity.as_bytes()));
        Ok(Self { folder, config: config.clone(), identity, title })
    }

    /// Makes the folder, or sees that its tiles are of this run.
    ///
    /// # Errors
    /// If there are tiles which shall not be used, or which are of another run.
    pub fn prepare(&self, resume: bool) -> Result<(), Error> {
        let folder = || self.folder.clone();
        let path = self.identity_file();
        match fs::read_to_string(&path) {
            Ok(_) if !resume => Err(Error::Unfinished { folder: folder() }),
            Ok(found) => {
                self.require(&found).map_err(|source| Error::Checkpoint { path: folder(), source })
            }
            // That a file is where a folder should be is found when the folder is made.
            Err(error)
                if [io::ErrorKind::NotFound, io::ErrorKind::NotADirectory]
                    .contains(&error.kind()) =>
            {
                let refused = |source| Error::Create { path: folder(), source };
                fs::create_dir_all(&self.folder).map_err(refused)?;
                Output::whole(&path, self.identity.as_bytes()).inspect_err(|_| {
                    // Nothing was begun. That it stays if there is something in it is right.
                    let _ = fs::remove_dir(&self.folder);
                })
            }
            Err(source) => Err(Error::Tile { path, source }),
        }
    }

    fn identity_file(&self) -> PathBuf {
        self.folder.join("identity")
    }

    /// Checks that the identity is this one.
    fn require(&self, found: &str) -> Result<(), CheckpointError> {
        if found == self.identity {
            return Ok(());
        }
        let table = of_this_version(open(IDENTITY, found)?)?;
        let Identity { configuration, .. } = table.try_into().map_err(damaged)?;
        let differences = configuration.differences(&self.config);
        let differences = differences.map_err(|e| CheckpointError::Damaged(e.to_string()))?;
        Err(CheckpointError::Configuration(differences))
    }

    fn file(&self, tile: u64) -> PathBuf {
        self.folder.join(format!("{tile:07}"))
    }

    /// Keeps a tile.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn write(&self, tile: u64, contents: &str) -> Result<(), Error> {
        Output::whole(&self.file(tile), seal(&self.title, contents).as_bytes())
    }

    /// What is in a tile; nothing if it is not finished, or not whole, or of another run.
    ///
    /// # Errors
    /// If it cannot be read.
    pub fn read(&self, tile: u64) -> Result<Option<String>, Error> {
        let path = self.file(tile);
        match fs::read_to_string(&path) {
            // What is damaged has to be made again.
            Ok(text) => Ok(open(&self.title, &text).ok().map(String::from)),
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

    /// Removes the folder: the run is finished.
    ///
    /// # Errors
    /// If it cannot be removed.
    pub fn remove(&self) -> Result<(), Error> {
        // Tiles without an identity are in nobody's way, should it end in between.
        let removed = fs::remove_file(self.identity_file());
        removed
            .and_then(|()| fs::remove_dir_all(&self.folder))
            .map_err(|source| Error::Write { path: self.folder.clone(), source })
    }
}

/// That a run in tiles was stopped.
pub(crate) fn interrupted() -> Error {
    Error::Interrupted { resume: Some("--resume".into()) }
}

/// Says of what failed for want of something outside the run that it can go on.
pub(crate) fn resumable(failure: Error) -> Error {
    match failure {
        Error::Write { .. } | Error::Tile { .. } => {
            Error::Resumable { resume: "--resume".into(), source: Box::new(failure) }
        }
        other => other,
    }
}
