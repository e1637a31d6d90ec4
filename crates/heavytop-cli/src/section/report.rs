//! The table of points, and what is said about them.

use super::orbit::Orbit;
use super::settings::Settings;
use crate::Error;
use crate::output::Output;
use crate::table::{STATE_COLUMNS, write_row};
use heavytop::{EnergyLevel, Invariant};
use lie_poisson::larger;
use std::io::{self, Write};
use std::path::Path;

/// Writes `section.csv`, up to the point that could not be reached.
///
/// # Errors
/// The failure of the first start that could not be followed, or that of writing.
pub(super) fn write_table(orbits: &mut [Orbit], output: &mut Output) -> Result<(), Error> {
    output.write(|to| writeln!(to, "start,crossing,{STATE_COLUMNS},x,y"))?;
    for (index, orbit) in orbits.iter_mut().enumerate() {
        output.write(|to| {
            for (number, crossing) in orbit.crossings.iter().enumerate() {
                write!(to, "{},{number},", index + 1)?;
                write_row(to, crossing.time, &crossing.mu, crossing.plane.iter().copied())?;
            }
            Ok(())
        })?;
        if let Some(failure) = orbit.failure.take() {
            return Err(failure);
        }
    }
    Ok(())
}

/// Prints what there is, and where it is.
pub(super) fn print(settings: &Settings, orbits: &[Orbit], out: &Path) -> Result<(), Error> {
    match write(settings, orbits, out, &mut io::stdout().lock()) {
        // Whoever closed the pipe has read enough.
        Err(source) if source.kind() != io::ErrorKind::BrokenPipe => {
            Err(Error::Write { path: "the summary".into(), source })
        }
        _ => Ok(()),
    }
}

fn write(settings: &Settings, orbits: &[Orbit], out: &Path, to: &mut impl Write) -> io::Result<()> {
    let Settings { section, method, step, crossings, .. } = settings;
    let EnergyLevel { energy, vertical_momentum, .. } = section.level();
    let points: usize = orbits.iter().map(|orbit| orbit.crossings.len()).sum();
    writeln!(to, "h = {energy} J, Pi.Gamma = {vertical_momentum} kg m²/s")?;
    writeln!(
        to,
        "{points} points of {} starts, by {}, {}, step {step:.3e} s",
        orbits.len(),
        method.formulation().name(),
        method.scheme().name()
    )?;
    let short = orbits.iter().filter(|orbit| orbit.crossings.len() <= *crossings).count();
    if short > 0 {
        let longest = settings.steps as f64 * step;
        writeln!(to, "{short} starts have fewer than {crossings} returns in {longest:.0} s")?;
    }
    let [h, f1, f2] = deviations(section.level(), orbits);
    writeln!(to, "largest deviations from the level: h {h:.1e}, f1 {f1:.1e}, f2 {f2:.1e}")?;
    writeln!(to, "picture and table are in {}", out.display())
}

/// Of h, f₁ and f₂, over all points.
fn deviations(level: &EnergyLevel, orbits: &[Orbit]) -> [f64; 3] {
    let expected = [
        (Invariant::Energy, level.energy),
        (Invariant::VerticalSquared, 1.0),
        (Invariant::VerticalMomentum, level.vertical_momentum),
    ];
    expected.map(|(invariant, value)| {
        let points = orbits.iter().flat_map(|orbit| &orbit.crossings);
        points.map(|point| (invariant.value(&level.top, &point.mu) - value).abs()).fold(0.0, larger)
    })
}
