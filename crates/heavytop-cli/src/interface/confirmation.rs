//! The question before an output that is absurdly large.

use crate::Error;
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
    let large = || Error::Large { room: room.clone(), free: free.clone(), remedy: forecast.remedy };
    if !(io::stdin().is_terminal() && io::stderr().is_terminal()) {
        return Err(large());
    }
    let mut asked = io::stderr().lock();
    let question = format!("heavytop: the run would write about {room}, and {free}; go on? [y/N] ");
    let asked = asked.write_all(question.as_bytes()).and_then(|()| asked.flush());
    let mut answer = String::new();
    match asked.and_then(|()| io::stdin().read_line(&mut answer)) {
        Ok(_) if ["y", "yes"].contains(&answer.trim().to_lowercase().as_str()) => Ok(()),
        _ => Err(large()),
    }
}
