//! The free rigid body in closed form against reference values, its invariants and its symmetries.
//!
//! The starts are on the separatrix, next to it and away from it, in all units.

use core::f64::consts::PI;
use heavytop::{EulerSolution, RigidBody};
use nalgebra::Vector3;
use proptest::prelude::*;

/// The unit of round-off, half the machine epsilon.
const ROUNDING: f64 = 0.5 * f64::EPSILON;

type Reference = ([f64; 3], [f64; 3], f64, [f64; 3]);

/// I, Π(0), t and Π(t), rounded from Taylor series of Euler's equations with 50 to 120 digits (mpmath 1.3). The rows
/// from 1e-200 on, of which the last are within rounding errors of the separatrix, come from the closed form with 120
/// to 900 digits, which agrees with the series elsewhere.
#[rustfmt::skip]
const REFERENCE: [Reference; 25] = [
    ([3.0, 4.0, 6.0], [-1.0, 0.5, 1.0], 1.0, [-1.035_145_873_697_028, 0.327_026_054_521_704_25, 1.035_145_873_697_028]),
    ([3.0, 4.0, 6.0], [-1.0, 0.5, 1.0], 5.0, [-1.020_835_659_214_941, -0.407_172_093_530_971_2, 1.020_835_659_214_941]),
    ([3.0, 4.0, 6.0], [-1.0, 0.5, 1.0], -7.0, [-0.575_306_398_718_931_2, 1.260_176_612_696_057_2, 0.575_306_398_718_931_2]),
    ([3.0, 4.0, 6.0], [-1.0, 0.5, 1.0], 40.0, [-0.020_212_005_749_973_585, -1.499_727_625_153_023, 0.020_212_005_749_973_585]),
    ([3.0, 4.0, 6.0], [-1e-07, 1.0, 1e-07], 100.0, [-0.000_416_026_164_535_095_6, 0.999_999_826_922_225_4, 0.000_416_026_164_535_095_6]),
    ([3.0, 4.0, 6.0], [-1e-07, 1.0, 1e-07], 200.0, [-0.692_922_013_165_743_5, -0.199_294_172_871_878_5, 0.692_922_013_165_743_5]),
    ([1.0, 2.0, 3.0], [-1e-06, 1.0, 1e-06], 20.0, [-0.000_253_687_813_686_604_96, 0.999_999_871_286_978_1, 0.000_439_397_906_730_640_67]),
    ([1.0, 2.0, 3.0], [-1e-06, 1.0, 1e-06], 75.0, [-0.000_501_592_089_314_370_1, -0.999_999_496_812_625_2, 0.000_868_781_832_330_916_6]),
    ([1.0, 2.0, 3.0], [-1e-06, 1.0, 1e-06], 150.0, [-0.492_489_497_909_309_9, -0.172_674_195_524_818_9, -0.853_016_832_571_838_8]),
    ([1.0, 2.0, 3.0], [-1e-06, 1.0, 1e-06], 600.0, [-5.941_720_575_927_465_5e-6, 0.999_999_999_931_391_9, -1.019_372_994_576_565_3e-5]),
    ([3.0, 4.0, 6.0], [-1.0, 0.5, 1.000_000_000_000_000_2], 100.0, [-1.117_994_958_545_100_4e-5, -1.499_999_999_916_672_4, 1.117_996_944_639_993e-5]),
    ([3.0, 4.0, 6.0], [-1.0, 0.5, 1.000_000_000_000_000_2], 400.0, [2.345_305_142_409_280_5e-5, 1.499_999_999_633_302_9, 2.345_306_089_171_201e-5]),
    ([3.0, 4.0, 6.0], [-1.0, 0.5, 0.999_999_999_999_999_9], 100.0, [-1.117_996_448_116_271_7e-5, -1.499_999_999_916_672_2, 1.117_995_455_068_825_4e-5]),
    ([3.0, 4.0, 6.0], [-1.0, 0.5, 0.999_999_999_999_999_9], 400.0, [-4.690_611_348_205_721e-5, 1.499_999_998_533_211, -4.690_611_111_515_240_6e-5]),
    ([3.0, 4.0, 6.0], [1.0, -0.5, 0.999_999_999_999_999_9], 200.0, [1.332_399_949_334_108_8e-6, 1.499_999_999_998_816_5, -1.332_316_621_670_919_1e-6]),
    ([6.0, 3.0, 4.0], [0.3, -1.2, -0.7], 1000.0, [0.130_024_836_283_768_4, -1.169_147_748_597_507_5, -0.797_613_367_427_325_9]),
    ([1.0, 1.000_000_000_000_000_4, 2.0], [0.3, 0.4, 0.2], 50.0, [0.468_668_365_504_222_9, -0.174_212_408_213_651_66, 0.200_000_000_000_000_3]),
    ([1.0, 1.000_000_000_001, 1.000_000_000_003], [0.3, -0.4, 0.2], 5_000_000_000_000.0, [0.100_106_397_719_905_11, 0.529_124_279_835_910_1, 0.002_491_108_924_481_746_5]),
    ([1e-08, 1.0, 1.000_000_01], [1e-09, 0.3, -0.2], 10.0, [2.169_721_032_758_288_6e-10, -0.315_482_536_952_387_04, -0.174_558_783_445_823_07]),
    ([1.0, 2.0, 3.0], [1e-200, 1.0, 3e-200], 1600.0, [-0.469_562_005_920_373_4, -0.343_578_361_344_454_85, 0.813_305_251_558_044_7]),
    ([1.0, 2.0, 3.0], [1e-200, 1.0, 3e-200], 3300.0, [9.628_102_154_705_448e-188, -1.0, 1.667_636_211_241_322e-187]),
    ([3.0, 4.0, 6.0], [0.7, 0.5, -0.700_000_000_000_000_1], 837.5, [0.709_013_197_867_762_1, 0.473_920_426_336_172_1, -0.709_013_197_867_762_2]),
    ([1.1, 1.3, 1.9], [0.3, -0.6, 0.227_636_073_191_798_43], 318.6, [-0.500_190_628_654_165_3, 0.327_991_381_092_443_9, 0.379_538_101_847_237_46]),
    ([1.9, 1.3, 1.1], [-0.227_636_073_191_798_43, 0.2, -0.3], 508.9, [-0.242_521_284_818_147_1, -0.144_383_194_071_143_33, 0.319_617_117_029_347_36]),
    ([10.0, 12.0, 15.0], [0.1, 0.9, 0.100_000_000_000_000_03], 5281.9, [0.571_105_633_218_462_7, -0.421_517_154_351_133_74, 0.571_105_633_218_462_7]),
];

fn solution(inertia: Vector3<f64>, start: Vector3<f64>) -> EulerSolution {
    EulerSolution::new(&RigidBody::new(inertia).unwrap(), start).unwrap()
}

#[test]
fn against_reference_values() {
    for (inertia, start, time, expected) in REFERENCE {
        let [inertia, start, expected] = [inertia, start, expected].map(Vector3::from);
        let error = (solution(inertia, start).at(time) - expected).norm();
        // The bound is a dozen rounding errors of Π, and of λ and so of t.
        let rate = expected.cross(&expected.component_div(&inertia)).norm();
        let bound = 16.0 * ROUNDING * (start.norm() + time.abs() * rate);
        assert!(error < bound, "{start:?} {time}: {error:e} {bound:e}");
    }
}

/// Negative control: starts on the separatrix and two rounding errors beside it all differ at t = 400, after the
/// turn.
#[test]
fn neighbours_of_the_separatrix_part() {
    let (body, time) = (RigidBody::new(Vector3::new(3.0, 4.0, 6.0)).unwrap(), 400.0);
    let ends = [1.0, 1.0 + f64::EPSILON, 1.0 - ROUNDING].map(|z| {
        let start = Vector3::new(-1.0, 0.5, z);
        EulerSolution::new(&body, start).unwrap().at(time)
    });
    assert!((ends[0] + Vector3::y() * 1.5).norm() < 1e-12);
    assert!((ends[1] - Vector3::y() * 1.5).norm() < 1e-4 && ends[1].x > 1e-5 && ends[1].z > 1e-5);
    assert!((ends[2] - Vector3::y() * 1.5).norm() < 1e-4 && ends[2].x < -1e-5 && ends[2].z < -1e-5);
}

#[test]
fn rotations_about_principal_axes_are_constant() {
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    for inertia in [[3.0, 4.0, 6.0], [1.0, 1.0, 1.0], [2.0, 2.0, 1.0], [1.5, 1.0, 1.5]] {
        for start in axes.into_iter().flat_map(|e| [e, -e, e * 1e-200, e * 1e300]) {
            let solution = solution(Vector3::from(inertia), start);
            assert_eq!([solution.at(0.0), solution.at(1e9)], [start; 2]);
        }
    }
    // Equilibria: any axis of equal moments, and rest.
    for start in [Vector3::new(0.3, -0.4, 0.0), Vector3::zeros()] {
        assert_eq!(solution(Vector3::new(2.0, 2.0, 1.0), start).at(7.0), start);
    }
    // Next to one of them, the precession rate is Π₁(1/I₁ − 1/I₂).
    let start = Vector3::new(1e-200, 0.3, 0.4);
    let (precession, quarter) = (solution(Vector3::new(1.0, 2.0, 2.0), start), 1e200 * PI);
    assert!((precession.at(0.0) - start).norm() < 4.0 * ROUNDING);
    assert!((precession.at(quarter) - Vector3::new(1e-200, 0.4, -0.3)).norm() < 8.0 * ROUNDING);
    // A component of Π of 1e-300 is enough to leave the unstable axis, after ln 1e300/λ.
    let leaving = solution(Vector3::new(3.0, 4.0, 6.0), Vector3::new(-1e-300, 1.0, 1e-300));
    assert!((leaving.at(300.0).y - 1.0).abs() < 1e-15);
    assert!((leaving.at(12.0 * 690.8).y).abs() < 0.9);
    assert!((leaving.at(1e6).y + 1.0).abs() < 1e-15);
}

#[test]
fn what_is_not_finite_is_refused() {
    let body = RigidBody::new(Vector3::new(1.0, 2.0, 2.5)).unwrap();
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(EulerSolution::new(&body, Vector3::new(0.1, bad, 0.2)).is_err());
    }
    // |Π| and |Π|/I exceed the largest number.
    assert!(EulerSolution::new(&body, Vector3::repeat(f64::MAX)).is_err());
    let small = RigidBody::new(Vector3::new(1.0, 2.0, 2.5) * 1e-160).unwrap();
    assert!(EulerSolution::new(&small, Vector3::new(1.0, 2.0, 3.0) * 1e160).is_err());
}

/// Draws three moments that obey the triangle inequality, some of them nearly equal, and a start of any signs, some
/// next to an axis and on the separatrix.
fn motion() -> impl Strategy<Value = (Vector3<f64>, Vector3<f64>)> {
    let component = || prop_oneof![3 => -1.0..1.0, 1 => -1e-9..1e-9, 1 => Just(0.0)];
    let free = ([1.0..1.9, 1.0..1.9, 1.0..1.9], [component(), component(), component()]);
    let near = (1e-14..1e-6, free.clone()).prop_map(|(e, ([a, b, c], pi))| ([a, a + e * b, c], pi));
    // I₁(I₃ − I₂) = I₃(I₂ − I₁), so that |Π₁| = |Π₃| is the separatrix.
    let bodies = prop_oneof![Just([3.0, 4.0, 6.0]), Just([10.0, 12.0, 15.0])];
    let separatrix = (bodies, component(), component(), any::<bool>()).prop_map(
        |(inertia, x, y, flip): (_, f64, f64, bool)| (inertia, [x, y, if flip { -x } else { x }]),
    );
    let order = Just([0, 1, 2]).prop_shuffle();
    (prop_oneof![2 => free, 1 => near, 2 => separatrix], order).prop_map(
        |((inertia, pi), [i, j, k])| {
            (Vector3::new(inertia[i], inertia[j], inertia[k]), Vector3::new(pi[i], pi[j], pi[k]))
        },
    )
}

proptest! {
    #[test]
    fn it_starts_at_its_start_and_keeps_its_invariants(
        (inertia, start) in motion(),
        exponent in prop_oneof![Just(0), -30..30, -150..150, Just(-290), Just(300)],
        periods in -1e6..1e6,
    ) {
        let start = start * 10.0_f64.powi(exponent);
        // |Π|² may underflow or overflow.
        let size = start.amax();
        if size == 0.0 {
            return Ok(());
        }
        let norm = (start / size).norm();
        let solution = solution(inertia, start);
        prop_assert!(((solution.at(0.0) - start) / size).norm() < 16.0 * ROUNDING * norm);
        let energy = |pi: Vector3<f64>| (pi / size).dot(&(pi / size).component_div(&inertia));
        for time in [0.1, 1.7, 33.0, periods] {
            let pi = solution.at(time / size);
            prop_assert!(((pi / size).norm() - norm).abs() < 16.0 * ROUNDING * norm);
            // Π/I is up to twice as large along one axis as along another.
            prop_assert!((energy(pi) - energy(start)).abs() < 32.0 * ROUNDING * norm * norm);
        }
    }

    /// The maps Π → sΠ, t → t/s and I → rI, t → rt take solutions to solutions: for powers of two to the last bit.
    #[test]
    fn units_do_not_matter(
        (inertia, start) in motion(), s in -500..500_i32, r in -400..400_i32, time in -50.0..50.0,
    ) {
        let (s, r) = (2.0_f64.powi(s), 2.0_f64.powi(r));
        let expected = solution(inertia, start).at(time) * s;
        prop_assert_eq!(solution(inertia * r, start * s).at(time / s * r), expected);
    }

    /// Half turns about the axes, and the reversal of time with Π → −Π, are symmetries to the last bit.
    #[test]
    fn symmetries((inertia, start) in motion(), time in -50.0..50.0) {
        let pi = solution(inertia, start).at(time);
        for half_turn in [[1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]] {
            let half_turn = Vector3::from(half_turn);
            let turned = solution(inertia, start.component_mul(&half_turn)).at(time);
            prop_assert_eq!(turned, pi.component_mul(&half_turn));
        }
        prop_assert_eq!(solution(inertia, -start).at(-time), -pi);
    }
}
