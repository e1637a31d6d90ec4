//! Formulations and schemes in configurations: by their names, for `#[serde(with = …)]`.

use super::named::by_name;
use heavytop::methods::{Formulation, SchemeName};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serializer};

/// A part of a method that has a name.
pub(crate) trait MethodPart: Copy + 'static {
    /// The kind of part, as messages name it.
    const KIND: &'static str;
    /// All parts of this kind, with their names.
    const NAMES: &'static [(&'static str, Self)];

    /// Returns the name of this part.
    fn name(self) -> &'static str;
}

impl MethodPart for Formulation {
    const KIND: &'static str = "formulation";
    const NAMES: &'static [(&'static str, Self)] = Self::NAMES;

    fn name(self) -> &'static str {
        self.name()
    }
}

impl MethodPart for SchemeName {
    const KIND: &'static str = "scheme";
    const NAMES: &'static [(&'static str, Self)] = Self::NAMES;

    fn name(self) -> &'static str {
        self.name()
    }
}

/// Reads the name of a part of a method.
pub(crate) fn deserialize<'de, T: MethodPart, D>(from: D) -> Result<Option<T>, D::Error>
where
    D: Deserializer<'de>,
{
    let name = Option::<String>::deserialize(from)?;
    name.map(|name| by_name(T::KIND, T::NAMES, &name)).transpose().map_err(D::Error::custom)
}

/// Writes the name of a part of a method.
pub(crate) fn serialize<T: MethodPart, S: Serializer>(
    part: &Option<T>,
    to: S,
) -> Result<S::Ok, S::Error> {
    match part {
        Some(part) => to.serialize_some(part.name()),
        None => to.serialize_none(),
    }
}
