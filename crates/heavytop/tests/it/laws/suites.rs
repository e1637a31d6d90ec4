//! The samples and tolerances of the law suites, and the checks of a suite together with its negative control.

use collective_integrators::{Start, laws};
use heavytop::{HeavyTop, Invariant};
use lie_poisson::Se3Dual;
use lie_poisson::laws::{Faulty, NoSamples, Report};

/// The round-off of the few dozen operations in a law, relative to the sizes that enter it.
pub const ROUND_OFF: f64 = 1e-13;

/// The round-off of the 100 steps of the suite of invariants, some ten units for each.
pub const ROUND_OFF_OF_RUNS: f64 = 1e-12;

/// The size of the steps.
pub const STEP: f64 = 0.05;

/// Momenta whose coordinates all differ, with Γ near an axis and away from all, and not of unit length.
pub fn momenta() -> [Se3Dual; 2] {
    let mu = |pi: [f64; 3], gamma: [f64; 3]| Se3Dual::new(pi.into(), gamma.into());
    [mu([0.7, -0.4, 1.3], [0.6, 0.1, 0.8]), mu([-0.2, 1.1, 0.5], [0.3, -0.9, -0.7])]
}

/// Checks that a suite accepts an object, where no fault can be seen, or where the same suite has its control beside it.
pub fn holds<'a, S>(
    object: &'a S,
    tolerance: f64,
    suite: impl Fn(&Faulty<'a, S>) -> Result<Report, NoSamples>,
) {
    suite(&Faulty::without_fault(object)).unwrap().check(tolerance).unwrap();
}

/// The residual that a fault must exceed: it changes a result by its own size, and not by a rounding error.
const CLEAR: f64 = 1e-3;

/// Checks that a suite accepts an object, and that it refuses the object with a fault in the given method and coordinate.
pub fn obeys<'a, S>(
    object: &'a S,
    (method, coordinate): (&'static str, usize),
    tolerance: f64,
    suite: impl Fn(&Faulty<'a, S>) -> Result<Report, NoSamples>,
) {
    let refused = suite(&Faulty::new(object, method, coordinate)).unwrap().check(CLEAR);
    assert!(refused.is_err(), "a fault of {method} in coordinate {coordinate} was not found");
    holds(object, tolerance, suite);
}

/// Runs the suites of an integrator of a top, whose energy deviates by no more than the given part.
pub fn obeys_as_integrator<I>(top: &HeavyTop, integrator: I, energy: f64)
where
    I: Start<Momentum = Se3Dual> + Clone,
{
    obeys(&integrator, ("step", 0), ROUND_OFF, |i| laws::start(i, &momenta(), STEP));
    let states = momenta().map(|mu| integrator.start(&mu).unwrap());
    let square = |mu: &Se3Dual| mu.0.1.norm_squared();
    let level = |mu: &Se3Dual| mu.0.0.dot(&mu.0.1);
    obeys(&integrator, ("step", 0), ROUND_OFF_OF_RUNS, |i| {
        laws::invariants(i, &states, STEP, &[&square, &level])
    });
    let h = |mu: &Se3Dual| Invariant::Energy.value(top, mu);
    holds(&integrator, energy, |i| laws::invariants(i, &states, STEP, &[&h]));
}

/// The bound (ωh)ᵖ on the deviation of the energy under a method of order p, for angular velocities ω up to 3 rad per unit
/// of time.
pub fn energy_of_order(p: i32) -> f64 {
    (3.0 * STEP).powi(p)
}
