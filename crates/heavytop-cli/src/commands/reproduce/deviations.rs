//! The table of the largest deviations of the invariants.

use super::record::{QUANTITIES, Record};
use serde::Serialize;
use std::fmt;
use std::path::PathBuf;

/// The results of the paper's experiment; as text, the table.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Reproduction {
    /// The folder of the figures and tables.
    pub out: PathBuf,
    /// The runs, in the order of the tables.
    pub runs: Vec<Deviations>,
}

/// The largest deviations of the invariants in a run: max |quantity − initial value| over all steps, NaN if the
/// quantity was NaN at any step.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Deviations {
    /// The formulation's name.
    pub formulation: &'static str,
    /// The scheme's name.
    pub scheme: &'static str,
    /// The time step, s.
    pub step: f64,
    /// The time after the last step, s.
    pub end: f64,
    /// The deviation of h, J.
    pub h: f64,
    /// The deviation of f₁ = |Γ|².
    pub f1: f64,
    /// The deviation of f₂ = Π·Γ, kg m²/s.
    pub f2: f64,
    /// The deviation of K, (kg m²/s)⁴.
    #[serde(rename = "K")]
    pub k: f64,
}

impl Deviations {
    pub(super) fn of(record: &Record) -> Self {
        let run = &record.experiment;
        let (formulation, scheme) = (run.method.formulation().name(), run.method.scheme().name());
        let (step, end) = (run.pace.schedule.step, run.pace.schedule.end());
        let [h, f1, f2, k] = record.deviations;
        Self { formulation, scheme, step, end, h, f1, f2, k }
    }

    fn deviations(&self) -> [f64; 4] {
        [self.h, self.f1, self.f2, self.k]
    }
}

impl Reproduction {
    /// Formats the deviations as `summary.csv`.
    pub(super) fn csv(&self) -> String {
        let mut text = String::from("formulation,scheme,step,end");
        for quantity in QUANTITIES {
            text += &format!(",{quantity}");
        }
        text.push('\n');
        for run in &self.runs {
            let Deviations { formulation, scheme, step, end, .. } = run;
            text += &format!("{formulation},{scheme},{step:?},{end:?}");
            for deviation in run.deviations() {
                text += &format!(",{deviation:?}");
            }
            text.push('\n');
        }
        text
    }
}

impl fmt::Display for Reproduction {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "{:<12}{:<19}{:>8} {:>9}", "formulation", "scheme", "step", "end")?;
        for quantity in QUANTITIES {
            write!(to, "{:>12}", quantity.symbol())?;
        }
        writeln!(to)?;
        for run in &self.runs {
            let Deviations { formulation, scheme, step, end, .. } = run;
            write!(to, "{formulation:<12}{scheme:<19}{step:>8} {end:>9}")?;
            for deviation in run.deviations() {
                write!(to, "{deviation:>12.3e}")?;
            }
            writeln!(to)?;
        }
        write!(
            to,
            "max |quantity - initial value| over all steps, h in J, f2 in kg m²/s, K in (kg m²/s)⁴;\n\
             figures and tables are in {}",
            self.out.display()
        )
    }
}
