//! CSV, NumPy's npz, Parquet.
//!
//! While a run goes on its rows are appended to one file: of text for CSV, which is the output
//! itself, and of 64-bit little-endian numbers otherwise. From those the output is made at the
//! end, in a pass for each array, by blocks: memory does not grow with the run.

mod npz;
pub(crate) mod parquet;
mod rows;

use crate::Error;
use crate::config::Config;
use crate::output::Output;
use crate::table::{Table, write_row};
use rows::Rows;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::fs::File;
use std::io;
use std::path::Path;

/// How a table is written.
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

/// How far a file goes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Extent {
    pub bytes: u64,
    /// The ends of lines.
    pub lines: u64,
    /// Whether the last byte is one.
    pub ends_line: bool,
}

impl Extent {
    /// Goes further by these bytes.
    pub fn add(&mut self, bytes: &[u8]) {
        self.bytes += bytes.len() as u64;
        self.lines += bytes.iter().filter(|byte| **byte == b'\n').count() as u64;
        self.ends_line = bytes.ends_with(b"\n");
    }
}

/// What an output says of its origin.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Metadata {
    /// heavytop
    pub program: &'static str,
    /// The program's version.
    pub version: &'static str,
    /// The whole configuration, in TOML.
    pub configuration: String,
}

impl Metadata {
    /// That of a run of this version of the program.
    ///
    /// # Errors
    /// As [`Config::to_toml`].
    pub fn new(config: &Config) -> Result<Self, Error> {
        let (program, version) = ("heavytop", env!("CARGO_PKG_VERSION"));
        Ok(Self { program, version, configuration: config.to_toml()? })
    }
}

impl Format {
    /// That of the file's ending; CSV for something like `/dev/stdout` that has none to choose.
    ///
    /// # Errors
    /// If there is no such format.
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
            _ if std::fs::metadata(path).is_ok_and(|m| !m.is_file() && !m.is_dir()) => {
                Ok(Self::Csv)
            }
            _ => Err(Error::Format { path: path.into() }),
        }
    }

    /// What comes before the first row in the file that grows.
    pub(crate) fn start(self, table: &Table) -> String {
        if self == Self::Csv { table.header() + "\n" } else { String::new() }
    }

    /// Puts a row as it is in the file that grows into `bytes`.
    pub(crate) fn encode(self, row: &[f64], bytes: &mut Vec<u8>) -> io::Result<()> {
        bytes.clear();
        if self == Self::Csv {
            return write_row(bytes, row.iter().copied());
        }
        bytes.extend(row.iter().flat_map(|number| number.to_le_bytes()));
        Ok(())
    }

    /// How many rows there are in the file that grows up to here; none if the last is not whole.
    pub(crate) fn rows(self, table: &Table, to: &Extent) -> Option<u64> {
        let row = 8 * table.width() as u64;
        match self {
            // The first line has the names.
            Self::Csv if to.ends_line => to.lines.checked_sub(1),
            Self::Csv => None,
            Self::Npz | Self::Parquet => to.bytes.is_multiple_of(row).then_some(to.bytes / row),
        }
    }

    /// Makes the output of the file that has grown; CSV is there already.
    pub(crate) fn convert(
        self,
        rows: &File,
        table: &Table,
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
