//! Parts of a sweep that are finished.

use super::measure::{Row, measure};
use super::plan::Plan;
use super::settings::SweepError;
use crate::Error;
use crate::output::Output;
use rayon::prelude::*;
use std::fmt::Write;
use std::fs;
use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// The tops of a tile. No bit depends on it.
const TILE: u64 = 256;

/// The folder of finished tiles, one file for each; it is there while the sweep is not finished.
///
/// A file has a line for each top: the values, separated by commas, nothing where there is none; a
/// tab; the failure.
#[derive(Debug)]
pub(super) struct Tiles<'a> {
    plan: &'a Plan,
    folder: PathBuf,
}

impl<'a> Tiles<'a> {
    /// The tiles of the sweep into this folder.
    pub fn new(plan: &'a Plan, out: &Path) -> Self {
        Self { plan, folder: out.join("sweep.partial") }
    }

    /// Makes the folder, or sees that it is one of this sweep.
    ///
    /// # Errors
    /// If there are tiles which shall not be used, or which are of another sweep.
    pub fn prepare(&self, resume: bool) -> Result<(), Error> {
        let refused = |source| Error::Create { path: self.folder.clone(), source };
        let identity = self.folder.join("identity");
        match fs::read_to_string(&identity) {
            Ok(_) if !resume => Err(SweepError::Unfinished { folder: self.folder.clone() }.into()),
            Ok(found) if found != self.plan.identity() => {
                Err(SweepError::Foreign { folder: self.folder.clone() }.into())
            }
            Ok(_) => Ok(()),
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                fs::create_dir_all(&self.folder).map_err(refused)?;
                Output::whole(&identity, self.plan.identity().as_bytes())
            }
            Err(source) => Err(Error::Tile { path: identity, source }),
        }
    }

    /// How many there are.
    pub fn count(&self) -> u64 {
        self.plan.tops.div_ceil(TILE)
    }

    /// The numbers of a tile's tops.
    pub fn tops(&self, tile: u64) -> Range<u64> {
        let first = tile * TILE;
        first..self.plan.tops.min(first + TILE)
    }

    fn file(&self, tile: u64) -> PathBuf {
        self.folder.join(format!("{tile:07}"))
    }

    /// Follows the tops of a tile on all threads, and keeps what comes of it.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn finish(&self, tile: u64) -> Result<(), Error> {
        let rows: Vec<Row> =
            self.tops(tile).into_par_iter().map(|number| measure(self.plan, number)).collect();
        let mut text = String::new();
        for row in rows {
            for (index, value) in row.values.iter().enumerate() {
                let comma = if index > 0 { "," } else { "" };
                // Writing to a string does not fail. The digits read back as the same number.
                let _ = match value {
                    Some(value) => write!(text, "{comma}{value:?}"),
                    None => write!(text, "{comma}"),
                };
            }
            let _ = writeln!(text, "\t{}", row.failure.as_deref().unwrap_or_default());
        }
        Output::whole(&self.file(tile), text.as_bytes())
    }

    /// What came of a tile; none if it is not finished.
    ///
    /// # Errors
    /// If it cannot be read.
    pub fn read(&self, tile: u64) -> Result<Option<Vec<Row>>, Error> {
        let path = self.file(tile);
        let text = match fs::read_to_string(&path) {
            Ok(text) => text,
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            Err(source) => return Err(Error::Tile { path, source }),
        };
        let tops = self.tops(tile);
        let rows: Option<Vec<Row>> = text.lines().map(|line| self.row(line)).collect();
        // What cannot be read has to be made again.
        Ok(rows.filter(|rows| rows.len() as u64 == tops.end - tops.start))
    }

    fn row(&self, line: &str) -> Option<Row> {
        let (numbers, failure) = line.split_once('\t')?;
        let number = |cell: &str| match cell {
            "" => Some(None),
            cell => cell.parse().ok().map(Some),
        };
        let values: Vec<Option<f64>> = numbers.split(',').map(number).collect::<Option<_>>()?;
        let failure = (!failure.is_empty()).then(|| failure.to_string());
        (values.len() == self.plan.columns().count()).then_some(Row { values, failure })
    }

    /// Removes the folder: the sweep is finished.
    ///
    /// # Errors
    /// If it cannot be removed.
    pub fn remove(&self) -> Result<(), Error> {
        let failed = |source| Error::Write { path: self.folder.clone(), source };
        fs::remove_dir_all(&self.folder).map_err(failed)
    }
}
