//! Paths to the keys of a configuration, as in `body.inertia[1]`.

use crate::vocabulary::brief;
use serde_path_to_error::{Path, Segment};
use std::fmt;
use std::ops::Range;
use toml::de::DeTable;

/// A step on the path to a value: a key of a table, or an index of an array.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Step {
    Key(String),
    Index(usize),
}

/// The path to a value of a configuration.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct KeyPath(pub Vec<Step>);

impl KeyPath {
    /// Returns the place of the value in a text, or of the innermost value on the way to it, with the number of steps
    /// that lead there.
    pub fn span(&self, text: &str) -> Option<(Range<usize>, usize)> {
        self.places(text).map(|(_, value, steps)| (value, steps))
    }

    /// Returns the place of the key itself in a text, if the path leads to a value with a key.
    pub fn key_span(&self, text: &str) -> Option<Range<usize>> {
        self.places(text).filter(|(_, _, steps)| *steps == self.0.len()).and_then(|(key, ..)| key)
    }

    /// Returns the places of the innermost value on the way and of its key, with the number of steps.
    fn places(&self, text: &str) -> Option<(Option<Range<usize>>, Range<usize>, usize)> {
        let document = DeTable::parse(text).ok()?;
        let Some((Step::Key(key), rest)) = self.0.split_first() else { return None };
        let (key, mut value) = document.get_ref().get_key_value(key.as_str())?;
        let (mut key, mut steps) = (Some(key.span()), 1);
        for step in rest {
            let inner = match step {
                Step::Key(key) => value
                    .get_ref()
                    .as_table()
                    .and_then(|table| table.get_key_value(key.as_str()))
                    .map(|(key, value)| (Some(key.span()), value)),
                Step::Index(index) => value.get_ref().get(*index).map(|value| (None, value)),
            };
            let Some(inner) = inner else { break };
            ((key, value), steps) = (inner, steps + 1);
        }
        Some((key, value.span(), steps))
    }
}

/// Reads names, dots, and indices in brackets. What is no such path becomes one that leads nowhere.
impl From<&str> for KeyPath {
    fn from(path: &str) -> Self {
        let steps = path.split(['.', '[']).map(|step| match step.strip_suffix(']') {
            Some(index) => index.parse().map_or_else(|_| Step::Key(step.into()), Step::Index),
            None => Step::Key(step.into()),
        });
        Self(steps.collect())
    }
}

impl From<&Path> for KeyPath {
    fn from(path: &Path) -> Self {
        let step = |segment: &Segment| match segment {
            Segment::Map { key } => Some(Step::Key(key.clone())),
            Segment::Seq { index } => Some(Step::Index(*index)),
            _ => None,
        };
        Self(path.iter().filter_map(step).collect())
    }
}

impl fmt::Display for KeyPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (number, step) in self.0.iter().enumerate() {
            match step {
                Step::Key(key) if number == 0 => write!(f, "{}", brief::text(key))?,
                Step::Key(key) => write!(f, ".{}", brief::text(key))?,
                Step::Index(index) => write!(f, "[{index}]")?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn a_path_leads_to_its_value_or_as_near_as_it_can() {
        let text = "[body]\ninertia = [1, 22, 3]";
        for (path, found, steps) in [
            ("body.inertia[1]", "22", 3),
            ("body.inertia[7]", "[1, 22, 3]", 2),
            ("body.inertia", "[1, 22, 3]", 2),
        ] {
            assert_eq!(KeyPath::from(path).to_string(), path);
            let (span, count) = KeyPath::from(path).span(text).unwrap();
            assert_eq!((&text[span], count), (found, steps));
        }
        let key = |path: &str| KeyPath::from(path).key_span(text).map(|span| &text[span]);
        assert_eq!([key("body"), key("body.inertia")], [Some("body"), Some("inertia")]);
        assert_eq!([key("body.inertia[1]"), key("body.mass")], [None, None]);
        assert_eq!(KeyPath::from("body.mass").span(text).unwrap().1, 1);
        assert_eq!(KeyPath::from("output.every").span(text), None);
    }
}
