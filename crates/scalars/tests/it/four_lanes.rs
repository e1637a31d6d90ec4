//! Four SIMD lanes (four numbers in one register): each computes what `f64` does, and they change places as
//! documented.

use generic_scalars::{FourLanes, FourLanesTask, InstructionSet, dispatch_four};
use proptest::prelude::*;

/// The results of six computations on four lanes, lane by lane.
type Results = [[f64; 4]; 6];

#[derive(Clone, Copy)]
struct All([f64; 4], [f64; 4]);

impl FourLanesTask for All {
    type Output = (Results, bool);

    #[inline(always)]
    fn run<T: FourLanes>(self) -> Self::Output {
        let (a, b) = (T::load(&self.0), T::load(&self.1));
        let results = [
            a.next(),
            a.previous(),
            a.first(),
            a.sum(),
            a.multiply_add(b, a),
            a.next().multiply_subtract(b.previous(), a.previous() * b.next()),
        ];
        let mut lanes = [[0.0; 4]; 6];
        for (lanes, result) in lanes.iter_mut().zip(results) {
            result.store(lanes);
        }
        (lanes, T::FUSED)
    }
}

/// Computes the same results with numbers; the indices of the first three are modulo 3.
fn expected(a: [f64; 4], b: [f64; 4], fused: bool) -> Results {
    let place = |i: usize, by: usize| if i < 3 { (i + by) % 3 } else { 3 };
    let each = |f: &dyn Fn(usize) -> f64| core::array::from_fn(f);
    let add = |x: f64, y: f64, z: f64| if fused { x.mul_add(y, z) } else { x * y + z };
    [
        each(&|i| a[place(i, 1)]),
        each(&|i| a[place(i, 2)]),
        each(&|_| a[0]),
        each(&|_| (a[0] + a[1]) + (a[2] + a[3])),
        each(&|i| add(a[i], b[i], a[i])),
        each(&|i| {
            let (j, k) = (place(i, 1), place(i, 2));
            add(a[j], b[k], -(a[k] * b[j]))
        }),
    ]
}

/// Returns whether the bits are equal; any NaN equals any other.
fn same(a: &Results, b: &Results) -> bool {
    let alike = |(a, b): (&f64, &f64)| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
    a.as_flattened().iter().zip(b.as_flattened()).all(alike)
}

/// Returns the results on all instruction sets that the machine has.
fn everywhere(a: [f64; 4], b: [f64; 4]) -> impl Iterator<Item = (Results, bool)> {
    InstructionSet::ALL.into_iter().filter_map(move |set| match dispatch_four(All(a, b), set) {
        Ok(results) => {
            assert!(set.is_available() && results.1 == (set != InstructionSet::Portable));
            Some(results)
        }
        Err(error) => {
            assert!(!set.is_available() && error.set == set);
            None
        }
    })
}

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), Just(-0.0), Just(f64::NAN), Just(f64::INFINITY), -1e3..1e3]
}

proptest! {
    #[test]
    fn lanes_compute_as_numbers_and_change_places(
        a in proptest::array::uniform4(number()),
        b in proptest::array::uniform4(number()),
    ) {
        for (results, fused) in everywhere(a, b) {
            prop_assert!(same(&results, &expected(a, b, fused)), "{a:?} {b:?}: {results:?}");
        }
    }
}

/// Negative control: the comparison detects a lane in the wrong place, and a sum rounded twice.
#[test]
fn other_places_and_other_roundings_differ() {
    let (a, b) = ([0.1, 0.2, 0.3, 0.4], [0.7, 0.6, 0.5, 0.8]);
    let mut count = 0;
    for (results, fused) in everywhere(a, b) {
        let mut moved = results;
        moved.swap(0, 1);
        assert!(!same(&moved, &results) && !same(&results, &expected(b, a, fused)));
        assert!(!same(&results, &expected(a, b, !fused)));
        count += 1;
    }
    assert!(count >= 1);
}
