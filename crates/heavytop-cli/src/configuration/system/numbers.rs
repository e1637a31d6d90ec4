//! A number or a list of numbers: [`Numbers`].

use serde::{Deserialize, Serialize};

/// A number, or the components of a vector.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(untagged, expecting = "expected a number or an array of numbers")]
pub enum Numbers {
    /// A value that is one number.
    One(f64),
    /// The components of a vector.
    Many(Vec<f64>),
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
