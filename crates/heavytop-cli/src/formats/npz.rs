//! The format npz of NumPy: an archive of npy arrays, not compressed.
//!
//! Source: NumPy Enhancement Proposal 1, *A simple file format for NumPy arrays*, version 1.0.

use super::metadata::Metadata;
use super::rows::Rows;
use super::run_table::RunTable;
use std::io::{self, Seek, Write};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

/// The number of bytes at whose multiples the arrays start in their files.
const ALIGNMENT: usize = 64;

/// The number of bytes that are written at once.
const BLOCK: usize = 1 << 16;

/// The length of the magic string, the version, and the length of the header.
const PREFIX: usize = 10;

pub(super) fn write(
    rows: &Rows<'_>,
    table: &RunTable,
    metadata: &Metadata,
    to: &mut (impl Write + Seek),
) -> io::Result<()> {
    let mut archive = ZipWriter::new(to);
    if let Err(error) = write_arrays(rows, table, metadata, &mut archive) {
        // Dropping the archive would try to write again, and print that it failed again.
        std::mem::forget(archive);
        return Err(error);
    }
    archive.finish()?;
    Ok(())
}

fn write_arrays<W: Write + Seek>(
    rows: &Rows<'_>,
    table: &RunTable,
    metadata: &Metadata,
    archive: &mut ZipWriter<W>,
) -> io::Result<()> {
    for (name, columns) in table.arrays() {
        let (n, bytes) = (rows.count, 8 * columns.start..8 * columns.end);
        let shape = match columns.len() {
            1 => format!("({n},)"),
            width => format!("({n}, {width})"),
        };
        begin(archive, name, "<f8", &shape, n * bytes.len() as u64)?;
        let mut block = Vec::with_capacity(BLOCK + bytes.len());
        rows.each(|row| {
            block.extend_from_slice(&row[bytes.clone()]);
            if block.len() >= BLOCK {
                archive.write_all(&block)?;
                block.clear();
            }
            Ok(())
        })?;
        archive.write_all(&block)?;
    }
    // A string is an array of dimension 0 whose characters have four bytes.
    let text = serde_json::to_string(metadata)?;
    let characters = text.chars().count();
    begin(archive, "metadata", &format!("<U{characters}"), "()", 4 * characters as u64)?;
    text.chars().try_for_each(|c| archive.write_all(&u32::from(c).to_le_bytes()))
}

/// Begins an array of `bytes` bytes.
fn begin<W: Write + Seek>(
    archive: &mut ZipWriter<W>,
    name: &str,
    kind: &str,
    shape: &str,
    bytes: u64,
) -> io::Result<()> {
    // The file has no time of day, so that the same run makes the same file.
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Stored)
        .last_modified_time(DateTime::default())
        .large_file(bytes > u64::from(u32::MAX / 2));
    archive.start_file(format!("{name}.npy"), options)?;
    let header = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}");
    let length = (PREFIX + header.len() + 1).next_multiple_of(ALIGNMENT) - PREFIX;
    archive.write_all(b"\x93NUMPY\x01\x00")?;
    archive.write_all(&(length as u16).to_le_bytes())?;
    writeln!(archive, "{header:<0$}", length - 1)
}
