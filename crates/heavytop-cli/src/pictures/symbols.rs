//! Names of coordinates and formulas as pictures write them: `Pi1^2` is Π₁².

/// The names of the Greek letters from α to ω, in the order of their characters; the first sigma is the final one.
const GREEK: [&str; 25] = [
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa",
    "lambda", "mu", "nu", "xi", "omicron", "pi", "rho", "", "sigma", "tau", "upsilon", "phi",
    "chi", "psi", "omega",
];

/// The digits from 0 to 9 above the line.
const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

/// Returns the symbol of a name: Greek letters for theirs, and digits at the end below the line. A name with other signs
/// than letters and digits keeps its digits, which may number two things.
pub(crate) fn symbol(name: &str) -> String {
    let digits = name.chars().rev().take_while(char::is_ascii_digit).count();
    let (letters, digits) = name.split_at(name.len() - digits);
    match letters.chars().all(char::is_alphabetic) && !letters.is_empty() {
        true => greek(letters).map_or_else(|| letters.into(), String::from) + &lowered(digits),
        false => match name.split_once('_') {
            Some((first, rest)) if greek(first).is_some() => format!("{}_{rest}", symbol(first)),
            _ => name.into(),
        },
    }
}

/// Returns a formula with the symbols of its names, and with exponents of one digit above the line. The names of functions
/// stay.
pub(crate) fn formula(text: &str) -> String {
    let mut written = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let length = match first {
            _ if is_in_name(first) && !first.is_ascii_digit() => {
                rest.find(|c| !is_in_name(c)).unwrap_or(rest.len())
            }
            _ if first.is_ascii_digit() => length_of_number(rest),
            _ => first.len_utf8(),
        };
        let (token, after) = rest.split_at(length);
        rest = after;
        let is_function = after.starts_with('(');
        match token {
            "^" => match exponent(after) {
                Some(raised) => {
                    written.push(raised);
                    rest = &after[1..];
                }
                None => written.push('^'),
            },
            // The digits below the line end a name, and are no number.
            _ if is_in_name(first) && !first.is_ascii_digit() && !is_function => {
                let index = index(after).filter(|_| !token.ends_with(|c: char| c.is_ascii_digit()));
                match index {
                    Some(index) => {
                        written += &symbol(&format!("{token}{index}"));
                        rest = &after[index.len() + 2..];
                    }
                    None => written += &symbol(token),
                }
            }
            _ => written += token,
        }
    }
    written
}

fn is_in_name(letter: char) -> bool {
    letter.is_alphanumeric() || letter == '_' || ('₀'..='₉').contains(&letter)
}

/// Returns the length of the number with which a text begins, such as 1.5e-3.
fn length_of_number(text: &str) -> usize {
    let digits = |text: &str| text.find(|c: char| !c.is_ascii_digit() && c != '.');
    let length = digits(text).unwrap_or(text.len());
    let Some(power) = text[length..].strip_prefix(['e', 'E']) else { return length };
    let unsigned = power.strip_prefix(['-', '+']).unwrap_or(power);
    match unsigned.starts_with(|c: char| c.is_ascii_digit()) {
        true => text.len() - unsigned.len() + digits(unsigned).unwrap_or(unsigned.len()),
        false => length,
    }
}

/// Returns the exponent with which a text begins, if it is a single digit.
fn exponent(text: &str) -> Option<char> {
    let mut letters = text.chars();
    let digit = letters.next()?.to_digit(10)?;
    let rest = letters.as_str();
    let goes_on = rest.starts_with(|next| is_in_name(next) || next == '.');
    // Of a power of a power the exponents would run into one another.
    let is_power = ["^", "**"].iter().any(|sign| rest.trim_start().starts_with(sign));
    (!goes_on && !is_power).then(|| RAISED[digit as usize])
}

/// Returns the index in brackets with which a text begins: that of a component, such as Pi[1].
fn index(text: &str) -> Option<&str> {
    let (index, _) = text.strip_prefix('[')?.split_once(']')?;
    (!index.is_empty() && index.chars().all(|c| c.is_ascii_digit())).then_some(index)
}

fn greek(name: &str) -> Option<char> {
    let small = name.to_lowercase();
    let place = GREEK.iter().position(|greek| **greek == small)?;
    let letter = char::from_u32(u32::from('α') + place as u32)?;
    match name.chars().next()?.is_uppercase() {
        true => letter.to_uppercase().next(),
        false => Some(letter),
    }
}

fn lowered(digits: &str) -> String {
    let lowered = |digit: char| char::from_u32(u32::from('₀') + digit.to_digit(10)?);
    digits.chars().filter_map(lowered).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_symbols() {
        let names = ["Pi1", "Gamma", "Omega12", "theta", "sigma", "psi", "c1", "I2", "omega", "h"];
        let symbols = ["Π₁", "Γ", "Ω₁₂", "θ", "σ", "ψ", "c₁", "I₂", "ω", "h"];
        assert_eq!(names.map(symbol), symbols);
        // Controls: other words stay, and so do digits that may number two things.
        for name in ["Π₁", "kinetic", "L1_2", "x_12", "positions[3]", "7", ""] {
            assert_eq!(symbol(name), name);
        }
        assert_eq!(symbol("Pi_12"), "Π_12");
    }

    #[test]
    fn formulas_have_symbols_and_functions_stay() {
        let cases = [
            ("Pi1^2/(2*I1) + k*c·Gamma", "Π₁²/(2*I₁) + k*c·Γ"),
            ("|Gamma|^2", "|Γ|²"),
            ("atan2(Gamma2, Gamma1)", "atan2(Γ₂, Γ₁)"),
            ("1.5e-3*x1^10 - 2e5*mu^0.5", "1.5e-3*x₁^10 - 2e5*μ^0.5"),
            ("(Pi×Gamma)[3]^3", "(Π×Γ)[3]³"),
            ("Pi[1]^2/I[1] + Pi1[2]", "Π₁²/I₁ + Π₁[2]"),
            ("x^y2^2", "x^y₂²"),
            ("x^2^3 + y^2 **3", "x^2³ + y^2 **3"),
            ("if(Pi1 < 2, Π₁, 0)", "if(Π₁ < 2, Π₁, 0)"),
        ];
        for (plain, written) in cases {
            assert_eq!(formula(plain), written);
        }
    }
}
