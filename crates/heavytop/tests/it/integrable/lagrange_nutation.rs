//! The nutation of Lagrange's top in closed form against reference values and its differential equation.
//!
//! The starts are at turning points, next to the vertical and on the separatrix, in all units.

use heavytop::{HeavyTop, LagrangeNutation};
use lie_poisson::Se3Dual;
use nalgebra::Vector3;
use proptest::prelude::*;

/// The unit of round-off, half the machine epsilon.
const ROUNDING: f64 = 0.5 * f64::EPSILON;

type Reference = ([f64; 3], [f64; 3], [f64; 3], f64, f64);

/// (I₁, I₃, m g l), Π(0), Γ(0), t and Γ₃(t), rounded from Taylor series of the heavy top equations with 40 to 130
/// digits (mpmath 1.3). The last six rows, within rounding errors of the separatrix, come from the closed form with
/// 100 digits, which agrees with the series elsewhere.
#[rustfmt::skip]
const REFERENCE: [Reference; 40] = [
    ([2.0, 1.0, 1.0], [0.000_299_999_995_5, 0.0, 0.999_999_955_000_000_4], [0.000_299_999_995_5, 0.0, 0.999_999_955_000_000_4], 10.0, 0.992_864_329_051_825_4),
    ([2.0, 1.0, 1.0], [0.000_299_999_995_5, 0.0, 0.999_999_955_000_000_4], [0.000_299_999_995_5, 0.0, 0.999_999_955_000_000_4], 30.0, 0.999_999_951_096_180_7),
    ([2.0, 1.0, 1.0], [0.000_299_999_995_5, 0.0, 0.999_999_955_000_000_4], [0.000_299_999_995_5, 0.0, 0.999_999_955_000_000_4], 100.0, 0.998_603_582_607_660_8),
    ([2.0, 1.0, 1.0], [0.009_999_833_334_166_664, 0.0, 0.999_950_000_416_665_3], [0.009_999_833_334_166_664, 0.0, 0.999_950_000_416_665_3], 20.0, 0.999_949_080_535_544_4),
    ([2.0, 1.0, 1.0], [0.009_999_833_334_166_664, 0.0, 0.999_950_000_416_665_3], [0.009_999_833_334_166_664, 0.0, 0.999_950_000_416_665_3], 50.0, -0.585_925_217_252_401),
    ([2.0, 1.0, 1.0], [1.2, 0.0, 1.6], [0.6, 0.0, 0.8], 10.0, 0.073_535_170_543_870_53),
    ([2.0, 1.0, 1.0], [1.2, 0.0, 1.6], [0.6, 0.0, 0.8], 50.0, 0.696_273_089_046_487_5),
    ([1.0, 1.0, 1.0], [1.0, 1.0, 3.0], [0.0, 3.0, 4.0], 1.0, -0.358_660_545_684_139_46),
    ([1.0, 1.0, 1.0], [1.0, 1.0, 3.0], [0.0, 3.0, 4.0], -1.0, 4.960_142_253_509_115),
    ([1.0, 1.0, 1.0], [1.0, 1.0, 3.0], [0.0, 3.0, 4.0], 5.0, 4.999_972_432_173_134),
    ([1.0, 1.0, 1.0], [1.0, 1.0, 3.0], [0.0, 3.0, 4.0], 20.0, 5.0),
    ([1.0, 1.0, 1.0], [-1.0, 1.0, 3.0], [0.0, 3.0, 4.0], 1.0, 4.960_142_253_509_115),
    ([1.0, 1.0, 1.0], [-1.0, 1.0, 3.0], [0.0, 3.0, 4.0], 20.0, 5.0),
    ([1.0, 1.0, 1.0], [1.000_000_000_000_000_2, 1.0, 3.0], [0.0, 3.0, 4.0], 20.0, 4.999_998_508_892_055),
    ([1.0, 1.0, 1.0], [1.000_000_000_000_000_2, 1.0, 3.0], [0.0, 3.0, 4.0], 50.0, 4.129_474_948_100_989),
    ([1.0, 1.0, 1.0], [0.999_999_999_999_999_9, 1.0, 3.0], [0.0, 3.0, 4.0], 20.0, 4.999_999_627_222_976),
    ([1.0, 1.0, 1.0], [0.999_999_999_999_999_9, 1.0, 3.0], [0.0, 3.0, 4.0], 50.0, -0.313_228_742_846_408_1),
    ([1.0, 1.0, 1.0], [3.0, 3.0, 1.0], [0.0, 3.0, -4.0], 0.5, 0.079_100_434_256_564_25),
    ([1.0, 1.0, 1.0], [3.0, 3.0, 1.0], [0.0, 3.0, -4.0], 10.0, 5.0),
    ([2.0, 1.0, 1.0], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0], 3.0, 0.429_538_972_879_429_77),
    ([2.0, 1.0, 1.0], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0], 20.0, 0.999_999_999_975_737_3),
    ([2.0, 1.0, 1.0], [0.0, 0.0, 0.0], [1e-10, 0.0, 1.0], 30.0, 0.996_672_616_088_150_5),
    ([2.0, 1.0, 1.0], [0.0, 0.0, 0.0], [1e-10, 0.0, 1.0], 40.0, 0.986_184_702_902_985_4),
    ([2.0, 1.0, 1.0], [0.0, 0.0, 0.0], [1e-10, 0.0, 1.0], 100.0, 0.999_200_206_532_371),
    ([2.0, 1.0, 1.0], [0.0, 0.0, 0.5], [1e-60, 0.0, 1.0], 200.0, 0.197_023_851_937_288_94),
    ([2.0, 1.0, 1.0], [0.0, 0.0, 0.5], [1e-60, 0.0, 1.0], 500.0, 1.0),
    ([1.0, 1.0, 1.0], [0.0, 0.0, 5.0], [1e-06, 0.0, 1.0], 100.0, 0.999_999_999_999_996),
    ([1.0, 1.0, 1.0], [0.0, 0.0, 2.0], [0.001, 0.0, 1.0], 100.0, 0.999_851_671_523_352_1),
    ([1.0, 1.0, 1.0], [0.0, 0.0, 2.0], [0.001, 0.0, 1.0], 1000.0, 0.999_010_656_570_275_1),
    ([2.0, 1.0, 1.0], [0.0, 1e-05, 0.3], [1e-05, 0.0, -1.0], 50.0, -0.999_999_999_985_336_6),
    ([1.0, 1.0, 1.0], [3.0, 0.0, 5.0], [3.0, 0.0, 4.0], 10.0, 4.0),
    ([2.0, 1.0, 1.0], [0.1, 0.2, 1000.0], [0.6, 0.0, 0.8], 1.0, 0.800_055_679_538_695_2),
    ([2.0, 1.0, 1.0], [0.5, 0.2, 3.0], [0.6, 0.0, 0.8], 300.0, 0.717_046_838_020_368_5),
    ([2.0, 1.0, 1.0], [50.0, -30.0, 3.0], [0.6, 0.0, 0.8], 3.0, 0.858_871_236_893_317_7),
    ([2.0, 1.0, 1.5], [1.397_408_361_240_351_8, 1.125_704_237_861_796_5, 0.513_533_492_690_3], [0.6, -0.5, 0.3], 47.5, 0.606_987_829_151_411),
    ([2.0, 1.0, 1.5], [-0.557_703_674_339_602_7, -2.711_815_857_329_435, 0.799_443_108_482_465_9], [0.6, -0.5, -0.4], 49.5, 0.501_185_021_317_033_9),
    ([2.0, 1.0, 1.5], [-0.171_571_619_632_562_07, -1.436_459_629_908_744_9, 1.763_965_697_552_184_5], [0.6, -0.5, 0.7], 51.5, 0.828_590_056_781_530_4),
    ([2.0, 1.0, 1.5], [-1.352_579_375_992_224, -2.771_253_094_309_17, 0.362_221_005_916_396_05], [0.6, -0.5, -0.6], 45.5, 0.533_040_473_045_101_6),
    ([2.0, 1.0, 1.5], [0.055_708_509_613_131_466, 2.030_098_836_599_777_6, -1.428_023_258_808_276_4], [0.6, -0.5, 0.1], 55.0, 0.530_734_668_609_809_2),
    ([2.0, 1.0, 1.5], [3.290_572_583_631_105, 0.824_824_832_527_903_7, 0.814_339_653_559_904_3], [0.6, -0.5, -0.8], 43.0, 0.648_376_692_551_97),
];

fn nutation([i1, i3, weight]: [f64; 3], pi: Vector3<f64>, gamma: Vector3<f64>) -> LagrangeNutation {
    let top = HeavyTop::lagrange(i1, i3, weight).unwrap();
    LagrangeNutation::new(&top, &Se3Dual::new(pi, gamma)).unwrap()
}

#[test]
fn against_reference_values() {
    for (top, pi, gamma, time, expected) in REFERENCE {
        let [pi, gamma] = [pi, gamma].map(Vector3::from);
        let nutation = nutation(top, pi, gamma);
        assert!((nutation.height(0.0) - gamma.z).abs() < 16.0 * ROUNDING * gamma.norm());
        let error = (nutation.height(time) - expected).abs();
        // A relative error of t contributes no more than |t du/dt|.
        let step = 1e-6 * time;
        let change = (nutation.height(time + step) - nutation.height(time - step)).abs() / 2e-6;
        // The bound is a dozen rounding errors of |Γ|, and of ν and so of t.
        let bound = 16.0 * ROUNDING * (gamma.norm() + change);
        assert!(error < bound, "{pi:?} {gamma:?} {time}: {error:e} {bound:e}");
    }
}

#[test]
fn an_unstable_top_falls_however_little_it_is_tilted() {
    for (tilt, length) in [(0.1_f64, 1.0), (3e-4, 0.7), (1e-8, 1.0), (1e-60, 0.7), (1e-140, 1.3)] {
        // u₁ = −1 + b²/2I₁W to the second order of the tilt, with b = Π·Γ and |Γ| = W = 1
        let direction = Vector3::new(tilt.sin(), 0.0, tilt.cos());
        let nutation = nutation([2.0, 1.0, 1.0 / length], direction, direction * length);
        let (lowest, highest) = nutation.turning_points();
        let (lowest, start) = (lowest / length, tilt.cos());
        assert!((lowest + 0.75).abs() < tilt * tilt + 1e-15, "{tilt}: {lowest}");
        // Next to the start the closed form loses no digits at all.
        let near = |height: f64| (height / length - start).abs() < 4.0 * ROUNDING;
        assert!(near(highest) && near(nutation.height(0.0)), "{tilt}");
        let half = 0.5 * nutation.period();
        assert!((nutation.height(half) / length - lowest).abs() < 1e-13);
        // The tilt grows by e^{λt} to about 1, λ² = (W/I₁)(1 − Π₃²/4I₁W).
        let rate = (0.5 * (1.0 - 0.125_f64)).sqrt();
        assert!((half * rate + tilt.ln()).abs() < 4.0, "{tilt}: {half}");
    }
}

#[test]
fn a_constant_height_stays() {
    let top = [1.0, 1.0, 1.0];
    // Equilibria: upright, stable and not; hanging; regular precession; Γ = 0.
    for (pi, gamma) in [
        ([0.0, 0.0, 1.0], [0.0, 0.0, 1.0]),
        ([0.0, 0.0, 5.0], [0.0, 0.0, 1.0]),
        ([0.0, 0.0, 5.0], [0.0, 0.0, -1.0]),
        ([3.0, 0.0, 5.0], [3.0, 0.0, 4.0]),
        ([3.0, 0.0, 5.0], [0.0, 0.0, 0.0]),
    ] {
        let [pi, gamma] = [pi, gamma].map(Vector3::from);
        let nutation = nutation(top, pi, gamma);
        assert_eq!(nutation.turning_points(), (gamma.z, gamma.z));
        assert!([0.0, 1.0, -1e9].iter().all(|&t| nutation.height(t) == gamma.z));
    }
    // The period of infinitesimal nutation, 2πI₁/√(Π₃² − 4I₁W) about the upright top
    let period = |spin| nutation(top, Vector3::z() * spin, Vector3::z()).period();
    assert!((period(5.0) - core::f64::consts::TAU / 21.0_f64.sqrt()).abs() < 1e-14);
    assert_eq!(period(1.0), f64::INFINITY);
    // Negative control: a neighbour of a regular precession nutates, by about its distance from it.
    let next = nutation(top, Vector3::new(3.0 + 1e-12, 0.0, 5.0), Vector3::new(3.0, 0.0, 4.0));
    let (lowest, highest) = next.turning_points();
    assert!((1e-14..1e-11).contains(&(highest - lowest)));
}

/// On the separatrix the top rises for ever: Γ₃ = |Γ| − (|Γ| − u₁) sech² ν(t − t₁).
#[test]
fn the_separatrix() {
    // b = Π₃|Γ| and E′ = W|Γ| are whole numbers.
    for (pi, gamma) in [([1.0, 1.0, 3.0], [0.0, 3.0, 4.0]), ([3.0, 3.0, 1.0], [0.0, 3.0, -4.0])] {
        let [pi, gamma] = [pi, gamma].map(Vector3::from);
        let nutation = nutation([1.0; 3], pi, gamma);
        let (lowest, highest) = nutation.turning_points();
        assert!((highest - 5.0).abs() < 1e-14 && nutation.period() == f64::INFINITY);
        assert!([-1e3, 1e3].iter().all(|&t| (nutation.height(t) - 5.0).abs() < 1e-14));
        // The rate is du/dt = (Γ × Ω)₃, and its square 2W/I₁ (u − u₁)(u − u₂)².
        let rate = gamma.x * pi.y - gamma.y * pi.x;
        let square = 2.0 * (gamma.z - lowest) * (gamma.z - highest).powi(2);
        assert!((rate * rate - square).abs() < 1e-13 * square);
    }
}

#[test]
fn what_has_no_nutation_is_refused() {
    let top = HeavyTop::lagrange(2.0, 1.0, 1.0).unwrap();
    let refused = |pi, gamma| LagrangeNutation::new(&top, &Se3Dual::new(pi, gamma)).is_err();
    assert!(refused(Vector3::repeat(f64::NAN), Vector3::z()));
    assert!(refused(Vector3::z(), Vector3::new(0.0, f64::INFINITY, 0.0)));
    // |Γ| and the ratio of the energies exceed the largest number.
    assert!(refused(Vector3::z(), Vector3::repeat(f64::MAX)));
    assert!(refused(Vector3::repeat(1e200), Vector3::new(0.6, 0.0, 0.8)));
    assert!(refused(Vector3::z() * 1e160, Vector3::new(0.6, 0.0, 0.8)));
    let kovalevskaya = HeavyTop::kovalevskaya(1.0, 1.0).unwrap();
    let upright = Se3Dual::new(Vector3::z(), Vector3::z());
    assert!(LagrangeNutation::new(&kovalevskaya, &upright).is_err());
}

/// Draws I₃, Π and Γ for I₁ = W = 1: free, at turning points, next to the vertical, next to regular precession and
/// next to the separatrix.
fn motion() -> impl Strategy<Value = (f64, Vector3<f64>, Vector3<f64>)> {
    let vector = |size: f64| [-size..size, -size..size, -size..size].prop_map(Vector3::from);
    let free = (vector(3.0), vector(1.0));
    let turning = (-2.0..2.0, -3.0..3.0, vector(1.0))
        .prop_map(|(a, spin, gamma)| (Vector3::new(a * gamma.x, a * gamma.y, spin), gamma));
    let vertical = (vector(1.0), vector(1.0), -30.0..-1.0, -30.0..-1.0, any::<bool>()).prop_map(
        |(pi, gamma, a, b, up)| {
            let (a, b) = (10.0_f64.powf(a), 10.0_f64.powf(b));
            let side = if up { 1.0 } else { -1.0 };
            (
                Vector3::new(a * pi.x, a * pi.y, 4.0 * pi.z),
                gamma.xy().push(0.0) * b + Vector3::z() * side,
            )
        },
    );
    // A regular precession turns at Π₃ = (1 + Γ₃a²)/a, Π⊥ = aΓ⊥.
    let precession = (0.3..3.0, -16.0..-6.0, vector(1.0)).prop_map(|(a, e, gamma)| {
        let e = 1.0 + 10.0_f64.powf(e);
        (Vector3::new(a * gamma.x * e, a * gamma.y, 1.0 / a + gamma.z * a), gamma)
    });
    let separatrix = (-1.0..1.0, any::<bool>(), vector(1.0)).prop_map(|(fraction, up, gamma)| {
        let pi = separatrix(fraction, up, gamma);
        (pi, gamma)
    });
    let states =
        prop_oneof![2 => free, 2 => turning, 2 => vertical, 1 => precession, 2 => separatrix];
    (0.1..2.0, states).prop_map(|(i3, (pi, gamma))| (i3, pi, gamma))
}

/// Returns Π with Π·Γ = Π₃|Γ| and |Π⊥|² = 2(|Γ| − Γ₃), where Π₃² is a fraction of its largest value.
fn separatrix(fraction: f64, up: bool, gamma: Vector3<f64>) -> Vector3<f64> {
    let (length, level) = (gamma.norm(), gamma.xy().norm());
    let spin = fraction * (2.0 * (length + gamma.z)).sqrt();
    let radial = spin * (length - gamma.z) / level;
    let across = (2.0 * (length - gamma.z) - radial * radial).max(0.0).sqrt();
    let across = if up { across } else { -across };
    let (x, y) = (gamma.x / level, gamma.y / level);
    Vector3::new(radial * x - across * y, radial * y + across * x, spin)
}

proptest! {
    /// At the start (du/dt)² and d²u/dt² agree with the turning points, and the height with Γ₃.
    #[test]
    fn it_starts_at_its_start_between_its_turning_points(
        (i3, pi, gamma) in motion(), time in prop_oneof![-10.0..10.0, -1e6..1e6],
    ) {
        prop_assume!(gamma.norm() > 0.1 && gamma.xy().norm() > 0.0);
        let nutation = nutation([1.0, i3, 1.0], pi, gamma);
        let length = gamma.norm();
        prop_assert!((nutation.height(0.0) - gamma.z).abs() < 32.0 * ROUNDING * length);
        let (lowest, highest) = nutation.turning_points();
        let slack = 16.0 * ROUNDING * length;
        prop_assert!(-length - slack <= lowest && highest <= length + slack);
        let height = nutation.height(time);
        prop_assert!(lowest - slack <= height && height <= highest + slack);
        let period = nutation.period();
        if period.is_finite() {
            // The error is that of the period, and of the time itself.
            let error = (nutation.height(time + period) - height).abs();
            let scale = 1.0 + pi.norm() + length;
            prop_assert!(error < 64.0 * ROUNDING * length * (1.0 + scale * (time.abs() + period)));
        }
        // The slope is that of the equations, up to h⁴ for a five-point difference, and round-off over h.
        let (h, at) = (1e-3, |t: f64| nutation.height(t));
        let slope = (8.0 * (at(h) - at(-h)) - at(2.0 * h) + at(-2.0 * h)) / (12.0 * h);
        prop_assert!((slope - (gamma.x * pi.y - gamma.y * pi.x)).abs() < 1e-9);
    }

    /// Other units of mass, length and time give the same motion: for powers of four to the last bit.
    #[test]
    fn units_do_not_matter(
        (i3, pi, gamma) in motion(), r in -120..120_i32, s in -120..120_i32, g in -120..120_i32,
        time in -50.0..50.0,
    ) {
        prop_assume!(gamma.norm() > 0.1);
        // I → rI, t → st, Π → (r/s)Π, W → (r/s²g)W, Γ → gΓ
        let [r, s, g] = [r, s, g].map(|n| 4.0_f64.powi(n));
        let expected = nutation([1.0, i3, 1.0], pi, gamma).height(time) * g;
        let other = nutation([r, i3 * r, r / s / s / g], pi * (r / s), gamma * g);
        prop_assert_eq!(other.height(time * s), expected);
    }

    /// Any other units give the same motion, away from the separatrix, where errors of rounded units do not grow.
    #[test]
    fn units_with_roundings_do_not_matter(
        pi in [-3.0..3.0, -3.0..3.0, 3.0..5.0], gamma in [-1.0..1.0, -1.0..1.0, -1.0..1.0],
        r in -30..30_i32, s in -30..30_i32, time in 0.0..10.0,
    ) {
        let [pi, gamma] = [pi, gamma].map(Vector3::from);
        prop_assume!(gamma.norm() > 0.1);
        let [r, s] = [r, s].map(|n| 10.0_f64.powi(n));
        let expected = nutation([1.0, 0.7, 1.0], pi, gamma).height(time);
        let other = nutation([r, 0.7 * r, r / s / s], pi * (r / s), gamma).height(time * s);
        prop_assert!((other - expected).abs() < 1e-12, "{} {}", other, expected);
    }
}
