//! The error for an unknown name: [`UnknownName`].

use thiserror::Error;

/// The error for a name that is not the name of a formulation, or of a scheme.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("unknown {kind} `{name}`; there are {}", known.join(", "))]
pub struct UnknownName {
    /// The kind of item: a formulation or a scheme.
    pub kind: &'static str,
    /// The name that was asked for.
    pub name: String,
    /// All names of the kind.
    pub known: Vec<&'static str>,
}

/// Returns the name of an item.
pub(super) fn name_of<T: Copy + PartialEq>(names: &[(&'static str, T)], item: T) -> &'static str {
    names.iter().find(|(_, other)| *other == item).map_or("", |(name, _)| name)
}

/// Returns the item with a name.
pub(super) fn by_name<T: Copy>(
    kind: &'static str,
    names: &[(&'static str, T)],
    name: &str,
) -> Result<T, UnknownName> {
    let found = names.iter().find(|(known, _)| *known == name).map(|(_, item)| *item);
    found.ok_or_else(|| {
        let known = names.iter().map(|(known, _)| *known).collect();
        UnknownName { kind, name: name.into(), known }
    })
}
