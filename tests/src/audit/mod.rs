//! The table of `docs/audit.md` with a row for every scheme and formulation: how it is measured, written and read.
//!
//! The example `audit` prints the table, and the test `audit` measures it again and compares.

mod measure;
mod methods;

pub use methods::{Method, methods};

use core::fmt;
use core::str::FromStr;
use std::error::Error;

/// An error of any kind, in any thread.
pub type Failure = Box<dyn Error + Send + Sync>;

/// The number of steps of the shorter one of two runs, which the test repeats.
pub const SHORT: u64 = 10_000;

/// The number of steps of the longer run.
pub const LONG: u64 = 1_000_000;

/// The step of both runs, in seconds.
pub const STEP: f64 = 0.02;

/// The line of the table with the names of the columns.
pub const HEADER: &str = "| formulation | scheme | order claimed | measured | Poisson defect, h = 1/10 | \
    max \\|Δf₁\\|, 10⁴ and 10⁶ steps | max \\|Δf₂\\| | max \\|Δh\\| | slope of h, 1/s | descent defect |";

/// The deviations of f₁, f₂ and h from their first values in a run of steps of [`STEP`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drifts {
    /// The largest deviations max |Δf₁| and max |Δf₂|.
    pub casimirs: [f64; 2],
    /// The largest deviation max |Δh| of the energy.
    pub energy: f64,
    /// The slope of h against t by least squares, from every hundredth step.
    pub slope: f64,
}

/// A row of the table: one formulation with one scheme, for the paper's top.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The formulation: on T\*C² ("collective"), without a lift ("reduced"), on six equations ("direct"), or by a
    /// splitting.
    pub formulation: String,
    /// The name of the scheme.
    pub scheme: String,
    /// The number of the step at which the run has failed.
    pub failed: Option<u64>,
    /// The order that the scheme claims.
    pub claimed: usize,
    /// The fitted slope of the error at t = 1 against exact values; `None` if too few errors are above round-off.
    pub order: Option<f64>,
    /// The Poisson defect ‖DφΛDφᵀ − Λ∘φ‖ of one step of 1/10 from the paper's start, by exact tangent maps.
    pub poisson: f64,
    /// The drifts over [`SHORT`] steps.
    pub short: Drifts,
    /// The drifts over all steps.
    pub long: Drifts,
    /// The descent defect |M(Φ(z′)) − M(Φ(z))| after one step, for lifts z and z′ of one momentum; `None` without
    /// lifts.
    pub descent: Option<f64>,
}

/// The text for a missing order.
const TOO_FEW: &str = "too few";

/// The text for a missing descent defect.
const NOTHING: &str = "—";

impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { formulation, scheme, claimed, poisson, short, long, .. } = self;
        let failed = self.failed.map_or_else(String::new, |n| format!(" (fails at step {n})"));
        let order = self.order.map_or_else(|| TOO_FEW.into(), |order| format!("{order:.2}"));
        write!(f, "| {formulation} | {scheme}{failed} | {claimed} | {order} | {poisson:.1e} |")?;
        for k in [0, 1] {
            write!(f, " {:.1e}, {:.1e} |", short.casimirs[k], long.casimirs[k])?;
        }
        write!(f, " {:.1e}, {:.1e} |", short.energy, long.energy)?;
        write!(f, " {:.1e}, {:.1e} |", short.slope, long.slope)?;
        match self.descent {
            Some(defect) => write!(f, " {defect:.1e} |"),
            None => write!(f, " {NOTHING} |"),
        }
    }
}

impl FromStr for Row {
    type Err = Failure;

    fn from_str(line: &str) -> Result<Self, Failure> {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        let [formulation, scheme, claimed, order, poisson, f1, f2, h, slope, descent] = cells[..]
        else {
            return Err(format!("{} cells in {line}", cells.len()).into());
        };
        let pair = |cell: &str| -> Result<[f64; 2], Failure> {
            let (short, long) =
                cell.split_once(", ").ok_or_else(|| format!("one of two: {cell}"))?;
            Ok([short.parse()?, long.parse()?])
        };
        let (f1, f2, h, slope) = (pair(f1)?, pair(f2)?, pair(h)?, pair(slope)?);
        let drifts = |k: usize| Drifts { casimirs: [f1[k], f2[k]], energy: h[k], slope: slope[k] };
        let number = |cell: &str, none: &str| -> Result<Option<f64>, Failure> {
            if cell == none { Ok(None) } else { Ok(Some(cell.parse()?)) }
        };
        let (scheme, failed) = match scheme.split_once(" (fails at step ") {
            Some((scheme, step)) => (scheme, Some(step.trim_end_matches(')').parse()?)),
            None => (scheme, None),
        };
        Ok(Self {
            formulation: formulation.to_owned(),
            scheme: scheme.to_owned(),
            failed,
            claimed: claimed.parse()?,
            order: number(order, TOO_FEW)?,
            poisson: poisson.parse()?,
            short: drifts(0),
            long: drifts(1),
            descent: number(descent, NOTHING)?,
        })
    }
}
