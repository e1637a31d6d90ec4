//! The sources of a configuration: a preset, a file, and assignments on the command line.

use super::assignment::{OPTION, line};
use super::configuration_text::ConfigurationText;
use super::repair::repairs;
use crate::configuration::{BodyConfig, Config, LeftOut, Preset};
use crate::errors::Error;
use crate::files::{Input, bounded};
use crate::vocabulary::brief::number;
use std::path::Path;
use toml::{Table, Value};

/// The largest size of a configuration file, in bytes.
const MOST_BYTES: u64 = 1 << 20;

/// The file name that stands for standard input.
const STANDARD_INPUT: &str = "-";

/// A configuration, and the texts that it was read from.
#[derive(Clone, Debug, PartialEq)]
pub struct Sources {
    config: Config,
    /// The texts; a later one overrides those before it.
    texts: Vec<ConfigurationText>,
    /// What was read, beside the command line.
    inputs: Vec<Input>,
}

impl Sources {
    /// Reads the configuration of a preset, or the default one, overridden by the keys of a file, overridden by
    /// assignments such as `integrator.end=50`. The file `-` is standard input.
    ///
    /// # Errors
    /// If the file cannot be read, has more than a mebibyte, or is not TOML; or if there are unknown keys or wrong
    /// types: the error then quotes the line, and offers a repair.
    ///
    /// # Example
    /// ```
    /// use heavytop_cli::configuration::Preset;
    /// use heavytop_cli::reading::Sources;
    /// let sources = Sources::read(Some(Preset::Lagrange), None, &["integrator.end=50".into()])?;
    /// assert_eq!(sources.config().experiment()?.pace.schedule.steps, 2500);
    /// # Ok::<(), heavytop_cli::Error>(())
    /// ```
    pub fn read(
        preset: Option<Preset>,
        file: Option<&Path>,
        assignments: &[String],
    ) -> Result<Self, Error> {
        let config = preset.map_or_else(Config::default, Preset::config);
        let mut sources = Self { config, texts: Vec::new(), inputs: Vec::new() };
        let of = preset.map_or_else(|| "the paper's top".into(), Preset::words);
        if let Some(path) = file {
            sources.inputs.push(match path == Path::new(STANDARD_INPUT) {
                true => Input::StandardInput,
                false => Input::File(path.into()),
            });
            sources.add(text(path)?)?;
        }
        for assignment in assignments {
            let text = line(assignment, &sources.table()?)?;
            sources.add(ConfigurationText { name: OPTION.into(), text })?;
        }
        let given: Vec<Table> = sources.texts.iter().filter_map(ConfigurationText::keys).collect();
        sources.config.left_out = LeftOut::new(of, &sources.table()?, &given);
        Ok(sources)
    }

    /// Returns the configuration that was read.
    #[must_use]
    pub fn config(&self) -> &Config {
        &self.config
    }

    /// Returns what was read, beside the command line: the configuration, and the tables of which it has the paths.
    #[must_use]
    pub fn inputs(&self) -> &[Input] {
        &self.inputs
    }

    /// Adds to a refusal the line of the key at fault, with the repair under it, where one of the texts has the key.
    #[must_use]
    pub fn locate(&self, mut error: Error) -> Error {
        if error.exit_code() != 2 || matches!(error, Error::Quoted { .. }) {
            return error;
        }
        for (key, note) in repairs(&error, &self.config) {
            for text in self.texts.iter().rev() {
                error = match text.quote(&key, &note, error) {
                    Ok(quoted) => return quoted,
                    Err(error) => error,
                };
            }
        }
        error
    }

    /// Overrides the configuration by the keys of a text.
    fn add(&mut self, text: ConfigurationText) -> Result<(), Error> {
        let (mut table, over) = (self.table()?, text.table()?);
        self.require_factors(&text, &over)?;
        remove_rivals(&mut table, &over);
        self.name_factors(&mut table, &over);
        overlay(&mut table, over);
        let mut config = text.read(table)?;
        // Paths in a file are relative to it.
        let folder = Path::new(&text.name).parent().unwrap_or(Path::new(""));
        if let Some(system) = config.system.as_mut() {
            match system.find_initial_file(folder) {
                Ok(path) => self.inputs.extend(path.map(Input::File)),
                Err(error) => {
                    return Err(text.quote("system.initial_file", "", error).unwrap_or_else(|e| e));
                }
            }
        }
        let system = config.system.as_mut();
        let read = system.map_or(Ok(None), |system| system.read_structure_constants(folder));
        match read {
            Ok(table) => self.inputs.extend(table.map(Input::File)),
            Err(error) => {
                return Err(text
                    .quote("system.structure_constants", "", error)
                    .unwrap_or_else(|e| e));
            }
        }
        match config.find_input_files(folder) {
            Ok(paths) => self.inputs.extend(paths.into_iter().map(Input::File)),
            Err(error) => {
                let key = repairs(&error, &config).into_iter().next();
                let (key, note) = key.unwrap_or_default();
                return Err(text.quote(&key, &note, error).unwrap_or_else(|error| error));
            }
        }
        self.config = config;
        self.texts.push(text);
        Ok(())
    }

    /// Checks that a text gives no factor of a weight moment that another text has given as a product: of the other factors
    /// nothing is known. That of a preset is the product of its factors.
    ///
    /// # Errors
    /// If it does; the error quotes the factor.
    fn require_factors(&self, text: &ConfigurationText, over: &Table) -> Result<(), Error> {
        let BodyConfig { mass, gravity, length, weight_moment, .. } = self.config.body;
        let over = over.get("body").and_then(Value::as_table);
        let factor = FACTORS.iter().find(|key| over.is_some_and(|over| over.contains_key(**key)));
        let (Some(factor), Some(product)) = (factor, weight_moment) else { return Ok(()) };
        if product == mass * gravity * length {
            return Ok(());
        }
        let error = Error::Misread(format!(
            "`body.{factor}` is a factor of `body.weight_moment`, which is {} before",
            number(product)
        ));
        let note = "write body.weight_moment, or mass, gravity and length instead of it";
        Err(text.quote(&format!("body.{factor}"), note, error).unwrap_or_else(|error| error))
    }

    /// Replaces the weight moment of the base by mass, gravity and length, where a text gives one of these.
    fn name_factors(&self, base: &mut Table, over: &Table) {
        let Some(over) = over.get("body").and_then(Value::as_table) else { return };
        let Some(base) = base.get_mut("body").and_then(Value::as_table_mut) else { return };
        if FACTORS.iter().any(|key| over.contains_key(*key)) && base.remove(WEIGHT).is_some() {
            let body = &self.config.body;
            for (key, value) in FACTORS.into_iter().zip([body.mass, body.gravity, body.length]) {
                base.insert(key.into(), value.into());
            }
        } else if over.contains_key(WEIGHT) {
            FACTORS.iter().for_each(|key| drop(base.remove(*key)));
        }
    }

    fn table(&self) -> Result<Table, Error> {
        Table::try_from(&self.config).map_err(Error::Unwritable)
    }
}

fn text(path: &Path) -> Result<ConfigurationText, Error> {
    let is_input = path == Path::new(STANDARD_INPUT);
    let (name, text) = match is_input {
        true => ("standard input".into(), bounded::read_from(std::io::stdin(), MOST_BYTES)),
        false => (path.display().to_string(), bounded::read(path, MOST_BYTES)),
    };
    let text = text.map_err(|source| Error::Read { path: name.clone().into(), source })?;
    Ok(ConfigurationText { name, text })
}

/// The key of `[body]` for the product of the factors.
const WEIGHT: &str = "weight_moment";

/// The keys of `[body]` for the factors of the weight moment.
const FACTORS: [&str; 3] = ["mass", "gravity", "length"];

/// Keys of `[initial]` that say the same thing in several ways.
const RIVALS: [&[&[&str]]; 2] = [
    &[&["angular_momentum"], &["angular_velocity"]],
    &[&["vertical"], &["inclination", "azimuth"], &["attitude"], &["euler_angles"]],
];

/// Keys of an input that say the same thing in several ways.
const RIVALS_OF_INPUT: &[&[&str]] = &[&["file", "time", "value", "checksum"], &["times", "values"]];

/// Removes the keys whose rivals override them.
fn remove_rivals(base: &mut Table, over: &Table) {
    let below = |table: &str| over.get(table).and_then(Value::as_table);
    if let (Some(over), Some(base)) = (below("initial"), base_of(base, "initial")) {
        remove_rivals_among(&RIVALS, base, over);
    }
    let Some(base) = base_of(base, "inputs") else { return };
    for (name, over) in below("inputs").into_iter().flatten() {
        if let (Some(over), Some(base)) = (over.as_table(), base_of(base, name)) {
            remove_rivals_among(&[RIVALS_OF_INPUT], base, over);
        }
    }
}

/// Returns the table of this name in a table.
fn base_of<'a>(base: &'a mut Table, name: &str) -> Option<&'a mut Table> {
    base.get_mut(name).and_then(Value::as_table_mut)
}

/// Removes the keys of one table whose rivals, in these ways to say a thing, override them.
fn remove_rivals_among(rivals: &[&[&[&str]]], base: &mut Table, over: &Table) {
    for ways in rivals {
        for (place, keys) in ways.iter().enumerate() {
            if keys.iter().any(|key| over.contains_key(*key)) {
                let others = ways.iter().enumerate().filter(|(other, _)| *other != place);
                others.flat_map(|(_, keys)| *keys).for_each(|key| drop(base.remove(*key)));
            }
        }
    }
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
