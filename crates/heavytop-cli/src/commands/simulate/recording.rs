//! The recording of a run: its rows on their way to the output.

use super::checkpoints::checkpoint::{self, Checkpoint};
use super::checkpoints::growing_file::Growing;
use super::simulate_options::SimulateOptions;
use crate::configuration::Config;
use crate::errors::{CheckpointError, Error};
use crate::files::{Input, Output, Place};
use crate::formats::recognition::ROWS;
use crate::formats::{Extent, Format, Metadata, RunTable};
use crate::runs::{Pace, Saved};
use crate::supervision::tiled_run::RESUME;
use lie_poisson_runs::RunFailure;
use std::fs;
use std::path::{Path, PathBuf};

/// The file to which a run appends its rows.
///
/// It is `NAME.partial` for CSV, `NAME.rows` for formats that are made of the rows at the end, and the output itself
/// if that is a device. Unless it is a device it is locked. The run that has the lock writes the output and keeps the
/// checkpoint.
pub(super) struct Recording {
    place: Place,
    format: Format,
    table: RunTable,
    config: Config,
    metadata: Metadata,
    rows: Growing,
}

/// What a recording needs to know of a run.
pub(super) struct RecordedRun<'a> {
    pub pace: Pace,
    /// The number of coordinates of the state that the integrator advances.
    pub dimension: usize,
    /// The number of steps at whose multiples the run can be resumed.
    pub resumable_after: u64,
    pub table: &'a RunTable,
    /// The Casimirs of a system, as formulas.
    pub casimirs: Vec<String>,
}

impl Recording {
    /// Begins a recording, from the first row or from a checkpoint.
    ///
    /// # Errors
    /// If another run writes the output, or there is a checkpoint that shall neither be resumed nor discarded, or one
    /// that cannot be resumed: then nothing is changed.
    pub fn begin(
        out: &Path,
        config: &Config,
        run: &RecordedRun<'_>,
        options: &SimulateOptions<'_>,
    ) -> Result<Self, Error> {
        let (format, place) = (Format::of(out)?, Place::of(out)?);
        let RecordedRun { pace, dimension, resumable_after, table, casimirs } = run;
        format.require_columns(table)?;
        require_replaceable(out, &place, (format, table), options)?;
        let metadata = Metadata::new(config)?.with_casimirs(casimirs.clone());
        let path = match format {
            _ if place.is_device => place.path.clone(),
            Format::Csv => place.beside("partial"),
            Format::Npz | Format::Parquet => place.beside("rows"),
        };
        let rows = match options.resume {
            Some(checkpoint) => {
                let steps = pace.schedule.steps;
                checkpoint
                    .require(config, format, out)
                    .and_then(|()| {
                        checkpoint.require_possible((steps, *resumable_after), *dimension, table)
                    })
                    .and_then(|()| reopen(path, checkpoint, pace, format, table))
                    .map_err(|source| Error::Checkpoint { path: checkpoint.path.clone(), source })?
            }
            None => {
                let mut rows = anew(&place, path, options.restart)?;
                rows.append(|bytes| bytes.extend_from_slice(format.start(table).as_bytes()))?;
                rows
            }
        };
        let (table, config) = ((*table).clone(), config.clone());
        Ok(Self { place, format, table, config, metadata, rows })
    }

    /// Adds the estimated error of the run to its metadata, which are written at the end.
    pub fn add_estimate(&mut self, error: Option<f64>) {
        self.metadata.error_estimate = error;
    }

    /// Makes a checkpoint and returns its path; a device has none.
    pub fn save(&mut self, saved: Saved, deviations: &[f64]) -> Result<Option<PathBuf>, Error> {
        let Some(path) = self.checkpoint() else { return Ok(None) };
        let rows = self.rows.mark()?;
        Checkpoint::new(&self.config, self.format, saved, deviations, rows).write(&path)?;
        Ok(Some(path))
    }

    fn checkpoint(&self) -> Option<PathBuf> {
        (!self.place.is_device).then(|| self.place.beside("checkpoint"))
    }

    pub fn append(&mut self, row: &[f64]) -> Result<(), Error> {
        let format = self.format;
        self.rows.append(|bytes| format.append(row, bytes))
    }

    /// Gives the output its name if the run succeeded.
    ///
    /// If the run failed, its rows are kept as `NAME.partial`. If it can continue from a checkpoint, the rows are
    /// kept for that. If it was refused, nothing is kept.
    pub fn conclude(mut self, outcome: Result<(), Error>) -> Result<(), Error> {
        let checkpoint = self.checkpoint().filter(|path| path.exists());
        let concluded = match outcome {
            Ok(()) => self.complete(),
            // A run that failed would fail there again.
            Err(
                failure @ Error::Run(RunFailure::Integration { .. } | RunFailure::NoValue { .. }),
            ) => {
                remove_checkpoint(&self.place);
                return Err(self.keep(failure));
            }
            Err(failure) => Err(failure),
        };
        match (concluded, checkpoint) {
            (Ok(()), _) => {
                remove_checkpoint(&self.place);
                Ok(())
            }
            (Err(interrupted @ Error::Interrupted { .. }), _) => Err(interrupted),
            (Err(failure), Some(_)) => {
                Err(Error::Resumable { resume: RESUME.into(), source: Box::new(failure) })
            }
            (Err(failure), None) if failure.exit_code() == 1 => Err(self.keep(failure)),
            (Err(refusal), None) => {
                self.discard();
                Err(refusal)
            }
        }
    }

    fn complete(&mut self) -> Result<(), Error> {
        if self.place.is_device {
            return self.rows.flush();
        }
        self.rows.mark()?;
        if self.format == Format::Csv {
            let renamed = fs::rename(self.rows.path(), &self.place.path);
            return renamed.map_err(|source| self.unwritten(source));
        }
        self.converted()?.complete()?;
        self.discard();
        Ok(())
    }

    /// Turns the rows so far into `NAME.partial`; where the disk is too full for that, the rows stay as they are.
    fn keep(mut self, failure: Error) -> Error {
        if self.place.is_device {
            return failure;
        }
        let mut partial = self.place.beside("partial");
        if self.format == Format::Csv {
            self.rows.keep_lines();
        } else {
            // What cannot be written any more is lost; the error reports the first failure.
            let _ = self.rows.flush();
            match self.converted().and_then(Output::keep) {
                Ok(()) => self.discard(),
                Err(_) => partial = self.rows.path().into(),
            }
        }
        Error::Kept { partial, source: Box::new(failure) }
    }

    /// Makes the output from the rows, before it has its name.
    fn converted(&self) -> Result<Output, Error> {
        let mut output = Output::create(&self.place.path).map_err(Error::too_late)?;
        self.format.convert(self.rows.file(), &self.table, &self.metadata, &mut output)?;
        Ok(output)
    }

    /// Removes the growing file, unless it is a device.
    fn discard(&self) {
        if !self.place.is_device {
            remove(self.rows.path());
        }
    }

    fn unwritten(&self, source: std::io::Error) -> Error {
        Error::Write { path: self.place.path.clone(), source }
    }
}

/// Checks that the output, and what is written and removed on the way to it, may be replaced.
///
/// # Errors
/// If one of the files is an input, or one that the program has not written.
fn require_replaceable(
    out: &Path,
    place: &Place,
    (format, table): (Format, &RunTable),
    options: &SimulateOptions<'_>,
) -> Result<(), Error> {
    let beginning = table.beginning();
    let kind = format.kind(&beginning);
    let read = options.resume.map(|checkpoint| Input::File(checkpoint.path.clone()));
    let with_checkpoint = read.map(|read| options.safeguard.and(read));
    let safeguard = with_checkpoint.as_ref().unwrap_or(options.safeguard);
    match options.resume {
        // The other formats are made at the end, in a new file.
        Some(_) if !place.is_device && format == Format::Csv => {
            safeguard.require_resumed(out, &kind)?;
        }
        _ => safeguard.require(out, &kind)?,
    }
    if place.is_device {
        return Ok(());
    }
    if format != Format::Csv {
        let rows = place.beside("rows");
        // The checksum in a checkpoint tells whether the rows are those before it.
        match options.resume {
            Some(_) => safeguard.require_other(&rows)?,
            None => safeguard.require_unfinished(&rows, &ROWS)?,
        }
    }
    // The checkpoint that is read is the one that is renewed.
    options.safeguard.require_unfinished(&place.beside("checkpoint"), &checkpoint::KIND)?;
    safeguard.require_unfinished(&place.beside("checkpoint.partial"), &checkpoint::KIND)
}

/// Removes the checkpoint, and the incomplete one of a run that was killed while it wrote it.
fn remove_checkpoint(place: &Place) {
    if !place.is_device {
        remove(&place.beside("checkpoint"));
        remove(&place.beside("checkpoint.partial"));
    }
}

/// Removes a file that is of no use any more, if it exists; it does no harm if it stays.
fn remove(path: &Path) {
    let _ = fs::remove_file(path);
}

/// Creates the growing file, empty. This run has its lock before anything is removed.
fn anew(place: &Place, path: PathBuf, restart: bool) -> Result<Growing, Error> {
    let is_there = path.exists();
    let file = place.open(&path)?;
    let checkpoint = place.beside("checkpoint");
    if !place.is_device && !restart && checkpoint.exists() {
        if !is_there {
            remove(&path);
        }
        return Err(Error::Unfinished { path: checkpoint, resume: RESUME.into() });
    }
    if place.is_device {
        return Ok(Growing::on_device(path, file));
    }
    // The old checkpoint would be for another run.
    remove_checkpoint(place);
    let refused = |source| Error::Create { path: place.path.clone(), source };
    Growing::new(path, file).map_err(refused)
}

/// Reopens the rows before a checkpoint, to continue from them.
fn reopen(
    path: PathBuf,
    checkpoint: &Checkpoint,
    pace: &Pace,
    format: Format,
    table: &RunTable,
) -> Result<Growing, CheckpointError> {
    let kept = pace.kept(checkpoint.saved().step);
    let is_right = |extent: &Extent| format.rows(table, extent) == Some(kept);
    match Growing::reopen(path.clone(), &checkpoint.rows, is_right) {
        Ok(Some(rows)) => Ok(rows),
        Ok(None) => Err(CheckpointError::OtherRows { path }),
        Err(source) => Err(CheckpointError::Rows { path, source }),
    }
}
