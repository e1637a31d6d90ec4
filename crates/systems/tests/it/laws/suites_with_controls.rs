//! The checks of a suite together with its negative control.

use lie_poisson_systems::lie_poisson::laws::{Faulty, NoSamples, Report};

/// Checks that a suite accepts a system, where no fault can be seen, or where the same suite has its control beside it.
pub fn holds<'a, S>(
    system: &'a S,
    tolerance: f64,
    suite: impl Fn(&Faulty<'a, S>) -> Result<Report, NoSamples>,
) {
    suite(&Faulty::without_fault(system)).unwrap().check(tolerance).unwrap();
}

/// The residual that a fault must exceed: it changes a result by its own size, and not by a rounding error.
const CLEAR: f64 = 1e-3;

/// Checks that a suite accepts a system, and that it refuses the system with a fault in the given method and coordinate.
pub fn obeys<'a, S>(
    system: &'a S,
    (method, coordinate): (&'static str, usize),
    tolerance: f64,
    suite: impl Fn(&Faulty<'a, S>) -> Result<Report, NoSamples>,
) {
    let refused = suite(&Faulty::new(system, method, coordinate)).unwrap().check(CLEAR);
    assert!(refused.is_err(), "a fault of {method} in coordinate {coordinate} was not found");
    holds(system, tolerance, suite);
}
