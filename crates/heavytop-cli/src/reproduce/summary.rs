//! The table of largest deviations.

use super::record::{QUANTITIES, Record};
use crate::Error;
use std::io::{self, Write};
use std::path::Path;

/// `summary.csv`.
pub(super) fn csv(records: &[Record]) -> String {
    let mut text = String::from("formulation,scheme,step,end");
    for quantity in QUANTITIES {
        text += &format!(",{quantity}");
    }
    text.push('\n');
    for record in records {
        let run = &record.experiment;
        let (formulation, scheme) = (run.method.formulation().name(), run.method.scheme().name());
        let (step, end) = (run.schedule.step, run.schedule.end());
        text += &format!("{formulation},{scheme},{step:?},{end:?}");
        for deviation in record.deviations {
            text += &format!(",{deviation:?}");
        }
        text.push('\n');
    }
    text
}

/// Prints the table, and where the files are.
pub(super) fn print(records: &[Record], out: &Path) -> Result<(), Error> {
    match write(records, out, &mut io::stdout().lock()) {
        // Whoever closed the pipe has read enough.
        Err(source) if source.kind() != io::ErrorKind::BrokenPipe => {
            Err(Error::Write { path: "the summary".into(), source })
        }
        _ => Ok(()),
    }
}

fn write(records: &[Record], out: &Path, to: &mut impl Write) -> io::Result<()> {
    write!(to, "{:<12}{:<19}{:>8} {:>9}", "formulation", "scheme", "step", "end")?;
    for quantity in QUANTITIES {
        write!(to, "{:>12}", quantity.symbol())?;
    }
    writeln!(to)?;
    for record in records {
        let run = &record.experiment;
        let (formulation, scheme) = (run.method.formulation().name(), run.method.scheme().name());
        let (step, end) = (run.schedule.step, run.schedule.end());
        write!(to, "{formulation:<12}{scheme:<19}{step:>8} {end:>9}")?;
        for deviation in record.deviations {
            write!(to, "{deviation:>12.3e}")?;
        }
        writeln!(to)?;
    }
    writeln!(
        to,
        "max |quantity - initial value| over all steps; figures and tables are in {}",
        out.display()
    )
}
