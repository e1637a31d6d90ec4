//! Suggestions for misspelt names.

/// The least likeness, from 0 to 1, at which a name is suggested.
const ALIKE: f64 = 0.7;

/// Returns the name most like the one typed, or `None` if none is like it.
pub(crate) fn nearest<'a>(
    typed: &str,
    names: impl IntoIterator<Item = &'a str>,
) -> Option<&'a str> {
    let scored = names.into_iter().map(|name| (strsim::jaro(typed, name), name));
    let near = scored.filter(|(alike, _)| *alike > ALIKE);
    near.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, name)| name)
}

/// Returns "; did you mean `…`?" with the name most like the one typed, or nothing if none is like it.
pub(crate) fn suggestion<'a>(typed: &str, names: impl IntoIterator<Item = &'a str>) -> String {
    nearest(typed, names).map_or_else(String::new, |name| format!("; did you mean `{name}`?"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_name_is_suggested_if_it_is_near() {
        let names = ["inertia", "mass", "gravity"];
        assert_eq!(suggestion("mas", names), "; did you mean `mass`?");
        assert_eq!(suggestion("intertia", names), "; did you mean `inertia`?");
        assert_eq!(suggestion("colour", names), "");
    }
}
