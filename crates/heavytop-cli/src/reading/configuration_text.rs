//! A text with keys of a configuration: a file, standard input, or an assignment on the command line.

use super::formula_place::within;
use super::hints::hint;
use super::key_path::{KeyPath, Step};
use super::plain_words::{UNKNOWN, message, repair};
use super::readable_text::readable;
use crate::configuration::Config;
use crate::errors::{Error, Quotation};
use crate::vocabulary::brief;
use toml::Table;
use toml::de::DeTable;

/// The repair of a state of a system that stands in the table for those of tops.
const SYSTEM_STATE: &str = "write the state of a system as initial = { ... } in [system]";

/// A text with keys of a configuration.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ConfigurationText {
    /// The name in messages.
    pub name: String,
    pub text: String,
}

impl ConfigurationText {
    /// Returns the keys of the text, each with a value of its type.
    ///
    /// # Errors
    /// If the text is not TOML, or has unknown keys or wrong types.
    pub fn table(&self) -> Result<Table, Error> {
        let unread = |error| self.misread(&error, KeyPath::default());
        let text = readable(&self.text);
        let table: Table = toml::from_str(&text).map_err(unread)?;
        // The text is first read by itself, since only its own text has lines to quote.
        self.read(table.clone())?;
        Ok(table)
    }

    /// Returns the keys of the text, which has been read before.
    pub fn keys(&self) -> Option<Table> {
        toml::from_str(&readable(&self.text)).ok()
    }

    /// Reads a configuration, whose keys may be of other texts too.
    ///
    /// # Errors
    /// If there are unknown keys or wrong types.
    pub fn read(&self, table: Table) -> Result<Config, Error> {
        Config::of_table(table).map_err(|error| {
            let path = KeyPath::from(error.path());
            self.misread(&error.into_inner(), path)
        })
    }

    /// Adds to an error the place of the value with this path, and the repair. If the text does not have the key, the
    /// error comes back as it is.
    pub fn quote(&self, path: &str, note: &str, error: Error) -> Result<Error, Error> {
        let path = KeyPath::from(path);
        match path.span(&self.text) {
            // A table alone tells nothing about a key in it.
            Some((span, steps)) if steps >= path.0.len().min(2) => {
                let span = within(&self.text, span, &error);
                let quotation = Box::new(Quotation::new(&self.name, &self.text, span, note));
                Ok(Error::Quoted { quotation, source: Box::new(error) })
            }
            _ => Err(error),
        }
    }

    /// Returns the error of the TOML reader with its place in the text, the key to which the path leads, and a repair.
    fn misread(&self, error: &toml::de::Error, mut path: KeyPath) -> Error {
        // A text that is no TOML has no keys.
        let is_text = path.0.is_empty() && DeTable::parse(&self.text).is_err();
        if let Some((place, note)) =
            error.span().filter(|_| is_text).and_then(|span| hint(&self.text, &span))
        {
            let quotation = Quotation::new(&self.name, &self.text, place, &note);
            let source = Box::new(Error::Misread(message(error.message())));
            return Error::Quoted { quotation: Box::new(quotation), source };
        }
        let message = message(error.message());
        // A message about two keys of one table begins with the one to quote.
        let own = message.strip_prefix('`').and_then(|rest| rest.split('`').next());
        path.0.extend(own.map(|key| Step::Key(key.into())));
        let at_path = path.span(&self.text).map(|(span, _)| span);
        let key = path.key_span(&self.text).filter(|_| message.starts_with(UNKNOWN));
        let span = key.or(at_path).or(error.span());
        let of_system = message.starts_with(UNKNOWN)
            && matches!(path.0.first(), Some(Step::Key(table)) if table == "initial")
            && self.keys().is_some_and(|table| table.contains_key("system"));
        let note = if of_system { SYSTEM_STATE.into() } else { repair(&message) };
        let quotation = Quotation::new(&self.name, &self.text, span.unwrap_or(0..0), &note);
        let message = match path.to_string().as_str() {
            // The message names the key already.
            _ if message.starts_with(UNKNOWN) || message.starts_with('`') => message,
            "" => message,
            key => format!("{key}: {message}"),
        };
        let source = Box::new(Error::Misread(brief::message(&message)));
        Error::Quoted { quotation: Box::new(quotation), source }
    }
}
