//! Scaling by powers of two, without rounding.

/// Returns the power of two with 2ⁿ ≤ |x| < 2ⁿ⁺¹. Division by it is exact.
///
/// For smaller x it is the least normal number.
pub(crate) fn power_of_two(x: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff << 52;
    f64::from_bits(x.to_bits() & EXPONENT).max(f64::MIN_POSITIVE)
}

#[cfg(test)]
mod tests {
    use super::power_of_two;

    #[test]
    fn it_is_the_power_of_two_below() {
        for (x, power) in [(1.0, 1.0), (-7.9, 4.0), (0.3, 0.25), (1e-310, f64::MIN_POSITIVE)] {
            assert_eq!(power_of_two(x), power);
        }
    }
}
