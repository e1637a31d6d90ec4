//! The command `sweep`: from a configuration to a table and pictures.

use super::judgements::impossible_members::impossible_members;
use super::judgements::worst_accuracy::{worst_accuracy, worst_warning};
use super::member_csv::{CSV, MemberCsv};
use super::member_table::MemberTable;
use super::member_tiles::Members;
use super::pictures::SweepPicture;
use super::processes::Processes;
use super::sweep_forecast::forecast;
use super::sweep_plan::Plan;
use super::sweep_summary::SweepSummary;
use crate::configuration::{Column, Config};
use crate::errors::Error;
use crate::files::place::require_folder;
use crate::files::{Kind, OutputSet};
use crate::formats::Metadata;
use crate::formats::recognition::{PAR1, is_parquet};
use crate::pictures::render;
use crate::supervision::tiled_run::{interrupted, resumable, threads};
use crate::supervision::warnings::warn;
use crate::supervision::{Forecast, Progress, TileOptions};
use std::path::{Path, PathBuf};

/// How the table is recognised.
const TABLE: Kind<'_> =
    Kind { name: "table of sweep", first: PAR1, is_whole: |_, file| is_parquet("sweep", file) };

/// The number of pixels per CSS pixel: 288 dots per inch.
const SCALE: f32 = 3.0;

/// Follows all tops of the configuration, or all motions of its system, and writes `sweep.parquet` into the folder `out`.
///
/// A grid with two axes also gets a heat map of each column, and a single axis a curve of each and the table as `sweep.csv`.
/// If asked to, it continues from the finished tiles of an
/// interrupted sweep.
///
/// Processes of an MPI job (feature `mpi`) share the work. The folder `out` must be on a file system that all of them
/// see, and only the first process returns the summary. No bit depends on the number of threads or processes. Memory
/// does not grow with the number of rows, except for the pictures.
///
/// # Errors
/// If the request is wrong, another run writes the sweep, or there is an interrupted sweep that shall be neither
/// resumed nor discarded: then nothing is written. If it was stopped, or a file cannot be written: then it can be
/// resumed. If all members fail: then the table is kept as `sweep.parquet.partial`. A single one that fails is no error:
/// its row says why.
///
/// # Example
/// ```
/// use heavytop_cli::configuration::Config;
/// use heavytop_cli::commands::sweep::sweep;
/// use heavytop_cli::supervision::TileOptions;
/// let folder = tempfile::tempdir()?;
/// let config: Config = toml::from_str(r#"
///     [system]
///     algebra = "so(3)"
///     hamiltonian = "½*(Π₁²/I₁ + Π₂²/I₂ + Π₃²/I₃)"
///     parameters = { I = [3, 2, 1] }
///     initial = { Pi = [0, 1, 0.1] }
///
///     [integrator]
///     end = 1.0
///
///     [sweep]
///     observables = ["invariant-drift"]
///     axes = [{ parameter = "system.parameters.I[0]", from = 2, to = 3, count = 3 },
///             { parameter = "system.initial.Pi[2]", from = 0, to = 1, count = 3 }]
/// "#)?;
/// let summary = sweep(&config, folder.path(), &TileOptions::default())?.ok_or("not the first process")?;
/// assert_eq!((summary.runs, summary.failed), (9, 0));
/// assert!(folder.path().join("drift_c1.png").exists());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sweep(
    config: &Config,
    out: &Path,
    options: &TileOptions<'_>,
) -> Result<Option<SweepSummary>, Error> {
    sweep_if(config, out, options, |_| Ok(()))
}

/// Sweeps as [`sweep`] does, if the caller agrees to the forecast. Only the first process of several asks, and only
/// where a sweep begins, not where it is resumed.
///
/// # Errors
/// Returns the errors of [`sweep`], and that of the caller: then nothing is written.
pub fn sweep_if(
    config: &Config,
    out: &Path,
    options: &TileOptions<'_>,
    agree: impl FnOnce(&Forecast) -> Result<(), Error>,
) -> Result<Option<SweepSummary>, Error> {
    let processes = Processes::join();
    let outcome = run(&processes, config, out, options, agree);
    processes.conclude(outcome)
}

fn run(
    processes: &Processes,
    config: &Config,
    out: &Path,
    options: &TileOptions<'_>,
    agree: impl FnOnce(&Forecast) -> Result<(), Error>,
) -> Result<Option<SweepSummary>, Error> {
    let (rank, size) = processes.place();
    let plan = Plan::new(config)?;
    let metadata = Metadata::new(&plan.config)?.with_casimirs(plan.family.casimirs());
    let members = Members::new(&plan, out)?;
    let threads = threads(options.threads)?;
    if rank == 0 {
        require_replaceable(&plan, out, options)?;
    }
    if rank == 0 && !options.resume {
        agree(&forecast(&plan, out))?;
    }
    // The first process holds the folder for all of them.
    let held = (rank == 0).then(|| members.tiles.prepare(options)).transpose()?;
    let estimate = || {
        let _shown = Progress::estimating(options.quiet);
        threads.install(|| worst_accuracy(&plan, &|| !options.stopped()))
    };
    let accuracy = (rank == 0).then(estimate).flatten();
    if rank == 0 && options.stopped() {
        // The table of tiles that are all finished would have no estimate.
        return Err(interrupted());
    }
    if rank == 0 {
        let family = plan.family.warnings().into_iter();
        let of_body = threads.install(|| impossible_members(&plan));
        let of_accuracy = accuracy.as_ref().and_then(|accuracy| worst_warning(&plan, accuracy));
        family.chain(of_body).chain(of_accuracy).for_each(warn);
    }
    let error_estimate = accuracy.and_then(|accuracy| accuracy.error);
    let metadata = metadata.with_error_estimate(error_estimate);
    processes.wait_for_all();
    let progress = Progress::of(plan.members, plan.nouns(), options.quiet || rank > 0);
    for tile in (rank..members.count()).step_by(size as usize) {
        threads.install(|| members.finish(tile, options)).map_err(resumable)?;
        progress.now(members.numbers(tile).end, String::new());
    }
    drop(progress);
    processes.wait_for_all();
    let Some(held) = held else { return Ok(None) };
    let assembled = assemble(&plan, &members, &metadata, out).map_err(resumable);
    if matches!(assembled, Ok(_) | Err(Error::Kept { .. })) {
        members.tiles.remove(held)?;
    }
    assembled.map(Some)
}

/// Checks that the tables and the pictures may be written.
fn require_replaceable(plan: &Plan, out: &Path, options: &TileOptions<'_>) -> Result<(), Error> {
    require_folder(out)?;
    let tables: [(&str, &Kind<'_>); 2] = [("sweep.parquet", &TABLE), ("sweep.csv", &CSV)];
    options.safeguard.require_all(out, if has_csv(plan) { &tables } else { &tables[..1] })?;
    let columns = plan.columns.iter().filter(|_| SweepPicture::of(plan).is_some());
    columns.map(|column| picture_files(column, out)).try_for_each(|[svg, png]| {
        options.safeguard.require(&svg, &render::SVG)?;
        options.safeguard.require(&png, &render::PNG)
    })
}

/// Returns whether a sweep has a table in CSV: one with curves. Of more members it would be large.
fn has_csv(plan: &Plan) -> bool {
    SweepPicture::of(plan) == Some(SweepPicture::Curve)
}

/// Returns the paths of the picture of a column.
fn picture_files(column: &Column, out: &Path) -> [PathBuf; 2] {
    ["svg", "png"].map(|ending| out.join(&column.name).with_extension(ending))
}

/// Makes the output files of all tiles.
///
/// If all members failed there are no pictures, and the table, which says why, does not get its final name.
fn assemble(
    plan: &Plan,
    members: &Members,
    metadata: &Metadata,
    out: &Path,
) -> Result<SweepSummary, Error> {
    let mut summary = SweepSummary::new(plan, metadata.error_estimate, out);
    let mut table = MemberTable::begin(plan, metadata, &out.join("sweep.parquet"))?;
    let csv = has_csv(plan).then(|| MemberCsv::begin(plan, &out.join("sweep.csv")));
    let mut csv = csv.transpose()?;
    members.each(|rows| {
        summary.add(&rows);
        csv.as_mut().map_or(Ok(()), |csv| csv.add(&rows))?;
        table.add(rows)
    })?;
    if let (true, Some(first)) = (summary.failed == plan.members, &summary.first_failure) {
        let (members, nouns) = (plan.members, plan.nouns());
        let failure = Error::AllFailed { members, nouns, first: first.clone() };
        return Err(Error::Kept { partial: table.keep()?, source: Box::new(failure) });
    }
    let mut files = OutputSet::default();
    files.push(table.whole()?)?;
    if let Some(csv) = csv {
        files.push(csv.whole())?;
    }
    if let Some(picture) = SweepPicture::of(plan) {
        draw(plan, picture, members, summary.failed, out, &mut files)?;
    }
    files.complete()?;
    Ok(summary)
}

/// Writes the picture of each column.
fn draw(
    plan: &Plan,
    picture: SweepPicture,
    members: &Members,
    failed: u64,
    out: &Path,
    files: &mut OutputSet,
) -> Result<(), Error> {
    for (index, column) in plan.columns.iter().enumerate() {
        let mut values: Vec<Option<f64>> = Vec::new();
        members.each(|rows| {
            values.extend(rows.iter().map(|row| row.value(index)));
            Ok(())
        })?;
        let drawing = picture.draw(plan, column, &values, failed)?;
        let (svg, png) = render::render(&drawing, SCALE)?;
        let [svg_file, png_file] = picture_files(column, out);
        files.add(&svg_file, svg.as_bytes())?;
        files.add(&png_file, &png)?;
    }
    Ok(())
}
