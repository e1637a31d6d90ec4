//! The table of a sweep, as Parquet.

use super::measure::Row;
use super::plan::Plan;
use crate::Error;
use crate::formats::Metadata;
use crate::output::Output;
use parquet::basic::{LogicalType, Repetition, Type as PhysicalType};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::errors::Result;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;
use std::io::Write;
use std::path::Path;
use std::sync::Arc;

/// Writes `index`, the parameters, the observables and `failure` of each top; the last two may be
/// null. The configuration is in the file's metadata.
///
/// # Errors
/// If the file cannot be written.
pub(super) fn write(
    plan: &Plan,
    rows: &[Row],
    metadata: &Metadata,
    path: &Path,
) -> std::result::Result<(), Error> {
    let mut output = Output::create(path)?;
    output.write(|to| Ok(write_table(plan, rows, metadata, to)?))?;
    output.complete()
}

fn write_table<W: Write + Send>(
    plan: &Plan,
    rows: &[Row],
    metadata: &Metadata,
    to: &mut W,
) -> Result<()> {
    let Metadata { program, version, configuration } = metadata;
    let pairs = [("program", *program), ("version", version), ("configuration", configuration)];
    let pairs = pairs.map(|(key, value)| KeyValue::new(key.into(), value.to_string()));
    let properties = WriterProperties::builder()
        .set_created_by(format!("{program} version {version}"))
        .set_key_value_metadata(Some(pairs.into()))
        .build();
    let mut file = SerializedFileWriter::new(to, Arc::new(schema(plan)?), Arc::new(properties))?;
    let mut group = file.next_row_group()?;
    if let Some(mut column) = group.next_column()? {
        let indices: Vec<i64> = (0..rows.len() as i64).collect();
        column.typed::<Int64Type>().write_batch(&indices, None, None)?;
        column.close()?;
    }
    for axis in 0..plan.axes.len() {
        if let Some(mut column) = group.next_column()? {
            let values: Vec<f64> =
                (0..plan.tops).filter_map(|n| plan.parameters(n).get(axis).copied()).collect();
            column.typed::<DoubleType>().write_batch(&values, None, None)?;
            column.close()?;
        }
    }
    for index in 0..plan.columns().count() {
        if let Some(mut column) = group.next_column()? {
            let cells = || rows.iter().map(|row| row.values.get(index).copied().flatten());
            let values: Vec<f64> = cells().flatten().collect();
            let present: Vec<i16> = cells().map(|cell| i16::from(cell.is_some())).collect();
            column.typed::<DoubleType>().write_batch(&values, Some(&present), None)?;
            column.close()?;
        }
    }
    if let Some(mut column) = group.next_column()? {
        let failures = rows.iter().filter_map(|row| row.failure.as_deref());
        let failures: Vec<ByteArray> = failures.map(ByteArray::from).collect();
        let present: Vec<i16> = rows.iter().map(|row| i16::from(row.failure.is_some())).collect();
        column.typed::<ByteArrayType>().write_batch(&failures, Some(&present), None)?;
        column.close()?;
    }
    group.close()?;
    file.close()?;
    Ok(())
}

fn schema(plan: &Plan) -> Result<Type> {
    let field = |name: &str, kind, repetition, logical| {
        let field = Type::primitive_type_builder(name, kind).with_repetition(repetition);
        Ok::<_, parquet::errors::ParquetError>(Arc::new(field.with_logical_type(logical).build()?))
    };
    let mut fields = vec![field("index", PhysicalType::INT64, Repetition::REQUIRED, None)?];
    for axis in &plan.axes {
        let name = axis.parameter.name();
        fields.push(field(name, PhysicalType::DOUBLE, Repetition::REQUIRED, None)?);
    }
    for column in plan.columns() {
        fields.push(field(column.name, PhysicalType::DOUBLE, Repetition::OPTIONAL, None)?);
    }
    let text = Some(LogicalType::String);
    fields.push(field("failure", PhysicalType::BYTE_ARRAY, Repetition::OPTIONAL, text)?);
    Type::group_type_builder("sweep").with_fields(fields).build()
}
