//! Integrates a Hamiltonian on se(3)∗ that is given as a closure: a rigid body with a heavy end and a quartic spring
//! to the vertical. No derivative is written down.
//!
//! ```text
//! cargo run --release -p heavytop --example custom
//! ```
//!
//! Prints the largest deviations up to t = 50 s of the energy and the Casimirs |Γ|² and Π·Γ. The collective Gauss
//! method of order 4 conserves the Casimirs to round-off and the energy to its order. The classical Runge–Kutta
//! method, which is collective too, conserves none of them. The program fails if this does not hold.

use collective_integrators::{Collective, RungeKutta, Start};
use heavytop::{HeavyTopSpace, SpinorRealisation};
use lie_poisson::{Casimirs, Covector, Hamiltonian, Pair, Se3, Se3Dual, from_closure, larger};
use nalgebra::Vector3;
use std::error::Error;

const STEP: f64 = 0.05;
const STEPS: usize = 1000;

/// Returns the largest deviations of h, |Γ|² and Π·Γ under a scheme.
fn deviations(scheme: RungeKutta) -> Result<[f64; 3], Box<dyn Error>> {
    // h = ½ Π·(I⁻¹Π) + Γ₃ + Γ₁⁴/2 joules, with moments of 2, 1.6 and 1 kg m²
    let energy = from_closure::<HeavyTopSpace, _>(|Covector(Pair(pi, gamma))| {
        let kinetic = pi.x * pi.x * 0.25 + pi.y * pi.y * 0.3125 + pi.z * pi.z * 0.5;
        let square = gamma.x * gamma.x;
        kinetic + gamma.z + square * square * 0.5
    });
    let start = Se3Dual::new(Vector3::new(0.4, -0.8, 1.6), Vector3::new(0.6, 0.0, -0.8));
    let algebra = Se3::default();
    let values = |mu: &Se3Dual| [energy.value(mu), algebra.casimir(0, mu), algebra.casimir(1, mu)];
    let integrator = Collective::new(scheme, SpinorRealisation, energy);
    let (initial, mut largest) = (values(&start), [0.0; 3]);
    for sample in integrator.trajectory(&start, STEP)?.take(STEPS + 1) {
        let now = values(&sample?.momentum);
        largest = std::array::from_fn(|i| larger(largest[i], (now[i] - initial[i]).abs()));
    }
    Ok(largest)
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("largest deviations up to t = 50 s, steps of {STEP} s");
    println!("{:>10} {:>10} {:>10} {:>14}", "scheme", "h (J)", "|Γ|²", "Π·Γ (kg m²/s)");
    let gauss = deviations(RungeKutta::gauss(2)?)?;
    let explicit = deviations(RungeKutta::rk4())?;
    for (name, [energy, square, level]) in [("Gauss 4", gauss), ("RK4", explicit)] {
        println!("{name:>10} {energy:>10.2e} {square:>10.2e} {level:>14.2e}");
    }
    // The bounds are round-off over the run, and the order of the method.
    let conserved = gauss[0] < STEP.powi(4) && gauss[1] < 1e-12 && gauss[2] < 1e-12;
    let control = explicit[1] > 1e-10 && explicit[2] > 1e-10;
    if conserved && control { Ok(()) } else { Err(format!("{gauss:?}, {explicit:?}").into()) }
}
