//! The command `section`: from a configuration to the table and the picture of a Poincaré section.

use super::orbits::orbit_accuracy::{OrbitAccuracy, orbit_accuracy};
use super::orbits::orbit_tiles::{Orbits, Stuck};
use super::picture::Picture;
use super::point_table::PointTable;
use super::section_summary::SectionSummary;
use super::settings::Settings;
use super::survey::Survey;
use crate::configuration::Config;
use crate::errors::Error;
use crate::files::place::require_folder;
use crate::files::{Kind, Output, OutputSet, Place};
use crate::formats::Metadata;
use crate::formats::recognition::{PAR1, is_parquet};
use crate::pictures::render;
use crate::runs::run_check::accuracy_warning;
use crate::supervision::tiled_run::{interrupted, resumable, threads};
use crate::supervision::warnings::warn;
use crate::supervision::{Held, Progress, TileOptions};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

/// How the table is recognised, in each of its formats.
const CSV: Kind<'_> = Kind::of_first_bytes("table of section", b"start,crossing,t,");
const PARQUET: Kind<'_> =
    Kind { name: "table of section", first: PAR1, is_whole: |_, file| is_parquet("section", file) };

/// The number of pixels per CSS pixel: 288 dots per inch.
const SCALE: f32 = 3.0;

/// Computes the section of the top or of the system of the configuration, and writes `section.csv`, `.parquet`, `.svg`
/// and `.png` into the folder `out`. If asked to, it continues from the finished starts of an interrupted section.
///
/// In the table of a system its coordinates stand for Π and Γ.
///
/// # Errors
/// If the request is wrong, another run writes the section, or there is an interrupted section that shall be neither
/// resumed nor discarded: then nothing is written. If a start cannot be followed: then `section.csv.partial` is kept.
/// If it was stopped, or a file cannot be written: then it can be resumed.
///
/// # Example
/// ```
/// use heavytop_cli::configuration::{Config, SectionConfig};
/// use heavytop_cli::commands::section::section;
/// use heavytop_cli::supervision::TileOptions;
/// let folder = tempfile::tempdir()?;
/// let small = SectionConfig { starts: 3, crossings: 5, ..SectionConfig::default() };
/// let config = Config { section: Some(small), ..Config::default() };
/// let summary = section(&config, folder.path(), &TileOptions::default())?;
/// assert_eq!(summary.points, 3 * (1 + 5));
/// assert!(summary.deviations.iter().all(|(_, deviation)| *deviation < 1e-9));
///
/// let kirchhoff: Config = toml::from_str(r#"
///     [system]
///     algebra = "se(3)"
///     hamiltonian = "(Pi1^2 + Pi2^2/2 + Pi3^2/3 + Gamma1^2 + Gamma2^2/2 + Gamma3^2/3)/2"
///     initial = { Pi = [1.0, 0.5, 0.3], Gamma = [0.6, 0.0, 0.8] }
///
///     [section]
///     surface = "Gamma3"
///     starts = 3
///     crossings = 5
///
///     [integrator]
///     step = 0.1
/// "#)?;
/// let summary = section(&kirchhoff, folder.path(), &TileOptions::default())?;
/// assert_eq!(summary.of["casimirs"]["c1"], "Pi·Gamma");
/// assert!(summary.deviations.iter().all(|(_, deviation)| *deviation < 1e-9));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn section(
    config: &Config,
    out: &Path,
    options: &TileOptions<'_>,
) -> Result<SectionSummary, Error> {
    let settings = Settings::of(config)?;
    let (survey, accuracy) = write(&settings, config, out, options)?;
    Ok(SectionSummary::new(&settings, &survey, accuracy, out))
}

/// Computes a section, writes its files, and returns its survey and the accuracy of some of its orbits.
fn write(
    settings: &Settings,
    config: &Config,
    out: &Path,
    options: &TileOptions<'_>,
) -> Result<(Survey, Option<OrbitAccuracy>), Error> {
    let config = settings.complete(config);
    let metadata = Metadata::new(&config)?;
    let orbits = Orbits::new(settings, &config, out)?;
    require_folder(out)?;
    let files = [
        ("section.csv", &CSV),
        ("section.parquet", &PARQUET),
        ("section.svg", &render::SVG),
        ("section.png", &render::PNG),
    ];
    options.safeguard.require_all(out, &files)?;
    let threads = threads(options.threads)?;
    let held = orbits.tiles.prepare(options)?;
    settings.problem.warnings().into_iter().for_each(warn);

    let progress = Progress::of(settings.limits.starts as u64, "starts", options.quiet);
    let done = AtomicU64::new(0);
    let count = |starts: usize| {
        let starts = starts as u64;
        progress.now(done.fetch_add(starts, Ordering::Relaxed) + starts, String::new());
    };
    let finished = threads.install(|| orbits.finish(options, count));
    drop(progress);

    let [csv, parquet, svg, png] = files.map(|(name, _)| out.join(name));
    if let Err(stuck) = finished {
        return Err(give_up(settings, &orbits, held, stuck, &csv));
    }
    let estimating = Progress::estimating(options.quiet);
    let estimate = || orbit_accuracy(settings, &orbits, &|| !options.stopped());
    let accuracy = threads.install(estimate).map_err(resumable)?;
    drop(estimating);
    if options.stopped() {
        return Err(interrupted());
    }
    let worst = accuracy.map(|accuracy| accuracy.worst);
    worst.as_ref().and_then(accuracy_warning).into_iter().for_each(warn);
    let metadata = metadata.with_error_estimate(worst.and_then(|worst| worst.error));
    let mut files = OutputSet::default();
    let written = write_points(settings, &orbits, &metadata, [&csv, &parquet], &mut files);
    let survey = written.map_err(resumable)?;
    let drawing = draw(settings, &orbits, &survey).map_err(resumable)?;
    let (drawing, pixels) = render::render(&drawing, SCALE)?;
    files.add(&svg, drawing.as_bytes()).map_err(resumable)?;
    files.add(&png, &pixels).map_err(resumable)?;
    files.complete().map_err(resumable)?;
    orbits.tiles.remove(held)?;
    Ok((survey, accuracy))
}

/// Writes the table, as CSV and as Parquet.
fn write_points(
    settings: &Settings,
    orbits: &Orbits<'_>,
    metadata: &Metadata,
    [csv, parquet]: [&Path; 2],
    files: &mut OutputSet,
) -> Result<Survey, Error> {
    let mut survey = Survey::new(settings);
    let mut text = Output::create(csv).map_err(Error::too_late)?;
    let mut table = PointTable::begin(&settings.header(), metadata, parquet)?;
    text.write(|to| writeln!(to, "{}", settings.header()))?;
    for tile in 0..orbits.count() {
        let (lines, orbits) = orbits.finished(tile)?;
        text.write(|to| to.write_all(lines.as_bytes()))?;
        for orbit in &orbits {
            survey.add(settings, orbit);
            table.add(orbit)?;
        }
    }
    files.push(text)?;
    files.push(table.whole()?)?;
    Ok(survey)
}

fn draw(settings: &Settings, orbits: &Orbits<'_>, survey: &Survey) -> Result<String, Error> {
    let mut picture = Picture::begin(settings, survey)?;
    for tile in 0..orbits.count() {
        orbits.finished(tile)?.1.iter().try_for_each(|orbit| picture.add(orbit))?;
    }
    picture.complete()
}

/// Ends a section that could not be finished.
///
/// If something outside the run failed, the run can be resumed from its tiles. If the numbers failed, they would fail
/// again, and the tiles are removed.
fn give_up(
    settings: &Settings,
    orbits: &Orbits<'_>,
    held: Held,
    stuck: Stuck,
    csv: &Path,
) -> Error {
    let kept = match &stuck.failure {
        Error::Interrupted { .. }
        | Error::Write { .. }
        | Error::Tile { .. }
        | Error::MissingTile { .. } => return resumable(stuck.failure),
        // A request that is refused has computed nothing.
        failure if failure.exit_code() == 1 => keep(settings, orbits, &stuck, csv).map(Some),
        _ => Ok(None),
    };
    match kept {
        Ok(partial) => {
            // It does no harm if they stay.
            let _ = orbits.tiles.remove(held);
            match partial {
                Some(partial) => Error::Kept { partial, source: Box::new(stuck.failure) },
                None => stuck.failure,
            }
        }
        // What cannot be written is lost; the error reports the first failure.
        Err(_) => stuck.failure,
    }
}

/// Keeps the points before the one that could not be reached as `section.csv.partial`.
fn keep(
    settings: &Settings,
    orbits: &Orbits<'_>,
    stuck: &Stuck,
    csv: &Path,
) -> Result<PathBuf, Error> {
    let mut text = Output::create(csv)?;
    text.write(|to| writeln!(to, "{}", settings.header()))?;
    for tile in 0..stuck.tile {
        let (lines, _) = orbits.finished(tile)?;
        text.write(|to| to.write_all(lines.as_bytes()))?;
    }
    text.write(|to| to.write_all(stuck.lines.as_bytes()))?;
    text.keep()?;
    Ok(Place::of(csv)?.beside("partial"))
}
