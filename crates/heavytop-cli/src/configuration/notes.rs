//! What the end of a run tells of its configuration: [`Notes`].

use super::top::{BodyConfig, LeftOut};
use serde::Serialize;
use std::fmt;

/// What the summary, the closing lines and the metadata of an output tell of a configuration of a top: the values that it
/// left out, and the principal axes that were found.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Notes {
    /// The values that were left out of `[body]` and `[initial]` although one of them was opened, as `body.gravity = 1.0`.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub left_out: Vec<String>,
    /// The top from which these values were taken.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub taken_from: Option<String>,
    /// The principal moments about the support, kg m², where the configuration does not give them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub principal_moments: Option<[f64; 3]>,
    /// The principal axes, a unit vector in the axes of the table `[body]` for each moment.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub principal_axes: Option<[[f64; 3]; 3]>,
}

impl Notes {
    /// Returns the notes of a body and of what its configuration leaves out.
    pub(super) fn new(body: &BodyConfig, left_out: &LeftOut) -> Self {
        let found = body.axes().ok().filter(|axes| !body.names(axes));
        Self {
            left_out: left_out.lines(),
            taken_from: Some(left_out.of.clone()).filter(|_| !left_out.keys.is_empty()),
            principal_moments: found.map(|axes| axes.moments().into()),
            principal_axes: found.map(|axes| axes.rotation().into()),
        }
    }

    /// Returns the notes as texts by name, for metadata.
    #[must_use]
    pub fn pairs(&self) -> Vec<(&'static str, String)> {
        let mut pairs = Vec::new();
        if let Some(of) = &self.taken_from {
            pairs.push(("left_out", self.left_out.join("\n")));
            pairs.push(("taken_from", of.clone()));
        }
        pairs.extend(
            self.principal_moments.map(|found| ("principal_moments", format!("{found:?}"))),
        );
        pairs.extend(self.principal_axes.map(|found| ("principal_axes", format!("{found:?}"))));
        pairs
    }
}

/// The axes of `[body]`.
const IDENTITY: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Returns a number without the digits that its computation has rounded.
fn rounded(x: f64) -> f64 {
    format!("{x:.7e}").parse().unwrap_or(x)
}

/// Writes a line for each note.
impl fmt::Display for Notes {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(of) = &self.taken_from {
            writeln!(to, "left out, and taken from {of}: {}", self.left_out.join(", "))?;
        }
        if let (Some(moments), Some(axes)) = (self.principal_moments, self.principal_axes) {
            let moments = moments.map(rounded);
            write!(to, "the principal moments about the support are {moments:?} kg m²")?;
            match axes == IDENTITY {
                true => writeln!(to)?,
                false => {
                    let axes = axes.map(|axis| axis.map(rounded));
                    writeln!(to, ", about the axes {axes:?}; the output is in the axes of [body]")?;
                }
            }
        }
        Ok(())
    }
}
