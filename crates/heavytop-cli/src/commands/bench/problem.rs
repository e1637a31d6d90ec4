//! The problem of a benchmark: tops, their starts, and their states at two times.

use crate::Error;
use crate::files::bounded;
use crate::vocabulary::brief;
use collective_integrators::{IntegrationError, Start};
use heavytop::methods::{MethodError, SchemeName};
use heavytop::{Body, CollectiveGauss, HeavyTop};
use lie_poisson::{BlockScales, Se3Dual};
use nalgebra::Vector3;
use std::path::Path;

/// The first of the two times at which errors are measured, s.
pub(super) const EARLY: f64 = 10.0;

/// The step of the reference, a Gauss method of order 16, s.
const STEP: f64 = 0.125;

/// A top with one start or many, and reference states at two times.
#[derive(Clone, Debug, PartialEq)]
pub struct BenchProblem {
    /// The top that all starts share.
    pub top: HeavyTop,
    /// The end of the runs, s.
    pub end: f64,
    /// The number of tops.
    pub tops: u64,
    /// The starts of the tops; top number n has start number n modulo their number.
    pub starts: Vec<Se3Dual>,
    /// The states of the starts after 10 s.
    pub early: Vec<Se3Dual>,
    /// The states of the starts at the end.
    pub late: Vec<Se3Dual>,
}

impl BenchProblem {
    /// Reads a file of numbers: I₁ I₂ I₃ mgl c₁ c₂ c₃ end on the first line; then for each top a line
    /// with (Π, Γ) at 0, 10 and end.
    ///
    /// # Errors
    /// If the file cannot be read, or has another form.
    pub fn read(path: &Path) -> Result<Self, Error> {
        let unread = |source| Error::Read { path: path.into(), source };
        let mut lines = (1..)
            .zip(bounded::lines(path).map_err(unread)?)
            .map(|(number, line)| line.map(|line| (number, line)).map_err(unread))
            .filter(|line| line.as_ref().map_or(true, |(_, line)| !line.trim().is_empty()));
        let row = |line: usize, text: &str, count: usize| numbers(path, line, text, count);
        let (first, head) = lines.next().transpose()?.unwrap_or_else(|| (1, String::new()));
        let head = row(first, &head, 8)?;
        let center_of_mass = Vector3::new(head[4], head[5], head[6]);
        let top = HeavyTop::new(&Body {
            inertia: Vector3::new(head[0], head[1], head[2]),
            mass: 1.0,
            gravity: head[3],
            length: 1.0,
            center_of_mass,
        })
        .map_err(Error::Body)?;
        let (mut starts, mut early, mut late) = (Vec::new(), Vec::new(), Vec::new());
        for line in lines {
            let (line, text) = line?;
            let row = row(line, &text, 18)?;
            let states = [&mut starts, &mut early, &mut late];
            for (states, row) in states.into_iter().zip(row.chunks_exact(6)) {
                states.push(Se3Dual::new(
                    Vector3::new(row[0], row[1], row[2]),
                    Vector3::new(row[3], row[4], row[5]),
                ));
            }
        }
        if starts.is_empty() {
            let message = "no top after the first line".to_owned();
            return Err(Error::Configuration { path: path.into(), line: 2, column: 1, message });
        }
        let (end, tops) = (head[7], starts.len() as u64);
        if end > EARLY && end.is_finite() {
            Ok(Self { top, end, tops, starts, early, late })
        } else {
            Err(Error::OutOfRange { name: "end", range: "finite and more than 10", value: end })
        }
    }

    /// Computes the references of the given starts until `end` (s), a multiple of ⅛ s that is more than 10 s.
    ///
    /// The method is the collective Gauss method of order 16 with steps of ⅛ s. Its errors are about 1e-13 for tops
    /// that turn as fast as the paper's.
    ///
    /// # Errors
    /// If a reference cannot be computed.
    pub fn with_references(top: HeavyTop, end: f64, starts: Vec<Se3Dual>) -> Result<Self, Error> {
        let gauss = CollectiveGauss::new(8, top)
            .map_err(|reason| MethodError::Scheme { scheme: SchemeName::Gauss(8), reason })?;
        let failed =
            |source: IntegrationError| Error::Timed { name: "reference".to_owned(), source };
        let (mut early, mut late) = (Vec::new(), Vec::new());
        for start in &starts {
            let mut run = gauss.trajectory(start, STEP)?;
            let mut after = |time: f64, passed: f64| {
                let steps = ((time - passed) / STEP).round() as usize;
                run.nth(steps - 1).transpose().map_err(failed)
            };
            // The first sample is the start.
            early.extend(after(EARLY + STEP, 0.0)?.map(|sample| sample.momentum));
            late.extend(after(end, EARLY)?.map(|sample| sample.momentum));
        }
        let tops = starts.len() as u64;
        Ok(Self { top, end, tops, starts, early, late })
    }

    /// Returns the problem with its first `count` tops at most.
    pub(super) fn first(&self, count: usize) -> Self {
        let first = |states: &[Se3Dual]| states.iter().take(count).copied().collect();
        let [starts, early, late] =
            [&self.starts, &self.early, &self.late].map(|states| first(states));
        Self {
            top: self.top,
            end: self.end,
            tops: self.tops.min(count as u64),
            starts,
            early,
            late,
        }
    }

    /// Returns the largest |Π| and |Γ| of the start and of the references of each top, in whose units errors are relative.
    pub(super) fn sizes(&self) -> impl Iterator<Item = BlockScales<Se3Dual>> {
        let references = self.early.iter().zip(&self.late);
        self.starts.iter().zip(references).map(|(start, (early, late))| {
            let mut sizes = BlockScales::of(start);
            sizes.include(early);
            sizes.include(late);
            sizes
        })
    }

    /// Returns the start of the top with number `index`.
    #[must_use]
    pub fn start(&self, index: u64) -> Se3Dual {
        // There is at least one start, and no more than memory holds.
        self.starts[(index % self.starts.len() as u64) as usize]
    }
}

fn numbers(path: &Path, line: usize, text: &str, count: usize) -> Result<Vec<f64>, Error> {
    let refused = |message| Error::Configuration { path: path.into(), line, column: 1, message };
    let row: Vec<f64> = text
        .split_whitespace()
        .map(|word| {
            word.parse().map_err(|_| refused(format!("`{}` is no number", brief::text(word))))
        })
        .collect::<Result<_, _>>()?;
    if row.len() == count {
        Ok(row)
    } else {
        Err(refused(format!("{count} numbers are wanted, there are {}", row.len())))
    }
}
