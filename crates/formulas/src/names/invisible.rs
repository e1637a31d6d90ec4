//! Characters that nobody sees, and those that look like others, in texts of users.

/// Characters that are invisible, or look like a space, with their names in Unicode.
const INVISIBLE: [(char, &str); 22] = [
    ('\u{a0}', "no-break space"),
    ('\u{ad}', "soft hyphen"),
    ('\u{2002}', "en space"),
    ('\u{2003}', "em space"),
    ('\u{2007}', "figure space"),
    ('\u{2008}', "punctuation space"),
    ('\u{2009}', "thin space"),
    ('\u{200a}', "hair space"),
    ('\u{200b}', "zero width space"),
    ('\u{200c}', "zero width non-joiner"),
    ('\u{200d}', "zero width joiner"),
    ('\u{200e}', "left-to-right mark"),
    ('\u{200f}', "right-to-left mark"),
    ('\u{2028}', "line separator"),
    ('\u{2029}', "paragraph separator"),
    ('\u{202a}', "left-to-right embedding"),
    ('\u{202c}', "pop directional formatting"),
    ('\u{202f}', "narrow no-break space"),
    ('\u{2060}', "word joiner"),
    ('\u{2066}', "left-to-right isolate"),
    ('\u{3000}', "ideographic space"),
    ('\u{feff}', "zero width no-break space"),
];

/// Returns the name of an invisible character in Unicode, or `None` for other characters.
///
/// # Example
/// ```
/// use lie_poisson_formulas::invisible_name;
/// assert_eq!(invisible_name('\u{200b}'), Some("zero width space"));
/// assert_eq!(invisible_name(' '), None);
/// ```
#[must_use]
pub fn invisible_name(character: char) -> Option<&'static str> {
    INVISIBLE.iter().find(|(known, _)| *known == character).map(|(_, name)| *name)
}

/// Returns a text of a user as a message shows it: with each invisible character as its number and name.
///
/// # Example
/// ```
/// use lie_poisson_formulas::shown;
/// assert_eq!(shown("2\u{a0}"), "2<U+00A0 no-break space>");
/// assert_eq!(shown("Π₁ + 2"), "Π₁ + 2");
/// ```
#[must_use]
pub fn shown(text: &str) -> String {
    let mut all = String::with_capacity(text.len());
    for character in text.chars() {
        match invisible_name(character) {
            Some(name) => all += &format!("<U+{:04X} {name}>", u32::from(character)),
            None => all.push(character),
        }
    }
    all
}
