//! The extent of a file: its bytes and its lines.

/// The number of bytes and lines of a file up to some place.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Extent {
    pub bytes: u64,
    /// The number of line ends.
    pub lines: u64,
    /// Whether the last byte is a line end.
    pub ends_line: bool,
}

impl Extent {
    /// Extends the extent by these bytes.
    pub fn add(&mut self, bytes: &[u8]) {
        self.bytes += bytes.len() as u64;
        self.lines += bytes.iter().filter(|byte| **byte == b'\n').count() as u64;
        self.ends_line = bytes.ends_with(b"\n");
    }
}
