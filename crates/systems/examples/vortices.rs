//! Integrates four point vortices on the unit sphere, on (so(3)∗)⁴, collectively through one Hopf map each.
//!
//! ```text
//! cargo run --release -p lie-poisson-systems --example vortices
//! ```
//!
//! Prints the largest deviations up to t = 50 s of the energy h, of the distances |x_i| from the centre and of the
//! moment of vorticity Σ k_i x_i. The Gauss method of order 6 conserves distances and moment to round-off, and h to
//! its order. With the explicit midpoint rule the vortices leave the sphere. The program fails if this does not hold.

use collective_integrators::{Collective, RungeKutta, Start};
use lie_poisson::{Hamiltonian, larger};
use lie_poisson_systems::PointVortices;
use momentum_map::{HOPF, PowerMap};
use nalgebra::Vector3;
use std::error::Error;

const STEP: f64 = 0.1;
const STEPS: usize = 500;

/// Returns the largest deviations of h, of the distances and of the moment of vorticity.
fn deviations(scheme: RungeKutta) -> Result<[f64; 3], Box<dyn Error>> {
    let vortices = PointVortices::new([1.0, -0.7, 1.5, 0.4])?;
    let positions = [
        Vector3::new(1.0, 0.2, -0.3),
        Vector3::new(-0.4, 1.0, 0.5),
        Vector3::new(0.1, -0.8, 0.7),
        Vector3::new(-0.5, -0.2, -1.0),
    ]
    .map(|x: Vector3<f64>| x.normalize());
    let start = vortices.momentum(&positions);
    let (energy, moment) = (vortices.value(&start), start.0.0.iter().sum::<Vector3<f64>>());
    let integrator = Collective::new(scheme, PowerMap::<_, 4>(HOPF), vortices);
    let mut largest = [0.0; 3];
    for sample in integrator.trajectory(&start, STEP)?.take(STEPS + 1) {
        let m = sample?.momentum;
        let distances = vortices.positions(&m).map(|x| (x.norm() - 1.0).abs());
        let now = [
            (vortices.value(&m) - energy).abs(),
            distances.into_iter().fold(0.0, larger),
            (m.0.0.iter().sum::<Vector3<f64>>() - moment).norm(),
        ];
        largest = std::array::from_fn(|i| larger(largest[i], now[i]));
    }
    Ok(largest)
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("largest deviations up to t = 50 s, steps of {STEP} s");
    println!("{:>18} {:>12} {:>10} {:>16}", "scheme", "h (m⁴/s²)", "|x_i| (m)", "Σ k_i x_i (m³/s)");
    let gauss = deviations(RungeKutta::gauss(3)?)?;
    let explicit = deviations(RungeKutta::explicit_midpoint())?;
    for (name, [energy, distance, moment]) in [("Gauss 6", gauss), ("explicit midpoint", explicit)]
    {
        println!("{name:>18} {energy:>12.2e} {distance:>10.2e} {moment:>16.2e}");
    }
    // The bounds are round-off over the run, and the order of the method.
    let conserved = gauss[0] < STEP.powi(6) && gauss[1] < 1e-12 && gauss[2] < 1e-12;
    let control = explicit[1] > 1e-9;
    if conserved && control { Ok(()) } else { Err(format!("{gauss:?}, {explicit:?}").into()) }
}
