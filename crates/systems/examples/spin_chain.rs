//! Integrates a periodic Heisenberg chain of 12 classical spins, without and with a magnetic field.
//!
//! ```text
//! cargo run --release -p systems-examples --bin spin_chain -- [PICTURE]
//! ```
//!
//! Prints the largest deviations up to t = 25 of the energy, of the lengths |s_i| and of the components of the total
//! spin S, in the units in which spins and J are numbers. The method conserves the lengths and, without field, S to
//! round-off, and h to its order. In a field along the third axis only S₃ is conserved, and S₁ and S₂ precess. The
//! program fails if this does not hold. With a PICTURE (a path ending in .png or .svg), draws the first component of each
//! spin against time, without and with the field.

mod pictures;

use collective_integrators::{Collective, RungeKutta, Start};
use lie_poisson::{Covector, Hamiltonian, Power, larger};
use lie_poisson_systems::{HeisenbergChain, Spins};
use momentum_map::{PowerMap, QuadraticMomentumMap, Side, So3OnC2};
use nalgebra::Vector3;
use pictures::arguments::Arguments;
use pictures::canvas::{self, PIXEL};
use pictures::raster::{self, Sites};
use std::error::Error;
use std::path::Path;

const SPINS: usize = 12;
const STEP: f64 = 0.05;
const STEPS: usize = 500;
/// The bound of round-off over the run.
const ROUND_OFF: f64 = 1e-12;

/// The spins at the time of each step.
type Motion = Vec<[Vector3<f64>; SPINS]>;

/// Returns the largest deviations of h, |s_i|, S₁, S₂, S₃ in a field, and the spins.
fn run(field: Vector3<f64>) -> Result<([f64; 5], Motion), Box<dyn Error>> {
    let chain = HeisenbergChain::<SPINS>::new(1.0, field)?;
    let mut angle = 0.0_f64;
    let start = Covector(Power([(); SPINS].map(|()| {
        angle += 0.7;
        Vector3::new(angle.cos(), angle.sin(), 0.4 + (3.0 * angle).sin()).normalize()
    })));
    let values = |s: &Spins<SPINS>| {
        let total: Vector3<f64> = s.0.0.iter().sum();
        let lengths = s.0.0.iter().map(|spin| (spin.norm() - 1.0).abs()).fold(0.0, larger);
        [chain.value(s), lengths, total.x, total.y, total.z]
    };
    let map = PowerMap::<_, SPINS>(QuadraticMomentumMap::new(So3OnC2, Side::Left));
    let gauss = Collective::new(RungeKutta::gauss(3)?, map, chain);
    let (initial, mut largest, mut motion) = (values(&start), [0.0; 5], Motion::new());
    for sample in gauss.trajectory(&start, STEP)?.take(STEPS + 1) {
        let s = sample?.momentum;
        let now = values(&s);
        largest = std::array::from_fn(|i| larger(largest[i], (now[i] - initial[i]).abs()));
        motion.push(s.0.0);
    }
    Ok((largest, motion))
}

fn draw(path: &Path, motions: [&Motion; 2]) -> Result<(), Box<dyn Error>> {
    let heading = [
        "A Heisenberg chain of 12 spins, J = 1",
        "Gauss method of order 6 through Hopf maps, steps of 0.05",
    ];
    canvas::save(path, heading, [1100, 760], |area| {
        let titles = [
            "without field",
            "in the field B = (0, 0, 1): every spin turns about the third axis too",
        ];
        for ((panel, motion), title) in area.split_evenly((2, 1)).iter().zip(motions).zip(titles) {
            let (left, right) = panel.split_horizontally(980 * PIXEL);
            let sites = Sites {
                title,
                time: STEP * STEPS as f64,
                name: "number i of the spin",
                count: SPINS,
            };
            let values = |i: usize, n: usize| motion[n][i].x;
            sites.draw(&left, motion.len(), values, 1.0)?;
            raster::scale(&right, "s₁", 1.0, [50 * PIXEL, 270 * PIXEL])?;
        }
        Ok(())
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::read(0)?;
    println!("largest deviations up to t = 25, steps of {STEP}, J = 1 (no dimensions)");
    let [a, b, c, d, e] = ["h", "|s_i|", "S₁", "S₂", "S₃"];
    println!("{:>8} {a:>9} {b:>9} {c:>9} {d:>9} {e:>9}", "field");
    let ((free, alone), (held, turned)) = (run(Vector3::zeros())?, run(Vector3::z())?);
    if let Some(path) = &arguments.picture {
        draw(path, [&alone, &turned])?;
    }
    for (field, [h, length, x, y, z]) in [("none", free), ("(0,0,1)", held)] {
        println!("{field:>8} {h:>9.1e} {length:>9.1e} {x:>9.1e} {y:>9.1e} {z:>9.1e}");
    }
    let energies = free[0] < STEP.powi(6) + ROUND_OFF && held[0] < STEP.powi(6) + ROUND_OFF;
    let without = free[1..].iter().all(|deviation| *deviation < ROUND_OFF);
    let within = held[1] < ROUND_OFF && held[4] < ROUND_OFF && held[2] > 0.1;
    let conserved = energies && without && within;
    if conserved { Ok(()) } else { Err(format!("{free:?}, {held:?}").into()) }
}
