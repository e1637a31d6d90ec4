//! The table of a run: its columns and rows.

use crate::errors::SystemTableError;
use crate::runs::Experiment;
use lie_poisson::{Covector, Pair, Se3Dual};
use lie_poisson_runs::TopQuantity;
use std::array;
use std::collections::HashSet;
use std::ops::Range;

/// The names of the columns of a state.
pub const STATE_COLUMNS: &str = "t,Pi1,Pi2,Pi3,Gamma1,Gamma2,Gamma3";

/// The names of the columns that the table of every top begins with.
pub(super) const TOP_COLUMNS: &str = "t,Pi1,Pi2,Pi3,Gamma1,Gamma2,Gamma3,h,f1,f2";

/// The names of the columns that the tables of some tops have after these.
const MORE_TOP_COLUMNS: [&str; 8] = ["C", "K", "G", "f3", "qw", "qx", "qy", "qz"];

/// Returns whether the table of some top has a column of this name after those of all tops.
pub(super) fn is_top_column(name: &str) -> bool {
    let mut requested = TopQuantity::NAMES.iter().flat_map(|(_, quantity)| quantity.columns());
    MORE_TOP_COLUMNS.contains(&name) || requested.any(|column| *column == name)
}

/// The names of the columns of the attitude.
pub const ATTITUDE_COLUMNS: &str = "qw,qx,qy,qz";

/// Returns the numbers in the columns of a state.
#[must_use]
pub fn state_values(time: f64, Covector(Pair(pi, gamma)): &Se3Dual) -> [f64; 7] {
    [time, pi.x, pi.y, pi.z, gamma.x, gamma.y, gamma.z]
}

/// Checks that no two columns of an output have one name.
///
/// # Errors
/// If two have, with the name.
pub fn require_distinct<'a>(
    columns: impl IntoIterator<Item = &'a str>,
) -> Result<(), SystemTableError> {
    let mut seen = HashSet::new();
    match columns.into_iter().find(|name| !seen.insert(*name)) {
        Some(name) => Err(SystemTableError::SameColumn { name: name.to_owned() }),
        None => Ok(()),
    }
}

/// The number of numbers that are formatted before their texts are copied.
const GROUP: usize = 8;

/// Appends a line of numbers, each with the fewest digits that read back as the same `f64`.
pub fn append_row(lines: &mut Vec<u8>, numbers: &[f64]) {
    let mut buffers: [_; GROUP] = array::from_fn(|_| zmij::Buffer::new());
    for numbers in numbers.chunks(GROUP) {
        // A processor waits where it reads bytes that it has just written in other pieces: the copies come later.
        let mut texts = [""; GROUP];
        for ((text, buffer), number) in texts.iter_mut().zip(&mut buffers).zip(numbers) {
            *text = buffer.format(*number);
        }
        for text in &texts[..numbers.len()] {
            lines.extend_from_slice(text.as_bytes());
            lines.push(b',');
        }
    }
    if !numbers.is_empty() {
        lines.pop();
    }
    lines.push(b'\n');
}

/// The columns of a table that form one array.
#[derive(Clone, Debug, PartialEq)]
pub struct Array {
    /// The name of the array.
    pub name: String,
    /// The columns.
    pub columns: Range<usize>,
    /// The shape of each sample, whose last index is the fastest; none for a number.
    pub shape: Vec<usize>,
}

/// The table of a run: t, the state, invariants, and the attitude if it is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct RunTable {
    /// The names of the columns.
    columns: Vec<String>,
    /// The groups of columns that form one array.
    arrays: Vec<Array>,
    /// The columns of the conserved quantities.
    invariants: Range<usize>,
}

impl RunTable {
    /// Creates the table of a run: t, the coordinates, the conserved quantities, the attitude if it is followed, and the
    /// quantities of a top that are asked for.
    ///
    /// # Errors
    /// If a coordinate, or a vector of them, has the name of another column.
    pub fn new(run: &Experiment, requested: &[TopQuantity]) -> Result<Self, SystemTableError> {
        let mut table = Self { columns: Vec::new(), arrays: Vec::new(), invariants: 0..0 };
        table.push("t", ["t".into()], None);
        for (name, columns) in run.coordinates() {
            table.push(&name, columns, run.model.shape(&name));
        }
        let first = table.columns.len();
        for name in run.conserved() {
            table.push(&name.clone(), [name], None);
        }
        table.invariants = first..table.columns.len();
        if run.attitude {
            table.push("q", ATTITUDE_COLUMNS.split(',').map(String::from), None);
        }
        for quantity in requested {
            let columns = quantity.columns().iter().map(|column| (*column).to_owned());
            table.push(&quantity.name().replace('-', "_"), columns, None);
        }
        require_distinct(table.columns.iter().map(String::as_str))?;
        require_distinct(table.arrays.iter().map(|array| array.name.as_str()))?;
        Ok(table)
    }

    /// Adds columns that form one array; unless it has another shape, a number or a vector.
    fn push(
        &mut self,
        name: &str,
        columns: impl IntoIterator<Item = String>,
        shape: Option<Vec<usize>>,
    ) {
        let first = self.columns.len();
        self.columns.extend(columns);
        let columns = first..self.columns.len();
        let shape = shape.unwrap_or_else(|| match columns.len() {
            1 => Vec::new(),
            count => vec![count],
        });
        self.arrays.push(Array { name: name.to_owned(), columns, shape });
    }

    /// Returns the names of the invariants in the table.
    #[must_use]
    pub fn invariants(&self) -> &[String] {
        self.columns.get(self.invariants.clone()).unwrap_or_default()
    }

    /// Returns the names of the columns, separated by commas.
    #[must_use]
    pub fn header(&self) -> String {
        self.columns.join(",")
    }

    /// Returns the names of the columns.
    pub(crate) fn header_names(&self) -> impl Iterator<Item = &str> {
        self.columns.iter().map(String::as_str)
    }

    /// Returns the beginning by which a table in CSV is recognised: the columns that all tops have, or all of the system.
    #[must_use]
    pub fn beginning(&self) -> String {
        let header = self.header();
        match header.starts_with(TOP_COLUMNS) {
            true => TOP_COLUMNS.into(),
            false => header + "\n",
        }
    }

    /// Returns the number of columns.
    #[must_use]
    pub fn width(&self) -> usize {
        self.columns.len()
    }

    /// Returns the groups of columns that form one array: t, Pi, Gamma, the invariants, q.
    #[must_use]
    pub fn arrays(&self) -> &[Array] {
        &self.arrays
    }

    /// Returns the values of the invariants in a row.
    #[must_use]
    pub fn invariant_values<'a>(&self, row: &'a [f64]) -> &'a [f64] {
        row.get(self.invariants.clone()).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_is_its_numbers_with_commas_between_them() {
        let numbers = [-0.1, 0.0, -0.0, 1e300, f64::NAN, 5e-324, f64::NEG_INFINITY, -1.0 / 3.0];
        for count in 0..3 * GROUP {
            let row: Vec<f64> = numbers.into_iter().cycle().take(count).collect();
            let texts = row.iter().map(|number| zmij::Buffer::new().format(*number).to_owned());
            let expected = format!("0\n{}\n", texts.collect::<Vec<_>>().join(","));
            let mut lines = b"0\n".to_vec();
            append_row(&mut lines, &row);
            assert_eq!(String::from_utf8_lossy(&lines), expected);
        }
    }
}
