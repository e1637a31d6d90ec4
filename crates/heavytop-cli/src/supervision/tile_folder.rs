//! The folder of tiles: finished parts of a run that outlast it.

use super::tiled_run::{RESUME, TileOptions};
use crate::configuration::{Config, inner, read_saved};
use crate::errors::{CheckpointError, Error};
use crate::files::sealed::{self, damaged, of_this_version, open, seal};
use crate::files::{Kind, Output, lock};
use serde::{Deserialize, Serialize};
use std::ffi::OsStr;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

/// The name of the file that identifies the run of the tiles.
const IDENTITY: &str = "identity";

/// The number of digits in the name of a tile, or more.
const DIGITS: usize = 7;

/// The first word of the identity.
const TITLE: &str = "heavytop-tiles ";

/// How the files of the folder are recognised.
const IDENTITY_KIND: Kind<'_> = Kind::of_first_bytes("identity of a run", TITLE.as_bytes());
const TILE_KIND: Kind<'_> = Kind::of_first_bytes("part of a run", b"heavytop-tile");

/// The file that is locked while a run uses the folder.
const LOCK: &str = "lock";

/// The folder of finished tiles, one file for each; it exists while the run is not finished.
///
/// A tile is a part of a run that does not depend on the others. Its file is complete or absent, and says which tile
/// of which configuration it is.
#[derive(Debug)]
pub(crate) struct Tiles {
    folder: PathBuf,
    config: Config,
    identity: String,
    /// The beginning of the first line of each tile.
    title: String,
}

/// The folder of tiles while this run alone uses it.
#[derive(Debug)]
#[must_use]
pub(crate) struct Held {
    path: PathBuf,
    _file: File,
}

/// Removes the file of the lock. Nobody else has it while the file is open.
impl Drop for Held {
    fn drop(&mut self) {
        // It does no harm if the file stays.
        let _ = fs::remove_file(&self.path);
    }
}

/// The settings that determine the numbers.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Identity {
    version: String,
    /// The instruction set on which the bits of the steps depend.
    instructions: String,
    #[serde(deserialize_with = "inner")]
    configuration: Config,
}

impl Tiles {
    /// Creates the tiles of a configuration in which no key that plays a part is left out.
    ///
    /// # Errors
    /// The errors of [`Config::to_toml`].
    pub fn new(folder: PathBuf, config: &Config) -> Result<Self, Error> {
        let version = env!("CARGO_PKG_VERSION").into();
        let instructions = config.instructions().to_string();
        let identity = Identity { version, instructions, configuration: config.clone() };
        let identity = seal(TITLE, &toml::to_string(&identity).map_err(Error::Unwritable)?);
        let title = format!("heavytop-tile {:08x}", crc32fast::hash(identity.as_bytes()));
        Ok(Self { folder, config: config.clone(), identity, title })
    }

    /// Prepares the folder: creates it, or checks that its tiles belong to this run, or discards them.
    ///
    /// # Errors
    /// If another run uses the folder, there are tiles that shall not be used, or that belong to another run, or a file
    /// would be replaced that is an input or not of this program: then nothing is changed.
    pub fn prepare(&self, options: &TileOptions<'_>) -> Result<Held, Error> {
        self.require_replaceable(options)?;
        let folder = || self.folder.clone();
        let refused = |source| Error::Create { path: folder(), source };
        let path = self.folder.join(LOCK);
        let take = || {
            fs::create_dir_all(&self.folder)?;
            lock::open(&path, true)
        };
        let opened = match take() {
            // A run that was done with the folder has removed it at this moment.
            Err(error) if error.kind() == io::ErrorKind::NotFound => take(),
            opened => opened,
        };
        let file = opened.map_err(|source| {
            // A folder that was created here is still empty.
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
                    // Nothing was begun. A folder that is not empty rightly stays.
                    let _ = fs::remove_dir(&self.folder);
                    return Err(error);
                }
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

    /// Checks that the files in the folder may be replaced and removed that have the names of this one's.
    fn require_replaceable(&self, options: &TileOptions<'_>) -> Result<(), Error> {
        let (safeguard, identity) = (options.safeguard, self.identity_file());
        match options.resume {
            // It is only read, and the message says what is wrong with it.
            true => safeguard.require_other(&identity)?,
            false => safeguard.require_unfinished(&identity, &IDENTITY_KIND)?,
        }
        safeguard.require_empty(&self.folder.join(LOCK), "lock of a run")?;
        // Beside an identity the files are tiles, though they may be damaged.
        let is_own = IDENTITY_KIND.is_of(&identity).unwrap_or(false);
        let entries = match fs::read_dir(&self.folder) {
            Ok(entries) => entries,
            // The folder will be created, or cannot be.
            Err(_) => return Ok(()),
        };
        for entry in entries.flatten().filter(|entry| is_tile_or_partial(&entry.file_name())) {
            match is_own {
                true => safeguard.require_other(&entry.path())?,
                false => safeguard.require_unfinished(&entry.path(), &TILE_KIND)?,
            }
        }
        Ok(())
    }

    fn identity_file(&self) -> PathBuf {
        self.folder.join(IDENTITY)
    }

    /// Checks that the identity is that of this run.
    fn require(&self, found: &str) -> Result<(), CheckpointError> {
        if found == self.identity {
            return Ok(());
        }
        let table = of_this_version(open(TITLE, found)?)?;
        let Identity { instructions, configuration, .. } = read_saved(table).map_err(damaged)?;
        let differences = configuration.differences(&self.config);
        let differences = differences.map_err(|e| CheckpointError::Damaged(e.to_string()))?;
        if differences.is_empty() {
            self.config.require_instructions(&instructions)?;
        }
        Err(CheckpointError::Configuration(differences))
    }

    fn file(&self, tile: u64) -> PathBuf {
        self.folder.join(format!("{tile:0DIGITS$}"))
    }

    /// Returns the first line of a tile, before the checksum: the number of the tile, and the run.
    fn title(&self, tile: u64) -> String {
        format!("{} {tile:07} ", self.title)
    }

    /// Writes the file of a tile.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self, tile: u64, contents: &str) -> Result<(), Error> {
        Output::whole(&self.file(tile), seal(&self.title(tile), contents).as_bytes())
    }

    /// Reads a tile; `None` if it is unfinished or incomplete, or belongs to another run.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn read(&self, tile: u64) -> Result<Option<String>, Error> {
        let path = self.file(tile);
        match fs::read_to_string(&path) {
            // A damaged tile has to be computed again.
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

    /// Returns the error that a tile is missing.
    pub fn missing(&self, tile: u64) -> Error {
        Error::MissingTile { tile, folder: self.folder.clone() }
    }

    /// Removes the folder when the run is finished.
    ///
    /// # Errors
    /// If the folder cannot be removed.
    pub fn remove(&self, held: Held) -> Result<(), Error> {
        self.empty()?;
        drop(held);
        match fs::remove_dir(&self.folder) {
            // Another run has begun in the folder, or is done with it, too.
            Err(error)
                if [io::ErrorKind::DirectoryNotEmpty, io::ErrorKind::NotFound]
                    .contains(&error.kind()) =>
            {
                Ok(())
            }
            removed => removed.map_err(|source| unwritten(&self.folder, source)),
        }
    }

    /// Removes the files of the run but the lock. Files with other names stay.
    fn empty(&self) -> Result<(), Error> {
        let remove = |path: &Path| match fs::remove_file(path) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => Err(unwritten(path, error)),
            _ => Ok(()),
        };
        // The identity goes first: tiles without an identity block nobody, should the run end in between.
        remove(&self.identity_file())?;
        let entries = fs::read_dir(&self.folder).map_err(|e| unwritten(&self.folder, e))?;
        for entry in entries {
            let entry = entry.map_err(|e| unwritten(&self.folder, e))?;
            if is_tile_or_partial(&entry.file_name()) {
                remove(&entry.path())?;
            }
        }
        Ok(())
    }
}

/// Returns whether a file has the name of a tile, or of a file that is being written: see [`Tiles::file`].
fn is_tile_or_partial(name: &OsStr) -> bool {
    let name = name.to_string_lossy();
    let (stem, is_partial) = match name.strip_suffix(".partial") {
        Some(stem) => (stem, true),
        None => (&*name, false),
    };
    let is_number = stem.len() >= DIGITS && stem.bytes().all(|byte| byte.is_ascii_digit());
    is_number || (is_partial && stem == IDENTITY)
}

fn unwritten(path: &Path, source: io::Error) -> Error {
    Error::Write { path: path.into(), source }
}
