//! Kinds of files, by which a command recognises what the program has written before.

use std::fs::File;
use std::io::{self, Read, Seek};
use std::path::Path;

/// The number of bytes from which a file is recognised, but for the formats whose metadata are elsewhere.
const HEAD: u64 = 1 << 16;

/// A kind of file that the program writes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Kind<'a> {
    /// The name in messages, such as "table of simulate".
    pub name: &'static str,
    /// The first bytes of every file of the kind. An unfinished file may have fewer.
    pub first: &'a [u8],
    /// Tells whether a complete file with these first bytes is of the kind. `head` is its beginning.
    pub is_whole: fn(head: &[u8], file: &mut File) -> io::Result<bool>,
}

impl<'a> Kind<'a> {
    /// Creates the kind of all files that begin with these bytes.
    pub const fn of_first_bytes(name: &'static str, first: &'a [u8]) -> Self {
        Self { name, first, is_whole: |_, _| Ok(true) }
    }

    /// Returns whether the file is complete and of this kind.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn is_of(&self, path: &Path) -> io::Result<bool> {
        let mut file = File::open(path)?;
        let head = head(&mut file)?;
        if !head.starts_with(self.first) {
            return Ok(false);
        }
        file.rewind()?;
        (self.is_whole)(&head, &mut file)
    }

    /// Returns whether the file can be an unfinished one of this kind.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn may_become(&self, path: &Path) -> io::Result<bool> {
        let head = head(&mut File::open(path)?)?;
        Ok(head.iter().zip(self.first).all(|(found, expected)| found == expected))
    }
}

fn head(file: &mut File) -> io::Result<Vec<u8>> {
    let mut head = Vec::new();
    file.take(HEAD).read_to_end(&mut head)?;
    Ok(head)
}

/// Returns whether a text occurs among the bytes.
pub(crate) fn contains(bytes: &[u8], text: &str) -> bool {
    bytes.windows(text.len()).any(|window| window == text.as_bytes())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn a_whole_file_has_all_first_bytes_and_an_unfinished_one_some_of_them() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        let is_of = |head: &[u8], _: &mut File| Ok(contains(head, "end"));
        let kind = Kind { name: "text", first: b"begin", is_whole: is_of };
        for (text, whole, unfinished) in [
            ("begin, end", true, true),
            ("begin", false, true),
            ("beg", false, true),
            ("begun, end", false, false),
            ("my notes, end", false, false),
        ] {
            std::fs::write(&path, text).unwrap();
            let found = (kind.is_of(&path).unwrap(), kind.may_become(&path).unwrap());
            assert_eq!(found, (whole, unfinished), "{text}");
        }
    }
}
