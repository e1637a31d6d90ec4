//! Times the fields and steps of large systems for the table of `docs/large_systems.md`.
//!
//!     large_systems lattice SIZE SWEEPS REPEATS
//!     large_systems vortices COUNT REPEATS
//!
//! Prints rows of a name and the least seconds, separated by a tab: for one sweep of a step of a lattice with SIZE³ spins
//! that is stopped after SWEEPS sweeps, or for one evaluation of the field of vortices. The number of threads is that of
//! RAYON_NUM_THREADS.

use lie_poisson_systems::collective_integrators::{
    Integrator, SphericalMidpoint, StageSolver, StepError, VectorField,
};
use lie_poisson_systems::lie_poisson::{Covector, Sites};
use lie_poisson_systems::nalgebra::Vector3;
use lie_poisson_systems::{HeisenbergLattice, LatticeMidpoint, ManyVortices};
use std::env;
use std::error::Error;
use std::time::Instant;

type Points = Covector<Sites<Vector3<f64>>>;

/// Returns the least time of `repeats` calls, in seconds.
fn least(repeats: usize, mut f: impl FnMut()) -> f64 {
    let time = |_| {
        let begin = Instant::now();
        f();
        begin.elapsed().as_secs_f64()
    };
    (0..repeats).map(time).fold(f64::INFINITY, f64::min)
}

/// Returns the time of a sweep of a step that is stopped after a number of sweeps.
fn sweep<I: Integrator<State = Points>>(
    method: &I,
    start: &Points,
    sweeps: usize,
    repeats: usize,
) -> f64 {
    let (mut s, mut workspace) = (start.clone(), method.workspace());
    let mut ends_as_asked = true;
    let time = least(repeats, || {
        let step = method.step_in_place(&mut s, 0.05, &mut workspace);
        let stopped =
            matches!(step, Err(StepError::NotConverged { iterations, .. }) if iterations == sweeps);
        ends_as_asked &= stopped;
    });
    assert!(ends_as_asked, "the step ended before {sweeps} sweeps");
    // The first guess takes an evaluation too.
    time / (sweeps + 1) as f64
}

fn lattice(size: usize, sweeps: usize, repeats: usize) -> Result<(), Box<dyn Error>> {
    let lattice = HeisenbergLattice::new([size; 3])?
        .with_exchange([1, 0, 0], 1.0)?
        .with_exchange([0, 1, 0], 1.0)?
        .with_exchange([0, 0, 1], 1.0)?
        .with_field(Vector3::new(0.1, -0.2, 0.5))?;
    let start = lattice.state(|[x, y, z]| {
        let i = (x + size * (y + size * z)) as f64;
        Vector3::new((2.3 * i).sin(), (1.7 * i).cos(), (0.9 * i + 0.2).sin()).normalize()
    });
    let solver = StageSolver { max_iterations: sweeps, ..StageSolver::default() };
    let fast = LatticeMidpoint::new(lattice.clone()).with_solver(solver);
    let general = SphericalMidpoint::new(lattice).with_solver(solver);
    println!("LatticeMidpoint\t{:e}", sweep(&fast, &start, sweeps, repeats));
    println!("SphericalMidpoint\t{:e}", sweep(&general, &start, sweeps, repeats));
    Ok(())
}

fn vortices(count: usize, repeats: usize) -> Result<(), Box<dyn Error>> {
    let strength = |i: usize| if i.is_multiple_of(3) { -0.5 } else { 1.0 };
    let vortices = ManyVortices::new((0..count).map(strength).collect())?;
    let spiral = |i: usize| {
        let z = 1.0 - (2 * i + 1) as f64 / count as f64;
        let (sin, cos) = (2.399963 * i as f64).sin_cos();
        Vector3::new(cos * (1.0 - z * z).sqrt(), sin * (1.0 - z * z).sqrt(), z)
    };
    let m = vortices.momentum((0..count).map(spiral))?;
    let mut rate = vortices.at(&m);
    println!("field\t{:e}", least(repeats, || vortices.at_into(&m, &mut rate)));
    let sweeps = 3;
    let solver = StageSolver { max_iterations: sweeps, ..StageSolver::default() };
    let midpoint = SphericalMidpoint::new(vortices).with_solver(solver);
    println!("SphericalMidpoint\t{:e}", sweep(&midpoint, &m, sweeps, repeats.div_ceil(4)));
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = env::args().skip(1).collect();
    let number = |i: usize| -> Result<usize, Box<dyn Error>> {
        Ok(words.get(i).ok_or("a number is missing")?.parse()?)
    };
    match words.first().map(String::as_str) {
        Some("lattice") => lattice(number(1)?, number(2)?, number(3)?),
        Some("vortices") => vortices(number(1)?, number(2)?),
        _ => Err("large_systems lattice SIZE SWEEPS REPEATS | vortices COUNT REPEATS".into()),
    }
}
