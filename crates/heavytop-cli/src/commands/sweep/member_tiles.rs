//! The members of a sweep, computed in tiles that outlast an interruption.

use super::measured_row::{Row, measure};
use super::sweep_plan::Plan;
use crate::errors::Error;
use crate::supervision::tiled_run::interrupted;
use crate::supervision::{TileOptions, Tiles};
use rayon::prelude::*;
use std::fmt::Write;
use std::ops::Range;
use std::path::Path;

/// The number of members in a tile. No bit depends on it.
const TILE: u64 = 256;

/// The members of a sweep, which are followed tile by tile.
///
/// A tile has a line for each member: the values, separated by commas, nothing where there is none; a
/// tab; the failure.
#[derive(Debug)]
pub(super) struct Members<'a> {
    plan: &'a Plan,
    pub tiles: Tiles,
}

impl<'a> Members<'a> {
    /// Creates the tiles of the plan below the folder `out`.
    ///
    /// # Errors
    /// If the configuration cannot be written as TOML.
    pub fn new(plan: &'a Plan, out: &Path) -> Result<Self, Error> {
        Ok(Self { plan, tiles: Tiles::new(out.join("sweep.partial"), &plan.config)? })
    }

    /// Returns the number of tiles.
    pub fn count(&self) -> u64 {
        self.plan.members.div_ceil(TILE)
    }

    /// Returns the numbers of the members of a tile.
    pub fn numbers(&self, tile: u64) -> Range<u64> {
        let first = tile * TILE;
        first..self.plan.members.min(first + TILE)
    }

    /// Follows the members of a tile on all threads and keeps their rows, unless the tile is finished already.
    ///
    /// # Errors
    /// If the run was stopped, or the tile cannot be written.
    pub fn finish(&self, tile: u64, options: &TileOptions<'_>) -> Result<(), Error> {
        if self.read(tile)?.is_some() {
            return Ok(());
        }
        let unless_stopped = |number| (!options.stopped()).then(|| measure(self.plan, number));
        let rows: Option<Vec<Row>> =
            self.numbers(tile).into_par_iter().map(unless_stopped).collect();
        let mut text = String::new();
        for row in rows.ok_or_else(interrupted)? {
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
        self.tiles.write(tile, &text)
    }

    /// Passes the rows of each tile to `visit`, in order. All tiles must be finished.
    ///
    /// # Errors
    /// If a tile is not finished, or `visit` fails.
    pub fn each(&self, mut visit: impl FnMut(Vec<Row>) -> Result<(), Error>) -> Result<(), Error> {
        (0..self.count())
            .try_for_each(|tile| visit(self.read(tile)?.ok_or_else(|| self.tiles.missing(tile))?))
    }

    /// Reads the rows of a tile; `None` if it is unfinished or not what it should be.
    fn read(&self, tile: u64) -> Result<Option<Vec<Row>>, Error> {
        let Some(text) = self.tiles.read(tile)? else { return Ok(None) };
        let rows: Option<Vec<Row>> = text.lines().map(|line| self.row(line)).collect();
        let numbers = self.numbers(tile);
        Ok(rows.filter(|rows| rows.len() as u64 == numbers.end - numbers.start))
    }

    fn row(&self, line: &str) -> Option<Row> {
        let (numbers, failure) = line.split_once('\t')?;
        let number = |cell: &str| match cell {
            "" => Some(None),
            cell => cell.parse().ok().map(Some),
        };
        let values: Vec<Option<f64>> = numbers.split(',').map(number).collect::<Option<_>>()?;
        let failure = (!failure.is_empty()).then(|| failure.to_string());
        (values.len() == self.plan.columns.len()).then_some(Row { values, failure })
    }
}
