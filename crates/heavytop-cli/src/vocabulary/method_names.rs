//! Formulations and schemes in configurations: by their names.

use super::named::by_name;
use heavytop::methods::{Formulation, Scheme};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serializer};

/// Reads and writes the name of a formulation, for `#[serde(with = …)]`.
pub(crate) mod formulation {
    use super::*;

    pub(crate) fn deserialize<'de, D>(from: D) -> Result<Option<Formulation>, D::Error>
    where
        D: Deserializer<'de>,
    {
        read("formulation", Formulation::NAMES, from)
    }

    pub(crate) fn serialize<S>(to: &Option<Formulation>, serializer: S) -> Result<S::Ok, S::Error>
    where
        S: Serializer,
    {
        write(to.map(Formulation::name), serializer)
    }
}

/// Reads and writes the name of a scheme, for `#[serde(with = …)]`.
pub(crate) mod scheme {
    use super::*;

    pub(crate) fn deserialize<'de, D>(from: D) -> Result<Option<Scheme>, D::Error>
    where
        D: Deserializer<'de>,
    {
        read("scheme", Scheme::NAMES, from)
    }

    pub(crate) fn serialize<S>(to: &Option<Scheme>, serializer: S) -> Result<S::Ok, S::Error>
    where
        S: Serializer,
    {
        write(to.map(Scheme::name), serializer)
    }
}

fn read<'de, T: Copy, D>(kind: &str, names: &[(&str, T)], from: D) -> Result<Option<T>, D::Error>
where
    D: Deserializer<'de>,
{
    let name = Option::<String>::deserialize(from)?;
    name.map(|name| by_name(kind, names, &name)).transpose().map_err(D::Error::custom)
}

fn write<S: Serializer>(name: Option<&str>, to: S) -> Result<S::Ok, S::Error> {
    match name {
        Some(name) => to.serialize_some(name),
        None => to.serialize_none(),
    }
}
