//! Errors of files with arrays.

use lie_poisson_runs::TopQuantity;
use std::io;

/// The reason why a file has not the array that is needed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FieldFileError {
    /// The file cannot be read.
    #[error("it cannot be read")]
    Read(#[source] io::Error),
    /// The file has another format, or one that is not read here.
    #[error("{0}")]
    Format(String),
    /// There is no array of this name, or nothing else that was looked for.
    #[error("it has no {kind} {name}; it has {}", if has.is_empty() { "none".into() } else { has.join(", ") } + &on_request(kind, name, has))]
    NoArray {
        /// What was looked for, such as "array".
        kind: &'static str,
        /// The name that was looked for.
        name: String,
        /// The names of those that there are.
        has: Vec<String>,
    },
    /// The array has another shape.
    #[error(
        "the shape of {name} is {found:?}, not {expected:?}, nor that with a number of samples before it"
    )]
    Shape {
        /// The name of the array.
        name: String,
        /// The shape of the system's array.
        expected: Vec<usize>,
        /// The shape in the file.
        found: Vec<usize>,
    },
}

/// Returns the end of a message that says how the run of a top gets a column of this name.
fn on_request(kind: &str, name: &str, has: &[String]) -> String {
    // Only the runs of tops have them.
    let is_there = |array: &&str| has.iter().any(|one| one.trim_end_matches('1') == *array);
    if !["Pi", "Gamma"].iter().all(is_there) {
        return String::new();
    }
    if kind == "attitude" {
        return "; write attitude = true under [output], and simulate again".into();
    }
    let named = TopQuantity::NAMES
        .iter()
        .find(|(known, _)| known.replace('-', "_") == name.replace('-', "_"));
    let is_vector = |quantity: &TopQuantity| quantity.columns().len() == 3;
    let fits = |quantity: &TopQuantity| !kind.starts_with("vector") || is_vector(quantity);
    let quantity = named
        .map(|(_, quantity)| *quantity)
        .or_else(|| TopQuantity::with_column(name))
        .filter(fits);
    quantity.map_or_else(String::new, |quantity| {
        format!("; write columns = [\"{}\"] under [output], and simulate again", quantity.name())
    })
}

impl From<io::Error> for FieldFileError {
    fn from(error: io::Error) -> Self {
        Self::Read(error)
    }
}
