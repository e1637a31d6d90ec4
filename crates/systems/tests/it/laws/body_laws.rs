//! The law suites of bodies: the gyrostat, the body in a fluid and the top on a movable base.

use super::suites_with_controls::{holds, obeys};
use crate::law_samples::{ENERGY_OF_ORDER_FOUR, ROUND_OFF, ROUND_OFF_OF_RUNS, STEP, samples};
use lie_poisson_systems::collective_integrators::{Collective, LiftFree, RungeKutta, Start, laws};
use lie_poisson_systems::lie_poisson::laws::{hamiltonian, lie_algebra, poisson_space};
use lie_poisson_systems::lie_poisson::{
    Covector, Hamiltonian, InfinitesimalAdjoint, LiePoisson, Pair, Se3, Se3Dual,
};
use lie_poisson_systems::momentum_map::laws::poisson_map;
use lie_poisson_systems::momentum_map::{DualQuaternions, Side, clebsch_realisation};
use lie_poisson_systems::nalgebra::{Matrix3, Vector3};
use lie_poisson_systems::{
    Gyrostat, Kirchhoff, MovableBaseAlgebra, MovableBaseDual, MovableBaseTop,
};

fn gyrostat() -> Gyrostat {
    let (center, rotor) = (Vector3::new(0.3, -0.1, 0.8), Vector3::new(0.1, -0.2, 0.7));
    Gyrostat::new(Vector3::new(2.0, 1.7, 1.0), 1.5, center, rotor).unwrap()
}

fn kirchhoff() -> Kirchhoff {
    let a = Matrix3::new(0.9, 0.1, 0.0, 0.1, 0.6, 0.05, 0.0, 0.05, 0.4);
    let b = Matrix3::new(0.1, -0.05, 0.02, 0.0, 0.08, 0.1, -0.07, 0.0, 0.03);
    let c = Matrix3::new(0.5, 0.0, 0.1, 0.0, 0.7, -0.1, 0.1, -0.1, 0.3);
    Kirchhoff::new(a, b, c).unwrap()
}

fn movable_base() -> MovableBaseTop {
    let (inertia, center) = (Vector3::new(2.0, 2.2, 1.0), Vector3::new(0.1, 0.0, 0.8));
    MovableBaseTop::new(inertia, [1.0, 2.0], 1.0, center).unwrap()
}

/// Runs the suites that the gyrostat and the body in a fluid share.
fn obeys_on_se3<H: Hamiltonian<LiePoisson<Se3>> + Copy>(h: H) {
    obeys(&Se3::default(), ("coadjoint", 0), ROUND_OFF, |algebra| {
        poisson_space(&LiePoisson::minus(algebra.clone()), &samples())
    });
    let gauss = LiftFree::new(RungeKutta::gauss(2).unwrap(), DualQuaternions, h);
    let momenta = [samples::<Se3Dual>()[0]];
    obeys(&gauss, ("step", 0), ROUND_OFF, |i| laws::start(i, &momenta, STEP));
    let states = momenta.map(|mu| gauss.start(&mu).unwrap());
    let square = |Covector(Pair(_, p)): &Se3Dual| p.dot(p);
    let level = |Covector(Pair(pi, p)): &Se3Dual| pi.dot(p);
    obeys(&gauss, ("step", 0), ROUND_OFF_OF_RUNS, |i| {
        laws::invariants(i, &states, STEP, &[&square, &level])
    });
    holds(&gauss, ENERGY_OF_ORDER_FOUR, |i| {
        laws::invariants(i, &states, STEP, &[&|mu: &Se3Dual| h.value(mu)])
    });
}

#[test]
fn gyrostat_laws() {
    obeys(&gyrostat(), ("differential", 3), ROUND_OFF, |h| {
        hamiltonian::<LiePoisson<Se3>, _>(h, &samples())
    });
    obeys_on_se3(gyrostat());
}

#[test]
fn kirchhoff_laws() {
    obeys(&kirchhoff(), ("differential", 3), ROUND_OFF, |h| {
        hamiltonian::<LiePoisson<Se3>, _>(h, &samples())
    });
    obeys_on_se3(kirchhoff());
}

#[test]
fn movable_base_algebra_laws() {
    let algebra = MovableBaseAlgebra::default();
    obeys(&algebra, ("bracket", 0), ROUND_OFF, |algebra| lie_algebra(algebra, &samples()));
    obeys(&algebra, ("coadjoint", 0), ROUND_OFF, |algebra| {
        poisson_space(&LiePoisson::minus(algebra.clone()), &samples())
    });
}

#[test]
fn movable_base_top_laws() {
    let suite = |h: &_| hamiltonian::<LiePoisson<MovableBaseAlgebra>, _>(h, &samples());
    obeys(&movable_base(), ("differential", 3), ROUND_OFF, suite);
    let adjoint = InfinitesimalAdjoint(MovableBaseAlgebra::default());
    let map = clebsch_realisation(adjoint, Side::Right).unwrap();
    obeys(&map, ("apply", 0), ROUND_OFF, |map| poisson_map(map, &samples()));
    let (top, momenta) = (movable_base(), [samples::<MovableBaseDual>()[0]]);
    let gauss = Collective::new(RungeKutta::gauss(2).unwrap(), map, top);
    obeys(&gauss, ("step", 0), ROUND_OFF, |i| laws::start(i, &momenta, STEP));
    let states = momenta.map(|mu| gauss.start(&mu).unwrap());
    let casimir = |index: usize| move |mu: &MovableBaseDual| MovableBaseTop::casimirs(mu)[index];
    obeys(&gauss, ("step", 0), ROUND_OFF_OF_RUNS, |i| {
        laws::invariants(i, &states, STEP, &[&casimir(0), &casimir(1), &casimir(2)])
    });
    holds(&gauss, ENERGY_OF_ORDER_FOUR, |i| {
        laws::invariants(i, &states, STEP, &[&|mu: &MovableBaseDual| top.value(mu)])
    });
}
