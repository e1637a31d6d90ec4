//! The rows of 64-bit numbers in a growing file.

use std::fs::File;
use std::io::{self, BufReader, Read, Seek};

/// The number of bytes that are read at once.
const BUFFER: usize = 1 << 20;

/// A file of rows, each with `width` little-endian numbers.
pub(super) struct Rows<'a> {
    file: &'a File,
    width: usize,
    /// The number of complete rows.
    pub count: u64,
}

impl<'a> Rows<'a> {
    pub fn new(file: &'a File, width: usize) -> io::Result<Self> {
        let bytes = file.metadata()?.len();
        Ok(Self { file, width, count: bytes / (8 * width as u64) })
    }

    /// Passes the bytes of each row to `visit`.
    pub fn each(&self, mut visit: impl FnMut(&[u8]) -> io::Result<()>) -> io::Result<()> {
        let mut from = BufReader::with_capacity(BUFFER, self.file);
        from.rewind()?;
        let mut row = vec![0; 8 * self.width];
        for _ in 0..self.count {
            from.read_exact(&mut row)?;
            visit(&row)?;
        }
        Ok(())
    }
}
