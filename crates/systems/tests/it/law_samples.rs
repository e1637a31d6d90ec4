//! The samples of the law suites, and their tolerances.

use lie_poisson_systems::lie_poisson::{Covector, Sites, Vector};
use lie_poisson_systems::nalgebra::Vector3;

/// A point of (so(3)∗)ᴺ for a number N that is known when the program runs.
pub type Spins = Covector<Sites<Vector3<f64>>>;

/// The round-off of the few dozen operations in a law, relative to the sizes that enter it.
pub const ROUND_OFF: f64 = 1e-13;

/// The round-off of the 100 steps of the suite of invariants, some ten units for each.
pub const ROUND_OFF_OF_RUNS: f64 = 1e-12;

/// The size of the steps.
pub const STEP: f64 = 0.05;

/// The bound C hᵖ on the relative deviation of an energy under a symplectic method of order 4, with C of size 1.
pub const ENERGY_OF_ORDER_FOUR: f64 = STEP * STEP * STEP * STEP;

/// The size of the steps of lattices, whose spins turn with up to 5 rad per unit of time, and of vortices, which pass close
/// to each other.
pub const SHORT_STEP: f64 = 0.01;

/// The bound (ωh)² on the deviation under a method of order 2, for short steps and angular velocities ω up to 5.
pub const ENERGY_OF_ORDER_TWO: f64 = 25.0 * SHORT_STEP * SHORT_STEP;

/// Returns three generic vectors, with coordinates in (−1, 1).
pub fn samples<V: Vector<Scalar = f64>>() -> Vec<V> {
    let mut seed = 12.0_f64;
    let mut next = move || {
        seed = (seed * 16_807.0) % 2_147_483_647.0;
        2.0 * seed / 2_147_483_647.0 - 1.0
    };
    (0..3).map(|_| V::from_coordinates(|_| next())).collect()
}

/// Returns the positions of N points on a spiral of the unit sphere, which are well apart from each other.
pub fn spiral(count: usize) -> impl Iterator<Item = Vector3<f64>> {
    (0..count).map(move |i| {
        let z = 1.0 - (2.0 * i as f64 + 0.8) / count as f64;
        // The golden angle: no two points have nearly one longitude and one latitude.
        let (sin, cos) = (2.399_963 * i as f64 + 0.7).sin_cos();
        let radius = (1.0 - z * z).sqrt();
        Vector3::new(radius * cos, radius * sin, z)
    })
}
