//! The table of a sweep with a single axis as CSV: [`MemberCsv`].

use super::measured_row::Row;
use super::sweep_plan::{FAILURE, INDEX, Plan};
use crate::errors::Error;
use crate::files::{Kind, Output};
use std::io::Write;
use std::path::Path;

/// How the table is recognised.
pub(super) const CSV: Kind<'_> =
    Kind { name: "table of sweep", first: b"index,", is_whole: |head, _| Ok(is_sweep(head)) };

/// The table with the columns of `sweep.parquet`. A value that is missing is an empty cell, and a failure a text in the last
/// one.
pub(super) struct MemberCsv<'a> {
    plan: &'a Plan,
    file: Output,
    /// The number of the next row.
    next: u64,
}

impl<'a> MemberCsv<'a> {
    /// Creates the table without rows.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn begin(plan: &'a Plan, path: &Path) -> Result<Self, Error> {
        let mut file = Output::create(path).map_err(Error::too_late)?;
        let axes = plan.axes.iter().map(|axis| axis.parameter.name());
        let columns = plan.columns.iter().map(|column| column.name.clone());
        let names = [INDEX.to_owned()].into_iter().chain(axes).chain(columns);
        let names = names.chain([FAILURE.to_owned()]).map(|name| quoted(&name));
        let header = names.collect::<Vec<_>>().join(",");
        file.write(|file| writeln!(file, "{header}"))?;
        Ok(Self { plan, file, next: 0 })
    }

    /// Adds the next rows.
    ///
    /// # Errors
    /// If they cannot be written.
    pub fn add(&mut self, rows: &[Row]) -> Result<(), Error> {
        let mut buffer = zmij::Buffer::new();
        for row in rows {
            let run = self.plan.family.run_values(&self.plan.parameters(self.next));
            let values = (0..self.plan.columns.len()).map(|column| row.value(column));
            let mut line = self.next.to_string();
            for value in run.into_iter().map(Some).chain(values) {
                line.push(',');
                // The digits read back as the same number.
                line.push_str(value.map_or("", |value| buffer.format(value)));
            }
            line.push(',');
            line.push_str(&quoted(row.failure.as_deref().unwrap_or_default()));
            self.file.write(|file| writeln!(file, "{line}"))?;
            self.next += 1;
        }
        Ok(())
    }

    /// Returns the file, complete but for its name.
    pub fn whole(self) -> Output {
        self.file
    }
}

/// Returns a text as a cell: in quotes if it has a comma, a quote or a line break. Source: RFC 4180, §2.
fn quoted(text: &str) -> String {
    match text.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.into(),
    }
}

/// Returns whether a text begins as the table of a sweep, whose last column is that of the failures.
fn is_sweep(head: &[u8]) -> bool {
    let head = String::from_utf8_lossy(head);
    let mut lines = head.lines();
    let is_header = lines.next().is_some_and(|header| header.ends_with(",failure"));
    is_header && lines.next().is_none_or(|row| row.starts_with("0,"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_quoted_where_they_must_be() {
        for (text, cell) in [
            ("", ""),
            ("too far", "too far"),
            ("I = (1, 2)", "\"I = (1, 2)\""),
            ("no \"lift\"", "\"no \"\"lift\"\"\""),
            ("one\ntwo", "\"one\ntwo\""),
        ] {
            assert_eq!(quoted(text), cell);
        }
    }

    #[test]
    fn a_table_of_a_sweep_is_told_from_other_tables() {
        for (text, expected) in [
            ("index,body.mass,megno,failure\n0,1.0,2.0,\n", true),
            ("index,body.mass,megno,failure\n", true),
            ("index,body.mass,megno,failure,mine\n0,1.0,2.0,,3\n", false),
            ("index,name,failure\nA,x,y\n", false),
            ("index,name\n0,x\n", false),
        ] {
            assert_eq!(is_sweep(text.as_bytes()), expected, "{text:?}");
        }
    }
}
