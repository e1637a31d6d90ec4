//! Conversion between the items of a configuration and their names.

use super::brief::text;
use super::suggestion::suggestion;

/// Returns the name of an item.
pub(crate) fn name_of<T: Copy + PartialEq>(names: &[(&'static str, T)], item: T) -> &'static str {
    names.iter().find(|(_, other)| *other == item).map_or("", |(name, _)| name)
}

/// Returns the item with a name; the error lists all names.
pub(crate) fn by_name<T: Copy>(kind: &str, names: &[(&str, T)], name: &str) -> Result<T, String> {
    let found = names.iter().find(|(known, _)| *known == name).map(|(_, item)| *item);
    found.ok_or_else(|| {
        let known: Vec<&str> = names.iter().map(|(known, _)| *known).collect();
        let suggested = suggestion(name, known.iter().copied());
        format!("unknown {kind} `{}`; there are {}{suggested}", text(name), known.join(", "))
    })
}
