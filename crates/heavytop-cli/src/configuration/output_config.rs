//! The table `[output]`: what is written.

use crate::vocabulary::named::by_name;
use lie_poisson_runs::TopQuantity;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// The table `[output]`: what is written.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct OutputConfig {
    /// The number n such that every n-th step is written, and the last one.
    pub every: u64,
    /// Whether the attitude is written.
    pub attitude: bool,
    /// The quantities of a top that have columns after the others. Those of the attitude bring its columns with them.
    #[serde(
        skip_serializing_if = "Vec::is_empty",
        serialize_with = "names",
        deserialize_with = "quantities"
    )]
    pub columns: Vec<TopQuantity>,
}

impl Default for OutputConfig {
    fn default() -> Self {
        Self { every: 1, attitude: false, columns: Vec::new() }
    }
}

impl OutputConfig {
    /// Returns whether a run follows the attitude.
    #[must_use]
    pub fn has_attitude(&self) -> bool {
        self.attitude || self.columns.iter().any(|quantity| quantity.needs_attitude())
    }
}

fn names<S: Serializer>(quantities: &[TopQuantity], to: S) -> Result<S::Ok, S::Error> {
    to.collect_seq(quantities.iter().map(|quantity| quantity.name()))
}

fn quantities<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<TopQuantity>, D::Error> {
    let mut found = Vec::new();
    for name in Vec::<String>::deserialize(from)? {
        let quantity = by_name("column", TopQuantity::NAMES, &name).map_err(|unknown| {
            let of = TopQuantity::with_column(&name);
            D::Error::custom(
                of.map_or(unknown, |of| format!("`{name}` is a column of `{}`", of.name())),
            )
        })?;
        if found.contains(&quantity) {
            return Err(D::Error::custom(format!("the column `{name}` stands twice")));
        }
        found.push(quantity);
    }
    Ok(found)
}
