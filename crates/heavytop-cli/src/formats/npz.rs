//! The format npz of NumPy: an archive of npy arrays, not compressed.
//!
//! Source: NumPy Enhancement Proposal 1, *A simple file format for NumPy arrays*, version 1.0.

use super::metadata::Metadata;
use super::rows::Rows;
use super::run_table::{Array, RunTable};
use std::io::{self, Seek, Write};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

/// The number of bytes at whose multiples the arrays start in their files.
const ALIGNMENT: usize = 64;

/// The least number of bytes that are written at once, but for the last ones.
const BLOCK: usize = 1 << 16;

/// The number of bytes of arrays that are kept in memory until their turn comes.
const KEPT: u64 = 1 << 25;

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
    write_numbers(rows, table.arrays(), KEPT, archive)?;
    // A string is an array of dimension 0 whose characters have four bytes.
    let text = serde_json::to_string(metadata)?;
    let characters = text.chars().count();
    begin(archive, "metadata", &format!("<U{characters}"), "()", 4 * characters as u64)?;
    text.chars().try_for_each(|c| archive.write_all(&u32::from(c).to_le_bytes()))
}

/// Writes arrays of numbers. The rows are read as often as it takes to keep at most so many bytes of them.
fn write_numbers<W: Write + Seek>(
    rows: &Rows<'_>,
    mut arrays: &[Array],
    most_kept: u64,
    archive: &mut ZipWriter<W>,
) -> io::Result<()> {
    while let Some((first, others)) = arrays.split_first() {
        let ends = others.iter().scan(0, |end, array| {
            *end += 8 * array.columns.len() as u64;
            Some(rows.count.saturating_mul(*end))
        });
        let (kept, later) = others.split_at(ends.take_while(|end| *end <= most_kept).count());
        write_together(rows, first, kept, archive)?;
        arrays = later;
    }
    Ok(())
}

/// Writes an array while the rows are read, and then others that have been kept from the same reading.
fn write_together<W: Write + Seek>(
    rows: &Rows<'_>,
    first: &Array,
    others: &[Array],
    archive: &mut ZipWriter<W>,
) -> io::Result<()> {
    let room = |array: &Array| Vec::with_capacity(rows.count as usize * array.columns.len());
    let (mut block, mut kept) = (Vec::new(), others.iter().map(room).collect::<Vec<_>>());
    begin_numbers(archive, first, rows.count)?;
    rows.each(|row| {
        let numbers = row.as_chunks::<8>().0;
        block.extend_from_slice(&numbers[first.columns.clone()]);
        for (kept, array) in kept.iter_mut().zip(others) {
            kept.extend_from_slice(&numbers[array.columns.clone()]);
        }
        if block.as_flattened().len() >= BLOCK {
            archive.write_all(block.as_flattened())?;
            block.clear();
        }
        Ok(())
    })?;
    archive.write_all(block.as_flattened())?;
    for (kept, array) in kept.iter().zip(others) {
        begin_numbers(archive, array, rows.count)?;
        archive.write_all(kept.as_flattened())?;
    }
    Ok(())
}

/// Begins an array of numbers with so many samples, each of its shape.
fn begin_numbers<W: Write + Seek>(
    archive: &mut ZipWriter<W>,
    array: &Array,
    rows: u64,
) -> io::Result<()> {
    let others: Vec<String> = array.shape.iter().map(|count| format!(" {count}")).collect();
    let shape = format!("({rows},{})", others.join(","));
    begin(archive, &array.name, "<f8", &shape, rows * 8 * array.columns.len() as u64)
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

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use std::io::Cursor;

    #[test]
    fn the_archive_does_not_depend_on_the_number_of_readings() {
        const WIDTH: usize = 6;
        let mut file = tempfile::tempfile().unwrap();
        // More than a block for each column.
        let rows = BLOCK / 8 + 5;
        let numbers = (0..rows * WIDTH).flat_map(|i| (i as f64).sqrt().to_le_bytes());
        file.write_all(&numbers.collect::<Vec<_>>()).unwrap();
        let archive = |widths: &[usize], most_kept| {
            let mut start = 0;
            let arrays = widths.iter().map(|width| {
                start += width;
                let shape = if *width == 1 { Vec::new() } else { vec![*width] };
                Array { name: format!("from {start}"), columns: start - width..start, shape }
            });
            let rows = Rows::new(&file, WIDTH).unwrap();
            let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
            write_numbers(&rows, &arrays.collect::<Vec<_>>(), most_kept, &mut archive).unwrap();
            archive.finish().unwrap().into_inner()
        };
        let widths = [1, 3, 1, 1];
        let in_one_reading = archive(&widths, u64::MAX);
        for columns in 0..=WIDTH {
            assert_eq!(archive(&widths, (8 * rows * columns) as u64), in_one_reading);
        }
        // Control: other arrays are other archives.
        assert_ne!(archive(&[1, 1, 3, 1], u64::MAX), in_one_reading);
    }
}
