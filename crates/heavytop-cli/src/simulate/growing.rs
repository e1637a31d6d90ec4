//! A file that grows with a run.

use crate::Error;
use crc32fast::Hasher;
use serde::{Deserialize, Serialize};
use std::fs::File;
use std::io::{self, BufWriter, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// So many bytes are checked at once.
const BUFFER: usize = 1 << 20;

/// The file up to some byte.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Mark {
    bytes: u64,
    checksum: u32,
}

/// A file that is written to at its end, and whose length and checksum are known.
pub(super) struct Growing {
    path: PathBuf,
    writer: BufWriter<File>,
    bytes: u64,
    checksum: Hasher,
}

impl Growing {
    /// The empty file, to be written from the start.
    pub fn new(path: PathBuf, file: File) -> Self {
        Self { path, writer: BufWriter::new(file), bytes: 0, checksum: Hasher::new() }
    }

    /// The file as it was at the mark: what has been written since is cut off. Nothing, and
    /// nothing is cut, if its bytes before the mark are not those that were marked.
    pub fn reopen(path: PathBuf, mark: &Mark) -> io::Result<Option<Self>> {
        let mut file = File::options().read(true).write(true).open(&path)?;
        let (checksum, read) = checksum(&mut file, mark.bytes)?;
        if read < mark.bytes || checksum.clone().finalize() != mark.checksum {
            return Ok(None);
        }
        file.set_len(mark.bytes)?;
        file.seek(SeekFrom::End(0))?;
        Ok(Some(Self { path, writer: BufWriter::new(file), bytes: mark.bytes, checksum }))
    }

    pub fn path(&self) -> &Path {
        &self.path
    }

    pub fn append(&mut self, bytes: &[u8]) -> Result<(), Error> {
        self.writer.write_all(bytes).map_err(|source| self.failed(source))?;
        self.checksum.update(bytes);
        self.bytes += bytes.len() as u64;
        Ok(())
    }

    /// Hands everything to the system.
    pub fn flush(&mut self) -> Result<(), Error> {
        self.writer.flush().map_err(|source| self.failed(source))
    }

    /// What has been written, which outlasts a power cut from now on.
    pub fn mark(&mut self) -> Result<Mark, Error> {
        self.flush()?;
        self.writer.get_ref().sync_all().map_err(|source| self.failed(source))?;
        Ok(Mark { bytes: self.bytes, checksum: self.checksum.clone().finalize() })
    }

    fn failed(&self, source: io::Error) -> Error {
        Error::Write { path: self.path.clone(), source }
    }
}

/// The checksum of the first bytes, at most so many, and how many there were.
fn checksum(file: &mut File, bytes: u64) -> io::Result<(Hasher, u64)> {
    let (mut checksum, mut read, mut buffer) = (Hasher::new(), 0, vec![0; BUFFER]);
    let mut from = file.take(bytes);
    loop {
        match from.read(&mut buffer)? {
            0 => return Ok((checksum, read)),
            n => {
                checksum.update(&buffer[..n]);
                read += n as u64;
            }
        }
    }
}
