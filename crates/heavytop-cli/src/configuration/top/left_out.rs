//! What a configuration leaves out of `[body]` and `[initial]`, and where it is taken from.

use serde::{Deserialize, Serialize};
use toml::{Table, Value};

/// The tables whose missing keys are told.
const TABLES: [&str; 2] = ["body", "initial"];

/// The keys of `[body]` and `[initial]` that a configuration leaves out although it opens one of these tables, with the
/// values that they get.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct LeftOut {
    /// The top that the values are those of.
    pub of: String,
    /// The keys, as paths, with their values in TOML.
    pub keys: Vec<[String; 2]>,
}

impl LeftOut {
    /// Finds the keys of a configuration that none of the texts gives; none if no text opens one of the tables.
    pub(crate) fn new(of: String, configuration: &Table, given: &[Table]) -> Self {
        let opens = |table: &Table| TABLES.iter().any(|name| table.contains_key(*name));
        if !given.iter().any(opens) || configuration.contains_key("system") {
            return Self::default();
        }
        let keys_of = |table: &Table, name: &str| {
            table.get(name).and_then(Value::as_table).cloned().unwrap_or_default()
        };
        let mut keys = Vec::new();
        for name in TABLES {
            for (key, value) in keys_of(configuration, name) {
                if !given.iter().any(|text| keys_of(text, name).contains_key(&key)) {
                    keys.push([format!("{name}.{key}"), value.to_string()]);
                }
            }
        }
        Self { of, keys }
    }

    /// Returns whether a key was left out, by its path.
    #[must_use]
    pub fn contains(&self, path: &str) -> bool {
        self.keys.iter().any(|[key, _]| key == path)
    }

    /// Returns whether nothing was left out.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.keys.is_empty()
    }

    /// Returns the keys with their values, as lines `body.gravity = 1.0`.
    #[must_use]
    pub fn lines(&self) -> Vec<String> {
        self.keys.iter().map(|[key, value]| format!("{key} = {value}")).collect()
    }
}
