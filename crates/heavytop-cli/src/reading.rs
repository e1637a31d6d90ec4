//! Configurations from text and as text.

use crate::Error;
use crate::config::Config;
use crate::preset::Preset;
use crate::suggestion::suggestion;
use std::collections::BTreeSet;
use std::path::Path;
use toml::{Table, Value};

impl Config {
    /// The configuration of a preset, or the default one, with the keys of a file put over it.
    ///
    /// # Errors
    /// As [`Config::read_over`].
    pub fn load(preset: Option<Preset>, file: Option<&Path>) -> Result<Self, Error> {
        let base = preset.map_or_else(Self::default, Preset::config);
        match file {
            Some(path) => base.read_over(path),
            None => Ok(base),
        }
    }

    /// The configuration of a file; keys that it leaves out are as by default.
    ///
    /// # Errors
    /// As [`Config::read_over`].
    pub fn read(path: &Path) -> Result<Self, Error> {
        Self::default().read_over(path)
    }

    /// The configuration of a file; keys that it leaves out are as here.
    ///
    /// # Errors
    /// If it cannot be read, is not TOML, or has unknown keys or wrong types; the error names the
    /// line and the column.
    pub fn read_over(&self, path: &Path) -> Result<Self, Error> {
        let text = std::fs::read_to_string(path)
            .map_err(|source| Error::Read { path: path.into(), source })?;
        let located = |error| located(path, &text, &error);
        // By itself first: only the text that was written has lines to name.
        let _: Self = toml::from_str(&text).map_err(located)?;
        let mut table = Table::try_from(self).map_err(Error::Unwritable)?;
        overlay(&mut table, toml::from_str(&text).map_err(located)?);
        table.try_into().map_err(located)
    }

    /// The configuration as TOML, which reads back as the same configuration.
    ///
    /// # Errors
    /// If it has a number that TOML has not: an integer of more than 63 bits.
    ///
    /// # Example
    /// ```
    /// use heavytop_cli::preset::Preset;
    /// let text = Preset::MultibodyBenchmark.config().to_toml()?;
    /// assert!(text.contains("[integrator]\nformulation = \"reduced\""));
    /// # Ok::<(), heavytop_cli::Error>(())
    /// ```
    pub fn to_toml(&self) -> Result<String, Error> {
        toml::to_string(self).map_err(Error::Unwritable)
    }

    /// The keys in which another configuration differs: `[integrator] step: 0.02 against 0.01`.
    ///
    /// # Errors
    /// As [`Config::to_toml`].
    pub fn differences(&self, other: &Self) -> Result<Vec<String>, Error> {
        let table = |config: &Self| Table::try_from(config).map_err(Error::Unwritable);
        let (here, there) = (table(self)?, table(other)?);
        let mut differences = Vec::new();
        for section in union(&here, &there) {
            let keys = |table: &Table| {
                table.get(section).and_then(Value::as_table).cloned().unwrap_or_default()
            };
            let (here, there) = (keys(&here), keys(&there));
            for key in union(&here, &there) {
                let text = |table: &Table| {
                    table.get(key).map_or_else(|| "nothing".into(), Value::to_string)
                };
                let (here, there) = (text(&here), text(&there));
                if here != there {
                    differences.push(format!("[{section}] {key}: {here} against {there}"));
                }
            }
        }
        Ok(differences)
    }
}

/// The keys of both tables.
fn union<'a>(one: &'a Table, other: &'a Table) -> BTreeSet<&'a String> {
    one.keys().chain(other.keys()).collect()
}

/// Puts the keys of one table over those of another, in tables within tables as well.
fn overlay(base: &mut Table, over: Table) {
    for (key, value) in over {
        match (base.get_mut(&key), value) {
            (Some(Value::Table(base)), Value::Table(over)) => overlay(base, over),
            (_, value) => {
                base.insert(key, value);
            }
        }
    }
}

/// The error with its place in the text.
fn located(path: &Path, text: &str, error: &toml::de::Error) -> Error {
    let before = text.get(..error.span().map_or(0, |span| span.start)).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    Error::Configuration {
        path: path.into(),
        line: before.matches('\n').count() + 1,
        column: before[line_start..].chars().count() + 1,
        message: message(error.message()),
    }
}

/// What Rust calls a number, and what everybody does.
const TYPES: [(&str, &str); 3] = [
    ("expected f64", "expected a number"),
    ("expected u32", "expected a whole number from 0 to 4294967295"),
    ("expected u64", "expected a whole number from 0 to 9223372036854775807"),
];

/// In our words, on one line, and with a suggestion for a misspelt key.
fn message(original: &str) -> String {
    let line = original.replace('\n', "; ").replace(" as i128", "");
    let line = TYPES.iter().fold(line, |line, (rust, plain)| line.replace(rust, plain));
    let Some(unknown) = line.strip_prefix("unknown field") else { return line };
    let mut quoted = unknown.split('`').skip(1).step_by(2);
    let suggested = quoted.next().map_or_else(String::new, |typed| suggestion(typed, quoted));
    format!("unknown key{unknown}{suggested}")
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::section::SectionConfig;

    #[test]
    fn a_configuration_reads_back_as_it_was_written() {
        for preset in [Preset::Kovalevskaya, Preset::MultibodyBenchmark] {
            let config = preset.config();
            let again: Config = toml::from_str(&config.to_toml().unwrap()).unwrap();
            assert_eq!(again, config);
            assert!(config.differences(&again).unwrap().is_empty());
        }
        let differences =
            Config::default().differences(&Preset::GoryachevChaplygin.config()).unwrap();
        assert_eq!(differences.len(), 3, "{differences:?}");
        assert_eq!(differences[0], "[body] inertia: [2.0, 2.0, 1.0] against [4.0, 4.0, 1.0]");
        // What one of them has alone is a difference, either way.
        let section = Some(SectionConfig { energy: Some(1.5), ..SectionConfig::default() });
        let other = Config { section, ..Config::default() };
        let energy = |differences: Vec<String>| differences.join("; ").contains("[section] energy");
        assert!(energy(Config::default().differences(&other).unwrap()));
        assert!(energy(other.differences(&Config::default()).unwrap()));
    }
}
