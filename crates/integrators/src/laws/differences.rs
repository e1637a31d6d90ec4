//! Comparisons for the suites: bits of points, and steps that may have failed.

use super::NoSamples;
use crate::error::StepError;
use crate::schemes::scheme::Step;
use lie_poisson::{Real, State, larger};

/// Returns the number of coordinates in which the bits of two points differ.
///
/// A NaN differs from every number and from NaN, so that two failures do not count as agreement.
pub(super) fn different_bits<V: State<Scalar = f64>>(a: &V, b: &V) -> f64 {
    let differ = |a: f64, b: f64| a.is_nan() || a.to_bits() != b.to_bits();
    (0..a.dimension()).filter(|&i| differ(a.coordinate(i), b.coordinate(i))).count() as f64
}

/// Returns 1 for a law that does not hold, and 0 for one that does.
pub(super) fn broken_unless(holds: bool) -> f64 {
    if holds { 0.0 } else { 1.0 }
}

/// Returns the point of the space of `like` with all its coordinates equal.
pub(super) fn constant<V: State>(like: &V, x: f64) -> V {
    let mut point = like.zeros_like();
    point.set_coordinates(|_| Real::from_f64(x));
    point
}

/// Returns the point after a step, or the point of the space of `like` with all coordinates NaN if the step failed.
pub(super) fn point_or_nan<V: State>(step: Result<Step<V>, StepError>, like: &V) -> V {
    step.map_or_else(|_| constant(like, f64::NAN), |step| step.point)
}

/// Returns the largest magnitude of a coordinate, or NaN.
pub(super) fn largest<V: State<Scalar = f64>>(point: &V) -> f64 {
    (0..point.dimension()).map(|i| point.coordinate(i).abs()).fold(0.0, larger)
}

/// Returns the largest magnitude of a coordinate of a − b, or NaN.
pub(super) fn largest_difference<V: State<Scalar = f64>>(a: &V, b: &V) -> f64 {
    let mut difference = a.clone();
    difference.subtract_in_place(b);
    largest(&difference)
}

/// Returns the points that differ from a given point in one coordinate, which is infinite or not a number.
pub(super) fn not_finite<V: State<Scalar = f64>>(point: &V) -> impl Iterator<Item = V> {
    let bad = move |i| {
        NOT_FINITE.map(|x| {
            let mut bad = point.clone();
            bad.set_coordinate(i, x);
            bad
        })
    };
    (0..point.dimension()).flat_map(bad)
}

/// The numbers that no state, momentum or step size may have.
pub(super) const NOT_FINITE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// Refuses an empty slice of samples.
pub(super) fn at_least_one<V>(what: &'static str, samples: &[V]) -> Result<(), NoSamples> {
    if samples.is_empty() { Err(NoSamples { what }) } else { Ok(()) }
}
