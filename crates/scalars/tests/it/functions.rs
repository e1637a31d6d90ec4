//! The functions of a scalar: integer powers against those of `f64`, and the derivatives of dual numbers over lanes.

use generic_scalars::{DefaultLanes, DualNumber, Lanes, Real};
use proptest::prelude::*;

/// Calls the method of the trait, which the method of `f64` hides.
fn power<T: Real>(x: T, n: i32) -> T {
    x.powi(n)
}

/// Returns whether two numbers agree to `units` units of round-off, where neither is subnormal.
fn near(a: f64, b: f64, units: f64) -> bool {
    a == b || (a - b).abs() <= units * f64::EPSILON * b.abs()
}

proptest! {
    /// For n < 0 the reciprocal of an infinite power is 0, where the exact power may be a subnormal number.
    #[test]
    fn integer_powers(x in -1e3..1e3_f64, n in -40..40_i32) {
        let (computed, expected) = (power(x, n), x.powi(n));
        let units = 2.0 + 2.0 * f64::from(n.abs());
        prop_assert!(near(computed, expected, units), "{x}^{n}: {computed:e}, not {expected:e}");
        // A negative control: a wrong exponent is seen.
        if x.abs() > 1.1 {
            prop_assert!(!near(power(x, n + 1), expected, units));
        }
    }

    #[test]
    fn derivatives_over_lanes_are_those_of_each_lane(x in prop::array::uniform4(-30.0..30.0_f64)) {
        let together = DualNumber::variable(DefaultLanes::load(&x));
        for (lane, x) in x.into_iter().enumerate() {
            let alone = DualNumber::variable(x);
            let pairs = [
                (together.exp(), alone.exp()),
                (together.sin(), alone.sin()),
                (together.cos(), alone.cos()),
                (together.tanh(), alone.tanh()),
                (together.powi(7), alone.powi(7)),
                (together.powi(-3), alone.powi(-3)),
            ];
            for (lanes, number) in pairs {
                prop_assert_eq!(lanes.value_without_derivative().lane(lane).to_bits(), number.value_without_derivative().to_bits());
                let slopes = (lanes.derivative().lane(lane), number.derivative());
                prop_assert_eq!(slopes.0.to_bits(), slopes.1.to_bits());
            }
        }
    }
}

#[test]
fn powers_at_the_ends_of_the_range() {
    for n in [i32::MIN, i32::MAX, 0] {
        assert_eq!(power(1.0, n), 1.0);
        assert_eq!(power(DualNumber::variable(1.0), n).derivative(), f64::from(n));
    }
    assert_eq!([2, 3].map(|n| power(-0.0, -n)), [f64::INFINITY, f64::NEG_INFINITY]);
    assert_eq!(power(1e200, 2), f64::INFINITY);
    // The square after the last factor is not formed, so that it cannot turn a derivative into NaN.
    assert_eq!(power(DualNumber::variable(1e300), 1).derivative(), 1.0);
    assert_eq!(power(f64::NAN, 0), 1.0);
    assert!(power(f64::NAN, 1).is_nan() && power(f64::NAN, -1).is_nan());
}

/// a mod b is a − q b, and the truncated quotient q has no derivative.
#[test]
fn derivatives_of_remainders() {
    for (a, b, quotient) in [(7.5, 2.0, 3.0), (-7.5, 2.0, -3.0), (7.5, -2.0, -3.0), (1.5, 2.0, 0.0)]
    {
        let remainder = DualNumber::new(a, 5.0) % DualNumber::new(b, 3.0);
        assert_eq!(remainder.value_without_derivative(), a - quotient * b);
        assert_eq!(remainder.derivative(), 5.0 - quotient * 3.0);
    }
}

/// A scalar with a derivative, or with several lanes, must not take the path of plain numbers.
#[test]
fn plain_numbers_alone_are_numbers() {
    assert_eq!(Real::as_f64(-2.5), Some(-2.5));
    assert_eq!(DualNumber::new(-2.5, 1.0).as_f64(), None);
    assert_eq!(DefaultLanes::from_f64(-2.5).as_f64(), None);
}
