//! The last line of a text file for which there was no room.

use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};

/// The number of bytes that are read at once.
const BLOCK: u64 = 4096;

/// Cuts off what follows the last line end: the beginning of a number reads as another number.
///
/// # Errors
/// If the file cannot be read or cut.
pub(crate) fn cut_torn_line(file: &mut File) -> io::Result<()> {
    let mut end = file.seek(SeekFrom::End(0))?;
    let mut block = Vec::new();
    while end > 0 {
        let start = end.saturating_sub(BLOCK);
        file.seek(SeekFrom::Start(start))?;
        block.clear();
        file.take(end - start).read_to_end(&mut block)?;
        if let Some(last) = block.iter().rposition(|&byte| byte == b'\n') {
            return file.set_len(start + last as u64 + 1);
        }
        end = start;
    }
    file.set_len(0)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn only_what_follows_the_last_line_end_is_cut() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        let long = "7".repeat(3 * BLOCK as usize);
        for (text, rest) in [
            ("", ""),
            ("1,2\n", "1,2\n"),
            ("1,2\n3,4", "1,2\n"),
            ("1,2", ""),
            (&format!("1\n{long}"), "1\n"),
            (&format!("1\n{long}\n"), &format!("1\n{long}\n")),
        ] {
            std::fs::write(&path, text).unwrap();
            let mut file = File::options().read(true).write(true).open(&path).unwrap();
            cut_torn_line(&mut file).unwrap();
            assert_eq!(std::fs::read_to_string(&path).unwrap(), rest);
        }
    }
}
