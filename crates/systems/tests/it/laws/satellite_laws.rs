//! The law suites of satellites, on circles and on ellipses, and of a body with reaction wheels.

use super::suites_with_controls::{holds, obeys};
use crate::law_samples::{ENERGY_OF_ORDER_FOUR, ROUND_OFF, ROUND_OFF_OF_RUNS, STEP, samples};
use lie_poisson_systems::collective_integrators::{Collective, Driven, RungeKutta, Start, laws};
use lie_poisson_systems::lie_poisson::laws::{hamiltonian, lie_algebra, poisson_space};
use lie_poisson_systems::lie_poisson::{
    Covector, Hamiltonian, InTime, LiePoisson, Pair, Real, So3, Time, TimeDependent,
};
use lie_poisson_systems::momentum_map::laws::poisson_map;
use lie_poisson_systems::momentum_map::{HOPF, TWO_FIELDS};
use lie_poisson_systems::nalgebra::Vector3;
use lie_poisson_systems::{
    KeplerOrbit, ReactionWheels, Satellite, SatelliteAlgebra, SatelliteDual, SatelliteOnEllipse,
    WheelMomenta,
};

const INERTIA: Vector3<f64> = Vector3::new(1.0, 1.2, 0.4);

fn satellite() -> Satellite {
    Satellite::new(INERTIA, 0.7).unwrap()
}

fn on_ellipse() -> SatelliteOnEllipse {
    SatelliteOnEllipse::new(INERTIA, KeplerOrbit::new(0.7, 0.3, 0.2).unwrap()).unwrap()
}

/// Two wheels, of which one is spun up steadily and the other to and fro.
#[derive(Clone, Copy, Debug)]
struct Wheels;

impl WheelMomenta<2> for Wheels {
    fn momenta<T: Real>(&self, time: T) -> [T; 2] {
        [time * 0.3 + 0.1, (time * 1.7).sin() * 0.4]
    }
}

fn reaction_wheels() -> ReactionWheels<Wheels, 2> {
    let axes = [Vector3::new(1.0, 0.0, 2.0), Vector3::new(0.3, -1.0, 0.0)];
    ReactionWheels::new(INERTIA, axes, Wheels).unwrap()
}

#[test]
fn satellite_algebra_laws() {
    let algebra = SatelliteAlgebra::default();
    obeys(&algebra, ("bracket", 0), ROUND_OFF, |algebra| lie_algebra(algebra, &samples()));
    obeys(&algebra, ("coadjoint", 0), ROUND_OFF, |algebra| {
        poisson_space(&LiePoisson::minus(algebra.clone()), &samples())
    });
}

#[test]
fn satellite_laws() {
    let suite = |h: &_| hamiltonian::<LiePoisson<SatelliteAlgebra>, _>(h, &samples());
    obeys(&satellite(), ("differential", 3), ROUND_OFF, suite);
    obeys(&TWO_FIELDS, ("apply", 0), ROUND_OFF, |map| poisson_map(map, &samples()));
    let (satellite, momenta) = (satellite(), [samples::<SatelliteDual>()[0]]);
    let gauss = Collective::new(RungeKutta::gauss(2).unwrap(), TWO_FIELDS, satellite);
    obeys(&gauss, ("step", 0), ROUND_OFF, |i| laws::start(i, &momenta, STEP));
    let states = momenta.map(|mu| gauss.start(&mu).unwrap());
    let casimir = |index: usize| move |mu: &SatelliteDual| Satellite::casimirs(mu)[index];
    // The Casimirs are functions of the second half of the coordinates.
    obeys(&gauss, ("step", 6), ROUND_OFF_OF_RUNS, |i| {
        laws::invariants(i, &states, STEP, &[&casimir(0), &casimir(1), &casimir(2)])
    });
    holds(&gauss, ENERGY_OF_ORDER_FOUR, |i| {
        laws::invariants(i, &states, STEP, &[&|mu: &SatelliteDual| satellite.value(mu)])
    });
}

#[test]
fn satellite_on_ellipse_laws() {
    let suite = |h: &_| hamiltonian::<InTime<LiePoisson<SatelliteAlgebra>>, _>(h, &samples());
    obeys::<SatelliteOnEllipse>(&on_ellipse(), ("differential", 3), ROUND_OFF, suite);
    let gauss = Driven::new(RungeKutta::gauss(2).unwrap(), TWO_FIELDS, TimeDependent(on_ellipse()));
    let momenta = [Pair(samples::<SatelliteDual>()[0], Time(0.4))];
    obeys(&gauss, ("step", 0), ROUND_OFF, |i| laws::start(i, &momenta, STEP));
    let states = momenta.map(|mu| gauss.start(&mu).unwrap());
    let casimir =
        |index: usize| move |mu: &Pair<SatelliteDual, Time>| Satellite::casimirs(&mu.0)[index];
    // The Casimirs are functions of the second half of the coordinates.
    obeys(&gauss, ("step", 6), ROUND_OFF_OF_RUNS, |i| {
        laws::invariants(i, &states, STEP, &[&casimir(0), &casimir(1), &casimir(2)])
    });
}

#[test]
fn reaction_wheels_laws() {
    let suite = |h: &_| hamiltonian::<InTime<LiePoisson<So3>>, _>(h, &samples());
    obeys::<ReactionWheels<Wheels, 2>>(&reaction_wheels(), ("differential", 1), ROUND_OFF, suite);
    let gauss = Driven::new(RungeKutta::gauss(2).unwrap(), HOPF, TimeDependent(reaction_wheels()));
    let momenta = [Pair(samples::<Covector<Vector3<f64>>>()[0], Time(0.4))];
    obeys(&gauss, ("step", 0), ROUND_OFF, |i| laws::start(i, &momenta, STEP));
    let states = momenta.map(|mu| gauss.start(&mu).unwrap());
    let square = |mu: &Pair<Covector<Vector3<f64>>, Time>| mu.0.0.dot(&mu.0.0);
    obeys(&gauss, ("step", 0), ROUND_OFF_OF_RUNS, |i| {
        laws::invariants(i, &states, STEP, &[&square])
    });
}
