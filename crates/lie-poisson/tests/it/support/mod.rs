//! The samples of the law suites, and their tolerance.

#[cfg(not(feature = "laws"))]
compile_error!("these tests need the law suite: cargo test --features laws");

use lie_poisson::Vector;
pub use lie_poisson::laws;
use lie_poisson::laws::Report;

/// The round-off of the few dozen operations in a law, relative to the sizes that enter it.
pub const TOLERANCE: f64 = 1e-13;

/// Returns four generic vectors, with coordinates in (−1, 1).
pub fn samples<V: Vector<Scalar = f64>>() -> Vec<V> {
    let mut seed = 12.0_f64;
    let mut next = move || {
        seed = (seed * 16_807.0) % 2_147_483_647.0;
        2.0 * seed / 2_147_483_647.0 - 1.0
    };
    (0..4).map(|_| V::from_coordinates(|_| next())).collect()
}

pub fn holds(report: Report) {
    report.check(TOLERANCE).unwrap();
}

/// Returns the laws that do not hold.
pub fn broken(report: &Report) -> Vec<&'static str> {
    let residuals = report.residuals().iter();
    residuals.filter(|(_, x)| x.is_nan() || *x > TOLERANCE).map(|(law, _)| *law).collect()
}
