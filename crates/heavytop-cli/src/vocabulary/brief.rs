//! Short forms of numbers and texts in messages.

use lie_poisson_formulas::{invisible_name, shown};

/// The number of characters after which a text is cut.
const MOST: usize = 60;

/// Formats the number without hundreds of digits.
pub(crate) fn number(x: f64) -> String {
    if x == 0.0 || (1e-6..1e16).contains(&x.abs()) { x.to_string() } else { format!("{x:e}") }
}

/// Returns the text on one line, or its first characters and an ellipsis. Characters that would control a terminal
/// are escaped, and invisible ones are named.
pub(crate) fn text(text: &str) -> String {
    let mut short = String::new();
    for (count, c) in text.chars().enumerate() {
        match c {
            _ if count == MOST => return short + "…",
            c if c.is_control() => short.extend(c.escape_default()),
            c if invisible_name(c).is_some() => short += &shown(c.encode_utf8(&mut [0; 4])),
            c => short.push(c),
        }
    }
    short
}

/// Shortens a message: long words are cut, long numbers get exponents, and of many words those in the middle are left
/// out.
pub(crate) fn message(message: &str) -> String {
    let words: Vec<String> = message.split(' ').map(word).collect();
    let message = words.join(" ");
    let count = message.chars().count();
    if count <= HEAD + TAIL {
        return message;
    }
    // The beginning says what is wrong, and the end what is expected.
    let head: String = message.chars().take(HEAD).collect();
    let tail: String = message.chars().skip(count - TAIL).collect();
    format!("{head} … {tail}")
}

/// The number of characters that stay at the beginning of a long message.
const HEAD: usize = 120;

/// The number of characters that stay at the end of a long message, which may list all schemes.
const TAIL: usize = 400;

fn word(word: &str) -> String {
    let is_mark = |c: char| c.is_ascii_punctuation() && c != '-';
    let bare = word.trim_matches(is_mark);
    match bare.parse() {
        Ok(value) if bare.len() > 24 => word.replace(bare, &number(value)),
        _ if word.chars().count() > MOST => {
            // A quotation mark and the comma after it.
            let marks = word.chars().rev().take(2).take_while(|c| is_mark(*c)).collect::<Vec<_>>();
            text(word) + &marks.into_iter().rev().collect::<String>()
        }
        _ => text(word),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_long_is_cut() {
        assert_eq!(text("mass"), "mass");
        assert_eq!(text(&"ä".repeat(1000)), "ä".repeat(60) + "…");
        assert_eq!(text("ma\u{ad}ss"), "ma<U+00AD soft hyphen>ss");
        assert_eq!(text("\0\u{1b}[2J\n"), "\\u{0}\\u{1b}[2J\\n");
        assert_eq!(message("expected a string"), "expected a string");
        let key = message(&format!("unknown key `{}`, expected", "x".repeat(1000)));
        assert_eq!(key, format!("unknown key `{}…`, expected", "x".repeat(59)));
        let digits = format!("got `1{}.0`, expected", "0".repeat(308));
        assert_eq!(message(&digits), "got `1e308`, expected");
        assert_eq!(message("got -99999999999999999999999999.5"), "got -1e26");
        let words = message(&format!("got \"{}\", expected a number", "x ".repeat(5000)));
        assert!(words.starts_with("got \"x x") && words.ends_with("x \", expected a number"));
        assert_eq!(words.chars().count(), HEAD + TAIL + 3);
    }
}
