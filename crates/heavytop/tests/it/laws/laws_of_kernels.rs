//! The law suites of the kernels of single tops, on each instruction set, and of their attitude.

use super::suites::{ROUND_OFF_OF_RUNS, energy_of_order, obeys_as_integrator};
use crate::kernels::top_ensembles::any_tops;
use collective_integrators::Splitting;
use heavytop::{CollectiveGauss, ReducedMidpoint, RotorSplitting, TopMidpoint, WithAttitude};
use lie_poisson::InstructionSet;

/// The three numbers of stages are those of the three sizes of registers.
#[test]
fn collective_gauss() {
    let top = any_tops()[1];
    for set in InstructionSet::available() {
        for stages in [2, 5, 8] {
            let gauss = CollectiveGauss::new(stages, top).unwrap().with_instructions(set).unwrap();
            let energy = energy_of_order(2 * stages as i32).max(ROUND_OFF_OF_RUNS);
            obeys_as_integrator(&top, gauss, energy);
        }
    }
}

#[test]
fn top_midpoint() {
    let top = any_tops()[2];
    for set in InstructionSet::available() {
        let midpoint = TopMidpoint::new(top).with_instructions(set).unwrap();
        obeys_as_integrator(&top, midpoint, energy_of_order(2));
    }
}

#[test]
fn reduced_midpoint() {
    let top = any_tops()[3];
    obeys_as_integrator(&top, ReducedMidpoint::new(top), energy_of_order(2));
}

/// The attitude is a part of the state, whose bits the suites compare. `attitude.rs` tests what it means.
#[test]
fn with_attitude() {
    let top = any_tops()[4];
    let gauss = WithAttitude(CollectiveGauss::new(3, top).unwrap());
    obeys_as_integrator(&top, gauss, energy_of_order(6));
    let midpoint = WithAttitude(TopMidpoint::new(top));
    obeys_as_integrator(&top, midpoint, energy_of_order(2));
    let splitting = WithAttitude(Splitting::strang(RotorSplitting(top)));
    obeys_as_integrator(&top, splitting, energy_of_order(2));
}
