//! Integrators for any number of sites: the lengths of spins and vortices.

use super::kinds::Kind;
use super::schemes::{scheme, spin, steps_hold};
use crate::input::Input;
use crate::targets::conservation::{largest_turn, lengths_hold};
use collective_integrators::{
    CollectiveSites, Composition, Equivariant, LiftFreeSites, RungeKutta, Start, Substeps,
};
use lie_poisson::generic_scalars::InstructionSet;
use lie_poisson::{Covector, Sites, SitesHamiltonian};
use lie_poisson_systems::{HeisenbergLattice, LatticeMidpoint, ManyVortices};
use momentum_map::{HOPF, QuadraticMomentumMap, Quaternions, Side, So3OnC2};
use nalgebra::Vector3;

pub(super) const KINDS: &[Kind] = &[
    ("LatticeMidpoint", lattice_midpoint),
    ("LatticeMidpoint, portable", portable_midpoint),
    ("CollectiveSites of spins", collective_spins),
    ("CollectiveSites of vortices", collective_vortices),
    ("CollectiveSites, composed", composed_collective),
    ("LiftFreeSites of spins", lift_free_spins),
    ("LiftFreeSites of vortices", lift_free_vortices),
    ("LiftFreeSites, composed", composed_lift_free),
];

/// The most spins of a lattice.
const MOST: usize = 204;

/// The most spins where Newton's iteration solves dense equations for the coordinates of all stages together.
const MOST_DENSE: usize = 12;

type Spins = Covector<Sites<Vector3<f64>>>;

/// Returns a lattice of at most so many spins with a state of it.
fn lattice(input: &mut Input<'_>, most: usize) -> Option<(HeisenbergLattice, Spins)> {
    let counts = [1, 2, 3, 4, 5, 9, 17, 0];
    let cells = [counts[input.choice(8)], counts[input.choice(4)], counts[input.choice(3)]];
    let mut lattice = HeisenbergLattice::new(cells).ok()?;
    if lattice.count() > most {
        return None;
    }
    for _ in 0..input.choice(3) {
        let offset = [(); 3].map(|()| input.choice(5) as i64 - 2);
        lattice = lattice.with_exchange(offset, input.number()).ok()?;
    }
    if input.choice(4) == 0 {
        lattice = lattice.with_anisotropy(input.direction(), input.number()).ok()?;
    }
    if input.choice(2) == 0 {
        lattice = lattice.with_field(input.vector()).ok()?;
    }
    let spins = [(); 4].map(|()| spin(input));
    let start = lattice.state(|[i, j, k]| spins[(i + 2 * j + 3 * k) % 4]);
    Some((lattice, start))
}

/// Returns up to four vortices with a state of them.
fn vortices(input: &mut Input<'_>) -> Option<(ManyVortices, Spins)> {
    let count = input.choice(5);
    let vortices = ManyVortices::new((0..count).map(|_| input.number()).collect()).ok()?;
    let positions: Vec<_> = (0..count).map(|_| input.direction()).collect();
    let start = vortices.momentum(positions).ok()?;
    Some((vortices, start))
}

/// Asserts that steps conserve the lengths, or are finite if the scheme conserves none.
fn lengths<I: Start<Momentum = Spins>>(
    integrator: &I,
    hamiltonian: &impl SitesHamiltonian<Vector3<f64>>,
    start: &Spins,
    step: f64,
    conserves: bool,
) -> bool {
    steps_hold(integrator, start, step, |before, after| {
        let ends = [&before.0[..], &after.momentum.0];
        let turn = if conserves { largest_turn(hamiltonian, ends, step) } else { f64::INFINITY };
        lengths_hold(ends[0], ends[1], turn)
    })
}

fn midpoint(input: &mut Input<'_>, instructions: InstructionSet) -> bool {
    let Some((lattice, start)) = lattice(input, MOST) else { return false };
    let midpoint = LatticeMidpoint::new(lattice.clone()).with_instructions(instructions);
    let Ok(midpoint) = midpoint else { return false };
    lengths(&midpoint, &lattice, &start, input.number(), true)
}

fn lattice_midpoint(input: &mut Input<'_>) -> bool {
    midpoint(input, InstructionSet::detected())
}

fn portable_midpoint(input: &mut Input<'_>) -> bool {
    midpoint(input, InstructionSet::Portable)
}

/// Returns a composition of a Runge–Kutta method with itself.
fn composition(input: &mut Input<'_>) -> (Composition<RungeKutta>, bool) {
    let (scheme, conserves) = scheme(input);
    (Composition::new(scheme, Substeps::yoshida4()), conserves)
}

fn on_spinors<S: Equivariant>((scheme, conserves): (S, bool), input: &mut Input<'_>) -> bool {
    let Some((lattice, start)) = lattice(input, MOST_DENSE) else { return false };
    let map = QuadraticMomentumMap::new(So3OnC2, Side::Left);
    let collective = CollectiveSites::new(scheme, map, lattice.clone());
    lengths(&collective, &lattice, &start, input.number(), conserves)
}

fn on_quaternions<S: Equivariant>((scheme, conserves): (S, bool), input: &mut Input<'_>) -> bool {
    let Some((lattice, start)) = lattice(input, MOST_DENSE) else { return false };
    let lift_free = LiftFreeSites::new(scheme, Quaternions, lattice.clone());
    lengths(&lift_free, &lattice, &start, input.number(), conserves)
}

fn collective_spins(input: &mut Input<'_>) -> bool {
    on_spinors(scheme(input), input)
}

fn composed_collective(input: &mut Input<'_>) -> bool {
    on_spinors(composition(input), input)
}

fn lift_free_spins(input: &mut Input<'_>) -> bool {
    on_quaternions(scheme(input), input)
}

fn composed_lift_free(input: &mut Input<'_>) -> bool {
    on_quaternions(composition(input), input)
}

/// Asserts the same of vortices. Near each other they may move much faster between the ends than at the ends and midpoints,
/// where the turn is measured. So only steps that turn no vortex by a radian or more are compared, which leaves the bound a
/// factor of a thousand.
fn lengths_of_vortices<I: Start<Momentum = Spins>>(
    integrator: &I,
    vortices: &ManyVortices,
    start: &Spins,
    step: f64,
    conserves: bool,
) -> bool {
    steps_hold(integrator, start, step, |before, after| {
        let ends = [&before.0[..], &after.momentum.0];
        let is_near = largest_turn(vortices, ends, step) < 1.0;
        let turn = if conserves && is_near { 1.0 } else { f64::INFINITY };
        lengths_hold(ends[0], ends[1], turn)
    })
}

fn collective_vortices(input: &mut Input<'_>) -> bool {
    let (scheme, conserves) = scheme(input);
    let Some((vortices, start)) = vortices(input) else { return false };
    let collective = CollectiveSites::new(scheme, HOPF, vortices.clone());
    lengths_of_vortices(&collective, &vortices, &start, input.number(), conserves)
}

fn lift_free_vortices(input: &mut Input<'_>) -> bool {
    let (scheme, conserves) = scheme(input);
    let Some((vortices, start)) = vortices(input) else { return false };
    let lift_free = LiftFreeSites::new(scheme, Quaternions, vortices.clone());
    lengths_of_vortices(&lift_free, &vortices, &start, input.number(), conserves)
}
