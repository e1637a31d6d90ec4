//! The table of a sweep as a Parquet file.

use super::measured_row::Row;
use super::sweep_plan::{FAILURE, INDEX, Plan};
use crate::errors::Error;
use crate::files::{Output, Place};
use crate::formats::Metadata;
use crate::formats::parquet::{GROUP, begin, io_error, required, write_column};
use parquet::basic::{LogicalType, Type as PhysicalType};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::errors::{ParquetError, Result};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;
use std::path::{Path, PathBuf};

/// The table with `index`, the parameters, the observables and `failure` of each member.
///
/// The observables and `failure` may be null. The configuration is in the file's metadata. Rows are written in
/// groups, and no more than a group of them is held in memory.
pub(super) struct MemberTable<'a> {
    plan: &'a Plan,
    path: PathBuf,
    file: SerializedFileWriter<Output>,
    /// The number of the first row in memory.
    first: u64,
    rows: Vec<Row>,
}

impl<'a> MemberTable<'a> {
    /// Creates the table without rows.
    ///
    /// # Errors
    /// If the file cannot be created.
    pub fn begin(
        plan: &'a Plan,
        metadata: &Metadata,
        path: &Path,
    ) -> std::result::Result<Self, Error> {
        let output = Output::create(path).map_err(Error::too_late)?;
        let repeated = |name: &str| {
            plan.axes.iter().any(|axis| axis.is_grid() && axis.parameter.name() == name)
        };
        let file = fields(plan);
        let file = file.and_then(|fields| begin("sweep", fields, metadata, repeated, output));
        let file = file.map_err(|source| failed(path, source))?;
        Ok(Self { plan, path: path.into(), file, first: 0, rows: Vec::new() })
    }

    /// Adds the next rows.
    ///
    /// # Errors
    /// If the rows cannot be written.
    pub fn add(&mut self, rows: Vec<Row>) -> std::result::Result<(), Error> {
        self.rows.extend(rows);
        if self.rows.len() < GROUP { Ok(()) } else { self.write() }
    }

    /// Leaves the complete file as `NAME.partial`, and returns its path.
    ///
    /// # Errors
    /// If the file cannot be completed.
    pub fn keep(self) -> std::result::Result<PathBuf, Error> {
        let partial = Place::of(&self.path)?.beside("partial");
        self.whole()?.keep().map(|()| partial)
    }

    /// Returns the file, complete but for its name.
    ///
    /// # Errors
    /// If the file cannot be completed.
    pub fn whole(mut self) -> std::result::Result<Output, Error> {
        if !self.rows.is_empty() {
            self.write()?;
        }
        self.file.into_inner().map_err(|source| failed(&self.path, source))
    }

    fn write(&mut self) -> std::result::Result<(), Error> {
        self.write_group().map_err(|source| failed(&self.path, source))?;
        self.first += self.rows.len() as u64;
        self.rows.clear();
        Ok(())
    }

    fn write_group(&mut self) -> Result<()> {
        let Self { plan, file, first, rows, .. } = self;
        let mut group = file.next_row_group()?;
        let indices = *first..*first + rows.len() as u64;
        let numbers: Vec<i64> = indices.clone().map(|index| index as i64).collect();
        write_column::<Int64Type>(&mut group, &numbers, None)?;
        for axis in 0..plan.axes.len() {
            let family = &plan.family;
            let value = |index| family.run_values(&plan.parameters(index)).get(axis).copied();
            let values: Vec<f64> = indices.clone().filter_map(value).collect();
            write_column::<DoubleType>(&mut group, &values, None)?;
        }
        for column in 0..plan.columns.len() {
            let cells = || rows.iter().map(|row| row.value(column));
            let values: Vec<f64> = cells().flatten().collect();
            let present: Vec<i16> = cells().map(|cell| i16::from(cell.is_some())).collect();
            write_column::<DoubleType>(&mut group, &values, Some(&present))?;
        }
        let failures = rows.iter().filter_map(|row| row.failure.as_deref());
        let failures: Vec<ByteArray> = failures.map(ByteArray::from).collect();
        let present: Vec<i16> = rows.iter().map(|row| i16::from(row.failure.is_some())).collect();
        write_column::<ByteArrayType>(&mut group, &failures, Some(&present))?;
        group.close()?;
        Ok(())
    }
}

fn failed(path: &Path, source: ParquetError) -> Error {
    Error::Write { path: path.into(), source: io_error(source) }
}

fn fields(plan: &Plan) -> Result<Vec<Type>> {
    let axes = plan.axes.iter().map(|axis| required(&axis.parameter.name(), PhysicalType::DOUBLE));
    // A column is optional unless it is declared otherwise.
    let optional = |name, kind| Type::primitive_type_builder(name, kind);
    let columns = plan.columns.iter();
    let columns = columns.map(|column| optional(&column.name, PhysicalType::DOUBLE).build());
    let failure = optional(FAILURE, PhysicalType::BYTE_ARRAY);
    let failure = failure.with_logical_type(Some(LogicalType::String)).build();
    let index = required(INDEX, PhysicalType::INT64);
    [index].into_iter().chain(axes).chain(columns).chain([failure]).collect()
}
