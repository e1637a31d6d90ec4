//! Brownian motions as functions of time.

use collective_integrators::{BrownianError, BrownianPaths};
use proptest::prelude::*;

const COMPONENTS: usize = 6;

fn increments(paths: &BrownianPaths, path: u64, from: f64, to: f64) -> [f64; COMPONENTS] {
    let mut increments = [0.0; COMPONENTS];
    paths.write_increments(path, from, to, &mut increments);
    increments
}

/// Returns the largest |z| = |mean|·√n/deviation of the covariances of the numbers of many samples with what they shall be.
fn worst_covariance<const K: usize>(
    samples: u64,
    sample: impl Fn(u64) -> [f64; K],
    expected: impl Fn(usize, usize) -> f64,
) -> f64 {
    let mut sums = [[0.0; K]; K];
    for i in 0..samples {
        let x = sample(i);
        for (a, row) in sums.iter_mut().enumerate() {
            row.iter_mut().zip(x).for_each(|(sum, y)| *sum += x[a] * y);
        }
    }
    let mut worst = 0.0_f64;
    for (a, row) in sums.iter().enumerate() {
        for (b, sum) in row.iter().enumerate() {
            let product = expected(a, a) * expected(b, b);
            // The variance of a product of two normal numbers.
            let deviation = (product + expected(a, b).powi(2)) / samples as f64;
            worst = worst.max((sum / samples as f64 - expected(a, b)).abs() / deviation.sqrt());
        }
    }
    worst
}

#[test]
#[ignore = "long"]
fn increments_have_the_covariances_of_brownian_motions() {
    let paths = BrownianPaths::new(3, 0.25).unwrap();
    // Over times that are parts of an interval, a whole one, and many, of several components.
    let times = [0.0, 0.3, 0.5, 1.0, 2.0, 5.625];
    let sample = |path: u64| -> [f64; 10] {
        core::array::from_fn(|i| {
            let (piece, component) = (i % 5, 3 * (i / 5));
            increments(&paths, path, times[piece], times[piece + 1])[component]
        })
    };
    let expected = |a: usize, b: usize| match a == b {
        true => (times[a % 5 + 1] - times[a % 5]) * 0.25,
        false => 0.0,
    };
    // The largest of 100 normal numbers is above 4.5 once in a thousand.
    let worst = worst_covariance(5_000, sample, expected);
    assert!(worst < 4.5, "{worst}");
    // Control: another variance is noticed.
    let wrong = worst_covariance(5_000, sample, |a, b| 1.2 * expected(a, b));
    assert!(wrong > 4.5, "{wrong}");
}

#[test]
fn seeds_paths_and_components_are_independent() {
    let sample = |i: u64| -> [f64; 8] {
        let of = |seed, path, component: usize| {
            increments(&BrownianPaths::new(seed, 1.0).unwrap(), path, i as f64, i as f64 + 1.0)
                [component]
        };
        [
            of(1, 0, 0),
            of(1, 0, 1),
            of(1, 0, 2),
            of(1, 0, 4),
            of(1, 1, 0),
            of(2, 0, 0),
            of(2, 1, 0),
            of(1, 2, 0),
        ]
    };
    let worst = worst_covariance(5_000, sample, |a, b| f64::from(u8::from(a == b)));
    assert!(worst < 4.5, "{worst}");
}

proptest! {
    /// W(c) − W(a) = (W(b) − W(a)) + (W(c) − W(b)), and backward the negative.
    #[test]
    fn increments_add_up(
        times in prop::array::uniform3(-40.0..40.0_f64),
        (seed, path) in (any::<u64>(), 0..1_u64 << 50),
        exponent in -30..30_i32,
    ) {
        let paths = BrownianPaths::new(seed, 10.0_f64.powi(exponent)).unwrap();
        let [a, b, c] = times;
        let [ab, bc, ac, ba] =
            [(a, b), (b, c), (a, c), (b, a)].map(|(from, to)| increments(&paths, path, from, to));
        let size = 10.0_f64.powi(exponent).sqrt();
        for k in 0..COMPONENTS {
            // Sums of some eighty numbers of this size.
            prop_assert!((ab[k] + bc[k] - ac[k]).abs() < 1e-13 * size);
            prop_assert_eq!(ab[k], -ba[k]);
        }
    }
}

#[test]
fn increments_are_bounded() {
    let paths = BrownianPaths::new(5, 1.0).unwrap();
    let largest = |paths: &BrownianPaths| {
        let all = (0..3000).flat_map(|n| increments(paths, 0, n as f64, n as f64 + 1.0));
        all.fold(0.0_f64, |most, x| most.max(x.abs()))
    };
    assert!(largest(&paths) > 3.0);
    assert_eq!(largest(&paths.with_bound(2.0).unwrap()), 2.0);
    assert_eq!(increments(&paths, 0, 1.0, 1.0), [0.0; COMPONENTS]);
    assert!(increments(&paths, 0, f64::NAN, 1.0)[0].is_nan());
    for bound in [0.5, f64::NAN] {
        assert!(matches!(paths.with_bound(bound), Err(BrownianError::Bound { .. })));
    }
    for interval in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(BrownianPaths::new(5, interval), Err(BrownianError::Interval { .. })));
    }
}
