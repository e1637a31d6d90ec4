//! The question before an output that is absurdly large.

use crate::errors::Error;
use crate::files::Place;
use crate::supervision::Forecast;
use crate::supervision::forecast::size;
use std::io::{self, IsTerminal, Write};
use std::path::Path;

/// The size above which an output is absurdly large, bytes, whatever room there is.
const LARGE: u64 = 100_000_000_000;

/// Asks before a run that needs more room than the disk has, or more than 100 GB. `yes` answers the question.
///
/// # Errors
/// If the user says no, or cannot be asked since stdin or stderr is no terminal.
pub(super) fn confirm(forecast: &Forecast, yes: bool) -> Result<(), Error> {
    // A link leads to the disk of its target, and a folder that is to be made is on the disk of the one above it.
    let out = Place::of(&forecast.out).map_or(forecast.out.clone(), |place| place.path);
    let folder = out.ancestors().find(|path| path.is_dir()).unwrap_or(Path::new("."));
    // Where the file system does not tell, the stated bound has to do.
    let free = fs4::available_space(folder).ok();
    let bound = free.unwrap_or(LARGE).min(LARGE);
    if yes || forecast.room <= bound {
        return Ok(());
    }
    let room = size(forecast.room);
    let free =
        free.map_or("free disk space is unknown".into(), |free| format!("{} are free", size(free)));
    let question = format!("heavytop: the run would write about {room}, and {free}; go on? [y/N] ");
    match is_agreed(&question) {
        Ok(true) => Ok(()),
        _ => Err(Error::Large { room, free, remedy: forecast.remedy }),
    }
}

/// Returns whether the user is at a terminal and answers a question with yes.
fn is_agreed(question: &str) -> io::Result<bool> {
    if !(io::stdin().is_terminal() && io::stderr().is_terminal()) {
        return Ok(false);
    }
    let mut asked = io::stderr().lock();
    asked.write_all(question.as_bytes())?;
    asked.flush()?;
    let mut answer = String::new();
    io::stdin().read_line(&mut answer)?;
    Ok(["y", "yes"].contains(&answer.trim().to_lowercase().as_str()))
}
