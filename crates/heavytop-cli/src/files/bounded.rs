//! Bounded reading of files that may have no end, such as `/dev/zero`.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Read};
use std::path::Path;

/// Reads the text of a file that has at most `most` bytes.
///
/// # Errors
/// [`io::ErrorKind::FileTooLarge`] if the file is larger. Another error if it cannot be read, or is not text.
pub(crate) fn read(path: &Path, most: u64) -> io::Result<String> {
    read_from(File::open(path)?, most)
}

/// Reads a text that has at most `most` bytes.
///
/// # Errors
/// The errors of [`read`].
pub(crate) fn read_from(from: impl Read, most: u64) -> io::Result<String> {
    let mut bytes = Vec::new();
    from.take(most + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most {
        let message = format!("it has more than {most} bytes");
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, message));
    }
    String::from_utf8(bytes).map_err(|error| io::Error::new(io::ErrorKind::InvalidData, error))
}

/// The length at which a line is cut; a longer line holds no row of numbers.
const LONGEST_LINE: u64 = 1 << 16;

/// Returns the lines of a file, with their line ends, read as they are asked for.
///
/// # Errors
/// If the file cannot be opened. The iterator ends with an error if it cannot be read, or is not text.
pub(crate) fn lines(path: &Path) -> io::Result<impl Iterator<Item = io::Result<String>>> {
    let mut from = BufReader::new(File::open(path)?);
    Ok(std::iter::from_fn(move || {
        let mut line = String::new();
        match from.by_ref().take(LONGEST_LINE).read_line(&mut line) {
            Ok(0) => None,
            Ok(_) => Some(Ok(line)),
            Err(error) => Some(Err(error)),
        }
    }))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn a_file_may_have_the_bound_and_no_more() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        std::fs::write(&path, "äö").unwrap();
        assert_eq!(read(&path, 4).unwrap(), "äö");
        assert_eq!(read(&path, 3).unwrap_err().kind(), io::ErrorKind::FileTooLarge);
        std::fs::write(&path, [0xff]).unwrap();
        assert_eq!(read(&path, 4).unwrap_err().kind(), io::ErrorKind::InvalidData);
    }
}
