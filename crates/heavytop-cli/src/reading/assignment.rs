//! Assignments on the command line: `--set integrator.end=50`.

use super::key_path::{KeyPath, Step};
use super::readable_text::readable;
use crate::errors::Error;
use toml::{Table, Value};

/// The option that makes assignments.
pub(super) const OPTION: &str = "--set";

/// Returns the assignment as a line of TOML.
///
/// A value that is not TOML is taken as text, so that names need no quotation marks. A path may end in an index, as in
/// `body.inertia[1]`; then the line holds the whole array of `base` with that value in it.
///
/// # Errors
/// If there is no `=`, no key before it, or no such component.
pub(super) fn line(assignment: &str, base: &Table) -> Result<String, Error> {
    let refused = |reason| Error::Assignment { assignment: assignment.into(), reason };
    let (path, value) = assignment.split_once('=').ok_or_else(|| refused("it has no ="))?;
    let (path, value) = (path.trim(), value.trim());
    if path.is_empty() || path.contains(['\n', '\r', '#', '"', '\'']) {
        return Err(refused("it has no key before ="));
    }
    if value.is_empty() {
        return Err(refused("it has no value after ="));
    }
    let value = match toml::from_str::<Table>(&readable(&format!("value = {value}"))) {
        // Printed again, so that a comment does not come along.
        Ok(table) if table.len() == 1 => table["value"].to_string(),
        _ => Value::from(value).to_string(),
    };
    let steps = KeyPath::from(path);
    let Some((Step::Index(index), array)) = steps.0.split_last() else {
        return Ok(format!("{path} = {value}"));
    };
    let components = array_at(base, array).ok_or_else(|| refused("there is no such array"))?;
    let mut components: Vec<String> = components.iter().map(ToString::to_string).collect();
    *components.get_mut(*index).ok_or_else(|| refused("there is no such component"))? = value;
    let array = KeyPath(array.to_vec());
    Ok(format!("{array} = [{}]", components.join(", ")))
}

fn array_at<'a>(base: &'a Table, path: &[Step]) -> Option<&'a Vec<Value>> {
    let Some((Step::Key(key), rest)) = path.split_first() else { return None };
    let first = base.get(key);
    let value = rest.iter().fold(first, |value, step| match step {
        Step::Key(key) => value?.get(key),
        Step::Index(index) => value?.get(*index),
    });
    value?.as_array()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn assignments_become_toml() {
        let base: Table = toml::from_str("body.inertia = [1.0, 2.0, 3.0]").unwrap();
        for (assignment, expected) in [
            ("integrator.end=50", "integrator.end = 50"),
            (" output.attitude = true", "output.attitude = true"),
            ("integrator.scheme=gauss-4", "integrator.scheme = \"gauss-4\""),
            ("integrator.scheme='gauss-4'", "integrator.scheme = \"gauss-4\""),
            ("body.mass=100000000000000000000", "body.mass = 100000000000000000000.0"),
            ("body.inertia=[1, 1, 1]", "body.inertia = [1, 1, 1]"),
            ("body.inertia[1]=2.5", "body.inertia = [1.0, 2.5, 3.0]"),
            ("body.inertia[1]=2.5 # wide", "body.inertia = [1.0, 2.5, 3.0]"),
            // What would be two lines is one text.
            ("body.mass=1\nbody.length=2", "body.mass = \"\"\"\n1\nbody.length=2\"\"\""),
        ] {
            let line = line(assignment, &base).unwrap();
            assert!(toml::from_str::<Table>(&line).is_ok(), "{line}");
            if !assignment.contains('\n') {
                assert_eq!(line, expected);
            }
        }
        for wrong in ["end", "=3", "body.mass=", "body.inertia[3]=1", "body.mass[0]=1"] {
            assert!(line(wrong, &base).is_err(), "{wrong}");
        }
        // What is no index makes a line that is no TOML, and is refused with it.
        assert!(toml::from_str::<Table>(&line("a[x]=1", &base).unwrap()).is_err());
    }
}
