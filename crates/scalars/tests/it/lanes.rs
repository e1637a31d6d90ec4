//! SIMD lanes (several numbers in one register): each computes what `f64` does, for every type, instruction set and
//! width.

use generic_scalars::{
    DefaultLanes, DualNumber, InstructionSet, LaneTask, Lanes, Mask, Real, Width, dispatch, larger,
};
use proptest::prelude::*;

/// Numbers at which an operation could differ, besides ordinary ones.
const SPECIAL: [f64; 10] = [
    0.0,
    -0.0,
    1.0,
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MIN_POSITIVE / 8.0,
    -5e-324,
    f64::MAX,
    f64::MIN_POSITIVE,
];

/// The numbers of the widest type, which has sixteen lanes.
type Numbers = [f64; 16];

fn numbers() -> impl Strategy<Value = Numbers> {
    let special = (0..SPECIAL.len()).prop_map(|i| SPECIAL[i]);
    proptest::array::uniform16(prop_oneof![special, -1e3..1e3, any::<f64>()])
}

/// Returns whether the bits are equal; any NaN equals any other, since Rust leaves their payloads open.
fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

/// Runs `check` on every type of lanes that the machine can run, and returns how many.
fn everywhere<K: LaneTask<Output = ()> + Copy>(check: K) -> usize {
    let mut count = 0;
    for set in InstructionSet::available() {
        for width in Width::ALL {
            count += usize::from(dispatch(check, set, width).is_ok());
        }
    }
    count
}

/// A result, the operation that computes one lane of it by `f64`, and its name.
type Case<T> = (&'static str, T, fn(f64, f64, f64) -> f64);

/// Returns the operations that every type computes as `f64` does.
#[inline(always)]
fn operations<T: Lanes>(a: T, b: T, c: T) -> [Case<T>; 27] {
    let mut assigned = a;
    assigned += b;
    assigned *= c;
    assigned -= a;
    assigned /= b;
    let one = T::from_f64(1.0);
    [
        ("+", a + b, |a, b, _| a + b),
        ("-", a - b, |a, b, _| a - b),
        ("*", a * b, |a, b, _| a * b),
        ("/", a / b, |a, b, _| a / b),
        ("%", a % b, |a, b, _| a % b),
        ("+ f64", a + 0.1, |a, _, _| a + 0.1),
        ("- f64", a - 0.1, |a, _, _| a - 0.1),
        ("* f64", a * 0.1, |a, _, _| a * 0.1),
        ("/ f64", a / 0.1, |a, _, _| a / 0.1),
        ("assigned", assigned, |a, b, c| ((a + b) * c - a) / b),
        ("negative", -a, |a, _, _| -a),
        ("root", a.sqrt(), |a, _, _| a.sqrt()),
        ("logarithm", a.ln(), |a, _, _| a.ln()),
        ("angle", a.atan2(b), |a, b, _| a.atan2(b)),
        ("exponential", a.exp(), |a, _, _| a.exp()),
        ("sine", a.sin(), |a, _, _| Real::sin(a)),
        ("cosine", a.cos(), |a, _, _| Real::cos(a)),
        ("hyperbolic tangent", a.tanh(), |a, _, _| a.tanh()),
        ("power", a.powi(5), |a, _, _| Real::powi(a, 5)),
        ("reciprocal power", a.powi(-6), |a, _, _| Real::powi(a, -6)),
        ("Stumpff", (one / (one + a * a)).stumpff(2), |a, _, _| (1.0 / (1.0 + a * a)).stumpff(2)),
        ("magnitude", a.magnitude(), |a, _, _| a.abs()),
        ("larger", a.larger(b), |a, b, _| larger(a, b)),
        ("maximum", a.maximum(b), |a, b, _| if a > b { a } else { b }),
        ("select", T::select(a.at_most(b), c, a), |a, b, c| if a <= b { c } else { a }),
        ("nonnegative", a.select_nonnegative(b, c), |a, b, c| if a >= 0.0 { b } else { c }),
        ("constant", T::from_f64(0.1) + T::zero() + one, |_, _, _| 0.1 + 0.0 + 1.0),
    ]
}

#[derive(Clone, Copy)]
struct Operations(Numbers, Numbers, Numbers);

impl LaneTask for Operations {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        let Self(a, b, c) = self;
        for (name, result, expected) in operations(T::load(&a), T::load(&b), T::load(&c)) {
            for i in 0..T::COUNT {
                let (result, expected) = (result.lane(i), expected(a[i], b[i], c[i]));
                let given = (T::COUNT, i, a[i], b[i], c[i]);
                assert!(same(result, expected), "{name} {given:?}: {result:e}, not {expected:e}");
            }
        }
    }
}

/// The task that checks that a fused type rounds once, and another one twice.
#[derive(Clone, Copy)]
struct MultiplyAdd(Numbers, Numbers, Numbers);

impl LaneTask for MultiplyAdd {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        let Self(a, b, c) = self;
        let (x, y, z) = (T::load(&a), T::load(&b), T::load(&c));
        let results =
            [x.multiply_add(y, z), x.multiply_subtract(y, z), x.negative_multiply_add(y, z)];
        for i in 0..T::COUNT {
            let (x, y, z) = (a[i], b[i], c[i]);
            let once = [x.mul_add(y, z), x.mul_add(y, -z), (-x).mul_add(y, z)];
            let twice = [x * y + z, x * y - z, z - x * y];
            let expected = if T::FUSED { once } else { twice };
            for (result, expected) in results.iter().zip(expected) {
                assert!(same(result.lane(i), expected), "{x:e} {y:e} {z:e}, {}", T::FUSED);
            }
        }
    }
}

#[derive(Clone, Copy)]
struct Masks(Numbers, Numbers);

impl LaneTask for Masks {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        let Self(a, b) = self;
        let (x, y) = (T::load(&a), T::load(&b));
        let (first, second) = (x.at_most(y), y.at_most(x));
        let (mut all, mut any) = (true, false);
        for i in 0..T::COUNT {
            let (p, q) = (a[i] <= b[i], b[i] <= a[i]);
            assert_eq!((first.lane(i), second.lane(i)), (p, q));
            assert_eq!(first.and(second).lane(i), p && q);
            assert_eq!(first.or(second).lane(i), p || q);
            assert_eq!(first.not().lane(i), !p);
            (all, any) = (all && p, any || p);
        }
        assert_eq!((first.all(), first.any()), (all, any));
        assert_eq!(x == y, (0..T::COUNT).all(|i| a[i] == b[i]));
        assert_eq!(<T::Mask as Mask>::COUNT, T::COUNT);
        assert!(T::Mask::from_bool(true).all() && !T::Mask::from_bool(false).any());
        assert!(!T::Mask::from_bool(true).lane(T::COUNT));
    }
}

/// The task that puts a different number into one lane, in each position.
#[derive(Clone, Copy)]
struct EachPosition;

impl LaneTask for EachPosition {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        for position in 0..T::COUNT {
            let with = |odd: f64| T::from_lanes(|i| if i == position { odd } else { 1.0 });
            assert!(with(1.5).all_below(1.5) && !with(1.5).all_below(1.25));
            assert_eq!(with(-7.0).max_abs(), 7.0);
            assert!(!with(f64::NAN).all_below(2.0) && with(f64::NAN).max_abs().is_nan());
            let large = with(3.0).at_most(T::from_f64(2.0)).not();
            assert!(large.any() && large.lane(position) && (large.all() == (T::COUNT == 1)));
            assert!(with(2.0) != with(1.0) && with(f64::NAN) != with(f64::NAN));
            assert!(!with(0.5).is_zero());
        }
        assert!(T::zero().is_zero() && (-T::zero()).is_zero());
        assert!(T::one().lane(T::COUNT).is_nan());
    }
}

/// The task that loads slices shorter than the lanes, as long, and longer.
#[derive(Clone, Copy)]
struct Slices;

impl LaneTask for Slices {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        let values: Vec<f64> = (0..20).map(f64::from).collect();
        for length in 1..values.len() {
            let lanes = T::load(&values[..length]);
            let mut back = [-1.0; 20];
            lanes.store(&mut back[..length]);
            for i in 0..T::COUNT {
                assert_eq!(lanes.lane(i), i.min(length - 1) as f64);
            }
            for (i, back) in back.iter().enumerate() {
                assert_eq!(*back, if i < length.min(T::COUNT) { i as f64 } else { -1.0 });
            }
        }
        assert!(T::load(&[]).lane(0).is_nan());
        T::one().store(&mut []);
    }
}

proptest! {
    #[test]
    fn every_operation_has_the_bits_of_f64(a in numbers(), b in numbers(), c in numbers()) {
        prop_assert!(everywhere(Operations(a, b, c)) >= 3);
    }

    #[test]
    fn a_fused_type_rounds_once_and_the_others_twice(a in numbers(), b in numbers(), c in numbers()) {
        prop_assert!(everywhere(MultiplyAdd(a, b, c)) >= 3);
    }

    #[test]
    fn masks_are_truth_lane_by_lane(a in numbers(), b in numbers()) {
        prop_assert!(everywhere(Masks(a, b)) >= 3);
        prop_assert!(everywhere(Masks(a, a)) >= 3);
    }
}

#[test]
fn every_pair_of_special_numbers() {
    for a in SPECIAL {
        for b in SPECIAL {
            let neighbours = |i: usize| SPECIAL[i % SPECIAL.len()];
            let c = core::array::from_fn(neighbours);
            assert!(everywhere(Operations([a; 16], [b; 16], c)) >= 3);
            assert!(everywhere(MultiplyAdd([a; 16], [b; 16], c)) >= 3);
            assert!(everywhere(Masks([a; 16], [b; 16])) >= 3);
        }
    }
}

#[test]
fn each_position_counts_and_slices_may_be_short() {
    assert!(everywhere(EachPosition) >= 3);
    assert!(everywhere(Slices) >= 3);
}

/// Negative control: the comparison distinguishes rounding once from rounding twice.
#[test]
fn rounding_once_and_twice_differ() {
    let (x, y) = (1.0 + f64::EPSILON, 1.0 - f64::EPSILON);
    assert!(!same(x.mul_add(y, -1.0), x * y - 1.0));
    assert!(!same(0.0, -0.0) && !same(f64::NAN, 1.0) && same(f64::NAN, -f64::NAN));
}

/// The task that returns how many lanes there are, and whether they are fused.
#[derive(Clone, Copy)]
struct Shape;

impl LaneTask for Shape {
    type Output = (usize, bool);

    #[inline(always)]
    fn run<T: Lanes>(self) -> (usize, bool) {
        (T::COUNT, T::FUSED)
    }
}

#[test]
fn sets_have_their_widths_and_missing_ones_are_refused() {
    let shape = |set, width| dispatch(Shape, set, width);
    for set in InstructionSet::ALL {
        let (register, fused) = match set {
            InstructionSet::Portable => (2, false),
            InstructionSet::Avx2 => (4, true),
            _ => (8, true),
        };
        println!("{set}: {}", if set.is_available() { "tested" } else { "not on this machine" });
        let chosen = set.if_available();
        assert_eq!(
            chosen.map_err(|missing| missing.set),
            set.is_available().then_some(set).ok_or(set)
        );
        let lanes =
            [(Width::Single, 1), (Width::Register, register), (Width::TwoRegisters, 2 * register)];
        for (width, lanes) in lanes {
            match shape(set, width) {
                Ok(found) => assert!(set.is_available() && found == (lanes, fused)),
                Err(error) => assert!(!set.is_available() && error.set == set, "{error}"),
            }
        }
    }
    assert!(InstructionSet::Portable.is_available());
    assert!(InstructionSet::detected().is_available());
    assert_eq!(DefaultLanes::COUNT, 4);
}

/// Dual numbers over lanes are compared by their values.
#[test]
fn dual_numbers_over_lanes() {
    let x = DualNumber::new(
        DefaultLanes::load(&[1.0, -2.0, 3.0, f64::NAN]),
        DefaultLanes::load(&[5.0, 0.5, -4.0, 1.0]),
    );
    let chosen = x.select_nonnegative(x * 2.0, -x);
    assert_eq!([0, 1, 2].map(|i| chosen.value_without_derivative().lane(i)), [2.0, 2.0, 6.0]);
    assert_eq!([0, 1, 2].map(|i| chosen.derivative().lane(i)), [10.0, -0.5, -8.0]);
    let size = x.magnitude();
    assert_eq!([0, 1, 2].map(|i| size.value_without_derivative().lane(i)), [5.0, 2.0, 4.0]);
    assert!(
        size.value_without_derivative().lane(3).is_nan()
            && size.derivative() == DefaultLanes::from_f64(0.0)
    );
}
