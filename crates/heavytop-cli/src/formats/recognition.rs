//! How the files of a run are recognised: by the names of their columns, or by their metadata.

use crate::files::Kind;
use parquet::file::reader::{FileReader, SerializedFileReader};
use std::fs::File;
use std::io::{self, Read};
use zip::ZipArchive;

/// The names of files of each format of `simulate` in messages, and how they are recognised.
pub(crate) const CSV: Kind =
    Kind { name: "table of simulate", first: b"t,", is_whole: |head, _| Ok(is_run(head)) };
pub(crate) const NPZ: Kind =
    Kind { name: "table of simulate", first: b"PK\x03\x04", is_whole: |_, file| Ok(is_npz(file)) };
pub(crate) const PARQUET: Kind =
    Kind { name: "table of simulate", first: PAR1, is_whole: |_, file| is_parquet("run", file) };

/// The rows of 64-bit numbers of a run that goes on: the first one is t = 0.
pub(crate) const ROWS: Kind = Kind::of_first_bytes("rows of simulate", &[0; 8]);

/// The first bytes of every Parquet file.
pub(crate) const PAR1: &[u8] = b"PAR1";

/// Returns whether a text begins as the table of a run: with the names t and h among its columns, and the time 0 in the
/// first row.
fn is_run(head: &[u8]) -> bool {
    let head = String::from_utf8_lossy(head);
    let mut lines = head.lines();
    let columns: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
    let numbers: Option<Vec<f64>> = lines.next().map_or(Some(vec![0.0; columns.len()]), |row| {
        row.split(',').map(|cell| cell.parse().ok()).collect()
    });
    columns[0] == "t"
        && columns.contains(&"h")
        && numbers.is_some_and(|row| row.len() == columns.len() && row[0] == 0.0)
}

/// Returns whether an archive has the metadata of this program.
fn is_npz(file: &mut File) -> bool {
    /// The metadata begin with the name of the program; the header of the array comes before them.
    const BYTES: u64 = 1024;
    let mut bytes = Vec::new();
    let read = ZipArchive::new(file).is_ok_and(|mut archive| {
        let metadata = archive.by_name("metadata.npy");
        metadata.is_ok_and(|metadata| metadata.take(BYTES).read_to_end(&mut bytes).is_ok())
    });
    // Each character has four bytes, of which the others are zero.
    bytes.retain(|byte| *byte != 0);
    read && crate::files::contains(&bytes, "{\"program\":\"heavytop\",")
}

/// Returns whether a Parquet file is a table of this name with the metadata of this program.
pub(crate) fn is_parquet(name: &str, file: &File) -> io::Result<bool> {
    let Ok(reader) = SerializedFileReader::new(file.try_clone()?) else { return Ok(false) };
    let metadata = reader.metadata().file_metadata();
    let pairs = metadata.key_value_metadata().into_iter().flatten();
    let program = pairs.filter(|pair| pair.key == "program").find_map(|pair| pair.value.as_deref());
    Ok(metadata.schema().name() == name && program == Some("heavytop"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_of_a_run_is_told_from_other_tables() {
        for (text, expected) in [
            ("t,Pi1,h,f1\n0.0,1.0,2.0,3.0\n", true),
            ("t,x,h,c1\n", true),
            ("t,x,h\n1.0,1.0,2.0\n", false),
            ("t,x,h\n0.0,1.0\n", false),
            ("t,x,h\n0.0,a,2.0\n", false),
            ("t,temperature\n0.0,20\n", false),
            ("time,x,h\n0.0,1.0,2.0\n", false),
            ("", false),
        ] {
            assert_eq!(is_run(text.as_bytes()), expected, "{text:?}");
        }
    }
}
