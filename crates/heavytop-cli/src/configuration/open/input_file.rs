//! The table of an input in a file of its own.

use super::input_config::{InputConfig, failed};
use crate::errors::{Error, InputFileError};
use crate::files::bounded;
use csv::{ReaderBuilder, StringRecord, Trim};
use std::path::{Path, PathBuf};

/// The largest size of a file, in bytes.
const MOST_BYTES: u64 = 1 << 26;

impl InputConfig {
    /// Makes the path of the file of the table an absolute one, notes the checksum of its text, and returns the path; `None` if
    /// there is no file.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub(super) fn find_file(
        &mut self,
        name: &str,
        folder: &Path,
    ) -> Result<Option<PathBuf>, Error> {
        let Some(file) = &mut self.file else { return Ok(None) };
        let given = folder.join(&*file);
        let unread = |error: std::io::Error| failed(name, &given, InputFileError::Read(error));
        // From another folder a run is resumed, too.
        let path = std::path::absolute(&given).map_err(unread)?;
        let text = read(&path).map_err(|error| failed(name, &path, error))?;
        // A path that is no text was none in the configuration.
        *file = path.to_string_lossy().into_owned();
        self.checksum = Some(crc32fast::hash(text.as_bytes()));
        Ok(Some(path))
    }

    /// Replaces the file of the table, if there is one, by the times and values in it.
    ///
    /// # Errors
    /// Those of [`columns`](Self::columns).
    pub(super) fn read_file(&mut self, name: &str) -> Result<(), Error> {
        let Some(file) = &self.file else { return Ok(()) };
        let path = Path::new(file);
        let (times, values) = self.columns(path).map_err(|error| failed(name, path, error))?;
        *self = Self { times, values, interpolation: self.interpolation, ..Self::default() };
        Ok(())
    }

    /// Returns the times and the values in the file of the table.
    ///
    /// # Errors
    /// If the file cannot be read, has changed since its checksum was noted, or has no such columns of numbers with times that
    /// increase.
    pub(super) fn columns(&self, path: &Path) -> Result<(Vec<f64>, Vec<f64>), InputFileError> {
        let text = read(path)?;
        if self.checksum.is_some_and(|before| before != crc32fast::hash(text.as_bytes())) {
            return Err(InputFileError::Changed);
        }
        let mut reader = ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .comment(Some(b'#'))
            .trim(Trim::All)
            .from_reader(text.as_bytes());
        let mut rows = reader.records().peekable();
        let names = match rows.peek() {
            Some(Ok(first)) if !is_row(first) => first.iter().map(str::to_owned).collect(),
            _ => Vec::new(),
        };
        if !names.is_empty() {
            rows.next();
        }
        let (time, value) = self.places(&names)?;
        let (mut times, mut values): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
        for row in rows {
            let row = row.map_err(|error| InputFileError::Read(error.into()))?;
            let number = |place: usize| {
                number(&row, place).ok_or_else(|| no_number(&row, place, (&names, &text)))
            };
            let (now, value) = (number(time)?, number(value)?);
            if let Some(&before) = times.last().filter(|before| **before >= now) {
                let (line, column) = (line(&row, &text), label(time, &names));
                return Err(InputFileError::NotIncreasing { line, column, time: now, before });
            }
            times.push(now);
            values.push(value);
        }
        Ok((times, values))
    }

    /// Returns the places of the columns of times and of values: those of the names, or the first two.
    fn places(&self, names: &[String]) -> Result<(usize, usize), InputFileError> {
        let place = |wanted: &String| {
            let place = names.iter().position(|name| name == wanted);
            let missing = || InputFileError::NoColumn { name: wanted.clone(), has: names.to_vec() };
            place.ok_or_else(missing)
        };
        let time = self.time.as_ref().map_or(Ok(0), place)?;
        // The first column that is not that of the times.
        let value = self.value.as_ref().map_or(Ok(usize::from(time == 0)), place)?;
        Ok((time, value))
    }
}

fn read(path: &Path) -> Result<String, InputFileError> {
    bounded::read(path, MOST_BYTES).map_err(InputFileError::Read)
}

/// Returns whether a first line is one of numbers, and not one of names.
fn is_row(record: &StringRecord) -> bool {
    record.iter().any(|cell| cell.parse::<f64>().is_ok())
}

/// Returns the finite number in a cell.
fn number(record: &StringRecord, place: usize) -> Option<f64> {
    record.get(place)?.parse().ok().filter(|number: &f64| number.is_finite())
}

/// Returns the error of a cell without a number, in a text whose columns have these names.
fn no_number(
    record: &StringRecord,
    place: usize,
    (names, text): (&[String], &str),
) -> InputFileError {
    let (line, column) = (line(record, text), label(place, names));
    match record.get(place) {
        Some(text) => InputFileError::NoNumber { line, column, text: text.into() },
        None => InputFileError::NoCell { line, column, cells: record.len() },
    }
}

/// Returns the number of the line of a record in a text, from 1.
fn line(record: &StringRecord, text: &str) -> u64 {
    let Some(place) = record.position() else { return 0 };
    // The position is that before the lines that are left out.
    let rest = text.get(place.byte() as usize..).unwrap_or_default().lines();
    let left_out = rest.take_while(|line| line.is_empty() || line.starts_with('#'));
    place.line() + left_out.count() as u64
}

/// Returns the name of a column, or its number, from 1, in a file without names.
fn label(place: usize, names: &[String]) -> String {
    names.get(place).map_or_else(|| (place + 1).to_string(), Clone::clone)
}
