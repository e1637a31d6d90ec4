//! The table of a run: its columns and rows.

use crate::errors::SystemTableError;
use crate::runs::{Experiment, Moment, SystemExperiment};
use heavytop::{HeavyTop, Invariant, PrincipalAxes, attitude_of_vertical};
use lie_poisson::{Covector, Pair, Quaternion, Se3Dual};
use std::array;
use std::collections::HashSet;
use std::ops::Range;

/// The names of the columns of a state.
pub const STATE_COLUMNS: &str = "t,Pi1,Pi2,Pi3,Gamma1,Gamma2,Gamma3";

/// The names of the columns that the table of every top begins with.
pub(super) const TOP_COLUMNS: &str = "t,Pi1,Pi2,Pi3,Gamma1,Gamma2,Gamma3,h,f1,f2";

/// The names of the columns that the tables of some tops have after these.
pub(super) const MORE_TOP_COLUMNS: [&str; 8] = ["C", "K", "G", "f3", "qw", "qx", "qy", "qz"];

/// The names of the columns of the attitude.
pub const ATTITUDE_COLUMNS: &str = "qw,qx,qy,qz";

/// Returns the numbers in the columns of a state.
#[must_use]
pub fn state_values(time: f64, Covector(Pair(pi, gamma)): &Se3Dual) -> [f64; 7] {
    [time, pi.x, pi.y, pi.z, gamma.x, gamma.y, gamma.z]
}

/// Returns the turn about the vertical that takes the attitude of the columns, where that of the principal axes is the
/// shortest one, to the shortest one.
fn turn_about_the_vertical(axes: &PrincipalAxes, start: &Se3Dual) -> Quaternion {
    let given = axes.state_from_principal(start);
    let shortest = axes.attitude_from_principal(&attitude_of_vertical(&start.0.1));
    attitude_of_vertical(&given.0.1) * shortest.conjugate()
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

/// The table of a run: t, the state, invariants, and the attitude if it is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct RunTable {
    /// The names of the columns.
    columns: Vec<String>,
    /// The groups of columns that form one array.
    arrays: Vec<(String, Range<usize>)>,
    /// The columns of the invariants.
    invariants: Range<usize>,
    /// What the invariants of a top are computed from.
    top: Option<(HeavyTop, Vec<Invariant>)>,
    /// The principal axes of a top in the axes of the columns, where these are others, and the turn about the vertical
    /// after which the attitude of the columns starts with the shortest rotation.
    axes: Option<(PrincipalAxes, Quaternion)>,
}

impl RunTable {
    /// Creates the table of a top: t, Π, Γ, the invariants h, f₁, f₂, and C, K, G or f₃, and the attitude if it is asked
    /// for, all in the axes in which the top was given.
    #[must_use]
    pub fn new(experiment: &Experiment) -> Self {
        let Experiment { top, axes, start, .. } = experiment;
        let mut invariants = top.invariants_from(start);
        // f₃ is a component of Π in principal axes, which is a column already if these are the axes of the columns.
        if axes.is_aligned() && top.axial_component().is_some() {
            invariants.retain(|invariant| *invariant != Invariant::AxialMomentum);
        }
        let mut table = Self::of(STATE_COLUMNS, &[("t", 1), ("Pi", 3), ("Gamma", 3)]);
        for invariant in &invariants {
            table.push(invariant.symbol());
        }
        table.invariants = 7..table.columns.len();
        if experiment.attitude {
            let first = table.columns.len();
            table.columns.extend(ATTITUDE_COLUMNS.split(',').map(String::from));
            table.arrays.push(("q".into(), first..table.columns.len()));
        }
        let axes = (!axes.is_aligned()).then(|| (*axes, turn_about_the_vertical(axes, start)));
        Self { top: Some((*top, invariants)), axes, ..table }
    }

    /// Creates the table of a system: t, the coordinates, h, and the Casimirs c1, c2 and so on.
    ///
    /// # Errors
    /// If a coordinate, or a vector of them, has the name of another column.
    pub fn of_system(experiment: &SystemExperiment) -> Result<Self, SystemTableError> {
        let coordinates = experiment.system.algebra().coordinates();
        let names: Vec<String> = coordinates.names().collect();
        let groups = coordinates.groups().map(|(name, places)| (name, places.len()));
        let groups: Vec<_> = [("t", 1)].into_iter().chain(groups).collect();
        let mut table = Self::of(&format!("t,{}", names.join(",")), &groups);
        let first = table.columns.len();
        table.push("h");
        for i in 1..=experiment.system.casimirs().len() {
            table.push(&format!("c{i}"));
        }
        table.invariants = first..table.columns.len();
        require_distinct(table.columns.iter().map(String::as_str))?;
        require_distinct(table.arrays.iter().map(|(name, _)| name.as_str()))?;
        Ok(table)
    }

    /// Creates a table of columns in groups, each with its width.
    fn of(columns: &str, groups: &[(&str, usize)]) -> Self {
        let mut start = 0;
        let arrays = groups.iter().map(|(name, width)| {
            start += width;
            ((*name).to_owned(), start - width..start)
        });
        let (columns, arrays) = (columns.split(',').map(String::from).collect(), arrays.collect());
        Self { columns, arrays, invariants: 0..0, top: None, axes: None }
    }

    /// Adds a column that is an array.
    fn push(&mut self, name: &str) {
        let place = self.columns.len();
        self.columns.push(name.to_owned());
        self.arrays.push((name.to_owned(), place..place + 1));
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

    /// Returns the beginning by which a table in CSV is recognised: the columns that all tops have, or all of the system.
    #[must_use]
    pub fn beginning(&self) -> String {
        match self.top {
            Some(_) => TOP_COLUMNS.into(),
            None => self.header() + "\n",
        }
    }

    /// Returns the number of columns.
    #[must_use]
    pub fn width(&self) -> usize {
        self.columns.len()
    }

    /// Returns the groups of columns that form one array: t, Pi, Gamma, the invariants, q.
    #[must_use]
    pub fn arrays(&self) -> &[(String, Range<usize>)] {
        &self.arrays
    }

    /// Returns the values of the invariants in a row.
    #[must_use]
    pub fn invariant_values<'a>(&self, row: &'a [f64]) -> &'a [f64] {
        row.get(self.invariants.clone()).unwrap_or_default()
    }

    /// Returns the values of the invariants of a top in a state in principal axes.
    pub fn values_at<'a>(&'a self, mu: &'a Se3Dual) -> impl Iterator<Item = f64> + 'a {
        let top = self.top.iter();
        top.flat_map(move |(top, invariants)| invariants.iter().map(move |f| f.value(top, mu)))
    }

    /// Replaces `row` by the row of a moment of a top.
    pub fn fill(&self, row: &mut Vec<f64>, moment: &Moment<'_>) {
        row.clear();
        let given = self.axes.map(|(axes, _)| axes.state_from_principal(moment.momentum));
        row.extend(state_values(moment.time, given.as_ref().unwrap_or(moment.momentum)));
        row.extend(self.values_at(moment.momentum));
        if let Some(q) = moment.attitude {
            let q = self.axes.map_or(*q, |(axes, turn)| turn * axes.attitude_from_principal(q));
            row.extend([q.scalar, q.vector.x, q.vector.y, q.vector.z]);
        }
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
