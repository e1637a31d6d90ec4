//! How the files of a run are recognised: by the names of their columns, or by their metadata.

use super::run_table::{TOP_COLUMNS, is_top_column};
use crate::files::Kind;
use parquet::file::reader::{FileReader, SerializedFileReader};
use std::fs::File;
use std::io::{self, Read};
use zip::ZipArchive;

/// Returns the kind of the CSV tables of runs that begin with these names of columns: those of all tops, or of one system.
pub(crate) fn csv(beginning: &str) -> Kind<'_> {
    let is_whole: fn(&[u8], &mut File) -> _ = |head, _| Ok(is_run(head));
    Kind { name: "table of simulate with these columns", first: beginning.as_bytes(), is_whole }
}

/// How the files of the other formats of `simulate` are recognised.
pub(crate) const NPZ: Kind<'_> =
    Kind { name: "table of simulate", first: b"PK\x03\x04", is_whole: |_, file| Ok(is_npz(file)) };
pub(crate) const PARQUET: Kind<'_> =
    Kind { name: "table of simulate", first: PAR1, is_whole: |_, file| is_parquet("run", file) };

/// The rows of 64-bit numbers of a run that goes on: the first one is t = 0.
pub(crate) const ROWS: Kind<'_> = Kind::of_first_bytes("rows of simulate", &[0; 8]);

/// The first bytes of every Parquet file.
pub(crate) const PAR1: &[u8] = b"PAR1";

/// Returns whether a text begins as the table of a run: with no columns of a top but those that tops have, and with numbers
/// in the first row, of the time 0.
fn is_run(head: &[u8]) -> bool {
    let head = String::from_utf8_lossy(head);
    let mut lines = head.lines();
    let header = lines.next().unwrap_or_default();
    let is_header = header.strip_prefix(TOP_COLUMNS).is_none_or(|others| {
        let mut others = others.split(',');
        // The columns end, or go on with a comma.
        others.next() == Some("") && others.all(is_top_column)
    });
    let count = header.split(',').count();
    let numbers: Option<Vec<f64>> = lines.next().map_or(Some(vec![0.0; count]), |row| {
        row.split(',').map(|cell| cell.parse().ok()).collect()
    });
    is_header && numbers.is_some_and(|row| row.len() == count && row.first() == Some(&0.0))
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
        for (more, expected) in [
            ("\n0.0,2,3,4,1,0,0,11,1,2\n", true),
            ("", true),
            (",K,qw,qx,qy,qz\n0.0,2,3,4,1,0,0,11,1,2,193,1,0,0,0\n", true),
            ("\n-0.0,2,3,4,1,0,0,11,1,2\n", true),
            ("\n1.0,2,3,4,1,0,0,11,1,2\n", false),
            ("\n0.0,2,3,4,1,0,0,11,1\n", false),
            ("\n0.0,2,3,4,1,0,0,11,1,a\n", false),
            // A table of a run, to which somebody has added a column.
            (",K,distance\n0.0,2,3,4,1,0,0,11,1,2,193,1\n", false),
            ("2,K\n0.0,2,3,4,1,0,0,11,1,2,193\n", false),
        ] {
            let text = format!("{TOP_COLUMNS}{more}");
            assert_eq!(is_run(text.as_bytes()), expected, "{text:?}");
        }
    }
}
