//! Integrates Kida's elliptical vortex on so(2, 1)∗, collectively through the Clebsch map T∗so(2, 1) → so(2, 1)∗.
//!
//! ```text
//! cargo run --release -p lie-poisson-systems --example kida_vortex
//! ```
//!
//! Prints the largest relative deviations of the energy h and of the Casimir a²b² up to t = 100 s and t = 1000 s, for steps
//! of 0.1 s. The Gauss method of order 4 conserves the Casimir to round-off, and h does not drift. With the classical
//! Runge–Kutta method of order 4 on the equations both drift in proportion to the time. The program fails if this does not
//! hold.

use collective_integrators::{Collective, Direct, HamiltonianField, RungeKutta, Start};
use lie_poisson::{Casimirs, Covector, Hamiltonian, InfinitesimalAdjoint, LiePoisson, larger};
use lie_poisson_systems::{KidaVortex, So21};
use momentum_map::{Side, clebsch_realisation};
use nalgebra::Vector3;
use std::error::Error;

const STEP: f64 = 0.1;

/// Returns the largest relative deviations of h and of the Casimir, up to t = 100 s and up to t = 1000 s.
fn deviations<I>(integrator: &I, vortex: &KidaVortex) -> Result<[[f64; 2]; 2], Box<dyn Error>>
where
    I: Start<Momentum = Covector<Vector3<f64>>>,
{
    let start = KidaVortex::momentum(1.5, 0.5, 0.3)?;
    let quantities = |mu: &_| [vortex.value(mu), So21.casimir(0, mu)];
    let (initial, mut largest, mut early) = (quantities(&start), [0.0; 2], [0.0; 2]);
    for (n, sample) in integrator.trajectory(&start, STEP)?.take(10_001).enumerate() {
        let now = quantities(&sample?.momentum);
        largest = std::array::from_fn(|i| larger(largest[i], (now[i] / initial[i] - 1.0).abs()));
        if n <= 1000 {
            early = largest;
        }
    }
    Ok([early, largest])
}

fn main() -> Result<(), Box<dyn Error>> {
    let vortex = KidaVortex::new(1.0, 0.1, 0.05)?;
    let map = clebsch_realisation(InfinitesimalAdjoint(So21), Side::Left)?;
    let gauss = deviations(&Collective::new(RungeKutta::gauss(2)?, map, vortex), &vortex)?;
    let field = HamiltonianField { space: LiePoisson::plus(So21), hamiltonian: vortex };
    let direct = deviations(&Direct::new(RungeKutta::rk4(), field), &vortex)?;
    println!("largest relative deviations, steps of {STEP} s");
    println!("{:>18} {:>8} {:>10} {:>10}", "scheme", "t (s)", "h", "a²b²");
    for (name, rows) in [("Gauss 4, Clebsch", gauss), ("RK4, direct", direct)] {
        for (time, [energy, casimir]) in [100, 1000].iter().zip(rows) {
            println!("{name:>18} {time:>8} {energy:>10.2e} {casimir:>10.2e}");
        }
    }
    let conserved = gauss[1][1] < 1e-12 && gauss[1][0] < 1.5 * gauss[0][0];
    let control = direct[1][0] > 5.0 * direct[0][0] && direct[1][1] > 5.0 * direct[0][1];
    if conserved && control { Ok(()) } else { Err(format!("{gauss:?}, {direct:?}").into()) }
}
