//! Point vortices on the sphere: their equations, and what a collective Gauss method conserves.

use crate::all_systems::drifts::{ROUND_OFF, drifts, energy_bound, schemes};
use collective_integrators::Collective;
use lie_poisson::{Hamiltonian, LiePoisson, PoissonSpace, PowerAlgebra, So3, Vector};
use lie_poisson_systems::{PointVortices, SystemError};
use momentum_map::{HOPF, PowerMap};
use nalgebra::Vector3;

#[test]
fn vortices_conserve_energy_spheres_and_the_moment_of_vorticity() {
    let vortices = PointVortices::new([1.0, -0.7, 1.5, 0.4]).unwrap();
    let positions = [
        Vector3::new(1.0, 0.2, -0.3),
        Vector3::new(-0.4, 1.0, 0.5),
        Vector3::new(0.1, -0.8, 0.7),
        Vector3::new(-0.5, -0.2, -1.0),
    ]
    .map(|x| x.normalize());
    let start = vortices.momentum(&positions);
    let map = PowerMap::<_, 4>(HOPF);
    for scheme in schemes() {
        let gauss = Collective::new(scheme.clone(), map, vortices);
        let [energy, spheres, x, y, z] = drifts(&gauss, &start, (0.1, 500), |m| {
            let sum: Vector3<f64> = m.0.0.iter().sum();
            let spheres = m.0.0.iter().map(Vector3::norm_squared).sum();
            [vortices.value(m), spheres, sum.x, sum.y, sum.z]
        });
        for drift in [spheres, x, y, z] {
            assert!(drift < ROUND_OFF, "{drift:e}");
        }
        assert!(energy < energy_bound(&scheme, 0.1), "{energy:e}");
    }
}

/// D²h(m) v is the slope of dh along v, which Newton's iteration needs.
#[test]
fn the_second_derivative_is_the_slope_of_the_differential() {
    let vortices = PointVortices::new([1.0, -0.7]).unwrap();
    let m = vortices.momentum(&[Vector3::new(0.6, 0.0, 0.8), Vector3::new(0.0, -1.0, 0.0)]);
    let v = vortices.momentum(&[Vector3::new(0.3, -0.2, 0.9), Vector3::new(-0.5, 0.1, 0.4)]);
    let at = |s: f64| vortices.differential(&(m + v.scaled(s)));
    let slope = (at(1e-5) - at(-1e-5)).scaled(0.5e5);
    let found = vortices.hessian(&m, &v).unwrap();
    // The difference quotient has errors of 1e-10 by truncation and of 1e-11 by rounding, times a few.
    assert!((found - slope).max_abs() < 1e-9, "{:e}", (found - slope).max_abs());
    assert!(found.max_abs() > 0.01);
}

#[test]
fn the_strengths_are_checked() {
    assert_eq!(PointVortices::new([1.0, 0.0]), Err(SystemError::Zero { name: "strength" }));
    assert!(matches!(PointVortices::new([f64::NAN]), Err(SystemError::NotFinite { .. })));
}

#[test]
fn vortex_equations_are_bogomolovs() {
    let strengths = [1.0, -0.7, 1.5];
    let vortices = PointVortices::new(strengths).unwrap();
    let x = [Vector3::x(), Vector3::new(0.0, 0.6, 0.8), Vector3::new(-0.8, 0.0, 0.6)];
    let m = vortices.momentum(&x);
    let space = LiePoisson::minus(PowerAlgebra::<_, 3>(So3));
    let rate = space.hamiltonian_vector(&m, &vortices.differential(&m)).0.0;
    for i in 0..3 {
        let term = |j: usize| {
            x[j].cross(&x[i]) * strengths[j]
                / (4.0 * core::f64::consts::PI * (1.0 - x[i].dot(&x[j])))
        };
        let expected: Vector3<f64> = (0..3).filter(|&j| j != i).map(term).sum();
        assert!((rate[i] / strengths[i] - expected).norm() < 1e-15);
    }
}
