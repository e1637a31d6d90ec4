//! The table of measurements, and the method to take for each accuracy.

use super::measurement::{Measurement, Reference};
use crate::vocabulary::brief::number;
use serde::Serialize;
use std::fmt;
use std::path::{Path, PathBuf};

const TARGETS: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];

/// Formats the measurements as `work-precision.csv`.
pub(super) fn csv(measurements: &[Measurement]) -> String {
    let mut text = String::from(
        "formulation,scheme,step,end,error,seconds,h,f1,f2,error_Pi,error_Gamma,relative_error\n",
    );
    for Measurement { method, step, end, outcome } in measurements {
        let (formulation, scheme) = (method.formulation().name(), method.scheme().name());
        let [h, f1, f2] = outcome.deviations;
        let ([pi, gamma], relative) = (outcome.parts, outcome.relative);
        text += &format!(
            "{formulation},{scheme},{step:?},{end:?},{:?},{:?},{h:?},{f1:?},{f2:?},{pi:?},\
             {gamma:?},{relative:?}\n",
            outcome.error, outcome.seconds
        );
    }
    text
}

/// The recommended methods; as text, a line for each accuracy.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Comparison {
    /// The folder of the figure and the table.
    pub out: PathBuf,
    /// The time at which errors are measured, s.
    pub end: f64,
    /// The uncertainty of the reference solution, relative to its size.
    pub uncertainty: f64,
    /// The recommendation for each of some accuracies.
    pub recommendations: Vec<Recommendation>,
}

/// The fastest runs whose errors do not exceed a bound.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Recommendation {
    /// The largest error allowed: the 2-norm of the error of (Π, Γ), relative to the largest |Π| and |Γ| of the motion.
    pub error: f64,
    /// The fastest of all methods; `None` if no method attains the accuracy, or the reference is less certain.
    pub fastest: Option<Choice>,
    /// The fastest Poisson map that attains the accuracy.
    pub fastest_poisson: Option<Choice>,
}

/// A method with its step.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Choice {
    /// The formulation's name.
    pub formulation: &'static str,
    /// The scheme's name.
    pub scheme: &'static str,
    /// The time step, s.
    pub step: f64,
    /// The error of the run: the 2-norm of the error of (Π, Γ), relative to the largest |Π| and |Γ| of the motion.
    pub error: f64,
    /// The error of Π, kg m²/s.
    #[serde(rename = "error_Pi")]
    pub error_pi: f64,
    /// The error of Γ.
    #[serde(rename = "error_Gamma")]
    pub error_gamma: f64,
    /// The larger of the errors of Π and Γ, relative to the largest |Π| and |Γ| of the motion.
    pub relative_error: f64,
    /// Computing time for a simulated second, s.
    pub seconds: f64,
}

impl Comparison {
    pub(super) fn new(measurements: &[Measurement], reference: &Reference, out: &Path) -> Self {
        let uncertainty = reference.uncertainty;
        let recommendation = |error| {
            let fastest = |poisson| {
                let certain = error >= uncertainty;
                certain.then(|| fastest(measurements, error, poisson)).flatten().map(Choice::of)
            };
            Recommendation { error, fastest: fastest(false), fastest_poisson: fastest(true) }
        };
        let recommendations = TARGETS.map(recommendation).into();
        Self { out: out.into(), end: reference.end, uncertainty, recommendations }
    }
}

impl Choice {
    fn of(Measurement { method, step, outcome, .. }: &Measurement) -> Self {
        let (formulation, scheme) = (method.formulation().name(), method.scheme().name());
        let (error, seconds) = (outcome.error, outcome.seconds);
        let ([error_pi, error_gamma], relative_error) = (outcome.parts, outcome.relative);
        Self {
            formulation,
            scheme,
            step: *step,
            error,
            error_pi,
            error_gamma,
            relative_error,
            seconds,
        }
    }
}

/// Returns the fastest run whose error is at most `target`, among Poisson maps alone if asked for.
fn fastest(measurements: &[Measurement], target: f64, poisson: bool) -> Option<&Measurement> {
    let eligible = |m: &&Measurement| {
        let is_poisson = m.method.formulation().is_poisson(m.method.scheme());
        m.outcome.error <= target && (is_poisson || !poisson)
    };
    let seconds = |m: &&Measurement| m.outcome.seconds;
    measurements.iter().filter(eligible).min_by(|a, b| seconds(a).total_cmp(&seconds(b)))
}

impl fmt::Display for Comparison {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        for Recommendation { error, fastest, fastest_poisson } in &self.recommendations {
            write!(to, "error {error:e}: ")?;
            match (fastest, fastest_poisson) {
                _ if *error < self.uncertainty => writeln!(to, "the reference is not as certain")?,
                (None, _) => writeln!(to, "none reaches it with these steps")?,
                (Some(any), Some(poisson)) if any == poisson => {
                    writeln!(to, "fastest {any}, which is Poisson")?;
                }
                (Some(any), None) => writeln!(to, "fastest {any}; fastest Poisson none")?,
                (Some(any), Some(poisson)) => {
                    writeln!(to, "fastest {any}; fastest Poisson {poisson}")?;
                }
            }
        }
        write!(
            to,
            "error: 2-norm of that of (Pi, Gamma) at t = {} s, relative to the largest |Pi| and |Gamma|, and in \
             parentheses\nthat of Pi (kg m²/s) and that of Gamma; the reference is certain to {:.0e}\n\
             time: computing time per simulated second; figure and table are in {}",
            number(self.end),
            self.uncertainty,
            self.out.display()
        )
    }
}

impl fmt::Display for Choice {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { formulation, scheme, step, seconds, error_pi, error_gamma, .. } = self;
        // Three digits of a step of any size.
        let step = number(format!("{step:.2e}").parse().unwrap_or(*step));
        write!(to, "{formulation}, {scheme} at step {step}, {:.2} µs", seconds * 1e6)?;
        write!(to, " (Pi {error_pi:.0e}, Gamma {error_gamma:.0e})")
    }
}
