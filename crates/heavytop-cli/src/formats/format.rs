//! The formats of a run: how its rows are kept while it proceeds, and how the output is made of them.
//!
//! During a run its rows are appended to one file. For CSV that is the output itself, as text. Otherwise it holds
//! 64-bit little-endian numbers, from which the output is made at the end, by blocks, in several passes if the run is
//! long. Memory does not grow with the run.

use super::extent::Extent;
use super::metadata::Metadata;
use super::rows::Rows;
use super::run_table::{RunTable, append_row};
use super::{npz, parquet, recognition};
use crate::errors::Error;
use crate::files::{Kind, Output, Place};
use serde::{Deserialize, Serialize};
use std::fmt;
use std::fs::File;
use std::path::Path;

/// The largest number of columns of a table of text or of Parquet, as of most spreadsheets.
const MOST_COLUMNS: usize = 1 << 14;

/// A file format for the table of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Format {
    /// Text: a line of names, then lines of numbers.
    Csv,
    /// NumPy's archive of arrays: `t`, `Pi`, `Gamma`, one for each invariant, `q` for the
    /// attitude, with a row for each time, and the string `metadata` in JSON.
    Npz,
    /// Apache Parquet with the columns of the CSV and key–value metadata.
    Parquet,
}

impl Format {
    /// Returns the format that the ending of the file names; CSV for `-`, which is standard output, and for a device such
    /// as `/dev/stdout`.
    ///
    /// # Errors
    /// If the ending stands for no format.
    ///
    /// # Example
    /// ```
    /// use heavytop_cli::formats::Format;
    /// assert_eq!(Format::of("top.parquet".as_ref())?, Format::Parquet);
    /// assert!(Format::of("top.xls".as_ref()).is_err());
    /// # Ok::<(), heavytop_cli::Error>(())
    /// ```
    pub fn of(path: &Path) -> Result<Self, Error> {
        let ending = path.extension().map(|ending| ending.to_ascii_lowercase());
        match ending.as_ref().and_then(|ending| ending.to_str()) {
            Some("csv") => Ok(Self::Csv),
            Some("npz") => Ok(Self::Npz),
            Some("parquet") => Ok(Self::Parquet),
            _ if Place::of(path).is_ok_and(|place| place.is_device) => Ok(Self::Csv),
            _ => Err(Error::Format { path: path.into() }),
        }
    }

    /// Checks that the format can have the columns of a table.
    ///
    /// # Errors
    /// If CSV or Parquet would have more than 16384.
    pub(crate) fn require_columns(self, table: &RunTable) -> Result<(), Error> {
        let (columns, most) = (table.width(), MOST_COLUMNS);
        match self {
            Self::Csv | Self::Parquet if columns > most => {
                Err(Error::TooWide { format: self.to_string(), columns, most })
            }
            _ => Ok(()),
        }
    }

    /// Returns the kind of a complete output in this format, whose table has this [beginning](RunTable::beginning).
    pub(crate) fn kind(self, beginning: &str) -> Kind<'_> {
        match self {
            Self::Csv => recognition::csv(beginning),
            Self::Npz => recognition::NPZ,
            Self::Parquet => recognition::PARQUET,
        }
    }

    /// Returns the text before the first row in the growing file.
    pub(crate) fn start(self, table: &RunTable) -> String {
        if self == Self::Csv { table.header() + "\n" } else { String::new() }
    }

    /// Appends a row, encoded as in the growing file.
    pub(crate) fn append(self, row: &[f64], bytes: &mut Vec<u8>) {
        match self {
            Self::Csv => append_row(bytes, row),
            Self::Npz | Self::Parquet => {
                bytes.extend(row.iter().flat_map(|number| number.to_le_bytes()));
            }
        }
    }

    /// Returns the number of rows in the growing file up to an extent; `None` if the last row is incomplete.
    pub(crate) fn rows(self, table: &RunTable, to: &Extent) -> Option<u64> {
        let row = 8 * table.width() as u64;
        match self {
            // The first line holds the names of the columns.
            Self::Csv if to.ends_line => to.lines.checked_sub(1),
            Self::Csv => None,
            Self::Npz | Self::Parquet => to.bytes.is_multiple_of(row).then_some(to.bytes / row),
        }
    }

    /// Makes the output from the growing file; CSV is complete already.
    pub(crate) fn convert(
        self,
        rows: &File,
        table: &RunTable,
        metadata: &Metadata,
        output: &mut Output,
    ) -> Result<(), Error> {
        output.write(|to| {
            let rows = Rows::new(rows, table.width())?;
            match self {
                Self::Csv => Ok(()),
                Self::Npz => npz::write(&rows, table, metadata, to),
                Self::Parquet => parquet::write(&rows, table, metadata, to),
            }
        })
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Csv => "CSV",
            Self::Npz => "npz",
            Self::Parquet => "Parquet",
        })
    }
}
