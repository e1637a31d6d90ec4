//! Kepler's equation: roots for every eccentricity and in all units, with derivatives, and on lanes.

use lie_poisson::{DefaultLanes, DualNumber, Lanes, Real};
use lie_poisson_systems::{KeplerOrbit, SystemError};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

/// The largest eccentricity.
const LARGEST: f64 = 1.0 - f64::EPSILON / 2.0;

/// Returns (1 − e) E + e (E − sin E) with E − sin E by its series for small E.
fn mean_anomaly(e: f64, anomaly: f64) -> f64 {
    let (mut term, mut sum) = (anomaly.powi(3) / 6.0, 0.0);
    for k in 2..25 {
        sum += term;
        term *= -anomaly * anomaly / f64::from(2 * k * (2 * k + 1));
    }
    anomaly * (1.0 - e) + e * sum
}

proptest! {
    #[test]
    fn every_root_is_found_in_all_units(
        distance in -16.0..0.0_f64,
        size in -30.0..0.49_f64,
        negative in any::<bool>(),
        power in -30..=30_i32,
    ) {
        let e = (1.0 - 10.0_f64.powf(distance)).min(LARGEST);
        let mean = 10.0_f64.powf(size) * if negative { -1.0 } else { 1.0 };
        let unit = 10.0_f64.powi(power);
        let orbit = KeplerOrbit::new(unit, e, 0.0).unwrap();
        let anomaly: f64 = orbit.eccentric_anomaly(mean / unit);
        // A few roundings of the series and of M itself.
        prop_assert!((mean_anomaly(e, anomaly) / mean - 1.0).abs() < 1e-14, "{e} {mean} {anomaly}");
        // Control: the bound sees a change of E by a few units.
        prop_assert!((mean_anomaly(e, anomaly * (1.0 + 4e-14)) / mean - 1.0).abs() > 1e-14);
    }

    /// dE/dt = n/u and d²E/dt² = −n² e sin E/u³ by dual numbers, and dν/dt from ν and from the law of areas.
    #[test]
    fn derivatives_are_those_of_keplers_laws(e in 0.0..0.95_f64, time in -20.0..20.0_f64) {
        let orbit = KeplerOrbit::new(1.3, e, 0.4).unwrap();
        let nested = DualNumber::new(DualNumber::variable(time), DualNumber::from_f64(1.0));
        let anomaly = orbit.eccentric_anomaly(nested);
        let value = anomaly.value_without_derivative().value_without_derivative();
        let plain: f64 = orbit.eccentric_anomaly(time);
        prop_assert_eq!(value.to_bits(), plain.to_bits());
        let u = 1.0 - e * value.cos();
        let first = anomaly.derivative().value_without_derivative();
        prop_assert!((first * u / 1.3 - 1.0).abs() < 1e-13, "{first}");
        let second = anomaly.derivative().derivative();
        let expected = -1.69 * e * value.sin() / u.powi(3);
        prop_assert!((second - expected).abs() < 1e-12 / u.powi(3), "{second} {expected}");
        let turn = orbit.true_anomaly(DualNumber::variable(time)).derivative();
        prop_assert!((turn / orbit.rate(time) - 1.0).abs() < 1e-12);
        // Control: the rate is not the mean motion.
        prop_assert!(e < 1e-3 || (turn / 1.3 - 1.0).abs() > 1e-9 || (u.powi(2) - (1.0 - e * e).sqrt()).abs() < 1e-6);
    }
}

#[test]
fn the_largest_eccentricity_has_roots_too() {
    for e in [0.0, 0.5, 0.999_999, LARGEST] {
        let orbit = KeplerOrbit::new(1.0, e, 0.0).unwrap();
        for exponent in -300..=0 {
            let mean = 3.0 * 10.0_f64.powi(exponent);
            let anomaly: f64 = orbit.eccentric_anomaly(mean);
            assert!((mean_anomaly(e, anomaly) / mean - 1.0).abs() < 1e-14, "{e} {mean}");
        }
        // The apocentre, and the pericentre.
        assert_eq!(orbit.eccentric_anomaly(0.0), 0.0);
        assert!((orbit.eccentric_anomaly(PI).abs() - PI).abs() < 1e-15);
    }
}

#[test]
fn lanes_have_the_bits_of_plain_numbers() {
    for e in [0.0, 0.3, 0.97] {
        let orbit = KeplerOrbit::new(0.9, e, -0.2).unwrap();
        for k in 0..50 {
            let time = |i: usize| f64::from(k) * 0.37 - 8.0 + 1.1 * i as f64;
            let lanes = orbit.tide(DefaultLanes::from_lanes(time));
            for i in 0..4 {
                assert_eq!(lanes.lane(i).to_bits(), orbit.tide(time(i)).to_bits(), "{e} {k} {i}");
            }
        }
    }
}

#[test]
fn a_period_is_one_turn() {
    let orbit = KeplerOrbit::new(2.0, 0.6, 0.1).unwrap();
    // The trapezoidal rule converges geometrically for periodic functions.
    let rate = |k: i32| orbit.rate(f64::from(k) / 200.0 * PI);
    let turn: f64 = (0..200).map(rate).sum::<f64>() / 200.0 * PI;
    assert!((turn - TAU).abs() < 1e-12, "{turn}");
    for time in [f64::NAN, f64::INFINITY] {
        assert!(orbit.rate(time).is_nan() && orbit.tide(time).is_nan());
    }
}

#[test]
fn the_parameters_are_checked() {
    let new = KeplerOrbit::new;
    for bad in [0.0, -1.0] {
        let refused = new(bad, 0.1, 0.0);
        assert!(matches!(refused, Err(SystemError::NotPositive { name: "mean motion", .. })));
    }
    for bad in [-0.1, 1.0, 2.0, f64::NAN] {
        let refused = new(1.0, bad, 0.0);
        assert!(matches!(refused, Err(SystemError::OutOfRange { name: "eccentricity", .. })));
    }
    assert!(matches!(new(1e200, 0.1, 0.0), Err(SystemError::NotFinite { .. })));
    assert!(matches!(new(1e-200, 0.1, 0.0), Err(SystemError::NotPositive { .. })));
    assert!(matches!(new(1.0, 0.1, f64::NAN), Err(SystemError::NotFinite { .. })));
    assert!(new(1.0, LARGEST, 0.0).is_ok() && new(1.0, 0.0, -3.0).is_ok());
}
