//! Formulas for coordinates: [`Element`].

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};
use std::collections::BTreeMap;

/// Formulas by the names of the coordinates, or of the vectors of coordinates, to which they belong; what is left out is 0.
pub type Element = BTreeMap<String, Formulas>;

/// A formula, or the formulas of the components of a vector. Numbers are formulas, too. The force on a fluid has rows
/// of numbers instead.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Formulas {
    /// The formula of a scalar.
    One(String),
    /// The formulas of the components of a vector.
    Many(Vec<String>),
    /// Coefficients of spherical harmonics, of a fluid alone.
    Rows(Vec<[f64; 4]>),
}

/// What a file may have.
#[derive(Deserialize)]
#[serde(
    untagged,
    expecting = "expected a formula, such as \"-0.1*Pi1\", an array of formulas, or, for a fluid, rows [l, m, re, im] of numbers"
)]
enum Written {
    One(Entry),
    Many(Vec<Entry>),
    Rows(Vec<[f64; 4]>),
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Entry {
    Number(f64),
    Text(String),
}

impl Entry {
    /// Returns the formula. A number is one, if it is finite.
    fn into_formula<E: Error>(self) -> Result<String, E> {
        match self {
            Self::Number(number) if number.is_finite() => Ok(format!("{number:?}")),
            Self::Number(number) => {
                Err(E::custom(format_args!("expected a finite number or a formula, got {number}")))
            }
            Self::Text(text) => Ok(text),
        }
    }
}

impl<'de> Deserialize<'de> for Formulas {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        Ok(match Written::deserialize(from)? {
            Written::One(entry) => Self::One(entry.into_formula()?),
            Written::Rows(rows) => Self::Rows(rows),
            Written::Many(entries) => {
                let formulas = entries.into_iter().map(Entry::into_formula);
                Self::Many(formulas.collect::<Result<_, _>>()?)
            }
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
            // No formula: the parser says so.
            Self::Rows(rows) => rows.iter().map(|row| format!("{row:?}")).collect(),
        }
    }
}

/// Returns the texts by name.
pub(super) fn parts(element: &Element) -> impl Iterator<Item = (&str, Vec<String>)> {
    element.iter().map(|(name, formulas)| (name.as_str(), formulas.texts()))
}
