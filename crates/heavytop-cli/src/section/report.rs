//! The table of points, and what is said about them.

use super::orbit::Orbit;
use super::settings::Settings;
use crate::Error;
use crate::output::Output;
use crate::table::{STATE_COLUMNS, state_values, write_row};
use heavytop::{EnergyLevel, Invariant};
use lie_poisson::larger;
use serde::Serialize;
use std::fmt;
use std::io::Write;
use std::path::{Path, PathBuf};

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
                let state = state_values(crossing.time, &crossing.mu);
                write_row(to, state.into_iter().chain(crossing.plane.iter().copied()))?;
            }
            Ok(())
        })?;
        if let Some(failure) = orbit.failure.take() {
            return Err(failure);
        }
    }
    Ok(())
}

/// A section in numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Summary {
    /// The folder of the picture and the table.
    pub out: PathBuf,
    /// h, J.
    pub energy: f64,
    /// Π·Γ, kg m²/s.
    pub vertical_momentum: f64,
    /// The formulation's name.
    pub formulation: &'static str,
    /// The scheme's name.
    pub scheme: &'static str,
    /// The time step, s.
    pub step: f64,
    /// The number of starts.
    pub starts: usize,
    /// The number of points, the starts included.
    pub points: usize,
    /// The number of returns asked of each start.
    pub crossings: usize,
    /// The number of starts that have fewer.
    pub short: usize,
    /// How long they were followed, s.
    pub longest: f64,
    /// The largest deviation of h from the level, J.
    pub h: f64,
    /// That of f₁ = |Γ|².
    pub f1: f64,
    /// That of f₂ = Π·Γ, kg m²/s.
    pub f2: f64,
}

impl Summary {
    pub(super) fn new(settings: &Settings, orbits: &[Orbit], out: &Path) -> Self {
        let Settings { section, method, step, steps, crossings, .. } = *settings;
        let level = section.level();
        let [h, f1, f2] = deviations(level, orbits);
        Self {
            out: out.into(),
            energy: level.energy,
            vertical_momentum: level.vertical_momentum,
            formulation: method.formulation().name(),
            scheme: method.scheme().name(),
            step,
            starts: orbits.len(),
            points: orbits.iter().map(|orbit| orbit.crossings.len()).sum(),
            crossings,
            short: orbits.iter().filter(|orbit| orbit.crossings.len() <= crossings).count(),
            longest: steps as f64 * step,
            h,
            f1,
            f2,
        }
    }
}

impl fmt::Display for Summary {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { energy, vertical_momentum, formulation, scheme, step, .. } = self;
        writeln!(to, "h = {energy} J, Pi.Gamma = {vertical_momentum} kg m²/s")?;
        let Self { points, starts, crossings, short, longest, h, f1, f2, .. } = self;
        writeln!(
            to,
            "{points} points of {starts} starts, by {formulation}, {scheme}, step {step:.3e} s"
        )?;
        if *short > 0 {
            writeln!(to, "{short} starts have fewer than {crossings} returns in {longest:.0} s")?;
        }
        writeln!(to, "largest deviations from the level: h {h:.1e}, f1 {f1:.1e}, f2 {f2:.1e}")?;
        write!(to, "picture and table are in {}", self.out.display())
    }
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
