//! The letters of names: Greek letters and their names, subscripts and digits.

/// The words that cannot be the name of a coordinate or of a parameter.
pub(crate) const RESERVED: &[&str] = &[
    "pi", "dot", "cross", "norm", "abs", "sqrt", "exp", "ln", "log", "sin", "cos", "tan", "sinh",
    "cosh", "tanh", "atan2", "arcsin", "asin", "arccos", "acos", "arctan", "atan", "log10", "cbrt",
    "hypot", "if", "sum",
];

/// The names of the Greek letters, from alpha to omega; the second sigma is the final one.
const GREEK: [&str; 25] = [
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa",
    "lambda", "mu", "nu", "xi", "omicron", "pi", "rho", "sigma", "sigma", "tau", "upsilon", "phi",
    "chi", "psi", "omega",
];

/// Returns the digit of a subscript such as ₁.
fn subscript(letter: char) -> Option<char> {
    let digit = u32::from(letter).checked_sub(0x2080).filter(|digit| *digit < 10)?;
    char::from_digit(digit, 10)
}

/// Returns whether a name may begin with the letter.
pub(crate) fn begins_name(letter: char) -> bool {
    letter.is_alphabetic() || letter == '_'
}

/// Returns whether a name may contain the letter after the first one.
pub(crate) fn continues_name(letter: char) -> bool {
    begins_name(letter) || letter.is_ascii_digit() || subscript(letter).is_some()
}

/// Returns whether the text is a name.
pub(crate) fn is_name(text: &str) -> bool {
    text.starts_with(begins_name) && text.chars().all(continues_name)
}

/// Appends the name of a Greek letter, and returns whether the letter is one.
fn push_greek(letter: char, name: &mut String) -> bool {
    let small = match letter {
        'µ' => 'μ',
        'Α'..='Ω' => char::from_u32(u32::from(letter) + 0x20).unwrap_or(letter),
        _ => letter,
    };
    let place = u32::from(small).checked_sub(u32::from('α'));
    let Some(greek) = place.and_then(|place| GREEK.get(place as usize)) else { return false };
    if small == letter || letter == 'µ' {
        name.push_str(greek);
    } else {
        let mut letters = greek.chars();
        name.extend(letters.next().map(|first| first.to_ascii_uppercase()));
        name.extend(letters);
    }
    true
}

/// Returns the name with Greek letters spelt out and subscripts as digits: Π₁ is `Pi1`.
pub(crate) fn canonical(text: &str) -> String {
    let mut name = String::with_capacity(text.len());
    for letter in text.chars() {
        if !push_greek(letter, &mut name) {
            name.push(subscript(letter).unwrap_or(letter));
        }
    }
    name
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn greek_letters_and_subscripts_have_plain_names() {
        let names = ["Π₁", "Γ", "Ω2", "θ", "µ", "μ", "x₁₀", "ς", "ω", "Pi1", "é"];
        let plain = ["Pi1", "Gamma", "Omega2", "theta", "mu", "mu", "x10", "sigma", "omega"];
        for (name, plain) in names.iter().zip(plain.iter().chain(&["Pi1", "é"])) {
            assert_eq!(canonical(name), *plain);
            assert!(is_name(name));
        }
    }

    #[test]
    fn superscripts_fractions_and_digits_begin_no_name() {
        for text in ["", "²", "x²", "½", "1x", "a b", "a·b", "₁"] {
            assert!(!is_name(text), "{text}");
        }
    }
}
