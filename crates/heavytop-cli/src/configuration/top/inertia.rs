//! The moments of inertia of `[body]`: three principal moments, or a matrix.

use nalgebra::{Matrix3, Vector3};
use serde::de::value::SeqAccessDeserializer;
use serde::de::{Error, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};
use std::fmt;

/// The moments of inertia of a body, kg m².
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Inertia {
    /// The principal moments; the axes of the body frame are the principal axes.
    Principal([f64; 3]),
    /// The rows of the inertia matrix, in any axes.
    Matrix([[f64; 3]; 3]),
}

/// The point about which moments of inertia are taken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum About {
    /// The fixed point.
    #[default]
    Support,
    /// The centre of mass.
    CenterOfMass,
}

impl Inertia {
    /// Returns the inertia matrix, kg m².
    #[must_use]
    pub fn matrix(&self) -> Matrix3<f64> {
        match self {
            Self::Principal(moments) => Matrix3::from_diagonal(&Vector3::from(*moments)),
            Self::Matrix(rows) => Matrix3::from_fn(|i, j| rows[i][j]),
        }
    }
}

impl From<[f64; 3]> for Inertia {
    fn from(moments: [f64; 3]) -> Self {
        Self::Principal(moments)
    }
}

/// Writes the moments or the rows in brackets.
impl fmt::Display for Inertia {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Principal(moments) => write!(to, "{moments:?}"),
            Self::Matrix(rows) => write!(to, "{rows:?}"),
        }
    }
}

/// An entry of the array: a moment, or a row of a matrix.
enum Entry {
    Moment(f64),
    Row([f64; 3]),
}

impl<'de> Deserialize<'de> for Entry {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_any(OneEntry)
    }
}

struct OneEntry;

impl<'de> Visitor<'de> for OneEntry {
    type Value = Entry;

    fn expecting(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str("a number, or a row of three numbers")
    }

    fn visit_f64<E>(self, moment: f64) -> Result<Entry, E> {
        Ok(Entry::Moment(moment))
    }

    fn visit_i64<E>(self, moment: i64) -> Result<Entry, E> {
        Ok(Entry::Moment(moment as f64))
    }

    fn visit_u64<E>(self, moment: u64) -> Result<Entry, E> {
        Ok(Entry::Moment(moment as f64))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, row: A) -> Result<Entry, A::Error> {
        <[f64; 3]>::deserialize(SeqAccessDeserializer::new(row)).map(Entry::Row)
    }
}

impl<'de> Deserialize<'de> for Inertia {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_seq(Entries)
    }
}

struct Entries;

impl<'de> Visitor<'de> for Entries {
    type Value = Inertia;

    fn expecting(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str("an array of length 3")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut entries: A) -> Result<Inertia, A::Error> {
        let mut all = Vec::new();
        while let Some(entry) = entries.next_element::<Entry>()? {
            all.push(entry);
        }
        match all.as_slice() {
            [Entry::Moment(a), Entry::Moment(b), Entry::Moment(c)] => {
                Ok(Inertia::Principal([*a, *b, *c]))
            }
            [Entry::Row(a), Entry::Row(b), Entry::Row(c)] => Ok(Inertia::Matrix([*a, *b, *c])),
            [_, _, _] => Err(A::Error::custom(
                "moments and rows are mixed, expected three numbers, or three rows of three numbers",
            )),
            other => Err(A::Error::invalid_length(other.len(), &self)),
        }
    }
}
