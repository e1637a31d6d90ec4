//! The summary of a section of a system, which `heavytop section` prints.

use super::section_summary::write_counts;
use super::survey::Survey;
use crate::commands::section::problems::limits::Limits;
use crate::commands::section::problems::section_problem::Problem;
use crate::commands::section::problems::system_problem::SystemProblem;
use serde::Serialize;
use serde_json::{Map, Value};
use std::fmt;
use std::path::{Path, PathBuf};

/// The summary of a section of a system, in numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SystemSectionSummary {
    /// The folder of the picture and the table.
    pub out: PathBuf,
    /// The name of the algebra.
    pub algebra: String,
    /// The Hamiltonian.
    pub hamiltonian: String,
    /// The Casimirs by their names, as formulas.
    pub casimirs: Map<String, Value>,
    /// The formula of the surface.
    pub surface: String,
    /// The level of the surface.
    pub level: f64,
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
    /// The largest deviations of h and of the Casimirs from the level, or from the start where that was given.
    pub deviations: Map<String, Value>,
}

impl SystemSectionSummary {
    pub(in crate::commands::section) fn new(
        problem: &SystemProblem,
        limits: &Limits,
        survey: &Survey,
        out: &Path,
    ) -> Self {
        let (section, (formulation, scheme)) = (&problem.section, problem.method());
        let system = section.system();
        let casimirs = system.casimirs().iter().map(|casimir| casimir.to_string().into());
        let deviations = survey.deviations.iter().map(|&deviation| deviation.into());
        Self {
            out: out.into(),
            algebra: system.algebra().name().into(),
            hamiltonian: system.hamiltonian().to_string(),
            casimirs: problem.conserved().into_iter().skip(1).zip(casimirs).collect(),
            surface: section.surface().to_string(),
            level: section.level(),
            formulation: formulation.name(),
            scheme: scheme.name(),
            step: limits.step,
            starts: survey.means.len(),
            points: survey.points,
            crossings: limits.crossings,
            short: survey.short,
            longest: limits.longest,
            deviations: problem.conserved().into_iter().zip(deviations).collect(),
        }
    }
}

impl fmt::Display for SystemSectionSummary {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { hamiltonian, surface, level, casimirs, .. } = self;
        write!(to, "h = {hamiltonian}")?;
        for (name, text) in casimirs {
            write!(to, "; {name} = {}", text.as_str().unwrap_or_default())?;
        }
        writeln!(to, "; on {surface} = {level}")?;
        let Self { points, starts, crossings, short, longest, formulation, scheme, step, .. } =
            self;
        write_counts(
            to,
            [*points, *starts, *crossings, *short],
            (formulation, scheme),
            [*step, *longest],
        )?;
        write!(to, "largest deviations:")?;
        // The energy comes before the Casimirs.
        let (energy, casimirs): (Vec<_>, Vec<_>) =
            self.deviations.iter().partition(|(name, _)| *name == "h");
        let deviations = energy.into_iter().chain(casimirs);
        let deviations = deviations.map(|(name, deviation)| {
            format!("{name} {:.1e}", deviation.as_f64().unwrap_or(f64::NAN))
        });
        writeln!(to, " {}", deviations.collect::<Vec<_>>().join(", "))?;
        write!(to, "picture and table are in {}", self.out.display())
    }
}
