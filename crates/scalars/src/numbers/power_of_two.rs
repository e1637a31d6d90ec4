//! Powers of two by products and sums alone, for every scalar.

use crate::numbers::real::Real;

/// Returns ±2ᵏ with ¾ 2ᵏ ≤ |x| ≤ 3/2 2ᵏ, which is the leading bit of 4x/3, for any scalar.
///
/// Over dual numbers the derivative is a multiple of that of x and is not zero.
///
/// ```
/// use generic_scalars::nearest_power_of_two;
/// assert_eq!([0.3, -5.0, 6.5].map(nearest_power_of_two::<f64>), [0.25, -4.0, 8.0]);
/// ```
///
/// Source: S. M. Rump, *Ultimately fast accurate summation*, SIAM J. Sci. Comput. 31 (2009), Alg. 3.5.
#[cfg_attr(optimised, inline(always))]
pub fn nearest_power_of_two<T: Real>(x: T) -> T {
    let q = x * (4.0 / 3.0 * (1.0 + 1.0 / f64::EPSILON));
    q - q * (1.0 - 0.5 * f64::EPSILON)
}

#[cfg(test)]
mod tests {
    use super::nearest_power_of_two;
    use crate::lanes::{DefaultLanes, Lanes};
    use crate::numbers::dual_number::DualNumber;

    #[test]
    fn it_is_the_nearest_power_of_two() {
        for k in [-900, -53, -1, 0, 1, 52, 900] {
            let power = 2.0_f64.powi(k);
            for part in [0.750_001, 0.9, 1.0, 1.1, 1.499_999] {
                for x in [part * power, -part * power] {
                    assert_eq!(nearest_power_of_two(x), power.copysign(x), "{part} 2^{k}");
                }
            }
            // Negative control: beyond these parts another power is nearer.
            assert_eq!(nearest_power_of_two(0.749_999 * power), power / 2.0);
            assert_eq!(nearest_power_of_two(1.500_001 * power), power * 2.0);
        }
    }

    #[test]
    fn lanes_have_its_bits_and_dual_numbers_its_derivative() {
        let x = [3.0, -0.2, 1e-30, 7e200];
        let lanes = nearest_power_of_two(DefaultLanes::load(&x));
        for (lane, x) in x.into_iter().enumerate().take(DefaultLanes::COUNT) {
            assert_eq!(lanes.lane(lane), nearest_power_of_two(x));
        }
        let dual = nearest_power_of_two(DualNumber::variable(5.0));
        assert!(dual.value_without_derivative() == 4.0 && dual.derivative() != 0.0);
    }
}
