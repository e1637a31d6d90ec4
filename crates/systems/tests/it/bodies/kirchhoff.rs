//! Kirchhoff's body in an ideal fluid: its equations, what a collective Gauss method conserves, and which parameters
//! are refused.

use crate::all_systems::drifts::{ROUND_OFF, drifts, energy_bound, schemes};
use collective_integrators::LiftFree;
use lie_poisson::{Covector, Hamiltonian, LiePoisson, Pair, PoissonSpace, Se3, Se3Dual};
use lie_poisson_systems::{Kirchhoff, SystemError};
use momentum_map::DualQuaternions;
use nalgebra::{Matrix3, Vector3};

fn body() -> Kirchhoff {
    let a = Matrix3::new(0.9, 0.1, 0.0, 0.1, 0.6, 0.05, 0.0, 0.05, 0.4);
    let b = Matrix3::new(0.1, -0.05, 0.02, 0.0, 0.08, 0.1, -0.07, 0.0, 0.03);
    let c = Matrix3::new(0.5, 0.0, 0.1, 0.0, 0.7, -0.1, 0.1, -0.1, 0.3);
    Kirchhoff::new(a, b, c).unwrap()
}

fn start() -> Se3Dual {
    Se3Dual::new(Vector3::new(0.4, -0.8, 0.6), Vector3::new(0.5, 0.3, -0.9))
}

#[test]
fn the_equations_are_kirchhoffs() {
    let (body, mu) = (body(), start());
    let (Covector(Pair(pi, p)), Pair(omega, v)) = (&mu, body.differential(&mu));
    let rate = LiePoisson::minus(Se3::default()).hamiltonian_vector(&mu, &Pair(omega, v));
    assert_eq!(rate, Se3Dual::new(pi.cross(&omega) + p.cross(&v), p.cross(&omega)));
}

/// A coupling of any two components may make the energy indefinite.
#[test]
fn every_entry_of_the_coupling_counts() {
    let one = Matrix3::identity();
    for place in 0..9 {
        let coupled = |size: f64| {
            let mut coupling = Matrix3::zeros();
            coupling[(place / 3, place % 3)] = size;
            Kirchhoff::new(one, coupling, one)
        };
        assert!(coupled(0.9).is_ok() && coupled(-0.9).is_ok(), "{place}");
        assert!(coupled(1.1).is_err() && coupled(-1.1).is_err(), "{place}");
    }
}

#[test]
fn the_body_conserves_energy_and_casimirs() {
    let body = body();
    for scheme in schemes() {
        let gauss = LiftFree::new(scheme.clone(), DualQuaternions, body);
        let [energy, square, level] = drifts(&gauss, &start(), (0.1, 1000), |mu| {
            let Covector(Pair(pi, p)) = mu;
            [body.value(mu), p.dot(p), pi.dot(p)]
        });
        assert!(square < ROUND_OFF && level < ROUND_OFF, "{square:e} {level:e}");
        assert!(energy < energy_bound(&scheme, 0.1), "{energy:e}");
    }
}

#[test]
fn the_parameters_are_checked() {
    let one = Matrix3::identity();
    let skew = Matrix3::new(1.0, 0.1, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);
    assert!(matches!(Kirchhoff::new(skew, one * 0.1, one), Err(SystemError::NotSymmetric { .. })));
    assert!(matches!(Kirchhoff::new(one, one * 1.5, one), Err(SystemError::NotPositive { .. })));
    assert!(matches!(Kirchhoff::new(one * f64::NAN, one, one), Err(SystemError::NotFinite { .. })));
}
