//! Errors of the files of inputs.

use crate::vocabulary::brief::text as brief;
use lie_poisson::InputTableError;
use std::io;

/// The reason why a file has not the table of an input.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum InputFileError {
    /// The file cannot be read.
    #[error("it cannot be read")]
    Read(#[source] io::Error),
    /// The file has another content than when the run began.
    #[error("it has changed since the run began")]
    Changed,
    /// There is no column of this name.
    #[error("line 1 has no column {name}; it has {}", if has.is_empty() { "no names".into() } else { has.join(", ") })]
    NoColumn {
        /// The name.
        name: String,
        /// The names of the columns that there are.
        has: Vec<String>,
    },
    /// A line ends before the column.
    #[error("line {line} has no cell in column {column}: it has {cells} in all")]
    NoCell {
        /// The number of the line, from 1.
        line: u64,
        /// The name of the column, or its number, from 1.
        column: String,
        /// The number of cells.
        cells: usize,
    },
    /// A cell has no finite number.
    #[error("line {line}, column {column}: `{}` is no finite number", brief(text))]
    NoNumber {
        /// The number of the line, from 1.
        line: u64,
        /// The name of the column, or its number, from 1.
        column: String,
        /// The text of the cell.
        text: String,
    },
    /// The times do not increase.
    #[error(
        "line {line}, column {column}: the times must increase, and {time} comes after {before}"
    )]
    NotIncreasing {
        /// The number of the line, from 1.
        line: u64,
        /// The name of the column, or its number, from 1.
        column: String,
        /// The time of the line.
        time: f64,
        /// The time before it.
        before: f64,
    },
    /// The table is too short, or its slopes overflow.
    #[error(transparent)]
    Table(#[from] InputTableError),
}
