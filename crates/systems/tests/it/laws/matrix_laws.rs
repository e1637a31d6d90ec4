//! The law suites of matrices: rigid bodies in N dimensions and fluids on the sphere.

use super::faulty_system::{holds, obeys};
use super::field_laws::generator;
use super::law_samples::{ENERGY_OF_ORDER_FOUR, ROUND_OFF, ROUND_OFF_OF_RUNS, STEP};
use core::f64::consts::PI;
use lie_poisson_systems::collective_integrators::{RungeKutta, laws};
use lie_poisson_systems::isospectral_flows::{IsospectralRungeKutta, LargeSkewHermitian};
use lie_poisson_systems::num_complex::Complex;
use lie_poisson_systems::{GeneralisedRigidBody, Zeitlin};

/// Returns a generic matrix without trace of norm 1.
fn generic(size: usize) -> LargeSkewHermitian {
    let entry = |j: usize, k: usize| {
        let x = (j * size + k) as f64 + 1.0;
        Complex::new((12.9898 * x).sin(), (35.0725 * x + 0.3).sin())
    };
    let mean = (0..size).map(|j| entry(j, j).im).sum::<f64>() / size as f64;
    let w = LargeSkewHermitian::from_upper(size, |j, k| {
        entry(j, k) - if j == k { Complex::new(0.0, mean) } else { Complex::ZERO }
    });
    let norm = w.norm();
    LargeSkewHermitian::from_upper(size, |j, k| w.at(j, k) / norm)
}

/// The dimensions of the rigid bodies.
const DIMENSIONS: [usize; 4] = [1, 2, 3, 7];

#[test]
fn generalised_rigid_body_laws() {
    for size in DIMENSIONS {
        let moments = (0..size).map(|j| 1.0 + 0.5 * j as f64).collect();
        let body = GeneralisedRigidBody::new(moments).unwrap();
        let m = [body.momentum(|j, k| ((j * j + 7 * k) as f64).cos())];
        // The energy counts each pair of axes once, the scalar product twice.
        let suite = |field: &_| generator(field, |m| body.energy(m), (-2.0, 1e-8), &m);
        let gauss = IsospectralRungeKutta::new(RungeKutta::gauss(2).unwrap(), body.clone());
        if size == 1 {
            // In one dimension nothing can turn, and no fault can be seen.
            holds(body.clone(), ROUND_OFF, suite);
            holds(gauss, ROUND_OFF, |i| laws::integrator(i, &m, STEP));
            continue;
        }
        obeys(body.clone(), 1, ROUND_OFF, suite);
        if size < 4 {
            obeys(gauss.clone(), 1, ROUND_OFF, |i| laws::integrator(i, &m, STEP));
        }
        let norm = |m: &LargeSkewHermitian| m.norm();
        obeys(gauss.clone(), 1, ROUND_OFF_OF_RUNS, |i| laws::invariants(i, &m, STEP, &[&norm]));
        obeys(gauss, 1, ENERGY_OF_ORDER_FOUR, |i| {
            let manakov = |m: &_| body.manakov_integral(m);
            laws::invariants(i, &m, STEP, &[&|m: &_| body.energy(m), &manakov])
        });
    }
}

/// The sizes of the matrices of fluids.
const SIZES: [usize; 3] = [2, 3, 8];

#[test]
fn zeitlin_laws() {
    for size in SIZES {
        let w = [generic(size)];
        let still = Zeitlin::new(size).unwrap();
        for fluid in [still.clone(), still.clone().with_rotation(0.7).unwrap()] {
            // The scalar product of functions is 4π/N times that of matrices, and their bracket has the factor 1/ħ.
            let c = -(size as f64) / (4.0 * PI * fluid.planck_constant());
            obeys(fluid.clone(), 1, ROUND_OFF, |field| {
                generator(field, |w| fluid.energy(w), (c, 1.0), &w)
            });
        }
        let gauss = IsospectralRungeKutta::new(RungeKutta::gauss(2).unwrap(), still.clone());
        if size < 4 {
            obeys(gauss.clone(), 1, ROUND_OFF, |i| laws::integrator(i, &w, STEP));
        }
        let casimir = |k: usize| {
            let fluid = still.clone();
            move |w: &LargeSkewHermitian| fluid.casimirs(w, k)[k - 1]
        };
        let angular = |w: &LargeSkewHermitian| still.angular_momentum(w)[0];
        obeys(gauss.clone(), 1, ROUND_OFF_OF_RUNS, |i| {
            laws::invariants(i, &w, STEP, &[&casimir(2), &casimir(3), &angular])
        });
        obeys(gauss, 1, ENERGY_OF_ORDER_FOUR, |i| {
            laws::invariants(i, &w, STEP, &[&|w: &_| still.energy(w)])
        });
    }
}
