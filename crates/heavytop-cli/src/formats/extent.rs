//! How far a file goes.

/// How far a file goes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Extent {
    pub bytes: u64,
    /// The ends of lines.
    pub lines: u64,
    /// Whether the last byte is one.
    pub ends_line: bool,
}

impl Extent {
    /// Goes further by these bytes.
    pub fn add(&mut self, bytes: &[u8]) {
        self.bytes += bytes.len() as u64;
        self.lines += bytes.iter().filter(|byte| **byte == b'\n').count() as u64;
        self.ends_line = bytes.ends_with(b"\n");
    }
}
