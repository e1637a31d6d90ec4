//! Hints for texts that are no TOML: what was written, and what to write instead.

use lie_poisson_formulas::invisible_name;
use std::ops::Range;

/// Characters that look like others, with those that TOML takes.
const LOOKALIKES: [(char, &str); 9] = [
    ('−', "-"),
    ('–', "-"),
    ('‐', "-"),
    ('“', "\""),
    ('”', "\""),
    ('„', "\""),
    ('‘', "'"),
    ('’', "'"),
    ('，', ","),
];

/// Returns the place at fault and what to write there, for an error of the reader at a place of the text.
pub(super) fn hint(text: &str, error: &Range<usize>) -> Option<(Range<usize>, String)> {
    let start = text.get(..error.start)?.rfind('\n').map_or(0, |newline| newline + 1);
    let line = text.get(start..)?.split('\n').next().unwrap_or_default();
    let found = strange_character(line)
        .or_else(|| decimal_comma(line, error.start - start))
        .or_else(|| leading_zeros(line, error.start - start))?;
    Some((start + found.0.start..start + found.0.end, found.1))
}

/// Finds the first invisible character of a line, or the first that looks like another.
fn strange_character(line: &str) -> Option<(Range<usize>, String)> {
    line.char_indices().find_map(|(at, character)| {
        let number = u32::from(character);
        let invisible = invisible_name(character)
            .map(|name| format!("delete the invisible character U+{number:04X} ({name})"));
        let known = LOOKALIKES.iter().find(|(known, _)| *known == character);
        let hint = invisible
            .or(known.map(|(_, plain)| format!("write {plain} instead of U+{number:04X}")))?;
        Some((at..at + character.len_utf8(), hint))
    })
}

/// Finds a number with a decimal comma at the place of an error.
fn decimal_comma(line: &str, at: usize) -> Option<(Range<usize>, String)> {
    let value = value_around(line, at)?;
    let (whole, decimals) = line[value.clone()].split_once(',')?;
    let is_number = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
    let is_comma = is_number(whole.trim_start_matches(['+', '-'])) && is_number(decimals);
    is_comma.then(|| (value, format!("write {whole}.{decimals}, with a decimal point")))
}

/// Finds a number that begins with zeros at the place of an error.
fn leading_zeros(line: &str, at: usize) -> Option<(Range<usize>, String)> {
    let value = value_around(line, at)?;
    let text = &line[value.clone()];
    let digits = text.trim_start_matches(['+', '-']);
    let sign = &text[..text.len() - digits.len()];
    let without = digits.trim_start_matches('0');
    let is_number = digits.parse::<f64>().is_ok() && digits.len() > 1;
    // A zero before the point, or as the whole number, stays.
    let zero = if without.starts_with(|first: char| first.is_ascii_digit()) { "" } else { "0" };
    let repaired = format!("{sign}{zero}{without}");
    (is_number && repaired != text).then(|| (value, format!("write {repaired}")))
}

/// Returns the place of the word around a place: what stands between spaces, brackets or an equals sign.
fn value_around(line: &str, at: usize) -> Option<Range<usize>> {
    let ends = |character: char| character.is_whitespace() || "=[]{}#".contains(character);
    // The error may be after the word.
    let is_after = line.get(at..)?.chars().next().is_none_or(ends);
    let at = if is_after { line.get(..at)?.trim_end().len() } else { at };
    let start = line.get(..at)?.rfind(ends).map_or(0, |end| end + 1);
    let end = line.get(start..)?.find(ends).map_or(line.len(), |end| start + end);
    let end = line[start..end].trim_end_matches(',').len() + start;
    (start < end).then_some(start..end)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use toml::de::DeTable;

    #[test]
    fn what_was_meant_is_offered() {
        for (text, marked, offered) in [
            ("a = 1\nstep = 0,05", "0,05", "write 0.05, with a decimal point"),
            ("x = { a = 1, b = -0,5 }", "-0,5", "write -0.5, with a decimal point"),
            ("mass = 01", "01", "write 1"),
            ("mass = -007.5 # kg", "-007.5", "write -7.5"),
            ("mass = 00", "00", "write 0"),
            ("mass = 00.5", "00.5", "write 0.5"),
            ("mass\u{a0}= 1", "\u{a0}", "delete the invisible character U+00A0 (no-break space)"),
            (
                "\u{200b}mass = 1",
                "\u{200b}",
                "delete the invisible character U+200B (zero width space)",
            ),
            ("mass = −1", "−", "write - instead of U+2212"),
            ("scheme = “rk4”", "“", "write \" instead of U+201C"),
        ] {
            let error = DeTable::parse(text).unwrap_err();
            let found = hint(text, &error.span().unwrap());
            let found = found.as_ref().map(|(place, hint)| (&text[place.clone()], hint.as_str()));
            assert_eq!(found, Some((marked, offered)), "{text}: {error}");
        }
        for text in ["a = [", "a = x", "a = 1 2", "mass 1", "= 1", "a = 1,x"] {
            let error = DeTable::parse(text).unwrap_err();
            assert_eq!(hint(text, &error.span().unwrap()), None, "{text}");
        }
    }
}
