//! Formulas over SIMD lanes have the bits of formulas over `f64`.

use crate::support::{FORMULAS, POINTS, formula, point};
use lie_poisson::{
    DefaultLanes, InstructionSet, LaneTask, Lanes, Se3Dual, State, StorageOver, TaskOver,
    UnfusedWorkspace, Vector, Width, dispatch, dispatch_unfused,
};
use lie_poisson_formulas::Formula;

/// Returns the point of lane `i` in all coordinates, and the points of all lanes.
fn lanes_of<T: Lanes>(points: &[Se3Dual]) -> Se3Dual<T> {
    Vector::from_coordinates(|i| T::from_lanes(|lane| points[lane % points.len()].coordinate(i)))
}

fn compare<T: Lanes>(h: &Formula, text: &str) {
    let points: Vec<Se3Dual> = POINTS.iter().map(|x| point(*x)).collect();
    let z = lanes_of::<T>(&points);
    let (value, gradient, second) = (h.value(&z), h.differential(&z), h.second_derivative(&z, &z));
    for lane in 0..T::COUNT {
        let z = points[lane % points.len()];
        assert_eq!(value.lane(lane).to_bits(), h.value(&z).to_bits(), "{text}");
        for i in 0..6 {
            let (alone, beside) = (h.differential(&z).coordinate(i), gradient.coordinate(i));
            assert_eq!(alone.to_bits(), beside.lane(lane).to_bits(), "{text} {i}");
            let alone = h.second_derivative(&z, &z).coordinate(i);
            assert_eq!(alone.to_bits(), second.coordinate(i).lane(lane).to_bits(), "{text} {i}");
        }
    }
}

/// Compares on the lanes of an instruction set.
struct OnWideLanes;

impl LaneTask for OnWideLanes {
    type Output = ();
    fn run<T: Lanes>(self) {
        FORMULAS.iter().for_each(|text| compare::<T>(&formula(text), text));
    }
}

/// Compares on the lanes of a register that have the operations of `f64`.
struct OnUnfusedLanes;

/// No storage.
struct Stateless;

impl<T: Lanes> StorageOver<T> for Stateless {
    type Storage = ();
    fn storage(&self) {}
}

impl<T: Lanes> TaskOver<T, Stateless> for OnUnfusedLanes {
    fn run(self, (): &mut ()) {
        FORMULAS.iter().for_each(|text| compare::<T>(&formula(text), text));
        for count in COUNTS {
            let text = with_terms_in_use(count);
            compare::<T>(&formula(&text), &text);
        }
    }
}

/// Numbers of terms for which the values and the derivatives take from few registers to more than 1024.
const COUNTS: [usize; 5] = [3, 12, 40, 100, 300];

/// Returns a formula in which so many terms are needed again after the last of them has been computed.
fn with_terms_in_use(count: usize) -> String {
    let term = |k: usize| format!("sin({k}*Pi1 + Gamma{})", k % 3 + 1);
    let sum = (1..=count).map(term).collect::<Vec<_>>().join(" + ");
    let product = (1..=count).map(|k| format!("(1 + {}/{count})", term(k)));
    format!("{sum} + {}", product.collect::<Vec<_>>().join("*"))
}

#[test]
fn formulas_of_any_length_have_their_value() {
    for count in COUNTS {
        let text = with_terms_in_use(count);
        let h = formula(&text);
        compare::<f64>(&h, &text);
        compare::<DefaultLanes>(&h, &text);
        let z = point(POINTS[1]);
        let terms: Vec<f64> =
            (1..=count).map(|k| (k as f64 * 0.7 + [1.9, 0.8, 1.1][k % 3]).sin()).collect();
        let product: f64 = terms.iter().map(|term| 1.0 + term / count as f64).product();
        let expected = terms.iter().sum::<f64>() + product;
        // Up to 100 angles of up to 72 rad, each rounded by up to 2⁻⁴⁷, and as many sums up to 100, each by up to 2⁻⁴⁷: 1.4e-12
        // if all errors had one sign; with n terms, n² as much.
        let allowed = 1.5e-12 * (count as f64 / 100.0).powi(2).max(1.0);
        assert!((h.value(&z) - expected).abs() < allowed, "{count}: {} {expected}", h.value(&z));
    }
}

#[test]
fn lanes_have_the_bits_of_single_numbers() {
    for text in FORMULAS {
        compare::<f64>(&formula(text), text);
        compare::<DefaultLanes>(&formula(text), text);
    }
    for set in InstructionSet::available() {
        dispatch(OnWideLanes, set, Width::Register).unwrap();
        dispatch_unfused(OnUnfusedLanes, &mut UnfusedWorkspace::new(&Stateless, set).unwrap());
    }
}

/// Negative control: the lanes hold different numbers.
#[test]
fn lanes_differ() {
    let points: Vec<Se3Dual> = POINTS.iter().map(|x| point(*x)).collect();
    let value = formula(FORMULAS[0]).value(&lanes_of::<DefaultLanes>(&points));
    assert_ne!(value.lane(0).to_bits(), value.lane(1).to_bits());
}

#[test]
fn formulas_can_be_shared_between_threads() {
    fn shared<T: Send + Sync + Clone + core::fmt::Debug + PartialEq>() {}
    shared::<Formula>();
    shared::<lie_poisson_formulas::FormulaHamiltonian<lie_poisson::So3>>();
}
