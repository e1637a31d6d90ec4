//! The command `export`: reads an archive of arrays and writes a file for each sample.

use super::export_summary::ExportSummary;
use crate::errors::{Error, FieldFileError};
use crate::fields::archive::Archive;
use crate::fields::field_file::failed;
use crate::fields::{image_data, ovf};
use crate::files::place::require_folder;
use crate::files::{Kind, Output, contains};
use crate::supervision::{Progress, Watch};
use clap::ValueEnum;
use std::fs;
use std::path::Path;

/// The format of another program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ExportFormat {
    /// Image data of VTK, for ParaView: NAME_000000.vti and so on, and NAME.pvd for all of them.
    Vti,
    /// The vector field format of OOMMF and Ubermag: NAME_000000.ovf and so on.
    Ovf,
}

impl ExportFormat {
    fn ending(self) -> &'static str {
        match self {
            Self::Vti => "vti",
            Self::Ovf => "ovf",
        }
    }

    /// How a file of the format is recognised that this command has written.
    fn kind(self) -> Kind<'static> {
        let name = "file of export";
        match self {
            Self::Vti => Kind {
                name,
                first: b"<?xml ",
                is_whole: |head, _| Ok(contains(head, image_data::COMMENT)),
            },
            Self::Ovf => Kind {
                name,
                first: b"# OOMMF OVF 2.0",
                is_whole: |head, _| Ok(contains(head, ovf::TITLE)),
            },
        }
    }
}

/// Writes every `every`-th sample, and the last one, of each array of vectors in the archive `run` to the folder `out`.
///
/// The archive may be larger than the memory: one sample is in it at a time.
///
/// # Errors
/// If the archive cannot be read or has no vectors on a lattice of one to three dimensions, a file cannot be written, or
/// one exists that this command has not written.
pub fn export(
    run: &Path,
    out: &Path,
    format: ExportFormat,
    every: u64,
    watch: &Watch<'_>,
) -> Result<ExportSummary, Error> {
    if every == 0 {
        return Err(Error::OutOfRange { name: "every", range: "at least 1", value: 0.0 });
    }
    require_folder(out)?;
    let read = |error| failed(run, error);
    let mut archive = Archive::open(run).map_err(read)?;
    let times = archive.numbers("t").map_err(read)?;
    let fields = fields(&mut archive, times.len()).map_err(read)?;
    fs::create_dir_all(out).map_err(|source| Error::Create { path: out.into(), source })?;
    let mut samples = 0;
    for (name, shape) in &fields {
        let (header, mut file) = archive.array(name).map_err(read)?;
        let progress = Progress::of(times.len() as u64, "samples", watch.quiet);
        let (mut numbers, mut files) = (vec![0.0; shape.iter().product()], Vec::new());
        for (number, time) in times.iter().enumerate() {
            watch.require_going()?;
            progress.at(number as u64);
            header.fill(&mut file, &mut numbers).map_err(|error| read(error.into()))?;
            if !(number as u64).is_multiple_of(every) && number + 1 != times.len() {
                continue;
            }
            let own = format!("{name}_{number:06}.{}", format.ending());
            let path = out.join(&own);
            watch.safeguard.require(&path, &format.kind())?;
            let mut output = Output::create(&path)?;
            output.write(|to| match format {
                ExportFormat::Vti => image_data::write(to, (name, *time), shape, &numbers),
                ExportFormat::Ovf => ovf::write(to, (name, *time), shape, &numbers),
            })?;
            output.complete()?;
            files.push((*time, own));
        }
        samples = files.len() as u64;
        if format == ExportFormat::Vti {
            let path = out.join(format!("{name}.pvd"));
            watch.safeguard.require(&path, &format.kind())?;
            Output::whole(&path, image_data::collection(&files).as_bytes())?;
        }
    }
    let arrays = fields.into_iter().map(|(name, _)| name).collect();
    Ok(ExportSummary { out: out.into(), arrays, samples })
}

/// Returns the name and the shape of each array of vectors on a lattice, of so many samples.
fn fields(
    archive: &mut Archive,
    samples: usize,
) -> Result<Vec<(String, Vec<usize>)>, FieldFileError> {
    let (mut fields, names) = (Vec::new(), archive.names());
    for name in &names {
        let Ok((header, _)) = archive.array(name) else { continue };
        let [count, cells @ .., 3] = &header.shape[..] else { continue };
        if *count != samples || !(1..=3).contains(&cells.len()) || cells.contains(&0) {
            continue;
        }
        // The name becomes that of files, and stands in their headers.
        if !name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '-') {
            let text = format!("the array {name:?} needs a name of letters, digits, _ and -");
            return Err(FieldFileError::Format(text));
        }
        fields.push((name.clone(), header.shape.get(1..).unwrap_or_default().to_vec()));
    }
    match fields.is_empty() {
        true => Err(FieldFileError::Format(format!(
            "it has no vectors on a lattice of one to three dimensions among {}",
            names.join(", ")
        ))),
        false => Ok(fields),
    }
}
