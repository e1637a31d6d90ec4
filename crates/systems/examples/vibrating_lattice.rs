//! Integrates spins on a chain of moving atoms: a twist of the spins sets the atoms in motion.
//!
//! ```text
//! cargo run --release -p systems-examples --bin vibrating_lattice -- [PICTURE]
//! ```
//!
//! Prints the largest deviations up to t = 30 of the energy h, of the lengths |s_i|, of the total spin S and of the total
//! momentum, in units in which all parameters are numbers. The Gauss method of order 6 through Hopf maps conserves lengths
//! and both totals to round-off, and h to its order. The program fails if this does not hold. With a PICTURE (a path ending
//! in .png or .svg), draws spins and displacements against time.

mod pictures;

use collective_integrators::{Collective, RungeKutta, Start};
use lie_poisson::{Automatic, Covector, Energy, Pair, Point, Power, RealSpace, larger};
use lie_poisson_systems::{SpinLattice, SpinLatticeSpace};
use momentum_map::{
    Cotangent, CotangentBundle, Identity, PowerMap, ProductMap, QuadraticMomentumMap, Side, So3OnC2,
};
use nalgebra::{SVector, Vector3};
use pictures::arguments::Arguments;
use pictures::canvas::{self, Area, PIXEL};
use pictures::raster::{self, Sites};
use std::error::Error;
use std::path::Path;

const ATOMS: usize = 16;
const STEP: f64 = 0.05;
const STEPS: usize = 600;
/// The bound of round-off over the run.
const ROUND_OFF: f64 = 1e-12;

type State = Point<SpinLatticeSpace<ATOMS>, f64>;

/// Atoms at rest, and spins along z with a twist about the middle.
fn start() -> State {
    let spins = std::array::from_fn(|i| {
        let from_middle = i as f64 - 0.5 * (ATOMS - 1) as f64;
        let angle = 2.5 * (-(from_middle / 2.0).powi(2)).exp();
        Vector3::new(angle.sin(), 0.0, angle.cos())
    });
    let at_rest = Cotangent::new(SVector::zeros(), Covector(SVector::zeros()));
    Pair(Covector(Power(spins)), at_rest)
}

/// The value of an atom at the time of a step.
type Values<'a> = dyn Fn(usize, usize) -> f64 + 'a;

fn draw(path: &Path, states: &[State]) -> Result<(), Box<dyn Error>> {
    let heading = [
        "A twist of spins sets the atoms of a chain in motion",
        "m = 1, κ = 2, J = 1, a = 0.5; Gauss method of order 6 through Hopf maps, steps of 0.05 (no units)",
    ];
    canvas::save(path, heading, [1100, 800], |area| {
        // The scale ends at a round number.
        let size = states.iter().map(|z| z.1.q.amax()).fold(0.0, larger);
        let size = (size * 10.0).ceil() / 10.0;
        let spin = |i: usize, n: usize| states[n].0.0.0[i].z;
        let displacement = |i: usize, n: usize| states[n].1.q[i];
        let panels = area.split_evenly((2, 1));
        let add = |panel: &Area, [title, name]: [&str; 2], values: &Values<'_>, most| {
            let (left, right) = panel.split_horizontally(980 * PIXEL);
            let sites = Sites {
                title,
                time: STEP * STEPS as f64,
                name: "number of the atom",
                count: ATOMS,
            };
            sites.draw(&left, states.len(), values, most)?;
            raster::scale(&right, name, most, [50 * PIXEL, 290 * PIXEL])
        };
        add(&panels[0], ["spins", "s₃"], &spin, 1.0)?;
        add(&panels[1], ["displacements of the atoms", "q"], &displacement, size)?;
        Ok(())
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::read(0)?;
    let lattice = SpinLattice::<ATOMS>::new(1.0, 2.0, 1.0, 0.5)?;
    let map = ProductMap(
        PowerMap::<_, ATOMS>(QuadraticMomentumMap::new(So3OnC2, Side::Left)),
        Identity(CotangentBundle(RealSpace::<ATOMS>)),
    );
    let gauss = Collective::new(RungeKutta::gauss(3)?, map, Automatic(lattice));
    let values = |z: &State| {
        let (spins, total) = (&z.0.0.0, z.0.0.0.iter().sum::<Vector3<f64>>());
        let length = spins.iter().map(|spin| (spin.norm() - 1.0).abs()).fold(0.0, larger);
        [lattice.energy(z), length, total.x, total.y, total.z, z.1.p.0.sum()]
    };
    let (initial, mut largest, mut states) = (values(&start()), [0.0; 6], Vec::new());
    for sample in gauss.trajectory(&start(), STEP)?.take(STEPS + 1) {
        let z = sample?.momentum;
        let now = values(&z);
        largest = std::array::from_fn(|i| larger(largest[i], (now[i] - initial[i]).abs()));
        states.push(z);
    }
    if let Some(path) = &arguments.picture {
        draw(path, &states)?;
    }
    println!("{ATOMS} atoms, largest deviations up to t = 30, steps of {STEP} (no dimensions)");
    for (name, deviation) in ["h", "|s_i|", "S₁", "S₂", "S₃", "Σ p_i"].iter().zip(largest) {
        println!("{name:>8} {deviation:>9.1e}");
    }
    let moved = states.iter().map(|z| z.1.q.amax()).fold(0.0, larger);
    let conserved =
        largest[0] < STEP.powi(6) + ROUND_OFF && largest[1..].iter().all(|x| *x < ROUND_OFF);
    if conserved && moved > 0.01 { Ok(()) } else { Err(format!("{largest:?}, {moved}").into()) }
}
