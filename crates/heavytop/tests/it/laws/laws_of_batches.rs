//! The law suites of batches, on each instruction set and at each width of the registers.

use super::suites::{STEP, obeys};
use crate::kernels::top_ensembles::{any_tops, members, starts, tops};
use collective_integrators::{AlternatingSubsteps, Substeps, laws};
use heavytop::{GaussBatch, HeavyTop, MidpointBatch, SymmetricTopBatch, TopMidpoint};
use lie_poisson::{InstructionSet, Se3Dual, Vector, Width};

/// The number of members with results of their own.
const MEMBERS: usize = 3;

/// Returns tops that differ in every parameter and in their states, and one whose state is not a number.
fn of_many_tops<B: Copy>(tops: &[B]) -> (Vec<(B, Se3Dual)>, (B, Se3Dual)) {
    let members = members(tops)[..MEMBERS].to_vec();
    let (top, state) = members[1];
    (members, (top, state.scaled(f64::NAN)))
}

fn gauss_batch_of<const S: usize>() {
    let (members, failing) = of_many_tops::<HeavyTop>(&any_tops());
    for set in InstructionSet::available() {
        for width in Width::ALL {
            let gauss = GaussBatch::<S>::new().unwrap().on(set, width).unwrap();
            obeys(&gauss, ("advance", 0), 0.0, |b| laws::batch(b, &members, &failing, STEP));
        }
    }
}

#[test]
fn gauss_batch() {
    gauss_batch_of::<1>();
    gauss_batch_of::<4>();
}

#[test]
fn midpoint_batch() {
    let (members, failing) = of_many_tops(&any_tops());
    for set in InstructionSet::available() {
        for width in Width::ALL {
            let midpoint = MidpointBatch::new().on(set, width).unwrap();
            obeys(&midpoint, ("advance", 0), 0.0, |b| laws::batch(b, &members, &failing, STEP));
        }
    }
    obeys(&MidpointBatch::default(), ("advance", 0), 0.0, |b| {
        laws::batch(b, &members, &failing, STEP)
    });
}

#[test]
fn symmetric_top_batch() {
    let (members, failing) = of_many_tops(&tops());
    let substeps = [
        AlternatingSubsteps::blanes_moan4(),
        AlternatingSubsteps::composed(&Substeps::sofroniou_spaletta10()),
    ];
    for (set, substeps) in InstructionSet::available().zip(substeps.iter().cycle()) {
        for width in Width::ALL {
            let splitting = SymmetricTopBatch::new(substeps.clone()).on(set, width).unwrap();
            obeys(&splitting, ("advance", 0), 0.0, |b| laws::batch(b, &members, &failing, STEP));
        }
    }
}

/// A batch of states of one top.
#[test]
fn top_midpoint_as_batch() {
    let (members, failing) = (&starts()[..MEMBERS], starts()[1].scaled(f64::NAN));
    for set in InstructionSet::available() {
        let midpoint = TopMidpoint::new(any_tops()[0]).with_instructions(set).unwrap();
        obeys(&midpoint, ("advance", 0), 0.0, |b| laws::batch(b, members, &failing, STEP));
    }
}
