//! The points of a section as a Parquet file.

use super::orbits::orbit::Orbit;
use super::orbits::orbit_tiles::values;
use crate::errors::Error;
use crate::files::Output;
use crate::formats::Metadata;
use crate::formats::parquet::{GROUP, begin, io_error, required, write_column};
use parquet::basic::Type as PhysicalType;
use parquet::data_type::{DoubleType, Int64Type};
use parquet::errors::{ParquetError, Result};
use parquet::file::writer::SerializedFileWriter;
use std::path::{Path, PathBuf};

/// The table with the columns of `section.csv`, and the configuration in the file's metadata.
///
/// Points are written in groups that end with an orbit. No more than a group of them is held in memory.
pub(super) struct PointTable {
    path: PathBuf,
    file: SerializedFileWriter<Output>,
    /// The columns `start` and `crossing`.
    indices: [Vec<i64>; 2],
    columns: Vec<Vec<f64>>,
}

impl PointTable {
    /// Creates the table without rows.
    ///
    /// # Errors
    /// If the file cannot be created.
    pub fn begin(
        header: &str,
        metadata: &Metadata,
        path: &Path,
    ) -> std::result::Result<Self, Error> {
        let output = Output::create(path).map_err(Error::too_late)?;
        let fields = header.split(',').enumerate().map(|(i, name)| {
            required(name, if i < 2 { PhysicalType::INT64 } else { PhysicalType::DOUBLE })
        });
        let file = fields.collect::<Result<Vec<_>>>();
        let file = file.and_then(|fields| begin("section", fields, metadata, |_| false, output));
        let file = file.map_err(|source| failed(path, source))?;
        let columns = vec![Vec::new(); header.split(',').count() - 2];
        Ok(Self { path: path.into(), file, indices: Default::default(), columns })
    }

    /// Adds the points of an orbit.
    ///
    /// # Errors
    /// If the points cannot be written.
    pub fn add(&mut self, orbit: &Orbit) -> std::result::Result<(), Error> {
        for (index, crossing) in orbit.crossings.iter().enumerate() {
            self.indices[0].push(orbit.number as i64);
            self.indices[1].push(index as i64);
            for (column, value) in self.columns.iter_mut().zip(values(crossing)) {
                column.push(value);
            }
        }
        if self.indices[0].len() < GROUP { Ok(()) } else { self.write() }
    }

    /// Returns the file, complete but for its name.
    ///
    /// # Errors
    /// If the file cannot be completed.
    pub fn whole(mut self) -> std::result::Result<Output, Error> {
        if !self.indices[0].is_empty() {
            self.write()?;
        }
        self.file.into_inner().map_err(|source| failed(&self.path, source))
    }

    fn write(&mut self) -> std::result::Result<(), Error> {
        self.write_group().map_err(|source| failed(&self.path, source))
    }

    fn write_group(&mut self) -> Result<()> {
        let mut group = self.file.next_row_group()?;
        for column in &mut self.indices {
            write_column::<Int64Type>(&mut group, column, None)?;
            column.clear();
        }
        for column in &mut self.columns {
            write_column::<DoubleType>(&mut group, column, None)?;
            column.clear();
        }
        group.close()?;
        Ok(())
    }
}

fn failed(path: &Path, source: ParquetError) -> Error {
    Error::Write { path: path.into(), source: io_error(source) }
}
