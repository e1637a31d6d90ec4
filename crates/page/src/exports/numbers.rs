//! Numbers of the top, in memory.
#![allow(unsafe_code, reason = "names without mangling are the interface of a WebAssembly module")]

use crate::exports::desk::{NUMBERS, with};
use crate::motions::snapshot::Snapshot;
use crate::records::deviation_record::MOST_INVARIANTS;
use crate::simulation::running_top::Simulation;
use lie_poisson::{Covector, Pair};

/// Returns the address of 33 numbers that describe the top at a time within the last step, or after it.
///
/// | places | numbers |
/// |---|---|
/// | 0 | the time after the last step, s |
/// | 1 | the number of steps since the throw |
/// | 2–4 | Π at the given time, kg m²/s, body frame |
/// | 5–7 | Γ at the given time, body frame |
/// | 8–11 | the quaternion of the attitude at the given time, the scalar first |
/// | 12–17 | the values of the invariants after the last step |
/// | 18–23 | their deviations, without their changes by friction |
/// | 24 | the number of invariants |
/// | 25, 26 | the numbers of columns and of points of the section |
/// | 27–32 | the changes of the invariants by friction |
///
/// All are 0 before the first throw.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn show(time: f64) -> *const f64 {
    with(std::ptr::null(), |desk| {
        if let Some(simulation) = &mut desk.simulation {
            desk.numbers = numbers(simulation, time);
        }
        desk.numbers.as_ptr()
    })
}

/// Returns the time after the last step, s; 0 before the first throw.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn time() -> f64 {
    with(0.0, |desk| desk.simulation.as_ref().map_or(0.0, Simulation::time))
}

/// Returns the address of the columns: the time, and the largest |Δ| of six invariants.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn columns() -> *const f64 {
    with(std::ptr::null(), |desk| {
        desk.simulation.as_ref().map_or(std::ptr::null(), |top| top.columns().as_ptr().cast())
    })
}

/// Returns the address of the points of the section: x, y, and the number of the orbit.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn section_points() -> *const f64 {
    with(std::ptr::null(), |desk| {
        let points = |top: &Simulation| top.section_points().as_ptr().cast();
        desk.simulation.as_ref().map_or(std::ptr::null(), points)
    })
}

fn numbers(simulation: &mut Simulation, time: f64) -> [f64; NUMBERS] {
    let mut numbers = [0.0; NUMBERS];
    let Snapshot { momentum: Covector(Pair(pi, gamma)), attitude } = simulation.at(time);
    (numbers[0], numbers[1]) = (simulation.time(), simulation.steps() as f64);
    numbers[2..5].copy_from_slice(pi.as_slice());
    numbers[5..8].copy_from_slice(gamma.as_slice());
    numbers[8] = attitude.scalar;
    numbers[9..12].copy_from_slice(attitude.vector.as_slice());
    numbers[12..12 + MOST_INVARIANTS].copy_from_slice(simulation.values());
    numbers[18..18 + MOST_INVARIANTS].copy_from_slice(&simulation.deviations());
    numbers[27..27 + MOST_INVARIANTS].copy_from_slice(&simulation.by_friction());
    numbers[24] = simulation.invariants().len() as f64;
    numbers[25] = simulation.columns().len() as f64;
    numbers[26] = simulation.section_points().len() as f64;
    numbers
}
