//! Comparisons for the suites: bits of points, and steps that may have failed.

use super::NoSamples;
use crate::{Step, StepError};
use lie_poisson::{Real, Vector};

/// Returns the number of coordinates in which the bits of two points differ.
///
/// A NaN differs from every number and from NaN, so that two failures do not count as agreement.
pub(super) fn different_bits<V: Vector<Scalar = f64>>(a: &V, b: &V) -> f64 {
    let differ = |a: f64, b: f64| a.is_nan() || a.to_bits() != b.to_bits();
    (0..V::DIM).filter(|&i| differ(a.coordinate(i), b.coordinate(i))).count() as f64
}

/// Returns 1 for a law that does not hold, and 0 for one that does.
pub(super) fn broken_unless(holds: bool) -> f64 {
    if holds { 0.0 } else { 1.0 }
}

/// Returns the point with all its coordinates equal.
pub(super) fn constant<V: Vector>(x: f64) -> V {
    V::from_coordinates(|_| Real::from_f64(x))
}

/// Returns the point after a step, or the point with all coordinates NaN if the step failed.
pub(super) fn point_or_nan<V: Vector>(step: Result<Step<V>, StepError>) -> V {
    step.map_or_else(|_| constant(f64::NAN), |step| step.point)
}

/// Returns the points that differ from a given point in one coordinate, which is infinite or not a number.
pub(super) fn not_finite<V: Vector<Scalar = f64>>(point: &V) -> impl Iterator<Item = V> {
    let bad = move |i| NOT_FINITE.map(|x| move |j| if i == j { x } else { point.coordinate(j) });
    (0..V::DIM).flat_map(bad).map(V::from_coordinates)
}

/// The numbers that no state, momentum or step size may have.
pub(super) const NOT_FINITE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// Refuses an empty slice of samples.
pub(super) fn at_least_one<V>(what: &'static str, samples: &[V]) -> Result<(), NoSamples> {
    if samples.is_empty() { Err(NoSamples { what }) } else { Ok(()) }
}
