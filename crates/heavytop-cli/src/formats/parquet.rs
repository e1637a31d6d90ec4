//! Apache Parquet: plain columns in row groups, not compressed.

use super::Metadata;
use super::rows::Rows;
use crate::table::Table;
use parquet::basic::{Repetition, Type as PhysicalType};
use parquet::data_type::DoubleType;
use parquet::errors::Result;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;
use std::io::{self, Write};
use std::sync::Arc;

/// The rows of a group, the last one excepted: 11 columns of them take 6 MB.
const GROUP: usize = 1 << 16;

pub(super) fn write<W: Write + Send>(
    rows: &Rows,
    table: &Table,
    metadata: &Metadata,
    to: &mut W,
) -> io::Result<()> {
    let mut file = begin(table, metadata, to)?;
    let mut columns = vec![Vec::with_capacity(GROUP); table.width()];
    rows.each(|row| {
        for (column, number) in columns.iter_mut().zip(row.as_chunks().0) {
            column.push(f64::from_le_bytes(*number));
        }
        if columns[0].len() == GROUP {
            write_group(&mut file, &mut columns)?
        }
        Ok(())
    })?;
    if !columns[0].is_empty() {
        write_group(&mut file, &mut columns)?;
    }
    file.close()?;
    Ok(())
}

fn begin<'a, W: Write + Send>(
    table: &Table,
    metadata: &Metadata,
    to: &'a mut W,
) -> Result<SerializedFileWriter<&'a mut W>> {
    let header = table.header();
    let fields = header.split(',').map(|name| {
        let field = Type::primitive_type_builder(name, PhysicalType::DOUBLE);
        Ok(Arc::new(field.with_repetition(Repetition::REQUIRED).build()?))
    });
    let fields = fields.collect::<Result<Vec<_>>>()?;
    let schema = Type::group_type_builder("run").with_fields(fields).build()?;
    let Metadata { program, version, configuration } = metadata;
    let pairs = [("program", *program), ("version", version), ("configuration", configuration)];
    let pairs = pairs.map(|(key, value)| KeyValue::new(key.into(), value.to_string()));
    let properties = WriterProperties::builder()
        .set_created_by(format!("{program} version {version}"))
        .set_key_value_metadata(Some(pairs.into()))
        // Numbers of a motion hardly ever occur twice.
        .set_dictionary_enabled(false)
        .build();
    SerializedFileWriter::new(to, Arc::new(schema), Arc::new(properties))
}

/// Writes the columns as a row group, and empties them.
fn write_group<W: Write + Send>(
    file: &mut SerializedFileWriter<W>,
    columns: &mut [Vec<f64>],
) -> Result<()> {
    let mut group = file.next_row_group()?;
    for column in columns {
        if let Some(mut writer) = group.next_column()? {
            writer.typed::<DoubleType>().write_batch(column, None, None)?;
            writer.close()?;
        }
        column.clear();
    }
    group.close()?;
    Ok(())
}
