//! One generic Hamiltonian system, and what a scheme does to it.
#![allow(dead_code, clippy::unwrap_used)]

use collective_integrators::*;
use lie_poisson::*;
use momentum_map::{Cotangent, CotangentBundle, SymplecticSpace};
use nalgebra::{Vector2, Vector3};

/// T*R²
pub type Phase = CotangentBundle<RealSpace<2>>;
pub type Z<T = f64> = Cotangent<Vector2<T>>;

/// H = ½(q₁² + 1)(p₁² + 1) + ½p₂² + ½q₂² + ⅒q₂⁴ + ³⁄₁₀ q₁q₂p₂: not separable, without symmetries.
#[derive(Clone, Copy)]
pub struct Generic;

impl Energy for Generic {
    type Space = Phase;

    fn energy<T: Real>(&self, z: &Z<T>) -> T {
        let (q, Covector(p)) = (&z.q, &z.p);
        let square = |x: T| x * x;
        (square(q.x) + 1.0) * (square(p.x) + 1.0) * 0.5
            + square(p.y) * 0.5
            + square(q.y) * 0.5
            + square(square(q.y)) * 0.1
            + q.x * q.y * p.y * 0.3
    }
}

pub fn phase() -> Phase {
    CotangentBundle(RealSpace)
}

pub fn field() -> HamiltonianField<Phase, Automatic<Generic>> {
    HamiltonianField { space: phase(), hamiltonian: Automatic(Generic) }
}

pub fn start() -> Z {
    Cotangent::new(Vector2::new(0.3, -0.4), Covector(Vector2::new(0.5, 0.6)))
}

/// Φ_hⁿ(z), h = time/n.
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

/// The order fitted to the errors at t = 1 with the given numbers of steps.
pub fn measured_order<S: Scheme>(scheme: &S, counts: &[usize]) -> f64 {
    let gauss = RungeKutta::gauss(8).unwrap();
    let exact = advance(&gauss, &field(), start(), 1.0, 40);
    let errors: Vec<(f64, f64)> = counts
        .iter()
        .map(|&n| {
            let end = advance(scheme, &field(), start(), 1.0, n);
            (1.0 / n as f64, (end - exact).max_abs())
        })
        .collect();
    // the references and the steps round at 1e-15 each
    fitted_order(&errors, 1e-13).unwrap()
}

/// max |Ω(DΦ u, DΦ v) − Ω(u, v)| over the coordinate vectors, with the exact tangent map.
pub fn symplectic_defect<S: Scheme>(scheme: &S, step: f64) -> f64 {
    let column = |i: usize| -> Z {
        let seeded: Z<DualNumber> = seed(&start(), &Z::basis(i));
        let mut workspace = scheme.workspace();
        let after = scheme.step(&field(), &seeded, step, &mut workspace).unwrap().point;
        derivative_part(&after)
    };
    let mut worst = 0.0_f64;
    for i in 0..Z::<f64>::DIM {
        for j in 0..i {
            let form = phase().symplectic_form::<f64>(&column(i), &column(j))
                - phase().symplectic_form::<f64>(&Z::basis(i), &Z::basis(j));
            worst = larger(worst, form.abs());
        }
    }
    worst
}

/// max |Φ_{−h}(Φ_h(z)) − z|
pub fn symmetry_defect<S: Scheme>(scheme: &S, step: f64) -> f64 {
    let there = advance(scheme, &field(), start(), step, 1);
    (advance(scheme, &field(), there, -step, 1) - start()).max_abs()
}

/// The change of two quadratic invariants, |Π|² and the energy of the free rigid body, in one step.
pub fn quadratic_defect<S: Scheme>(scheme: &S, step: f64) -> f64 {
    let inverse_inertia = Vector3::new(1.0, 0.5, 0.3);
    let euler = from_fn(|pi: &Vector3<f64>| pi.cross(&pi.component_mul(&inverse_inertia)));
    let pi = Vector3::new(0.6, -0.8, 1.1);
    let after = advance(scheme, &euler, pi, step, 1);
    let energy = |pi: &Vector3<f64>| pi.component_mul(&inverse_inertia).dot(pi);
    larger((after.norm_squared() - pi.norm_squared()).abs(), (energy(&after) - energy(&pi)).abs())
}

/// The round-off of a step with a few dozen evaluations, with room for cancellation.
pub const ROUND_OFF: f64 = 1e-13;

/// The flags of a scheme against what it does, in both directions.
pub fn keeps_its_promises<S: Scheme>(scheme: &S, counts: &[usize], name: &str) {
    let measured = measured_order(scheme, counts);
    assert!((measured - scheme.order() as f64).abs() < 0.3, "{name}: {measured}");
    let checks = [
        ("symplectic", scheme.is_symplectic(), symplectic_defect(scheme, 0.1)),
        ("symmetric", scheme.is_symmetric(), symmetry_defect(scheme, 0.1)),
    ];
    for (property, promised, defect) in checks {
        assert_eq!(promised, defect < ROUND_OFF, "{name} {property}: {defect:e}");
    }
}
