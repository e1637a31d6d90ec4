//! Events of random functions with known zeros, jumps and poles, along the motion x = t, which no method rounds.

use collective_integrators::{Direct, Direction, Events, Integrator, RungeKutta, from_fn};
use nalgebra::Vector1;
use proptest::prelude::*;
use proptest::sample::select;
use std::f64::consts::PI;

/// The step of the runs.
const STEP: f64 = 0.125;

/// Returns the times of the events of g along x = t up to a number of steps.
fn times(g: impl Fn(f64) -> f64, direction: Direction, steps: usize) -> Vec<f64> {
    let clock =
        Direct::new(RungeKutta::explicit_midpoint(), from_fn(|_: &Vector1<f64>| Vector1::x()));
    let run = clock.trajectory_from(Vector1::zeros(), STEP).take(steps + 1);
    let events = Events::new(&clock, run, |x: &Vector1<f64>| g(x[0]), direction);
    events.map(|event| event.unwrap().time).collect()
}

/// Returns whether the times are these, up to the rounding of g over its slope.
fn are(times: &[f64], expected: &[f64], tolerance: f64) -> bool {
    times.len() == expected.len()
        && times.iter().zip(expected).all(|(t, zero)| (t - zero).abs() <= tolerance)
}

/// A place within n steps: at a sample, including the start and the end, or anywhere.
fn place(steps: usize) -> impl Strategy<Value = f64> {
    prop_oneof![
        (0..=steps).prop_map(|n| STEP * n as f64),
        (0.0..STEP * steps as f64),
        (0.0..STEP),
        (STEP * (steps as f64 - 1.0)..STEP * steps as f64),
    ]
}

/// A unit of g, with a sign.
fn unit() -> impl Strategy<Value = f64> {
    (-30..=30, any::<bool>()).prop_map(|(k, minus)| {
        let size = 10.0_f64.powi(k);
        if minus { -size } else { size }
    })
}

/// A function that is never zero, and smooth.
fn factor(kind: usize, x: f64) -> f64 {
    match kind {
        0 => 1.0,
        1 => (0.3 * x).exp(),
        _ => 3.0 + x.cos(),
    }
}

proptest! {
    /// (x − a)(x − b): both zeros are found, wherever they lie, and none if they are one. Zeros at the start do not count.
    #[test]
    fn both_zeros_of_a_product(
        (steps, a, b) in (1_usize..6).prop_flat_map(|n| (Just(n), place(n), place(n))),
        s in unit(), kind in 0_usize..3,
    ) {
        let (a, b) = (a.min(b), a.max(b));
        prop_assume!(a == b || b - a > 1e-5);
        // A zero may not lie so near to a sample that it counts as one.
        let near = |x: f64| (x / STEP - (x / STEP).round()).abs();
        prop_assume!([a, b].iter().all(|&x| near(x) == 0.0 || near(x) > 1e-5));
        let g = |x: f64| s * factor(kind, x) * (x - a) * (x - b);
        let expected: Vec<f64> =
            [a, b].into_iter().filter(|&zero| a != b && zero > 0.0).collect();
        let tolerance = 1e-14 / (b - a).max(1e-5);
        let found = times(g, Direction::Both, steps);
        prop_assert!(are(&found, &expected, tolerance), "{a} {b} {steps}: {found:?}");
        // Each direction has its own.
        let (first, second) =
            if s > 0.0 { (Direction::Down, Direction::Up) } else { (Direction::Up, Direction::Down) };
        let of = |zero: f64| if a != b && zero > 0.0 { vec![zero] } else { vec![] };
        prop_assert!(are(&times(g, first, steps), &of(a), tolerance));
        prop_assert!(are(&times(g, second, steps), &of(b), tolerance));
    }

    /// A change of sign without a zero is no event, and a zero elsewhere is one.
    #[test]
    fn jumps_and_poles(
        a in place(4), b in place(4), s in unit(), kind in 0_usize..7,
        left in 1e-4..1.0_f64, right in 1e-4..1.0_f64, slope in 0.0..3.0_f64,
    ) {
        let jump = |x: f64| match kind {
            0 => 1.0 / x,
            1 => x.powi(-3),
            2 => (0.5 * PI + x).tan(),
            // Both sides grow or fall towards the jump.
            3 => if x < 0.0 { slope * x - left } else { slope * x + right },
            4 => if x < 0.0 { -left / (1.0 + slope * x * x) } else { right },
            5 => f64::atan2(-1e-9 * x.signum(), -1.0),
            _ => x.signum() / x.abs().sqrt(),
        };
        let found = times(|x| s * jump(x - a), Direction::Both, 4);
        prop_assert!(found.is_empty(), "{kind} {a}: {found:?}");
        // With a zero in another step.
        let cell = |x: f64| (x / STEP).floor();
        prop_assume!((cell(a) - cell(b)).abs() > 1.0 && b > 0.0);
        let found = times(|x| s * jump(x - a) * (x - b), Direction::Both, 4);
        prop_assert!(are(&found, &[b], 1e-10), "{kind} {a} {b}: {found:?}");
    }

    /// Zeros of every order are crossings if the order is odd, and touches if it is even.
    #[test]
    fn orders(a in place(4), s in unit(), order in select(vec![1, 2, 3, 4, 5, 6, 7])) {
        let found = times(|x| s * (x - a).powi(order), Direction::Both, 4);
        let counts = order % 2 == 1 && a > 0.0;
        prop_assert!(are(&found, &vec![a; usize::from(counts)], 1e-12), "{order}: {found:?}");
        let root = |x: f64| s * (x - a).signum() * (x - a).abs().powf(1.0 / f64::from(order));
        let found = times(root, Direction::Both, 4);
        prop_assert!(are(&found, &vec![a; usize::from(a > 0.0)], 1e-12), "1/{order}: {found:?}");
    }

    /// A vector that turns with the velocity w passes each angle once per turn, and not where atan2 jumps.
    #[test]
    fn angles(phase in -PI..PI, level in -10.0..10.0_f64, w in 0.1..3.0_f64, up in any::<bool>()) {
        let turn = if up { w } else { -w };
        let angle = |x: f64| f64::atan2((phase + turn * x).sin(), (phase + turn * x).cos()) - level;
        let clock =
            Direct::new(RungeKutta::explicit_midpoint(), from_fn(|_: &Vector1<f64>| Vector1::x()));
        let run = || clock.trajectory_from(Vector1::zeros(), STEP).take(81);
        let found = |direction| -> Vec<f64> {
            let events = Events::new(&clock, run(), |x: &Vector1<f64>| angle(x[0]), direction);
            events.modulo(2.0 * PI).map(|event| event.unwrap().time).collect()
        };
        let first = ((level - phase) / turn).rem_euclid(2.0 * PI / w);
        prop_assume!(first > 1e-9 && (10.0 - first).rem_euclid(2.0 * PI / w) > 1e-9);
        let expected: Vec<f64> =
            (0..).map(|k| first + f64::from(k) * 2.0 * PI / w).take_while(|t| *t < 10.0).collect();
        let (along, against) =
            if up { (Direction::Up, Direction::Down) } else { (Direction::Down, Direction::Up) };
        prop_assert!(are(&found(along), &expected, 1e-12), "{:?} {expected:?}", found(along));
        prop_assert!(found(against).is_empty());
        // Without the period, a level that is not passed in the step of the jump is found, and the jump does not count.
        if level.abs() < PI - w * STEP {
            let plain = times(angle, Direction::Both, 80);
            prop_assert!(are(&plain, &expected, 1e-12), "{plain:?} {expected:?}");
        }
    }
}

/// Powers of two as units of x, t and g change no bit.
#[test]
fn units_do_not_matter() {
    let in_units = |length: f64, time: f64, size: f64| -> Vec<f64> {
        let field = from_fn(move |_: &Vector1<f64>| Vector1::new(length / time));
        let clock = Direct::new(RungeKutta::explicit_midpoint(), field);
        let run = clock.trajectory_from(Vector1::zeros(), STEP * time).take(17);
        let g = |x: f64| (x - 0.03) * (x - 0.05) * (x - 0.5) * (x - 1.7) / (x - 1.1);
        let value = |x: &Vector1<f64>| size * g(x[0] / length);
        let events = Events::new(&clock, run, value, Direction::Both);
        events.map(|event| event.unwrap().time / time).collect()
    };
    let plain = in_units(1.0, 1.0, 1.0);
    assert!(are(&plain, &[0.03, 0.05, 0.5, 1.7], 1e-13), "{plain:?}");
    let [large, small] = [2.0_f64.powi(100), 2.0_f64.powi(-100)];
    for units in [[large, 1.0, 1.0], [1.0, small, 1.0], [small, large, small], [1.0, 1.0, large]] {
        let [length, time, size] = units;
        assert_eq!(in_units(length, time, size), plain, "{units:?}");
    }
}

/// A slow function, whose change in a step is near the rounding of the state, keeps its zeros.
#[test]
fn slow_functions_have_zeros() {
    for speed in [1e-6, 1e-8, 1e-10, 1e-11] {
        let field = from_fn(move |_: &Vector1<f64>| Vector1::new(speed));
        let clock = Direct::new(RungeKutta::explicit_midpoint(), field);
        let run = clock.trajectory_from(Vector1::new(0.8), STEP).take(17);
        let value = |x: &Vector1<f64>| x[0] - (0.8 + 1.03 * speed);
        let found: Vec<f64> =
            Events::new(&clock, run, value, Direction::Both).map(|e| e.unwrap().time).collect();
        assert!(are(&found, &[1.03], 2e-16 / speed + 1e-14), "{speed}: {found:?}");
    }
}
