//! `heavytop section`: Poincaré sections on an energy level.

mod orbit;
mod picture;
mod report;
mod settings;

use crate::Error;
use crate::config::Config;
use crate::output::Output;
use crate::progress::Progress;
use crate::render;
use settings::Settings;
use std::io::Write;
use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};

pub use report::Summary;
pub use settings::SectionConfig;

/// Pixels per CSS pixel: 288 dots per inch.
const SCALE: f32 = 3.0;

/// Finds the section of the configuration, and writes `section.csv`, `.svg` and `.png` into the
/// folder `out`.
///
/// # Errors
/// If the request is wrong, in which case nothing is written; or a start cannot be followed, in
/// which case `section.csv.partial` is kept.
///
/// # Example
/// ```
/// use heavytop_cli::config::Config;
/// use heavytop_cli::section::section;
/// let folder = tempfile::tempdir()?;
/// let mut config = Config::default();
/// (config.section.starts, config.section.crossings) = (3, 5);
/// let summary = section(&config, folder.path(), true)?;
/// assert_eq!(summary.points, 3 * (1 + 5));
/// assert!(summary.h < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn section(config: &Config, out: &Path, quiet: bool) -> Result<Summary, Error> {
    let settings = Settings::new(config)?;
    let starts = settings.section.starts(settings.starts, settings.seed)?;
    std::fs::create_dir_all(out).map_err(|source| Error::Create { path: out.into(), source })?;
    let file = |ending| out.join("section").with_extension(ending);
    let mut table = Output::create(&file("csv"))?;
    if let Some(warning) = settings.method.warning() {
        // Where stderr is closed nobody can be warned.
        let _ = writeln!(std::io::stderr(), "heavytop: {warning}");
    }

    let progress = Progress::of(starts.len() as u64, "starts", quiet);
    let done = AtomicU64::new(0);
    let mut orbits = orbit::orbits(&settings, &starts, || {
        progress.now(done.fetch_add(1, Ordering::Relaxed) + 1, String::new());
    })?;
    drop(progress);

    let written = report::write_table(&mut orbits, &mut table);
    table.conclude(written)?;
    let (svg, png) = render::render(&picture::picture(&settings.section, &orbits), SCALE)?;
    Output::whole(&file("svg"), svg.as_bytes())?;
    Output::whole(&file("png"), &png)?;
    Ok(Summary::new(&settings, &orbits, out))
}
