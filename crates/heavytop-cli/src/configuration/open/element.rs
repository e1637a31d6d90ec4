//! Formulas for coordinates: [`Element`].

use serde::{Deserialize, Deserializer, Serialize};
use std::collections::BTreeMap;

/// Formulas by the names of the coordinates, or of the vectors of coordinates, to which they belong; what is left out is 0.
pub type Element = BTreeMap<String, Formulas>;

/// A formula, or the formulas of the components of a vector. Numbers are formulas, too.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Formulas {
    /// The formula of a scalar.
    One(String),
    /// The formulas of the components of a vector.
    Many(Vec<String>),
}

/// What a file may have.
#[derive(Deserialize)]
#[serde(untagged, expecting = "expected a formula, such as \"-0.1*Pi1\", or an array of formulas")]
enum Written {
    One(Entry),
    Many(Vec<Entry>),
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Entry {
    Number(f64),
    Text(String),
}

impl From<Entry> for String {
    fn from(entry: Entry) -> Self {
        match entry {
            Entry::Number(number) => format!("{number:?}"),
            Entry::Text(text) => text,
        }
    }
}

impl<'de> Deserialize<'de> for Formulas {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        Ok(match Written::deserialize(from)? {
            Written::One(entry) => Self::One(entry.into()),
            Written::Many(entries) => Self::Many(entries.into_iter().map(String::from).collect()),
        })
    }
}

impl Formulas {
    /// Returns the texts of the formulas.
    #[must_use]
    pub fn texts(&self) -> Vec<String> {
        match self {
            Self::One(text) => vec![text.clone()],
            Self::Many(texts) => texts.clone(),
        }
    }
}

/// Returns the texts by name.
pub(super) fn parts(element: &Element) -> impl Iterator<Item = (&str, Vec<String>)> {
    element.iter().map(|(name, formulas)| (name.as_str(), formulas.texts()))
}
