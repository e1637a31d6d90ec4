//! The law suites of the tops, and of the paper's action and maps.

use super::suites::{ROUND_OFF, momenta, obeys};
use crate::kernels::top_ensembles::any_tops;
use heavytop::{
    HeavyTop, HeavyTopSpace, RigidBody, SPINOR_MOTIONS, SpinorMomentum, SpinorRealisation, Varpi,
};
use lie_poisson::laws::hamiltonian;
use lie_poisson::{LiePoisson, So3, Vector};
use momentum_map::MomentumMap;
use momentum_map::laws::{
    cotangent_lift, equivariance, fibre_symmetry, group_action, lift, poisson_map,
};
use nalgebra::Vector3;

/// Returns three generic vectors, with coordinates in (−1, 1).
fn samples<V: Vector<Scalar = f64>>() -> Vec<V> {
    let mut seed = 9.0_f64;
    let mut next = move || {
        seed = (seed * 16_807.0) % 2_147_483_647.0;
        2.0 * seed / 2_147_483_647.0 - 1.0
    };
    (0..3).map(|_| V::from_coordinates(|_| next())).collect()
}

/// Each coordinate of dh is tested: those of Ω, and those of the weight.
#[test]
fn heavy_tops() {
    for top in any_tops() {
        for coordinate in 0..6 {
            obeys(&top, ("differential", coordinate), ROUND_OFF, |h| {
                hamiltonian::<HeavyTopSpace, _>(h, &samples())
            });
        }
    }
    // Parameters that are zero: the weight of a free body, and the sides of integrable tops.
    let integrable = [
        HeavyTop::free_rigid_body(Vector3::new(1.0, 2.0, 2.5)),
        HeavyTop::lagrange(2.0, 1.0, 0.7),
        HeavyTop::kovalevskaya(1.0, 0.7),
        HeavyTop::goryachev_chaplygin(1.0, 0.7),
    ];
    for top in integrable.map(Result::unwrap) {
        obeys(&top, ("differential", 1), ROUND_OFF, |h| {
            hamiltonian::<HeavyTopSpace, _>(h, &samples())
        });
    }
}

#[test]
fn the_rigid_body() {
    let body = RigidBody::new(Vector3::new(1.0, 2.0, 2.5)).unwrap();
    for coordinate in 0..3 {
        obeys(&body, ("differential", coordinate), ROUND_OFF, |h| {
            hamiltonian::<LiePoisson<So3>, _>(h, &samples())
        });
    }
}

#[test]
fn the_realisation() {
    for coordinate in 0..8 {
        obeys(&SpinorRealisation, ("pull_back", coordinate), ROUND_OFF, |map| {
            poisson_map(map, &samples())
        });
        obeys(&SpinorRealisation, ("flow", coordinate), ROUND_OFF, |map| {
            fibre_symmetry(map, &samples(), &[0.3, 2.0, -40.0])
        });
    }
    obeys(&SpinorRealisation, ("lift", 0), ROUND_OFF, |map| lift(map, &samples()));
    obeys(&SpinorRealisation, ("lift", 0), ROUND_OFF, |map| lift(map, &momenta()));
}

#[test]
fn the_map_to_se3() {
    for coordinate in 0..7 {
        obeys(&Varpi, ("pull_back", coordinate), ROUND_OFF, |map| poisson_map(map, &samples()));
    }
}

/// The action is made of parts whose suites have their controls where they are defined. A fault of the momentum map
/// is found.
#[test]
fn the_action_on_spinors() {
    let report = group_action(&SPINOR_MOTIONS, &samples(), &samples()).unwrap();
    report.check(ROUND_OFF).unwrap();
    let report = cotangent_lift(&SPINOR_MOTIONS, &samples(), &samples()).unwrap();
    report.check(ROUND_OFF).unwrap();
    let report = equivariance(&SPINOR_MOTIONS, &samples(), &samples()).unwrap();
    report.check(ROUND_OFF).unwrap();
    let map: SpinorMomentum = MomentumMap(SPINOR_MOTIONS);
    obeys(&map, ("pull_back", 0), ROUND_OFF, |map| poisson_map(map, &samples()));
}
