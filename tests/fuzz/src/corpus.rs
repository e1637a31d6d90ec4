//! A corpus as text: a line for each case, with escapes as in a Rust byte string.

/// Returns the line of a case.
#[must_use]
pub fn line(case: &[u8]) -> String {
    case.escape_ascii().to_string()
}

/// Returns the cases of a text with a line for each.
///
/// # Example
/// ```
/// let case = b"[body]\nmass = \x00\xff \"\\\"";
/// let text = format!("{}\n{}\n", fuzz_targets::line(case), fuzz_targets::line(b""));
/// assert_eq!(fuzz_targets::cases(&text), [case.to_vec(), Vec::new()]);
/// ```
#[must_use]
pub fn cases(text: &str) -> Vec<Vec<u8>> {
    text.lines().map(unescape).collect()
}

fn unescape(line: &str) -> Vec<u8> {
    let mut bytes = line.bytes();
    let mut case = Vec::new();
    while let Some(byte) = bytes.next() {
        case.push(match byte {
            b'\\' => escaped(&mut bytes),
            byte => byte,
        });
    }
    case
}

/// Returns the byte that follows a backslash: `n`, `r`, `t`, `xff`, or itself.
fn escaped(bytes: &mut impl Iterator<Item = u8>) -> u8 {
    match bytes.next() {
        Some(b'n') => b'\n',
        Some(b'r') => b'\r',
        Some(b't') => b'\t',
        Some(b'x') => {
            let mut digit = || bytes.next().and_then(|d| char::from(d).to_digit(16)).unwrap_or(0);
            (digit() * 16 + digit()) as u8
        }
        byte => byte.unwrap_or(b'\\'),
    }
}
