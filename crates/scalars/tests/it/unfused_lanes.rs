//! Lanes whose results are those of `f64`, on every instruction set.

use generic_scalars::{
    InstructionSet, LaneTask, Lanes, Mask, Real, StorageOver, TaskOver, UnfusedWorkspace, Width,
    cross, dispatch, dispatch_unfused, dot,
};
use nalgebra::Vector3;
use proptest::prelude::*;

/// The number of runs, and the types of lanes that a run has seen.
struct Counter;

impl<T: Lanes> StorageOver<T> for Counter {
    type Storage = (u32, usize, bool);

    fn storage(&self) -> (u32, usize, bool) {
        assert!(!T::FUSED);
        (0, T::COUNT, T::HAS_SLOW_PATHS)
    }
}

/// Evaluates every operation at each pair of numbers.
struct Evaluate<'a>(&'a [(f64, f64)], &'a mut Vec<Vec<u64>>);

#[inline(always)]
fn operations<T: Lanes>(a: T, b: T) -> [T; 17] {
    let (u, v) = (Vector3::new(a, b, a - b), Vector3::new(b, a * b, a));
    let turned = cross(&u, &v);
    let below = a.at_most(b);
    [
        a + b,
        a - b,
        a * b,
        a / b,
        a % b,
        -a,
        Real::sqrt(a),
        a.magnitude(),
        a.maximum(b),
        a.larger(b),
        a.multiply_add(b, a),
        a.multiply_subtract(b, a),
        a.negative_multiply_add(b, a),
        T::select(below, a, b),
        T::select(below.not().or(below.and(b.at_most(a))), b, a),
        dot(&u, &turned),
        turned.x + turned.y * turned.z,
    ]
}

/// Returns the bits of every operation for each pair, with one pair in each lane.
#[inline(always)]
fn evaluated<T: Lanes>(pairs: &[(f64, f64)]) -> Vec<Vec<u64>> {
    let mut all = Vec::new();
    for group in pairs.chunks(T::COUNT) {
        let place = |i: usize| i.min(group.len() - 1);
        let results =
            operations(T::from_lanes(|i| group[place(i)].0), T::from_lanes(|i| group[place(i)].1));
        for lane in 0..group.len() {
            // Rust leaves the payload of a NaN open.
            let bits = |x: &T| if x.lane(lane).is_nan() { 0 } else { x.lane(lane).to_bits() };
            all.push(results.iter().map(bits).collect());
        }
    }
    all
}

impl<T: Lanes> TaskOver<T, Counter> for Evaluate<'_> {
    #[inline(always)]
    fn run(self, (runs, ..): &mut (u32, usize, bool)) {
        *runs += 1;
        *self.1 = evaluated::<T>(self.0);
    }
}

/// The same with the types of [`dispatch`].
impl LaneTask for Evaluate<'_> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        *self.1 = evaluated::<T>(self.0);
    }
}

fn in_registers(set: InstructionSet, pairs: &[(f64, f64)]) -> Vec<Vec<u64>> {
    let mut space = UnfusedWorkspace::new(&Counter, set).unwrap();
    assert_eq!(space.instructions(), set);
    let mut results = Vec::new();
    dispatch_unfused(Evaluate(pairs, &mut results), &mut space);
    results
}

proptest! {
    #[test]
    fn every_lane_has_the_bits_of_plain_numbers(
        pairs in prop::collection::vec((any::<f64>(), any::<f64>()), 1..20),
    ) {
        let expected = evaluated::<f64>(&pairs);
        for set in InstructionSet::available() {
            prop_assert_eq!(&in_registers(set, &pairs), &expected, "{}", set);
        }
    }
}

/// Negative control of the test above: lanes with fused multiply-add have other bits.
#[test]
fn fused_lanes_differ() {
    let pairs: Vec<_> = (1..40).map(|i| (0.1 * f64::from(i), 1.0 / f64::from(i))).collect();
    let expected = evaluated::<f64>(&pairs);
    for set in InstructionSet::available() {
        assert_eq!(in_registers(set, &pairs), expected, "{set}");
        let mut results = Vec::new();
        dispatch(Evaluate(&pairs, &mut results), set, Width::Register).unwrap();
        assert_eq!(results == expected, set == InstructionSet::Portable, "{set}");
    }
}

/// Keeps what the storage says.
struct Look<'a>(&'a mut (u32, usize, bool));

impl<T: Lanes> TaskOver<T, Counter> for Look<'_> {
    fn run(self, storage: &mut (u32, usize, bool)) {
        storage.0 += 1;
        *self.0 = *storage;
    }
}

#[test]
fn the_storage_stays_and_belongs_to_one_type_of_lanes() {
    for set in InstructionSet::ALL {
        let Ok(mut space) = UnfusedWorkspace::new(&Counter, set) else {
            assert!(!set.is_available(), "{set}");
            continue;
        };
        let mut seen = (0, 0, false);
        for runs in 1..4 {
            dispatch_unfused(Look(&mut seen), &mut space);
            assert_eq!(seen.0, runs);
        }
        // Four lanes in two registers of 128 bits, four of 256 bits, eight of 512 bits.
        let count = if set == InstructionSet::Avx512 { 8 } else { 4 };
        assert_eq!((seen.1, seen.2), (count, set == InstructionSet::Portable), "{set}");
    }
}
