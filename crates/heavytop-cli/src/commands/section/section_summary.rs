//! The summary of a section, which `heavytop section` prints.

use super::orbits::orbit_accuracy::OrbitAccuracy;
use super::settings::Settings;
use super::survey::Survey;
use serde::Serialize;
use serde_json::{Map, Value};
use std::fmt;
use std::path::{Path, PathBuf};

/// The summary of a section, in numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SectionSummary {
    /// The folder of the picture and the table.
    pub out: PathBuf,
    /// What the section is of, and the largest deviations: `energy`, `vertical_momentum`, `h`, `f1` and `f2` of a top;
    /// `algebra`, `hamiltonian`, `casimirs`, `surface`, `level` and `deviations` of another system.
    #[serde(flatten)]
    pub of: Map<String, Value>,
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
    /// The largest estimated error of the orbits that were measured, to two digits: the largest |Δμ_b|/|μ_b| over the
    /// blocks b of coordinates at their last return. 1 means that nothing of the state is right.
    pub error_estimate: Option<f64>,
    /// The accuracy of the orbits that were measured.
    #[serde(skip)]
    accuracy: Option<OrbitAccuracy>,
    /// The largest deviations of h and of the Casimirs from the level, or from the start where that was given, in SI
    /// units, by name.
    #[serde(skip)]
    pub deviations: Vec<(String, f64)>,
    /// The level and the surface, on a line.
    #[serde(skip)]
    title: String,
}

impl SectionSummary {
    pub(super) fn new(
        settings: &Settings,
        survey: &Survey,
        accuracy: Option<OrbitAccuracy>,
        out: &Path,
    ) -> Self {
        let (problem, limits) = (&settings.problem, &settings.limits);
        let (formulation, scheme) = (problem.method().formulation(), problem.method().scheme());
        Self {
            out: out.into(),
            of: problem.summary(&survey.deviations),
            formulation: formulation.name(),
            scheme: scheme.name(),
            step: limits.step,
            starts: survey.means.len(),
            points: survey.points,
            crossings: limits.crossings,
            short: survey.short,
            longest: limits.longest,
            error_estimate: accuracy.and_then(|accuracy| accuracy.worst.error),
            accuracy,
            deviations: problem.conserved().into_iter().zip(survey.deviations.clone()).collect(),
            title: problem.title(),
        }
    }
}

impl fmt::Display for SectionSummary {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { points, starts, formulation, scheme, step, crossings, short, longest, .. } =
            self;
        writeln!(to, "{}", self.title)?;
        let starts = counted(*starts);
        writeln!(to, "{points} points of {starts}, by {formulation}, {scheme}, step {step:.3e} s")?;
        if *short > 0 {
            let (few, verb) = (counted(*short), if *short == 1 { "has" } else { "have" });
            let fewer = format!("{few} {verb} fewer than {crossings} returns in {longest:.0} s");
            writeln!(to, "{fewer}; raise [section] longest for more")?;
        }
        let deviations = self.deviations.iter().map(|(name, most)| format!("{name} {most:.1e}"));
        let deviations = deviations.collect::<Vec<_>>().join(", ");
        match deviations.is_empty() {
            true => writeln!(to, "the forces leave nothing conserved")?,
            false => writeln!(to, "largest deviations: {deviations}")?,
        }
        match self.accuracy {
            Some(OrbitAccuracy { worst, least: Some(least), measured }) => {
                let (of, most) = (counted(measured), worst.error.unwrap_or(least));
                writeln!(
                    to,
                    "estimated error of {of} at the end: {least:.1e} to {most:.1e} of the state"
                )?;
            }
            _ => writeln!(to, "no estimate of the error")?,
        }
        write!(to, "picture and table are in {}", self.out.display())
    }
}

/// Returns the words for a number of starts.
fn counted(starts: usize) -> String {
    format!("{starts} start{}", if starts == 1 { "" } else { "s" })
}
