//! The summary of a section, which `heavytop section` prints.

use super::survey::Survey;
use crate::commands::section::problems::limits::Limits;
use crate::commands::section::problems::section_problem::Problem;
use crate::commands::section::problems::top_problem::TopProblem;
use crate::pictures::caption::number;
use serde::Serialize;
use std::fmt;
use std::path::{Path, PathBuf};

/// The summary of a section, in numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SectionSummary {
    /// The folder of the picture and the table.
    pub out: PathBuf,
    /// The energy h of the level, J.
    pub energy: f64,
    /// The vertical momentum Π·Γ of the level, kg m²/s.
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
    /// The number of returns that each start should have.
    pub crossings: usize,
    /// The number of starts that have fewer returns.
    pub short: usize,
    /// The time for which a start is followed at most, s.
    pub longest: f64,
    /// The largest deviation of h from the level, J.
    pub h: f64,
    /// The largest deviation of f₁ = |Γ|².
    pub f1: f64,
    /// The largest deviation of f₂ = Π·Γ, kg m²/s.
    pub f2: f64,
}

impl SectionSummary {
    pub(in crate::commands::section) fn new(
        problem: &TopProblem,
        limits: &Limits,
        survey: &Survey,
        out: &Path,
    ) -> Self {
        let Limits { step, longest, crossings, .. } = *limits;
        let (level, (formulation, scheme)) = (problem.section.level(), problem.method());
        let deviation = |i: usize| survey.deviations.get(i).copied().unwrap_or(f64::NAN);
        let [h, f1, f2] = [0, 1, 2].map(deviation);
        Self {
            out: out.into(),
            energy: level.energy,
            vertical_momentum: level.vertical_momentum,
            formulation: formulation.name(),
            scheme: scheme.name(),
            step,
            starts: survey.means.len(),
            points: survey.points,
            crossings,
            short: survey.short,
            longest,
            h,
            f1,
            f2,
        }
    }
}

impl fmt::Display for SectionSummary {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { energy, vertical_momentum, formulation, scheme, step, .. } = self;
        let [energy, vertical_momentum] = [*energy, *vertical_momentum].map(number);
        writeln!(to, "h = {energy} J, Pi.Gamma = {vertical_momentum} kg m²/s")?;
        let Self { points, starts, crossings, short, longest, h, f1, f2, .. } = self;
        write_counts(
            to,
            [*points, *starts, *crossings, *short],
            (formulation, scheme),
            [*step, *longest],
        )?;
        writeln!(to, "largest deviations from the level: h {h:.1e}, f1 {f1:.1e}, f2 {f2:.1e}")?;
        write!(to, "picture and table are in {}", self.out.display())
    }
}

/// Writes the numbers of points, starts, returns and starts that have fewer returns, the method, the step and the longest
/// time (s).
pub(in crate::commands::section) fn write_counts(
    to: &mut fmt::Formatter<'_>,
    [points, starts, crossings, short]: [usize; 4],
    (formulation, scheme): (&str, &str),
    [step, longest]: [f64; 2],
) -> fmt::Result {
    let starts = counted(starts, "start");
    writeln!(to, "{points} points of {starts}, by {formulation}, {scheme}, step {step:.3e} s")?;
    if short > 0 {
        let (short, verb) = (counted(short, "start"), if short == 1 { "has" } else { "have" });
        let fewer = format!("{short} {verb} fewer than {crossings} returns in {longest:.0} s");
        writeln!(to, "{fewer}; raise [section] longest for more")?;
    }
    Ok(())
}

/// Returns a number with a word, in the plural where there is not one.
fn counted(number: usize, word: &str) -> String {
    format!("{number} {word}{}", if number == 1 { "" } else { "s" })
}
