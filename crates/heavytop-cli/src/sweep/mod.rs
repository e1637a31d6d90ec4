//! `heavytop sweep`: many tops at once.

mod heat_map;
mod measure;
mod observable;
mod parameter;
mod plan;
mod processes;
mod settings;
mod summary;
mod table;
mod tiles;

use crate::Error;
use crate::config::Config;
use crate::formats::Metadata;
use crate::output::Output;
use crate::progress::Progress;
use crate::render;
use measure::Row;
use plan::Plan;
use processes::Processes;
use std::io::{self, Write};
use std::path::Path;
use tiles::Tiles;

pub use observable::{Column, Observable};
pub use parameter::{Parameter, Part};
pub use settings::{AxisConfig, SweepConfig, SweepError};
pub use summary::Summary;

/// Pixels per CSS pixel: 288 dots per inch.
const SCALE: f32 = 3.0;

/// Follows all tops of the configuration; writes `sweep.parquet` into the folder `out`, with a heat map of
/// each column for a grid with two axes. With `resume` it goes on from the finished tiles of an
/// interrupted sweep.
///
/// Processes of an MPI job (feature `mpi`) share the work; `out` must be on a file system that all
/// of them see, and the first of them alone has the summary. No bit depends on the number of threads
/// or processes.
///
/// # Errors
/// If the request is wrong, in which case nothing is written, or a file cannot be written. A top that
/// fails is no error: its row says why.
///
/// # Example
/// ```
/// use heavytop_cli::config::{Config, IntegratorConfig};
/// use heavytop_cli::sweep::{Observable, SweepConfig, sweep};
/// let folder = tempfile::tempdir()?;
/// let mut map = SweepConfig { observables: vec![Observable::Sali], ..SweepConfig::default() };
/// map.axes.iter_mut().for_each(|axis| axis.count = Some(3));
/// let integrator = Some(IntegratorConfig { end: 1.0, ..IntegratorConfig::default() });
/// let config = Config { sweep: Some(map), integrator, ..Config::default() };
/// let summary = sweep(&config, folder.path(), false, true)?.ok_or("not the first process")?;
/// assert_eq!((summary.tops, summary.failed), (9, 0));
/// assert!(folder.path().join("sali.png").exists());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sweep(
    config: &Config,
    out: &Path,
    resume: bool,
    quiet: bool,
) -> Result<Option<Summary>, Error> {
    let processes = Processes::join();
    let outcome = run(&processes, config, out, resume, quiet);
    processes.conclude(outcome)
}

fn run(
    processes: &Processes,
    config: &Config,
    out: &Path,
    resume: bool,
    quiet: bool,
) -> Result<Option<Summary>, Error> {
    let (rank, size) = processes.place();
    let (plan, metadata) = (Plan::new(config)?, Metadata::new(config)?);
    let tiles = Tiles::new(&plan, out);
    if rank == 0 {
        tiles.prepare(resume)?;
        if let Some(warning) = plan.method.warning() {
            // Where stderr is closed nobody can be warned.
            let _ = writeln!(io::stderr(), "heavytop: {warning}");
        }
    }
    processes.wait_for_all();
    let progress = Progress::of(plan.tops, "tops", quiet || rank > 0);
    for tile in (rank..tiles.count()).step_by(size as usize) {
        if tiles.read(tile)?.is_none() {
            tiles.finish(tile)?;
        }
        progress.now(tiles.tops(tile).end, String::new());
    }
    drop(progress);
    processes.wait_for_all();
    if rank > 0 {
        return Ok(None);
    }
    let rows = assemble(&plan, &tiles, &metadata, out)?;
    Ok(Some(Summary::new(&plan, &rows, out)))
}

/// Makes the files of all tiles.
fn assemble(
    plan: &Plan,
    tiles: &Tiles,
    metadata: &Metadata,
    out: &Path,
) -> Result<Vec<Row>, Error> {
    let mut rows: Vec<Row> = Vec::new();
    for tile in 0..tiles.count() {
        let of_tile = tiles.read(tile)?;
        rows.extend(of_tile.ok_or_else(|| Error::MissingTile { tile, folder: out.into() })?);
    }
    table::write(plan, &rows, metadata, &out.join("sweep.parquet"))?;
    for (index, column) in plan.columns().enumerate() {
        let values: Vec<Option<f64>> =
            rows.iter().map(|row| row.values.get(index).copied().flatten()).collect();
        if let Some(drawing) = heat_map::heat_map(plan, column, &values)? {
            let (svg, png) = render::render(&drawing, SCALE)?;
            Output::whole(&out.join(column.name).with_extension("svg"), svg.as_bytes())?;
            Output::whole(&out.join(column.name).with_extension("png"), &png)?;
        }
    }
    tiles.remove()?;
    Ok(rows)
}
