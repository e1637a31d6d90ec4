//! The starts of a section, computed in tiles that outlast an interruption.

use super::orbit::{Crossing, Orbit, orbit};
use crate::commands::section::settings::Settings;
use crate::configuration::Config;
use crate::errors::Error;
use crate::supervision::tiled_run::interrupted;
use crate::supervision::{TileOptions, Tiles};
use rayon::prelude::*;
use std::fmt::Write;
use std::ops::Range;
use std::path::Path;

/// The number of returns in a tile, unless a single start has more. No bit depends on it.
const TILE: usize = 256;

/// The starts of a section, which are followed tile by tile.
///
/// A tile has a line for each point, as in `section.csv`.
#[derive(Debug)]
pub(in crate::commands::section) struct Orbits<'a> {
    settings: &'a Settings,
    starts: Vec<Vec<f64>>,
    pub tiles: Tiles,
}

/// The failure of a tile whose starts could not be followed to the end, and their points until then.
pub(in crate::commands::section) struct Stuck {
    /// The number of the tile.
    pub tile: u64,
    /// The lines of the points.
    pub lines: String,
    /// The first error of the tile.
    pub failure: Error,
}

impl<'a> Orbits<'a> {
    /// Finds the starts of the settings; their tiles are below the folder `out`, for the configuration of the
    /// settings.
    ///
    /// # Errors
    /// If too few starts are found.
    pub fn new(settings: &'a Settings, config: &Config, out: &Path) -> Result<Self, Error> {
        let starts = settings.problem.starts(&settings.limits)?;
        Ok(Self { settings, starts, tiles: Tiles::new(out.join("section.partial"), config)? })
    }

    /// Returns a start, counted from 0.
    pub fn start(&self, start: usize) -> Option<&[f64]> {
        self.starts.get(start).map(Vec::as_slice)
    }

    /// Returns the number of tiles.
    pub fn count(&self) -> u64 {
        self.starts.len().div_ceil(self.size()) as u64
    }

    /// Returns the number of starts in a tile.
    fn size(&self) -> usize {
        (TILE / self.settings.limits.crossings).max(1)
    }

    /// Returns the starts of a tile, counted from 0.
    fn starts(&self, tile: u64) -> Range<usize> {
        let first = tile as usize * self.size();
        first..self.starts.len().min(first + self.size())
    }

    /// Follows the starts of all unfinished tiles on all threads; `done` receives the number of starts of each tile.
    ///
    /// If starts fail, the tiles before the first one that fails are finished nevertheless.
    ///
    /// # Errors
    /// Returns the error of the first tile that could not be finished.
    pub fn finish(
        &self,
        options: &TileOptions<'_>,
        done: impl Fn(usize) + Sync,
    ) -> Result<(), Stuck> {
        let stuck = (0..self.count()).into_par_iter().find_map_first(|tile| {
            let finished = self.finish_tile(tile, options);
            done(self.starts(tile).len());
            finished.err()
        });
        stuck.map_or(Ok(()), |stuck| Err(*stuck))
    }

    fn finish_tile(&self, tile: u64, options: &TileOptions<'_>) -> Result<(), Box<Stuck>> {
        let mut lines = String::new();
        let stuck = |lines, failure| Box::new(Stuck { tile, lines, failure });
        match self.read(tile) {
            Ok(Some(_)) => return Ok(()),
            Ok(None) if options.stopped() => return Err(stuck(lines, interrupted())),
            Ok(None) => {}
            Err(failure) => return Err(stuck(lines, failure)),
        }
        for index in self.starts(tile) {
            let (orbit, failure) = orbit(self.settings, options, index + 1, &self.starts[index]);
            write_lines(&mut lines, &orbit);
            if let Some(failure) = failure {
                return Err(stuck(lines, failure));
            }
        }
        self.tiles.write(tile, &lines).map_err(|failure| stuck(lines, failure))
    }

    /// Returns the lines of a finished tile, and its orbits.
    ///
    /// # Errors
    /// If the tile is missing.
    pub fn finished(&self, tile: u64) -> Result<(String, Vec<Orbit>), Error> {
        self.read(tile)?.ok_or_else(|| self.tiles.missing(tile))
    }

    /// Returns the finished orbit of a start, counted from 0.
    ///
    /// # Errors
    /// If its tile is missing.
    pub fn orbit(&self, start: usize) -> Result<Option<Orbit>, Error> {
        let tile = (start / self.size()) as u64;
        let (_, orbits) = self.finished(tile)?;
        Ok(orbits.into_iter().nth(start - self.starts(tile).start))
    }

    /// Reads a tile; `None` if it is unfinished or not what it should be.
    fn read(&self, tile: u64) -> Result<Option<(String, Vec<Orbit>)>, Error> {
        let Some(lines) = self.tiles.read(tile)? else { return Ok(None) };
        let orbits = self.parse(tile, &lines);
        Ok(orbits.map(|orbits| (lines, orbits)))
    }

    /// Parses the lines of a tile into orbits, one for each of its starts.
    fn parse(&self, tile: u64, lines: &str) -> Option<Vec<Orbit>> {
        let dimension = self.settings.problem.columns().len();
        let mut orbits: Vec<Orbit> = Vec::new();
        for line in lines.lines() {
            let (number, index, crossing) = point(line, dimension)?;
            if index == 0 {
                orbits.push(Orbit { number, crossings: Vec::new() });
            }
            let orbit = orbits.last_mut().filter(|orbit| {
                (orbit.number, orbit.crossings.len()) == (number, index)
                    && index <= self.settings.limits.crossings
            })?;
            orbit.crossings.push(crossing);
        }
        let numbers = orbits.iter().map(|orbit| orbit.number);
        numbers.eq(self.starts(tile).map(|index| index + 1)).then_some(orbits)
    }
}

/// Returns the numbers in the columns after the first two.
pub(in crate::commands::section) fn values(crossing: &Crossing) -> impl Iterator<Item = f64> {
    let Crossing { time, state, plane } = crossing;
    [*time].into_iter().chain(state.iter().copied()).chain(*plane)
}

fn write_lines(lines: &mut String, orbit: &Orbit) {
    for (index, crossing) in orbit.crossings.iter().enumerate() {
        // Writing to a string does not fail. The digits read back as the same number.
        let _ = write!(lines, "{},{index}", orbit.number);
        values(crossing).for_each(|value| {
            let _ = write!(lines, ",{value:?}");
        });
        lines.push('\n');
    }
}

/// Parses a line into the number of the start, the number of the crossing, and the point, whose state has a dimension.
fn point(line: &str, dimension: usize) -> Option<(usize, usize, Crossing)> {
    let (number, rest) = line.split_once(',')?;
    let (index, rest) = rest.split_once(',')?;
    let finite = |cell: &str| cell.parse().ok().filter(|value: &f64| value.is_finite());
    let values: Vec<f64> = rest.split(',').map(finite).collect::<Option<_>>()?;
    let [time, state @ .., x, y] = values.as_slice() else { return None };
    if state.len() != dimension {
        return None;
    }
    let crossing = Crossing { time: *time, state: state.to_vec(), plane: [*x, *y] };
    Some((number.parse().ok()?, index.parse().ok()?, crossing))
}
