//! The format Apache Parquet: columns in row groups, compressed by gzip.

use super::metadata::Metadata;
use super::rows::Rows;
use super::run_table::RunTable;
use crate::vocabulary::brief::number;
use parquet::basic::{Compression, Encoding, GzipLevel, Repetition, Type as PhysicalType};
use parquet::data_type::{DataType, DoubleType};
use parquet::errors::{ParquetError, Result};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::{ColumnPath, Type};
use std::io::{self, Write};
use std::sync::Arc;

/// The number of rows in a group, except the last one: 11 columns of them take 6 MB.
pub(crate) const GROUP: usize = 1 << 16;

pub(super) fn write<W: Write + Send>(
    rows: &Rows<'_>,
    table: &RunTable,
    metadata: &Metadata,
    to: &mut W,
) -> io::Result<()> {
    let header = table.header();
    let fields = header.split(',').map(|name| required(name, PhysicalType::DOUBLE));
    // The numbers of a motion hardly ever repeat.
    let file = fields.collect::<Result<_>>();
    let file = file.and_then(|fields| begin("run", fields, metadata, |_| false, to));
    let mut file = file.map_err(io_error)?;
    let mut columns = vec![Vec::with_capacity(GROUP); table.width()];
    rows.each(|row| {
        for (column, number) in columns.iter_mut().zip(row.as_chunks().0) {
            column.push(f64::from_le_bytes(*number));
        }
        if columns[0].len() == GROUP {
            write_group(&mut file, &mut columns).map_err(io_error)?;
        }
        Ok(())
    })?;
    if !columns[0].is_empty() {
        write_group(&mut file, &mut columns).map_err(io_error)?;
    }
    file.close().map_err(io_error)?;
    Ok(())
}

/// Returns the error of the system that the writer of Parquet passes on.
pub(crate) fn io_error(error: ParquetError) -> io::Error {
    match error {
        ParquetError::External(cause) => match cause.downcast::<io::Error>() {
            Ok(cause) => *cause,
            Err(cause) => io::Error::other(cause),
        },
        error => error.into(),
    }
}

/// The level of compression: higher ones are several times as slow, and make files of numbers a few percent smaller.
const LEVEL: u32 = 3;

/// Begins a file with these fields and key–value metadata.
///
/// A dictionary makes columns of numbers smaller whose values are `repeated`. The other columns of numbers are split into
/// streams of their first bytes, their second bytes and so on: signs, exponents and leading digits compress well.
pub(crate) fn begin<W: Write + Send>(
    name: &str,
    fields: Vec<Type>,
    metadata: &Metadata,
    repeated: impl Fn(&str) -> bool,
    to: W,
) -> Result<SerializedFileWriter<W>> {
    let is_split = |field: &&Type| {
        field.get_physical_type() == PhysicalType::DOUBLE && !repeated(field.name())
    };
    let split: Vec<_> = fields.iter().filter(is_split).map(|f| f.name().to_owned()).collect();
    let fields = fields.into_iter().map(Arc::new).collect();
    let schema = Type::group_type_builder(name).with_fields(fields).build()?;
    let Metadata { program, version, configuration, casimirs, error_estimate, notes } = metadata;
    let pairs = [("program", *program), ("version", version), ("configuration", configuration)];
    let pairs = pairs.into_iter().map(|(key, value)| KeyValue::new(key.into(), value.to_string()));
    let notes = notes.pairs().into_iter().map(|(key, text)| KeyValue::new(key.into(), text));
    let numbered = (1..).zip(casimirs);
    let pairs = pairs.chain(numbered.map(|(i, text)| KeyValue::new(format!("c{i}"), text.clone())));
    let estimate = error_estimate.map(|e| KeyValue::new("error_estimate".into(), number(e)));
    let pairs = pairs.chain(estimate);
    let pairs = pairs.chain(notes);
    let mut properties = WriterProperties::builder()
        .set_created_by(format!("{program} version {version}"))
        .set_key_value_metadata(Some(pairs.collect()))
        .set_compression(Compression::GZIP(GzipLevel::try_new(LEVEL)?))
        .set_statistics_enabled(EnabledStatistics::Chunk);
    for name in split {
        let column = ColumnPath::new(vec![name]);
        properties = properties
            .set_column_dictionary_enabled(column.clone(), false)
            .set_column_encoding(column, Encoding::BYTE_STREAM_SPLIT);
    }
    SerializedFileWriter::new(to, Arc::new(schema), Arc::new(properties.build()))
}

/// Returns the type of a column without nulls.
pub(crate) fn required(name: &str, kind: PhysicalType) -> Result<Type> {
    let field = Type::primitive_type_builder(name, kind);
    field.with_repetition(Repetition::REQUIRED).build()
}

/// Writes the next column of a row group.
///
/// It takes the values that are present and, unless the column is required, 1 for each value and 0 for each null.
pub(crate) fn write_column<T: DataType>(
    group: &mut SerializedRowGroupWriter<'_, impl Write + Send>,
    values: &[T::T],
    present: Option<&[i16]>,
) -> Result<()> {
    let column = group.next_column()?;
    let mut column = column.ok_or_else(|| ParquetError::General("one column too many".into()))?;
    column.typed::<T>().write_batch(values, present, None)?;
    column.close()
}

/// Writes the columns as a row group, and empties them.
fn write_group<W: Write + Send>(
    file: &mut SerializedFileWriter<W>,
    columns: &mut [Vec<f64>],
) -> Result<()> {
    let mut group = file.next_row_group()?;
    for column in columns {
        write_column::<DoubleType>(&mut group, column, None)?;
        column.clear();
    }
    group.close()?;
    Ok(())
}
