//! Configurations as TOML, and the differences of two of them.

use super::keyed_value::KeyedValue;
use crate::configuration::Config;
use crate::errors::Error;
use crate::vocabulary::brief;
use serde::de::{DeserializeOwned, Error as _};
use serde::{Deserialize, Deserializer};
use std::collections::BTreeSet;
use toml::{Table, Value};

/// The error of a table that is no configuration, with the path of the key at fault.
type Misread = serde_path_to_error::Error<toml::de::Error>;

/// Reads the configuration in a larger table, by the code that reads a configuration alone.
///
/// # Errors
/// If there are unknown keys or wrong types.
pub(crate) fn inner<'de, D: Deserializer<'de>>(from: D) -> Result<Config, D::Error> {
    Config::of_table(Table::deserialize(from)?).map_err(D::Error::custom)
}

/// Reads the table of a file that the program has written, such as a checkpoint.
///
/// # Errors
/// If there are missing or unknown keys, or wrong types.
pub(crate) fn read_saved<T: DeserializeOwned>(table: Table) -> Result<T, toml::de::Error> {
    T::deserialize(KeyedValue(Value::Table(table)))
}

impl Config {
    /// Returns the configuration of a table.
    ///
    /// # Errors
    /// If there are unknown keys or wrong types.
    pub(crate) fn of_table(table: Table) -> Result<Self, Misread> {
        serde_path_to_error::deserialize(KeyedValue(Value::Table(table)))
    }

    /// Returns the configuration as TOML, which reads back as the same configuration. For a system it lacks the tables of
    /// tops.
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
        // `toml::to_string` writes integers of more than 63 bits, which cannot be read back; `Table::try_from` refuses them.
        let mut table = Table::try_from(self).map_err(Error::Unwritable)?;
        if self.system.is_none() {
            return toml::to_string(self).map_err(Error::Unwritable);
        }
        // `Config::system` makes sure that they have nothing but the values of keys left out.
        for of_tops in ["body", "initial"] {
            table.remove(of_tops);
        }
        toml::to_string(&table).map_err(Error::Unwritable)
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

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::configuration::{Preset, SectionConfig};

    #[test]
    fn a_configuration_reads_back_as_it_was_written() {
        for preset in [Preset::Kovalevskaya, Preset::MultibodyBenchmark] {
            let config = preset.config();
            let again: Config = toml::from_str(&config.to_toml().unwrap()).unwrap();
            assert_eq!(again, config);
            assert!(config.differences(&again).unwrap().is_empty());
        }
        let system =
            "[system]\nalgebra = 'so(3)'\nhamiltonian = 'Pi·Pi'\ninitial = { Pi = [1, 2, 3] }";
        let system: Config = toml::from_str(system).unwrap();
        let text = system.to_toml().unwrap();
        assert!(!text.contains("[body]") && !text.contains("[initial]"), "{text}");
        assert_eq!(toml::from_str::<Config>(&text).unwrap(), system);
        let differences =
            Config::default().differences(&Preset::GoryachevChaplygin.config()).unwrap();
        assert_eq!(differences.len(), 3, "{differences:?}");
        assert_eq!(differences[0], "[body] inertia: [2.0, 2.0, 1.0] against [4.0, 4.0, 1.0]");
        let mut heavy = Config::default();
        (heavy.body.weight_moment, heavy.integrator.step) = (Some(1e308), Some(1e-9));
        let expected =
            ["[body] weight_moment: 1.0 against 1e308", "[integrator] step: nothing against 1e-9"];
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
