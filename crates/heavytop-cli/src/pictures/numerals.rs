//! Numbers as pictures show them: with a minus sign, and with raised digits where they have powers of ten.

/// The decimal exponents of numbers that are written without a power of ten.
const PLAIN: std::ops::RangeInclusive<i32> = -3..=5;

/// Formats a power of ten with raised digits.
pub(crate) fn power_of_ten(exponent: i32) -> String {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let digit = |c: char| c.to_digit(10).map_or('⁻', |digit| RAISED[digit as usize]);
    format!("10{}", exponent.to_string().chars().map(digit).collect::<String>())
}

/// Formats a number with the fewest digits from which the same `f64` is read.
pub(crate) fn exact(x: f64) -> String {
    let scientific = format!("{x:e}");
    let parts = scientific.split_once('e').map(|(digits, power)| (digits, power.parse::<i32>()));
    let text = match parts {
        Some((digits, Ok(power))) if !PLAIN.contains(&power) => match digits {
            "1" | "-1" => format!("{}{}", digits.trim_end_matches('1'), power_of_ten(power)),
            _ => format!("{digits}×{}", power_of_ten(power)),
        },
        // Adding 0 turns −0 into 0.
        _ => (x + 0.0).to_string(),
    };
    text.replace('-', "−")
}

/// Formats a number with at most so many significant digits.
pub(crate) fn significant(x: f64, digits: usize) -> String {
    let rounded = format!("{x:.*e}", digits.saturating_sub(1));
    exact(rounded.parse().unwrap_or(x))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_at_every_scale() {
        assert_eq!(power_of_ten(-12), "10⁻¹²");
        let cases = [
            (0.02, "0.02"),
            (-11.75, "−11.75"),
            (0.0, "0"),
            (-0.0, "0"),
            (1e-4, "10⁻⁴"),
            (-1e20, "−10²⁰"),
            (2.943e-20, "2.943×10⁻²⁰"),
            (123_456.0, "123456"),
            (f64::INFINITY, "inf"),
        ];
        for (x, text) in cases {
            assert_eq!(exact(x), text);
        }
        assert_eq!(significant(1.0 / 3.0 * 1e-3, 6), "3.33333×10⁻⁴");
        assert_eq!(significant(4.464_101_615, 6), "4.4641");
    }
}
