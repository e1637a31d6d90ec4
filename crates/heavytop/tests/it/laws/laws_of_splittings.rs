//! The law suites of the splittings, whose flows are exact.

use super::suites::{
    ROUND_OFF, ROUND_OFF_OF_RUNS, STEP, energy_of_order, holds, momenta, obeys, obeys_as_integrator,
};
use crate::kernels::top_ensembles::{any_tops, tops};
use collective_integrators::{AlternatingSubsteps, ExactFlows, LieTrotter, Splitting, Start, laws};
use heavytop::{RigidBody, RotorSplitting, SymmetricTopSplitting};
use lie_poisson::{Covector, Hamiltonian, Se3Dual, Vector};
use nalgebra::Vector3;

/// Checks that each flow is a one-parameter group, and that flows of different parts do not commute.
fn obeys_as_flows<E>(flows: &E, z: &E::Point)
where
    E: ExactFlows<Point: Vector<Scalar = f64>>,
{
    for index in 0..E::COUNT {
        let flow = |time: f64, z: &E::Point| flows.flow(index, time, z);
        let law = |s: f64| (flow(0.3, &flow(s, z)) - flow(0.3 + s, z)).max_abs() / z.max_abs();
        // Four rotations, each to a few units.
        assert!(law(0.9) < ROUND_OFF && law(-0.3) < ROUND_OFF && law(7.0) < ROUND_OFF, "{index}");
        let next = (index + 1) % E::COUNT;
        let (one, two) =
            (flows.flow(next, 0.3, &flow(0.9, z)), flow(0.9, &flows.flow(next, 0.3, z)));
        // Control: a flow of another part in place of the first gives another point.
        assert!((one - two).max_abs() > 1e-3 * z.max_abs(), "{index}");
    }
    assert_eq!(flows.flow(E::COUNT, 0.3, z), *z);
}

#[test]
fn symmetric_top_splitting() {
    let flows: SymmetricTopSplitting = tops()[2];
    momenta().iter().for_each(|mu| obeys_as_flows(&flows, mu));
    obeys_as_integrator(flows.top(), Splitting::strang(flows), energy_of_order(2));
    let alternating = Splitting::alternating(flows, AlternatingSubsteps::blanes_moan4());
    obeys_as_integrator(flows.top(), alternating, energy_of_order(4));
}

#[test]
fn rotor_splitting() {
    let flows = RotorSplitting(any_tops()[1]);
    momenta().iter().for_each(|mu| obeys_as_flows(&flows, mu));
    obeys_as_integrator(&flows.0, Splitting::strang(flows), energy_of_order(2));
    let sequence = Splitting::new(flows, LieTrotter);
    obeys_as_integrator(&flows.0, sequence, energy_of_order(1));
}

#[test]
fn rotor_splitting_of_the_rigid_body() {
    let body = RigidBody::new(Vector3::new(1.0, 2.0, 2.5)).unwrap();
    let flows = RotorSplitting(body);
    let momenta = momenta().map(|mu: Se3Dual| Covector(mu.0.0));
    momenta.iter().for_each(|pi| obeys_as_flows(&flows, pi));
    let strang = Splitting::strang(flows);
    obeys(&strang, ("step", 0), ROUND_OFF, |i| laws::start(i, &momenta, STEP));
    let states = momenta.map(|pi| strang.start(&pi).unwrap());
    let square = |Covector(pi): &Covector<Vector3<f64>>| pi.norm_squared();
    obeys(&strang, ("step", 0), ROUND_OFF_OF_RUNS, |i| {
        laws::invariants(i, &states, STEP, &[&square])
    });
    holds(&strang, energy_of_order(2), |i| {
        laws::invariants(i, &states, STEP, &[&|pi: &_| body.value(pi)])
    });
}
