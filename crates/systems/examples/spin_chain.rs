//! Integrates a periodic Heisenberg chain of 12 classical spins, without and with a magnetic field.
//!
//! ```text
//! cargo run --release -p lie-poisson-systems --example spin_chain
//! ```
//!
//! Prints the largest deviations up to t = 25 of the energy, of the lengths |s_i| and of the components of the total
//! spin S, in the units in which spins and J are numbers. The method conserves the lengths and, without field, S to
//! round-off, and h to its order. In a field along the third axis only S₃ is conserved, and S₁ and S₂ precess. The
//! program fails if this does not hold.

use collective_integrators::{Collective, RungeKutta, Start};
use lie_poisson::{Covector, Hamiltonian, Power, larger};
use lie_poisson_systems::{HeisenbergChain, Spins};
use momentum_map::{PowerMap, QuadraticMomentumMap, Side, So3OnC2};
use nalgebra::Vector3;
use std::error::Error;

const SPINS: usize = 12;
const STEP: f64 = 0.05;
const STEPS: usize = 500;
/// The bound of round-off over the run.
const ROUND_OFF: f64 = 1e-12;

/// Returns the largest deviations of h, |s_i|, S₁, S₂, S₃ in a field.
fn deviations(field: Vector3<f64>) -> Result<[f64; 5], Box<dyn Error>> {
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
    let (initial, mut largest) = (values(&start), [0.0; 5]);
    for sample in gauss.trajectory(&start, STEP)?.take(STEPS + 1) {
        let now = values(&sample?.momentum);
        largest = std::array::from_fn(|i| larger(largest[i], (now[i] - initial[i]).abs()));
    }
    Ok(largest)
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("largest deviations up to t = 25, steps of {STEP}, J = 1 (no dimensions)");
    let [a, b, c, d, e] = ["h", "|s_i|", "S₁", "S₂", "S₃"];
    println!("{:>8} {a:>9} {b:>9} {c:>9} {d:>9} {e:>9}", "field");
    let (free, held) = (deviations(Vector3::zeros())?, deviations(Vector3::z())?);
    for (field, [h, length, x, y, z]) in [("none", free), ("(0,0,1)", held)] {
        println!("{field:>8} {h:>9.1e} {length:>9.1e} {x:>9.1e} {y:>9.1e} {z:>9.1e}");
    }
    let energies = free[0] < STEP.powi(6) + ROUND_OFF && held[0] < STEP.powi(6) + ROUND_OFF;
    let without = free[1..].iter().all(|deviation| *deviation < ROUND_OFF);
    let within = held[1] < ROUND_OFF && held[4] < ROUND_OFF && held[2] > 0.1;
    let conserved = energies && without && within;
    if conserved { Ok(()) } else { Err(format!("{free:?}, {held:?}").into()) }
}
