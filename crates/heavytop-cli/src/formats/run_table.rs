//! The table of a run: its columns and rows.

use crate::runs::{Experiment, Moment};
use heavytop::{HeavyTop, Invariant};
use lie_poisson::{Covector, Pair, Se3Dual};
use std::io::{self, Write};
use std::ops::Range;

/// The names of the columns of a state.
pub const STATE_COLUMNS: &str = "t,Pi1,Pi2,Pi3,Gamma1,Gamma2,Gamma3";

/// The names of the columns of the attitude.
pub const ATTITUDE_COLUMNS: &str = "qw,qx,qy,qz";

/// Returns the numbers in the columns of a state.
#[must_use]
pub fn state_values(time: f64, Covector(Pair(pi, gamma)): &Se3Dual) -> [f64; 7] {
    [time, pi.x, pi.y, pi.z, gamma.x, gamma.y, gamma.z]
}

/// Writes a line of numbers, each with the fewest digits that read back as the same `f64`.
///
/// # Errors
/// Returns the error of the writer.
pub fn write_row(to: &mut impl Write, numbers: impl IntoIterator<Item = f64>) -> io::Result<()> {
    let mut text = zmij::Buffer::new();
    for (i, number) in numbers.into_iter().enumerate() {
        if i > 0 {
            to.write_all(b",")?;
        }
        to.write_all(text.format(number).as_bytes())?;
    }
    to.write_all(b"\n")
}

/// The table of a run: t, Π, Γ, invariants, and the attitude if it is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct RunTable {
    top: HeavyTop,
    invariants: Vec<Invariant>,
    attitude: bool,
}

impl RunTable {
    /// Creates the table of an experiment. The invariants are h, f₁, f₂, and K or G.
    #[must_use]
    pub fn new(experiment: &Experiment) -> Self {
        let mut invariants = experiment.top.invariants();
        // f₃ is Π₃, which is a column already.
        invariants.retain(|invariant| *invariant != Invariant::AxialMomentum);
        Self { top: experiment.top, invariants, attitude: experiment.attitude }
    }

    /// Returns the invariants in the table.
    #[must_use]
    pub fn invariants(&self) -> &[Invariant] {
        &self.invariants
    }

    /// Returns the names of the columns, separated by commas.
    #[must_use]
    pub fn header(&self) -> String {
        let mut header = String::from(STATE_COLUMNS);
        for invariant in &self.invariants {
            header = header + "," + invariant.symbol();
        }
        if self.attitude { header + "," + ATTITUDE_COLUMNS } else { header }
    }

    /// Returns the number of columns.
    #[must_use]
    pub fn width(&self) -> usize {
        7 + self.invariants.len() + if self.attitude { 4 } else { 0 }
    }

    /// Returns the groups of columns that form one array: t, Pi, Gamma, the invariants, q.
    #[must_use]
    pub fn arrays(&self) -> Vec<(&'static str, Range<usize>)> {
        let mut arrays = vec![("t", 0..1), ("Pi", 1..4), ("Gamma", 4..7)];
        let numbered = self.invariants.iter().zip(7..);
        arrays.extend(numbered.map(|(invariant, i)| (invariant.symbol(), i..i + 1)));
        if self.attitude {
            arrays.push(("q", self.width() - 4..self.width()));
        }
        arrays
    }

    /// Returns the values of the invariants in a row.
    #[must_use]
    pub fn invariant_values<'a>(&self, row: &'a [f64]) -> &'a [f64] {
        row.get(7..7 + self.invariants.len()).unwrap_or_default()
    }

    /// Replaces `row` by the row of a moment.
    pub fn fill(&self, row: &mut Vec<f64>, moment: &Moment<'_>) {
        row.clear();
        row.extend(state_values(moment.time, moment.momentum));
        row.extend(self.invariants.iter().map(|f| f.value(&self.top, moment.momentum)));
        if let Some(q) = moment.attitude {
            row.extend([q.scalar, q.vector.x, q.vector.y, q.vector.z]);
        }
    }
}
