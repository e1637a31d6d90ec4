//! The file of a problem of `bench`: tops, their starts, and their states at two times.

use crate::errors::Error;
use crate::files::bounded;
use crate::vocabulary::brief;
use heavytop::{Body, HeavyTop};
use lie_poisson::Se3Dual;
use lie_poisson_runs::contests::{EARLY, TimedProblem};
use nalgebra::Vector3;
use std::path::Path;

/// Reads a file of numbers: I₁ I₂ I₃ mgl c₁ c₂ c₃ end on the first line; then for each top a line
/// with (Π, Γ) at 0, 10 and end.
///
/// # Errors
/// If the file cannot be read, or has another form.
pub(super) fn read(path: &Path) -> Result<TimedProblem, Error> {
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
        Ok(TimedProblem { top, end, tops, starts, early, late })
    } else {
        Err(Error::OutOfRange { name: "end", range: "finite and more than 10", value: end })
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
