//! The coordinates of a top in the words of pictures.

/// The names of the vectors, with their symbols and their units.
const VECTORS: [(&str, &str, &str); 2] = [("Pi", "Π", " (kg m²/s)"), ("Gamma", "Γ", "")];

/// Returns the title of the axis of a vector.
pub(super) fn title(name: &str) -> String {
    let vector = VECTORS.iter().find(|(own, ..)| *own == name);
    vector.map_or_else(|| name.to_owned(), |(_, symbol, unit)| format!("{symbol}{unit}"))
}

/// Returns the symbol of a component, such as `Π₁` for `Pi1`.
pub(super) fn symbol(column: &str) -> String {
    let letters = column.trim_end_matches(|c: char| c.is_ascii_digit());
    let lowered = column[letters.len()..].chars().filter_map(|digit| {
        let digit = digit.to_digit(10)?;
        char::from_u32(u32::from('₀') + digit)
    });
    let vector = VECTORS.iter().find(|(own, ..)| *own == letters);
    vector.map_or(letters, |(_, symbol, _)| symbol).chars().chain(lowered).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_symbols() {
        assert_eq!((title("Pi"), title("Gamma")), ("Π (kg m²/s)".into(), "Γ".into()));
        assert_eq!((symbol("Pi1"), symbol("Gamma3")), ("Π₁".into(), "Γ₃".into()));
    }
}
