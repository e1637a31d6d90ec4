//! Bounded reading of files that may have no end, such as `/dev/zero`.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Read};
use std::path::Path;

/// Reads the text of a file that has at most `most` bytes.
///
/// # Errors
/// [`io::ErrorKind::FileTooLarge`] if the file is larger. Another error if it cannot be read, or is not text in UTF-8.
pub(crate) fn read(path: &Path, most: u64) -> io::Result<String> {
    read_from(File::open(path)?, most)
}

/// The mark before a text by which some programs say that it is in UTF-8.
const BYTE_ORDER_MARK: char = '\u{feff}';

/// Reads a text that has at most `most` bytes, without a byte order mark.
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
    let invalid = |error: String| io::Error::new(io::ErrorKind::InvalidData, error);
    if let Some(name) = other_encoding(&bytes) {
        return Err(invalid(format!("it is text in {name}; save it as UTF-8")));
    }
    let text = String::from_utf8(bytes).map_err(|error| invalid(error.to_string()))?;
    Ok(text.strip_prefix(BYTE_ORDER_MARK).map(String::from).unwrap_or(text))
}

/// Returns the name of an encoding other than UTF-8: by its byte order mark, or by a zero in the first character, which
/// no text has in UTF-8.
fn other_encoding(bytes: &[u8]) -> Option<&'static str> {
    match bytes {
        [0xff, 0xfe, 0, 0, ..] | [0, 0, 0xfe, 0xff, ..] => Some("UTF-32"),
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => Some("UTF-16"),
        [0, first, ..] | [first, 0, ..] if *first != 0 => Some("UTF-16"),
        _ => None,
    }
}

/// The length at which a line is cut; a longer line holds no row of numbers.
const LONGEST_LINE: u64 = 1 << 16;

/// Returns the lines of a file, with their line ends, read as they are asked for.
///
/// # Errors
/// If the file cannot be opened. The iterator ends with an error if it cannot be read, or is not text.
pub(crate) fn lines(path: &Path) -> io::Result<impl Iterator<Item = io::Result<String>>> {
    let mut from = BufReader::new(File::open(path)?);
    let mut is_first = true;
    Ok(std::iter::from_fn(move || {
        let mut line = String::new();
        match from.by_ref().take(LONGEST_LINE).read_line(&mut line) {
            Ok(0) => None,
            Ok(_) if std::mem::take(&mut is_first) => {
                Some(Ok(line.trim_start_matches(BYTE_ORDER_MARK).to_owned()))
            }
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
        std::fs::write(&path, "\u{feff}a").unwrap();
        assert_eq!(read(&path, 4).unwrap(), "a");
        assert_eq!(lines(&path).unwrap().next().unwrap().unwrap(), "a");
        let utf_16: Vec<u8> = "[body]".encode_utf16().flat_map(u16::to_le_bytes).collect();
        for (bytes, said) in [
            (&[&[0xff, 0xfe], &utf_16[..]].concat(), "it is text in UTF-16; save it as UTF-8"),
            (&utf_16, "it is text in UTF-16; save it as UTF-8"),
            (&vec![0, 0, 0xfe, 0xff, 0, 0, 0, b'a'], "it is text in UTF-32; save it as UTF-8"),
        ] {
            std::fs::write(&path, bytes).unwrap();
            assert_eq!(read(&path, 99).unwrap_err().to_string(), said);
        }
        std::fs::write(&path, [0xff]).unwrap();
        assert_eq!(read(&path, 4).unwrap_err().kind(), io::ErrorKind::InvalidData);
    }
}
