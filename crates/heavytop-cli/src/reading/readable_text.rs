//! The text that the reader of TOML gets for one that a user has written.

use std::ops::Range;
use toml::de::{DeArray, DeTable, DeValue};

/// Returns the text with each integer beyond 64 bits as a number with an exponent: for a user both are numbers.
///
/// All places in the text stay, since the number is as long as the integer. An integer that is too large for a 64-bit
/// number stays, and so does a text that is not TOML.
pub(super) fn readable(text: &str) -> String {
    let mut readable = text.to_owned();
    let mut places = Vec::new();
    if let Ok(document) = DeTable::parse(text) {
        of_table(document.get_ref(), &mut places);
    }
    for (place, integer) in places {
        if let Some(number) = with_exponent(&integer, place.len()) {
            readable.replace_range(place, &number);
        }
    }
    readable
}

/// The place of an integer that has more than 64 bits, and its digits with its sign.
type Large = (Range<usize>, String);

fn of_table(table: &DeTable<'_>, places: &mut Vec<Large>) {
    table.values().for_each(|value| of_value(value.get_ref(), value.span(), places));
}

fn of_array(array: &DeArray<'_>, places: &mut Vec<Large>) {
    array.iter().for_each(|value| of_value(value.get_ref(), value.span(), places));
}

fn of_value(value: &DeValue<'_>, span: Range<usize>, places: &mut Vec<Large>) {
    match value {
        DeValue::Table(table) => of_table(table, places),
        DeValue::Array(array) => of_array(array, places),
        DeValue::Integer(integer)
            if integer.radix() == 10 && integer.as_str().parse::<i64>().is_err() =>
        {
            places.push((span, integer.as_str().to_owned()));
        }
        _ => {}
    }
}

/// Returns the 64-bit number nearest to an integer, as digits and an exponent, with so many characters.
fn with_exponent(integer: &str, length: usize) -> Option<String> {
    let value: f64 = integer.parse().ok().filter(|value: &f64| value.is_finite())?;
    let shortest = format!("{value:e}");
    let (digits, exponent) = shortest.split_once('e')?;
    let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let exponent = exponent.parse::<usize>().ok()?.checked_sub(decimals)?;
    let digits = digits.replace('.', "");
    // An exponent may begin with zeros.
    let width = length.checked_sub(digits.len() + 1)?;
    Some(format!("{digits}e{exponent:0width$}")).filter(|number| number.len() == length)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use toml::{Table, Value};

    #[test]
    fn integers_beyond_64_bits_become_numbers_of_the_same_length_and_value() {
        let integers = [
            "9223372036854775808",
            "-9223372036854775809",
            "12345678901234567891234567",
            "1_000_000_000_000_000_000_000",
        ];
        for integer in
            integers.iter().map(ToString::to_string).chain((19..308).map(|n| "7".repeat(n + 1)))
        {
            let text = format!("[a]\nb = [1, {integer}] # {integer}\nc = 2");
            let read = readable(&text);
            assert_eq!(read.len(), text.len());
            let table: Table = toml::from_str(&read).unwrap();
            let expected: f64 = integer.replace('_', "").parse().unwrap();
            assert_eq!(
                table["a"]["b"],
                Value::from(vec![Value::from(1), Value::from(expected)]),
                "{read}"
            );
            assert_eq!(table["a"]["c"], Value::from(2));
        }
        // What is read anyway stays, and so does what is no 64-bit number.
        let infinite = format!("a = {}", "7".repeat(310));
        for text in ["a = 9223372036854775807", "a = 0xffffffffffffffffffff", "a = [", &infinite] {
            assert_eq!(readable(text), text);
        }
    }
}
