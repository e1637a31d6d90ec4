//! The table, and what to take for which accuracy.

use super::label;
use super::measure::{Measurement, Reference};
use crate::Error;
use std::io::{self, Write};
use std::path::Path;

const TARGETS: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];

/// `work-precision.csv`.
pub(super) fn csv(measurements: &[Measurement]) -> String {
    let mut text = String::from("formulation,scheme,step,end,error,seconds,h,f1,f2\n");
    for Measurement { method, step, end, outcome } in measurements {
        let (formulation, scheme) = (method.formulation().name(), method.scheme().name());
        let [h, f1, f2] = outcome.deviations;
        text += &format!(
            "{formulation},{scheme},{step:?},{end:?},{:?},{:?},{h:?},{f1:?},{f2:?}\n",
            outcome.error, outcome.seconds
        );
    }
    text
}

/// Prints a line for each target accuracy, and where the files are.
pub(super) fn print(
    measurements: &[Measurement],
    reference: &Reference,
    out: &Path,
) -> Result<(), Error> {
    match write(measurements, reference, out, &mut io::stdout().lock()) {
        // Whoever closed the pipe has read enough.
        Err(source) if source.kind() != io::ErrorKind::BrokenPipe => {
            Err(Error::Write { path: "the recommendations".into(), source })
        }
        _ => Ok(()),
    }
}

fn write(
    measurements: &[Measurement],
    reference: &Reference,
    out: &Path,
    to: &mut impl Write,
) -> io::Result<()> {
    for target in TARGETS {
        write!(to, "error {target:e}: ")?;
        if target < reference.uncertainty {
            writeln!(to, "the reference is not as certain")?;
            continue;
        }
        match (fastest(measurements, target, false), fastest(measurements, target, true)) {
            (None, _) => writeln!(to, "none reaches it with these steps")?,
            (Some(any), Some(poisson)) if any == poisson => {
                writeln!(to, "fastest {}, which is Poisson", describe(any))?;
            }
            (Some(any), poisson) => {
                let poisson = poisson.map_or_else(|| "none".into(), describe);
                writeln!(to, "fastest {}; fastest Poisson {poisson}", describe(any))?;
            }
        }
    }
    writeln!(
        to,
        "error: 2-norm of that of (Pi, Gamma) at t = {} s; the reference is certain to {:.0e}\n\
         time: computing time per simulated second; figure and table are in {}",
        reference.end,
        reference.uncertainty,
        out.display()
    )
}

/// The fastest run whose error is at most `target`; of Poisson maps alone, if asked for.
fn fastest(measurements: &[Measurement], target: f64, poisson: bool) -> Option<&Measurement> {
    let eligible = |m: &&Measurement| {
        let is_poisson = m.method.formulation().is_poisson(m.method.scheme());
        m.outcome.error <= target && (is_poisson || !poisson)
    };
    let seconds = |m: &&Measurement| m.outcome.seconds;
    measurements.iter().filter(eligible).min_by(|a, b| seconds(a).total_cmp(&seconds(b)))
}

fn describe(measurement: &Measurement) -> String {
    let Measurement { method, step, outcome, .. } = measurement;
    format!("{} at step {step:.3}, {:.2} µs", label(method), outcome.seconds * 1e6)
}
