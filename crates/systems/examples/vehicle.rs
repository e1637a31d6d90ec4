//! Integrates a torpedo without fins in an ideal fluid (Kirchhoff's equations). It does not keep moving along its
//! long axis, but turns broadside on, since the fluid that it drags is heavier there.
//!
//! ```text
//! cargo run --release -p lie-poisson-systems --example vehicle
//! ```
//!
//! Prints, every 4 s up to t = 40 s, the angle of the impulse P with the long axis, which grows from 1° beyond 150°
//! and returns. Prints also the deviations of h, |P|² and Π·P, which the collective Gauss method of order 6, in its
//! form without a lift, keeps below 1e-12. The program fails if a deviation is larger, or the angle stays below 90°.

use collective_integrators::{LiftFree, RungeKutta, Start};
use lie_poisson::{Covector, Hamiltonian, Pair, Se3Dual, larger};
use lie_poisson_systems::Kirchhoff;
use momentum_map::DualQuaternions;
use nalgebra::{Matrix3, Vector3};
use std::error::Error;

const STEP: f64 = 0.05;
const STEPS: usize = 800;
/// The bound of round-off over the run; the error of the method in h is smaller at this step.
const BOUND: f64 = 1e-12;

fn main() -> Result<(), Box<dyn Error>> {
    // Body and fluid have moments of 2, 2, 1 kg m² and masses of 3, 3, 1.5 kg; the long axis is the third.
    let moments = Matrix3::from_diagonal(&Vector3::new(0.5, 0.5, 1.0));
    let masses = Matrix3::from_diagonal(&Vector3::new(1.0 / 3.0, 1.0 / 3.0, 1.0 / 1.5));
    let vehicle = Kirchhoff::new(moments, Matrix3::zeros(), masses)?;
    let tilt = 1.0_f64.to_radians();
    let start =
        Se3Dual::new(Vector3::new(0.0, 0.0, 0.05), Vector3::new(tilt.sin(), 0.0, tilt.cos()));
    let conserved = |mu: &Se3Dual| {
        let Covector(Pair(pi, p)) = mu;
        [vehicle.value(mu), p.norm_squared(), pi.dot(p)]
    };
    let gauss = LiftFree::new(RungeKutta::gauss(3)?, DualQuaternions, vehicle);

    println!(
        "{:>6} {:>10} {:>11} {:>16} {:>18}",
        "t (s)", "angle (°)", "Δh (J)", "Δ|P|² (kg²m²/s²)", "ΔΠ·P (kg²m³/s²)"
    );
    let (initial, mut largest, mut widest) = (conserved(&start), [0.0; 3], 0.0);
    for sample in gauss.trajectory(&start, STEP)?.take(STEPS + 1) {
        let sample = sample?;
        let Covector(Pair(_, p)) = sample.momentum;
        let angle = p.angle(&Vector3::z()).to_degrees();
        let values = conserved(&sample.momentum);
        let [h, square, level] = std::array::from_fn(|i| values[i] - initial[i]);
        if sample.step.is_multiple_of(80) {
            println!(
                "{:>6.1} {angle:>10.3} {h:>11.2e} {square:>16.2e} {level:>18.2e}",
                sample.time
            );
        }
        widest = larger(widest, angle);
        for (worst, deviation) in largest.iter_mut().zip([h, square, level]) {
            *worst = larger(*worst, deviation.abs());
        }
    }
    if largest.iter().all(|worst| *worst < BOUND) && widest > 90.0 {
        Ok(())
    } else {
        Err(format!("deviations {largest:?}, bound {BOUND:e}, widest angle {widest}°").into())
    }
}
