//! Reading and writing of configurations as TOML.

use super::config::Config;
use super::preset::Preset;
use crate::Error;
use crate::files::bounded;
use crate::vocabulary::brief::{self, text};
use crate::vocabulary::suggestion::suggestion;
use serde::Deserializer;
use serde_path_to_error::Segment;
use std::collections::BTreeSet;
use std::ops::Range;
use std::path::Path;
use toml::de::DeTable;
use toml::{Table, Value};

/// The largest size of a configuration file.
const MOST_BYTES: u64 = 1 << 20;

impl Config {
    /// Returns the configuration of a preset, or the default one, overridden by the keys of a file.
    ///
    /// # Errors
    /// The errors of [`Config::read_over`].
    pub fn load(preset: Option<Preset>, file: Option<&Path>) -> Result<Self, Error> {
        let base = preset.map_or_else(Self::default, Preset::config);
        match file {
            Some(path) => base.read_over(path),
            None => Ok(base),
        }
    }

    /// Reads the configuration of a file; keys that it leaves out have their default values.
    ///
    /// # Errors
    /// The errors of [`Config::read_over`].
    pub fn read(path: &Path) -> Result<Self, Error> {
        Self::default().read_over(path)
    }

    /// Reads the configuration of a file; keys that it leaves out have the values of `self`.
    ///
    /// # Errors
    /// If the file cannot be read, has more than a mebibyte, is not TOML, or has unknown keys or wrong types; the
    /// error then names the line, the column and the key.
    pub fn read_over(&self, path: &Path) -> Result<Self, Error> {
        let text = bounded::read(path, MOST_BYTES)
            .map_err(|source| Error::Read { path: path.into(), source })?;
        let located = |error, way: &[&Segment]| located(path, &text, &error, way);
        let unread = |error| located(error, &[]);
        // The file is first read by itself, since only its own text has lines to name.
        let _ = read(toml::Deserializer::parse(&text).map_err(unread)?, located)?;
        let mut table = Table::try_from(self).map_err(Error::Unwritable)?;
        overlay(&mut table, toml::from_str(&text).map_err(unread)?);
        read(table, located)
    }

    /// Returns the configuration as TOML, which reads back as the same configuration.
    ///
    /// # Errors
    /// If a number cannot be written in TOML: an integer of more than 63 bits.
    ///
    /// # Example
    /// ```
    /// use heavytop_cli::configuration::Preset;
    /// let text = Preset::MultibodyBenchmark.config().to_toml()?;
    /// assert!(text.contains("[integrator]\nformulation = \"reduced\""));
    /// # Ok::<(), heavytop_cli::Error>(())
    /// ```
    pub fn to_toml(&self) -> Result<String, Error> {
        toml::to_string(self).map_err(Error::Unwritable)
    }

    /// Returns the keys in which another configuration differs: `[integrator] step: 0.02 against 0.01`.
    ///
    /// # Errors
    /// The errors of [`Config::to_toml`].
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
                let (here, there) = (here.get(key), there.get(key));
                // Texts are compared, so that NaN equals itself.
                if here.map(Value::to_string) != there.map(Value::to_string) {
                    let [here, there] = [here, there]
                        .map(|value| value.map_or("nothing".into(), |v| brief::message(&short(v))));
                    differences.push(format!("[{section}] {key}: {here} against {there}"));
                }
            }
        }
        Ok(differences)
    }
}

/// Returns the keys of both tables.
fn union<'a>(one: &'a Table, other: &'a Table) -> BTreeSet<&'a String> {
    one.keys().chain(other.keys()).collect()
}

/// Overrides the keys of one table by those of another, in nested tables as well.
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

/// Deserialises the configuration, or returns the error with the way to its key.
fn read<'de>(
    from: impl Deserializer<'de, Error = toml::de::Error>,
    located: impl Fn(toml::de::Error, &[&Segment]) -> Error,
) -> Result<Config, Error> {
    serde_path_to_error::deserialize(from).map_err(|error| {
        let path = error.path().clone();
        let way: Vec<&Segment> = path.iter().collect();
        located(error.into_inner(), &way)
    })
}

/// Formats the value, each of its numbers with the fewest digits.
fn short(value: &Value) -> String {
    match value {
        Value::Float(number) => format!("{number:?}"),
        Value::Array(values) => {
            let values: Vec<String> = values.iter().map(short).collect();
            format!("[{}]", values.join(", "))
        }
        other => other.to_string(),
    }
}

/// Returns the error with its place in the text, and with the key to which the way leads.
fn located(path: &Path, text: &str, error: &toml::de::Error, way: &[&Segment]) -> Error {
    let start = error.span().or_else(|| span(text, way)).map_or(0, |span| span.start);
    let before = text.get(..start).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    let (key, message) = (key(way), message(error.message()));
    Error::Configuration {
        path: path.into(),
        line: before.matches('\n').count() + 1,
        column: before[line_start..].chars().count() + 1,
        message: match key.as_str() {
            // The message of an unknown key names it already.
            _ if message.starts_with(UNKNOWN) => message,
            "" => message,
            key => format!("{key}: {message}"),
        },
    }
}

/// Formats the way to a key, as in `body.inertia[3]`.
fn key(way: &[&Segment]) -> String {
    way.iter().fold(String::new(), |key, segment| match segment {
        Segment::Map { key: name } if key.is_empty() => text(name),
        Segment::Map { key: name } => format!("{key}.{}", text(name)),
        Segment::Seq { index } => format!("{key}[{index}]"),
        _ => key,
    })
}

/// Returns the place of the value in the text, or of the innermost value on the way to it.
fn span(text: &str, way: &[&Segment]) -> Option<Range<usize>> {
    let document = DeTable::parse(text).ok()?;
    let Some((Segment::Map { key }, rest)) = way.split_first() else { return None };
    let mut value = document.get_ref().get(key.as_str())?;
    for segment in rest {
        let inner = match segment {
            Segment::Map { key } => value.get_ref().get(key.as_str()),
            Segment::Seq { index } => value.get_ref().get(*index),
            _ => None,
        };
        match inner {
            Some(inner) => value = inner,
            None => break,
        }
    }
    Some(value.span())
}

/// Names of types in messages of Rust, and the plain words for them.
const TYPES: [(&str, &str); 5] = [
    ("missing field", "missing key"),
    ("expected a sequence", "expected an array"),
    ("expected f64", "expected a number"),
    ("expected u32", "expected a whole number from 0 to 4294967295"),
    ("expected u64", "expected a whole number from 0 to 9223372036854775807"),
];

/// The text by which Rust's messages call a table.
const TABLE: &str = "expected struct ";

/// The beginning of a message about an unknown key.
const UNKNOWN: &str = "unknown key";

/// Rewrites a message in plain words, short, on one line, and with a suggestion for a misspelt key.
fn message(original: &str) -> String {
    let line = original.replace('\n', "; ").replace(" as i128", "");
    let line = TYPES.iter().fold(line, |line, (rust, plain)| line.replace(rust, plain));
    let line = match line.split_once(TABLE) {
        Some((before, _)) => format!("{before}expected a table"),
        None => line,
    };
    let line = brief::message(&line);
    let Some(unknown) = line.strip_prefix("unknown field") else { return line };
    let mut quoted = unknown.split('`').skip(1).step_by(2);
    let suggested = quoted.next().map_or_else(String::new, |typed| suggestion(typed, quoted));
    format!("{UNKNOWN}{unknown}{suggested}")
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::configuration::SectionConfig;

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
        let mut heavy = Config::default();
        (heavy.body.mass, heavy.integrator.step) = (1e308, Some(1e-9));
        let expected =
            ["[body] mass: 1.0 against 1e308", "[integrator] step: nothing against 1e-9"];
        assert_eq!(Config::default().differences(&heavy).unwrap(), expected);
        // A difference counts even if too much text surrounds it to be shown.
        let tops = |mass: &str| {
            let axis = "{ parameter = 'body.length', uniform = [0, 1] }, ".repeat(40);
            let text =
                format!("{axis}{{ parameter = 'body.mass', uniform = [0, {mass}] }}, {axis}");
            toml::from_str::<Config>(&format!("sweep.axes = [{text}]")).unwrap()
        };
        assert_eq!(tops("1").differences(&tops("2")).unwrap().len(), 1);
        assert!(tops("nan").differences(&tops("nan")).unwrap().is_empty());
        // A table that only one of the two configurations has is a difference, either way.
        let section = Some(SectionConfig { energy: Some(1.5), ..SectionConfig::default() });
        let other = Config { section, ..Config::default() };
        let energy = |differences: Vec<String>| differences.join("; ").contains("[section] energy");
        assert!(energy(Config::default().differences(&other).unwrap()));
        assert!(energy(other.differences(&Config::default()).unwrap()));
    }
}
