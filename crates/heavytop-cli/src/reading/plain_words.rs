//! Plain words for the messages of the TOML reader.

use crate::vocabulary::brief;
use crate::vocabulary::suggestion::suggestion;

/// Names of types in messages of Rust, and the plain words for them.
const TYPES: [(&str, &str); 5] = [
    ("missing field", "missing key"),
    ("expected a sequence", "expected an array"),
    ("expected f64", "expected a number"),
    ("expected u32", "expected a whole number from 0 to 4294967295"),
    ("expected u64", "expected a whole number from 0 to 9223372036854775807"),
];

/// The text by which Rust's messages call a table.
const TABLE: &str = "expected struct ";

/// The beginning of a message about an unknown key.
pub(super) const UNKNOWN: &str = "unknown key";

/// The beginning of a suggestion.
const SUGGESTION: &str = "did you mean ";

/// Rewrites a message in plain words, short, on one line, and with a suggestion for a misspelt key.
pub(super) fn message(original: &str) -> String {
    let line = original.replace('\n', "; ").replace(" as i128", "");
    let line = TYPES.iter().fold(line, |line, (rust, plain)| line.replace(rust, plain));
    let line = match line.split_once(TABLE) {
        Some((before, _)) => format!("{before}expected a table"),
        None => line,
    };
    let line = brief::message(&line);
    let Some(unknown) = line.strip_prefix("unknown field") else { return line };
    let mut quoted = unknown.split('`').skip(1).step_by(2);
    let suggested = quoted.next().map_or_else(String::new, |typed| suggestion(typed, quoted));
    format!("{UNKNOWN}{unknown}{suggested}")
}

/// Returns the repair that a message in plain words offers: the name that was meant, or what is expected.
pub(super) fn repair(message: &str) -> String {
    if let Some(start) = message.rfind(SUGGESTION) {
        return message[start..].into();
    }
    if let Some(expected) = message.strip_prefix(UNKNOWN).and_then(|_| message.split("; ").next()) {
        // The message lists the keys that there are.
        return if expected.contains("expected") {
            "there is no such key".into()
        } else {
            String::new()
        };
    }
    if let (true, Some((_, repair))) = (message.starts_with('`'), message.rsplit_once("; ")) {
        return repair.into();
    }
    match message.rsplit_once("expected ") {
        Some((_, "fewer elements in array" | "fewer elements")) => "write fewer numbers".into(),
        Some((_, expected)) => format!("write {expected}"),
        None => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_offer_a_repair() {
        for (original, offered) in [
            ("unknown field `mas`, expected one of `mass`, `length`", "did you mean `mass`?"),
            ("unknown field `x`, expected one of `mass`, `length`", "there is no such key"),
            ("invalid type: string \"a\", expected f64", "write a number"),
            ("invalid length 2, expected an array of length 3", "write an array of length 3"),
            ("`a` excludes `b`; write one of them", "write one of them"),
            ("unclosed array", ""),
        ] {
            assert_eq!(repair(&message(original)), offered);
        }
    }
}
