//! Constructors: parameters are refused, or what is made of them obeys its laws.

mod closed_forms;
mod matrices;
mod systems;
mod tables;

use crate::input::Input;
use collective_integrators::Start;
use lie_poisson::Vector;

pub(crate) fn run(case: &[u8]) {
    let input = &mut Input::new(case);
    match input.choice(16) {
        0 => closed_forms::euler_solution(input),
        1 => closed_forms::lagrange_nutation(input),
        2 => closed_forms::elliptic_functions(input),
        3 => closed_forms::section(input),
        4 => tables::tableau(input),
        5 => tables::substeps(input),
        6 => tables::structure_constants(input),
        7 => systems::gyrostat(input),
        8 => systems::kirchhoff(input),
        9 => systems::vortices(input),
        10 => systems::kida_vortex(input),
        11 => systems::movable_base(input),
        12 => systems::lattice(input),
        13 => matrices::generalised_rigid_body(input),
        14 => matrices::zeitlin(input),
        _ => systems::many_vortices(input),
    }
}

/// Asserts that steps of an integrator fail, or lead to a finite state.
fn steps<I>(integrator: &I, start: &I::Momentum, step: f64)
where
    I: Start<Momentum: Vector<Scalar = f64>>,
{
    if let Ok(sample) = integrator.after(start, step, 2) {
        assert!(
            sample.momentum.max_abs().is_finite(),
            "{start:?}, {step:e}: {:?}",
            sample.momentum
        );
    }
}
