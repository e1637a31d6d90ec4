//! A file in which there are arrays, by which a run starts or which is exported.

use super::archive::{self, Archive};
use super::{image_reader, ovf};
use crate::errors::{Error, FieldFileError};
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// Returns the checksum of a file.
///
/// # Errors
/// If it cannot be read.
pub(crate) fn checksum(path: &Path) -> Result<u32, Error> {
    let sum = || -> io::Result<u32> {
        let (mut file, mut block) = (File::open(path)?, vec![0; 1 << 20]);
        let mut hasher = crc32fast::Hasher::new();
        loop {
            match file.read(&mut block)? {
                0 => return Ok(hasher.finalize()),
                n => hasher.update(&block[..n]),
            }
        }
    };
    sum().map_err(|error| failed(path, error.into()))
}

/// Returns the numbers of an array in a file, or of its last sample, if its first index numbers samples.
///
/// # Errors
/// If the file cannot be read, or has no such array.
pub(crate) fn last(path: &Path, name: &str, shape: &[usize]) -> Result<Vec<f64>, Error> {
    let read = match ending(path).as_deref() {
        Some("npz") => Archive::open(path).and_then(|mut file| file.last(name, shape)),
        Some("npy") => archive::last_of_array(path, name, shape),
        Some("ovf" | "omf") => ovf::read(path, name, shape),
        Some("vti") => image_reader::read(path, name, shape),
        _ => {
            let text = "a start is read from .npz, .npy, .ovf, .omf or .vti";
            Err(FieldFileError::Format(text.into()))
        }
    };
    read.map_err(|error| failed(path, error))
}

/// Returns the ending of a name in small letters.
pub(crate) fn ending(path: &Path) -> Option<String> {
    path.extension()?.to_str().map(str::to_ascii_lowercase)
}

/// Returns the error of a file.
pub(crate) fn failed(path: &Path, source: FieldFileError) -> Error {
    Error::FieldFile { path: path.into(), source: Box::new(source) }
}
