//! The rows of 64-bit numbers in a growing file.

use std::fs::File;
use std::io::{self, Read, Seek};

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
        let row = 8 * self.width;
        let mut block = vec![0; (BUFFER / row).max(1) * row];
        let (mut from, mut left) = (self.file, self.count.saturating_mul(row as u64));
        from.rewind()?;
        while left > 0 {
            let bytes = left.min(block.len() as u64) as usize;
            from.read_exact(&mut block[..bytes])?;
            block[..bytes].chunks_exact(row).try_for_each(&mut visit)?;
            left -= bytes as u64;
        }
        Ok(())
    }
}
