//! A number or a list of numbers: [`Numbers`].

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};

/// A number, or the components of a vector. Rows of numbers, such as positions, are the components one after the other.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Numbers {
    /// A value that is one number.
    One(f64),
    /// The components of a vector.
    Many(Vec<f64>),
}

/// What a file may have.
#[derive(Deserialize)]
#[serde(
    untagged,
    expecting = "expected a number, an array of numbers, or an array of rows of numbers"
)]
enum Written {
    One(f64),
    Many(Vec<f64>),
    Rows(Vec<Vec<f64>>),
}

impl<'de> Deserialize<'de> for Numbers {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        Ok(match Written::deserialize(from)? {
            Written::One(value) => Self::One(value),
            Written::Many(values) => Self::Many(values),
            Written::Rows(rows) => match rows.iter().all(|row| row.len() == rows[0].len()) {
                true => Self::Many(rows.concat()),
                false => return Err(D::Error::custom("expected rows of one length")),
            },
        })
    }
}

impl Numbers {
    /// Returns the number or the components.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        match self {
            Self::One(value) => core::slice::from_ref(value),
            Self::Many(values) => values,
        }
    }
}
