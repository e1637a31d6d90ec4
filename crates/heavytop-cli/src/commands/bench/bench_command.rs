//! The command `bench`: what is timed, and the table of the times.

use super::problem_file::read;
use crate::configuration::Config;
use crate::errors::Error;
use crate::supervision::Progress;
use crate::supervision::tiled_run::threads as pool;
use heavytop::HeavyTop;
use lie_poisson::{Covector, Pair, Se3Dual};
use lie_poisson_runs::contests::{Contest, TimedProblem, TimedRun};
use nalgebra::{Rotation3, Vector3};
use serde::Serialize;
use std::collections::BTreeSet;
use std::fmt;
use std::path::Path;

/// The simulated time of one top, s.
const LONG: f64 = 1000.0;

/// The simulated time of each top of an ensemble, s.
const SHORT: f64 = 20.0;

/// The number of tops of an ensemble whose reference solutions are computed.
const REFERENCES: u64 = 10_000;

/// The options of `bench`: which integrators, how many tops, how many threads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BenchOptions {
    /// A part of the names of the integrators to time; `None` times all of them.
    pub only: Option<String>,
    /// The number of tops in the ensemble.
    pub tops: u64,
    /// The number of threads for the ensemble.
    pub threads: usize,
}

/// The times and errors of all integrators.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Bench {
    /// The number of threads of the ensembles.
    pub threads: usize,
    /// The timed runs, in the order in which they were made.
    pub runs: Vec<TimedRun>,
}

/// Times every fast path and the general integrators.
///
/// The tops are those of the problem file. Without one they are the configured top alone to t = 1000 s, and an
/// ensemble about it to t = 20 s.
///
/// # Errors
/// If the request is wrong, or a step fails.
///
/// # Example
/// ```no_run
/// use heavytop_cli::commands::bench::{BenchOptions, bench};
/// use heavytop_cli::configuration::Config;
/// let bench = bench(&Config::default(), None, BenchOptions { only: None, tops: 1000, threads: 1 }, true)?;
/// println!("{bench}");
/// # Ok::<(), heavytop_cli::Error>(())
/// ```
pub fn bench(
    config: &Config,
    problem: Option<&Path>,
    options: BenchOptions,
    quiet: bool,
) -> Result<Bench, Error> {
    let BenchOptions { only, tops, threads } = options;
    let pool = pool(Some(threads))?;
    let problems = match problem {
        Some(path) => vec![read(path)?],
        None => own(config, tops)?,
    };
    let progress = Progress::of(0, "runs", quiet);
    let (mut runs, mut others) = (Vec::new(), BTreeSet::new());
    for problem in &problems {
        pool.install(|| {
            let done = &mut |run: TimedRun| {
                progress.now(runs.len() as u64, run.name.clone());
                runs.push(run);
            };
            Contest { problem, only: only.as_deref(), others: &mut others, done }.run()
        })?;
    }
    if let (Some(only), true) = (only, runs.is_empty()) {
        return Err(Error::NoContestant { only, names: others.into_iter().collect() });
    }
    Ok(Bench { threads, runs })
}

fn own(config: &Config, tops: u64) -> Result<Vec<TimedProblem>, Error> {
    if !(2..=1_000_000_000).contains(&tops) {
        let range = "at least 2 and at most 1e9";
        return Err(Error::OutOfRange { name: "tops", range, value: tops as f64 });
    }
    let (top, start) = (config.top()?, config.start()?);
    let one = TimedProblem::with_references(top, LONG, vec![start])?;
    let around = (0..tops.min(REFERENCES)).map(|index| near(&top, &start, index)).collect();
    let many = TimedProblem { tops, ..TimedProblem::with_references(top, SHORT, around)? };
    Ok(vec![one, many])
}

/// Returns the start with number `index` of a sequence that fills the neighbourhood of a start evenly.
///
/// Π differs by up to a quarter of |Π| + √(I mgl |Γ|/2), with the largest moment I, and Γ is turned about e₁ and e₃. The
/// root is the Π of a top that swings; for the paper's top it is 1 kg m²/s.
fn near(top: &HeavyTop, Covector(Pair(pi, gamma)): &Se3Dual, index: u64) -> Se3Dual {
    // Powers of the relatives of the plastic number: a Kronecker sequence in five dimensions.
    const ROTATIONS: [f64; 5] = [
        0.881_271_451_226_064,
        0.776_639_370_759_107,
        0.684_430_105_236_148,
        0.603_168_708_098_158,
        0.531_555_324_820_293,
    ];
    let [x, y, z, first, third] = ROTATIONS.map(|r| (index as f64 * r).fract() - 0.5);
    let swing = (0.5 * top.inertia().max()).sqrt() * (top.weight_moment() * gamma.norm()).sqrt();
    let size = 0.5 * (pi.norm() + swing);
    let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), 2.0 * third)
        * Rotation3::from_axis_angle(&Vector3::x_axis(), 2.0 * first);
    Se3Dual::new(pi + Vector3::new(x, y, z) * size, turn * gamma)
}

impl fmt::Display for Bench {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let columns = ["tops", "ms", "ns per top and step", "error at 10", "at the end"];
        let [tops, ms, each, early, late] = columns;
        writeln!(f, "{:<46}{:<13}{tops:>8}{ms:>10}{each:>21}{early:>13}{late:>12}", "", "step, s")?;
        for run in &self.runs {
            let each = run.seconds * 1e9 / (run.steps as f64 * run.tops as f64);
            let ms = run.seconds * 1e3;
            let (name, step) = (&run.name, run.setting.trim_start_matches("h = "));
            let step = step.get(..step.len().min(10)).unwrap_or(step);
            writeln!(
                f,
                "{name:<46}{step:<13}{:>8}{ms:>10.2}{each:>21.2}{:>13.1e}{:>12.1e}",
                run.tops, run.relative_error_10, run.relative_error_end
            )?;
        }
        writeln!(f, "Ensembles on {} thread(s); each time is the least of several.", self.threads)?;
        write!(f, "Each error is the larger of those of Π and of Γ, relative to its size.")
    }
}
