//! The generic system of the law suites, and the check that a scheme keeps its promises.
#![allow(dead_code)]

#[cfg(not(feature = "laws"))]
compile_error!("these tests need the law suites: cargo test --features laws");

pub use collective_integrators::laws::{self, GenericSystem, MeasuredScheme};
use collective_integrators::*;
use lie_poisson::*;
use momentum_map::{Cotangent, CotangentBundle};
use nalgebra::Vector2;

/// The phase space T*R² of the generic system.
pub type Phase = CotangentBundle<RealSpace<2>>;
pub type Z<T = f64> = Cotangent<Vector2<T>>;

pub fn phase() -> Phase {
    GenericSystem::space()
}

pub fn field() -> HamiltonianField<Phase, Automatic<GenericSystem>> {
    GenericSystem::field()
}

pub fn start() -> Z {
    GenericSystem::start()
}

/// Returns the state Φ_hⁿ(z) after n steps of size h = time/n.
pub fn advance<S: Scheme, F: VectorField>(
    scheme: &S,
    field: &F,
    z: F::Point,
    time: f64,
    n: usize,
) -> F::Point {
    let mut workspace = scheme.workspace();
    (0..n).fold(z, |z, _| scheme.step(field, &z, time / n as f64, &mut workspace).unwrap().point)
}

/// The round-off of a step with a few dozen evaluations, with some cancellation.
pub const ROUND_OFF: f64 = 1e-13;

/// Checks the laws of a scheme, and that it has no property that it does not claim.
pub fn keeps_its_promises<S: Scheme>(scheme: &S, name: &str) {
    if let Err(broken) = laws::scheme(scheme).check(ROUND_OFF) {
        panic!("{name}: {broken}");
    }
    let measured = MeasuredScheme::of(scheme);
    // Errors of DOP853 at the steps that can be measured fall as h^8.5.
    assert!(measured.order < scheme.order() as f64 + 0.6, "{name}: {measured:?}");
    let checks = [
        (scheme.is_symplectic(), measured.symplecticity),
        (scheme.is_symmetric(), measured.symmetry),
        (scheme.preserves_quadratic_invariants(), measured.quadratic_invariants),
    ];
    for (claimed, defect) in checks {
        assert_eq!(claimed, defect < ROUND_OFF, "{name}: {measured:?}");
    }
}

/// Returns the laws that do not hold in a report.
pub fn broken(report: &laws::Report) -> Vec<&'static str> {
    let residuals = report.residuals().iter();
    residuals
        .filter(|(_, residual)| residual.is_nan() || *residual > ROUND_OFF)
        .map(|(law, _)| *law)
        .collect()
}
