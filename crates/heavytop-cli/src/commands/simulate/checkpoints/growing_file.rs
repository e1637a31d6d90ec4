//! A file to which a run appends its rows.

use crate::errors::Error;
use crate::files::lock;
use crate::files::torn_line::cut_torn_line;
use crate::formats::Extent;
use crc32fast::Hasher;
use serde::{Deserialize, Serialize};
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// The number of bytes that are read at once.
const BUFFER: usize = 1 << 20;

/// The least number of bytes that are written at once, but for the last ones.
const BLOCK: usize = 1 << 16;

/// The length and the checksum of a file up to some byte.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(in crate::commands::simulate) struct Mark {
    bytes: u64,
    checksum: u32,
}

/// A file that is written at its end, and whose length and checksum are known.
///
/// It is written in blocks of whole rows. A block that cannot be written is lost, but for its beginning. As a
/// [`BufWriter`](io::BufWriter) does, it writes the last block when it is dropped.
pub(in crate::commands::simulate) struct Growing {
    path: PathBuf,
    file: File,
    /// What will be written next.
    block: Vec<u8>,
    /// The number of bytes that have been written, and their checksum.
    bytes: u64,
    checksum: Hasher,
}

impl Growing {
    /// Writes to a device, from the place in it where its file is.
    pub fn on_device(path: PathBuf, file: File) -> Self {
        Self { path, file, block: Vec::new(), bytes: 0, checksum: Hasher::new() }
    }

    /// Empties the file, and writes it from the start.
    pub fn new(path: PathBuf, file: File) -> io::Result<Self> {
        file.set_len(0)?;
        Ok(Self::on_device(path, file))
    }

    /// Reopens the file as it was at the mark, and cuts off what has been written since.
    ///
    /// Returns `None`, and cuts nothing, if the bytes before the mark are not those that were marked, or the file
    /// does not have the right extent there.
    ///
    /// # Errors
    /// If the file cannot be read, or another run is writing it.
    pub fn reopen(
        path: PathBuf,
        mark: &Mark,
        is_right: impl FnOnce(&Extent) -> bool,
    ) -> io::Result<Option<Self>> {
        let mut file = lock::open(&path, false)?;
        let (checksum, extent) = checksum(&mut file, mark.bytes)?;
        let is_marked = extent.bytes == mark.bytes && checksum.clone().finalize() == mark.checksum;
        if !is_marked || !is_right(&extent) {
            return Ok(None);
        }
        file.set_len(mark.bytes)?;
        file.seek(SeekFrom::End(0))?;
        Ok(Some(Self { path, file, block: Vec::new(), bytes: mark.bytes, checksum }))
    }

    /// Returns the file, which holds what was flushed.
    pub fn file(&self) -> &File {
        &self.file
    }

    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Appends a row, which `encode` adds to the bytes that are given to it.
    pub fn append(&mut self, encode: impl FnOnce(&mut Vec<u8>)) -> Result<(), Error> {
        encode(&mut self.block);
        if self.block.len() >= BLOCK { self.flush() } else { Ok(()) }
    }

    /// Passes all bytes to the operating system.
    pub fn flush(&mut self) -> Result<(), Error> {
        let written = self.file.write_all(&self.block);
        if written.is_ok() {
            self.checksum.update(&self.block);
            self.bytes += self.block.len() as u64;
        }
        self.block.clear();
        written.map_err(|source| self.failed(source))
    }

    /// Returns the mark of what has been written, after making it outlast a power cut.
    pub fn mark(&mut self) -> Result<Mark, Error> {
        self.flush()?;
        self.file.sync_all().map_err(|source| self.failed(source))?;
        Ok(Mark { bytes: self.bytes, checksum: self.checksum.clone().finalize() })
    }

    /// Ends a file of text: a line for which there is no room is cut off.
    pub fn keep_lines(mut self) {
        // What cannot be written any more is lost; the error reports the first failure.
        let _ = self.flush();
        let _ = cut_torn_line(&mut self.file);
    }

    fn failed(&self, source: io::Error) -> Error {
        Error::Write { path: self.path.clone(), source }
    }
}

impl Drop for Growing {
    fn drop(&mut self) {
        // The error that matters has been reported already.
        let _ = self.flush();
    }
}

/// Computes the checksum of the first bytes, at most so many, and how far they go.
fn checksum(file: &mut File, bytes: u64) -> io::Result<(Hasher, Extent)> {
    let (mut checksum, mut buffer, mut extent) =
        (Hasher::new(), vec![0; BUFFER], Extent::default());
    let mut from = file.take(bytes);
    loop {
        let read = match from.read(&mut buffer)? {
            0 => return Ok((checksum, extent)),
            n => &buffer[..n],
        };
        checksum.update(read);
        extent.add(read);
    }
}
