//! Inputs by tables: the interpolations against other formulas for them, over every scalar and in all units.

use InputTableError::{DifferentLengths, NotFinite, NotIncreasing, Outside, TooShort, TooSteep};
use lie_poisson::*;
use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;

const ALL: [Interpolation; 3] =
    [Interpolation::Constant, Interpolation::Linear, Interpolation::Cubic];

/// A table with 2 to 9 entries, and places in it: whole numbers are its times.
fn tables() -> impl Strategy<Value = (Vec<f64>, Vec<f64>, [f64; 4])> {
    let gaps = prop::collection::vec(0.2..3.0_f64, 1..9);
    (gaps, prop::collection::vec(-2.0..2.0_f64, 9), prop::array::uniform4(0.0..1.0_f64)).prop_map(
        |(gaps, values, parts)| {
            let mut times = vec![-1.5];
            times.extend(gaps.iter().scan(-1.5, |time, gap| {
                *time += gap;
                Some(*time)
            }));
            let (first, last) = (times[0], times[times.len() - 1]);
            let places = parts.map(|part| first + (last - first) * part);
            let values = values.into_iter().take(times.len()).collect();
            (times, values, places)
        },
    )
}

/// Returns the natural cubic spline as a sum of |t − tᵢ|³ and a line, whose weights w obey Σ w = Σ w tᵢ = 0.
fn natural_spline(times: &[f64], values: &[f64]) -> impl Fn(f64) -> f64 + use<> {
    let n = times.len();
    let mut matrix = DMatrix::zeros(n + 2, n + 2);
    for (i, t) in times.iter().enumerate() {
        for (j, other) in times.iter().enumerate() {
            matrix[(i, j)] = (t - other).abs().powi(3);
        }
        for (k, power) in [1.0, *t].into_iter().enumerate() {
            matrix[(i, n + k)] = power;
            matrix[(n + k, i)] = power;
        }
    }
    let right = DVector::from_fn(n + 2, |i, _| values.get(i).copied().unwrap_or(0.0));
    let weights = matrix.lu().solve(&right).unwrap();
    let times = times.to_vec();
    move |t| {
        let cubes =
            times.iter().zip(weights.iter()).map(|(other, w)| w * (t - other).abs().powi(3));
        cubes.sum::<f64>() + weights[n] + weights[n + 1] * t
    }
}

proptest! {
    #[test]
    fn interpolations_are_those_of_other_formulas((times, values, places) in tables()) {
        let table = |kind| InputTable::new(times.clone(), values.clone(), kind).unwrap();
        let [held, lines, spline] = ALL.map(table);
        let reference = natural_spline(&times, &values);
        for t in places.into_iter().chain(times.iter().copied()) {
            let place = times.iter().rposition(|begin| *begin <= t).unwrap();
            prop_assert_eq!(held.at(t).to_bits(), values[place].to_bits());
            let line = match times.get(place + 1) {
                Some(end) => {
                    let part = (t - times[place]) / (end - times[place]);
                    (1.0 - part) * values[place] + part * values[place + 1]
                }
                None => values[place],
            };
            // Round-off of values below 2; the reference has a condition below 10⁶.
            prop_assert!((lines.at(t) - line).abs() < 1e-14);
            prop_assert!((spline.at(t) - reference(t)).abs() < 1e-9);
            // A piece begins with its value itself. The last one ends with the round-off of a sum of four terms, which
            // intervals between 0.2 and 3 and values below 2 keep below 400.
            if times.contains(&t) {
                let bound = if t == times[times.len() - 1] { 400.0 * f64::EPSILON } else { 0.0 };
                prop_assert!((spline.at(t) - values[place]).abs() <= bound);
            }
        }
        let line: Vec<_> = times.iter().map(|t| 0.7 - 0.3 * t).collect();
        let line = InputTable::new(times.clone(), line, Interpolation::Cubic).unwrap();
        prop_assert!(places.iter().all(|t| (line.at(*t) - (0.7 - 0.3 * t)).abs() < 1e-13));
    }

    #[test]
    fn derivatives_are_those_of_dual_numbers((times, values, places) in tables()) {
        for kind in ALL {
            let table = InputTable::new(times.clone(), values.clone(), kind).unwrap();
            for t in places.into_iter().chain(times.iter().copied()) {
                let (value, slope) = (table.at(DualNumber::variable(t)), table.derivative(t));
                prop_assert_eq!(value.value_without_derivative().to_bits(), table.at(t).to_bits());
                prop_assert!((value.derivative() - slope).abs() <= 1e-13 * (1.0 + slope.abs()));
                prop_assert!(kind != Interpolation::Constant || slope == 0.0);
            }
        }
    }

    /// The spline has two continuous derivatives, and none at the ends; straight lines, the control, have not.
    #[test]
    fn splines_are_smooth_twice((times, values, _) in tables()) {
        type Twice = DualNumber<DualNumber>;
        for kind in [Interpolation::Linear, Interpolation::Cubic] {
            let table = InputTable::new(times.clone(), values.clone(), kind).unwrap();
            let near = |t: f64| {
                let t = DualNumber::new(DualNumber::variable(t), DualNumber::constant(1.0));
                let u: Twice = table.at(t);
                [u.derivative().value_without_derivative(), u.derivative().derivative()]
            };
            let jumps = times.iter().skip(1).take(times.len() - 2).map(|t| {
                let [[first, second], [first_after, second_after]] = [near(t.next_down()), near(*t)];
                (first - first_after).abs().max((second - second_after).abs())
            });
            let jump = jumps.fold(0.0, f64::max);
            if kind == Interpolation::Cubic {
                // Second derivatives are below 6 · 4/0.2² = 600.
                prop_assert!(jump < 1e-11, "{jump}");
                let ends = [near(times[0])[1], near(times[times.len() - 1])[1]];
                prop_assert!(ends.iter().all(|second| second.abs() < 1e-11), "{ends:?}");
            } else if times.len() > 2 {
                prop_assert!(jump > 1e-6);
            }
        }
    }

    /// Lanes in different intervals, outside and NaN have the bits of each alone.
    #[test]
    fn lanes_have_the_bits_of_each_lane((times, values, places) in tables(), outside in 0..12_usize) {
        for kind in ALL {
            let table = InputTable::new(times.clone(), values.clone(), kind).unwrap();
            let mut moments = places;
            let ends = [times[0] - 0.1, f64::NAN, times[times.len() - 1] + 0.1, times[0]];
            if let (Some(moment), Some(end)) = (moments.get_mut(outside % 4), ends.get(outside / 2)) {
                *moment = *end;
            }
            let lanes = DefaultLanes::from_lanes(|i| moments[i % 4]);
            for (together, alone) in [
                (table.at(lanes), moments.map(|t| table.at(t))),
                (table.derivative(lanes), moments.map(|t| table.derivative(t))),
            ] {
                for i in 0..DefaultLanes::COUNT {
                    let (one, other) = (together.lane(i), alone[i % 4]);
                    prop_assert!(one.to_bits() == other.to_bits() || (one.is_nan() && other.is_nan()));
                }
            }
        }
    }

    #[test]
    fn interpolations_do_not_know_units(
        (times, values, places) in tables(),
        unit_of_time in -100..100_i32,
        unit in -100..100_i32,
    ) {
        let [time, unit] = [unit_of_time, unit].map(|power| 2.0_f64.powi(power));
        for kind in ALL {
            let plain = InputTable::new(times.clone(), values.clone(), kind).unwrap();
            let scaled = InputTable::new(
                times.iter().map(|t| t * time).collect(),
                values.iter().map(|u| u * unit).collect(),
                kind,
            )
            .unwrap();
            for t in places {
                prop_assert_eq!(scaled.at(t * time), plain.at(t) * unit);
                prop_assert_eq!(scaled.derivative(t * time), plain.derivative(t) * unit / time);
            }
        }
    }

    #[test]
    fn the_next_break_is_the_next_time((times, values, places) in tables()) {
        let table = InputTable::new(times.clone(), values, Interpolation::Linear).unwrap();
        let beyond = [f64::NEG_INFINITY, times[0] - 1.0, times[times.len() - 1] + 1.0, f64::INFINITY];
        for t in places.into_iter().chain(times.iter().copied()).chain(beyond) {
            let after = times.iter().copied().find(|other| *other > t);
            let before = times.iter().copied().rev().find(|other| *other < t);
            prop_assert_eq!(table.next_break(t, true), after);
            prop_assert_eq!(table.next_break(t, false), before);
        }
        prop_assert_eq!(table.next_break(f64::NAN, true), None);
        prop_assert_eq!(table.next_break(f64::NAN, false), None);
        prop_assert_eq!(table.breakpoints(), &times[..]);
    }
}

#[test]
fn what_is_no_table_is_refused() {
    let of = |times: &[f64], values: &[f64]| {
        ALL.map(|kind| InputTable::new(times.to_vec(), values.to_vec(), kind).map(drop))
    };
    let cases: &[(&[f64], &[f64], InputTableError)] = &[
        (&[0.0, 1.0], &[1.0], DifferentLengths { times: 2, values: 1 }),
        (&[], &[], TooShort { times: 0 }),
        (&[0.0], &[1.0], TooShort { times: 1 }),
        (&[0.0, 1.0, 1.0], &[0.0; 3], NotIncreasing { row: 3, before: 1.0, time: 1.0 }),
        (&[0.0, -1.0, 1.0], &[0.0; 3], NotIncreasing { row: 2, before: 0.0, time: -1.0 }),
        (
            &[0.0, f64::INFINITY],
            &[0.0; 2],
            NotFinite { column: "time", row: 2, number: f64::INFINITY },
        ),
        (
            &[0.0, 1.0],
            &[f64::NEG_INFINITY, 0.0],
            NotFinite { column: "value", row: 1, number: f64::NEG_INFINITY },
        ),
    ];
    for (times, values, error) in cases {
        assert_eq!(of(times, values), [Err(*error); 3], "{error}");
    }
    let nan = |times, values| matches!(of(times, values)[0], Err(NotFinite { row: 2, .. }));
    assert!(nan(&[0.0, f64::NAN], &[0.0; 2]) && nan(&[0.0, 1.0], &[0.0, f64::NAN]));
    // A step over 10³⁰⁸ is no number, but may be held.
    let steep = of(&[0.0, 1.0, 2.0], &[0.0, 1e307, -1.79e308]);
    assert_eq!(steep[0], Ok(()));
    assert_eq!(steep[1], Err(TooSteep { row: 2, from: 1.0, to: 2.0 }));
    assert!(matches!(steep[2], Err(TooSteep { .. })));
    assert_eq!(
        of(&[0.0, 1e-300], &[0.0, 1e300])[1],
        Err(TooSteep { row: 1, from: 0.0, to: 1e-300 })
    );
    assert_eq!(of(&[0.0, 1.0], &[0.0, 1e300]), [Ok(()); 3]);
}

#[test]
fn a_table_that_is_shorter_than_a_run_is_refused() {
    let table = InputTable::new(vec![0.0, 1.0], vec![2.0, 3.0], Interpolation::Linear).unwrap();
    for (begin, end) in [(0.0, 1.0), (1.0, 0.0), (0.25, 0.75)] {
        assert_eq!(table.require_until(begin, end), Ok(()));
    }
    let error = table.require_until(0.0, 10.0).unwrap_err();
    assert_eq!(error, Outside { first: 0.0, last: 1.0, begin: 0.0, end: 10.0 });
    assert_eq!(
        error.to_string(),
        "the table of the input goes from 0 to 1, and the run from 0 to 10"
    );
    for (begin, end) in [(-0.1, 1.0), (1.1, 0.5), (f64::NAN, 1.0), (0.0, f64::NAN)] {
        assert!(table.require_until(begin, end).is_err());
    }
    assert!([-0.1, 1.1, f64::NAN].iter().all(|t| table.at(*t).is_nan()));
    assert_eq!([table.at(0.0), table.at(1.0)], [2.0, 3.0]);
}

#[test]
fn names_of_interpolations() {
    for kind in ALL {
        assert_eq!(kind.to_string().parse(), Ok(kind));
        assert!(Interpolation::NAMES.contains(&(kind.name(), kind)));
    }
    assert_eq!(Interpolation::NAMES.len(), ALL.len());
    assert!("Cubic".parse::<Interpolation>().is_err());
}
