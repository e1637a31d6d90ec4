//! Computes the nutation of a Lagrange top, collectively on T∗C² and by its closed form in Jacobi's elliptic
//! functions.
//!
//! ```text
//! cargo run --release -p heavytop --example nutation
//! ```
//!
//! Prints the height Γ₃ of both every 2 s up to t = 20 s, between the turning points. The Gauss method of order 12
//! follows the closed form to round-off, the implicit midpoint rule to its second order. The program fails if Gauss
//! is further away than 1e-11, or the midpoint rule as close as that.

use collective_integrators::{Collective, RungeKutta, Start};
use heavytop::{HeavyTop, LagrangeNutation, SpinorRealisation};
use lie_poisson::{Se3Dual, larger};
use nalgebra::Vector3;
use std::error::Error;

const STEP: f64 = 0.1;
const STEPS: usize = 200;
/// The sum of round-off over the run and the error of the method of order 12.
const BOUND: f64 = 1e-11;

fn main() -> Result<(), Box<dyn Error>> {
    // I₁ = I₂ = 2 kg m², I₃ = 1 kg m², m g l = 1 J
    let top = HeavyTop::lagrange(2.0, 1.0, 1.0)?;
    let start = Se3Dual::new(Vector3::new(0.5, 0.2, 3.0), Vector3::new(0.6, 0.0, 0.8));
    let exact = LagrangeNutation::new(&top, &start)?;
    let gauss = Collective::new(RungeKutta::gauss(6)?, SpinorRealisation, top);
    let midpoint = Collective::new(RungeKutta::implicit_midpoint(), SpinorRealisation, top);

    let (lowest, highest) = exact.turning_points();
    println!("Γ₃ between {lowest:.6} and {highest:.6}, period {:.6} s", exact.period());
    println!("{:>6} {:>12} {:>12} {:>12}", "t (s)", "Γ₃ exact", "Gauss 12 −", "midpoint −");
    let (mut gauss_error, mut midpoint_error) = (0.0, 0.0);
    let runs = gauss.trajectory(&start, STEP)?.zip(midpoint.trajectory(&start, STEP)?);
    for (fine, coarse) in runs.take(STEPS + 1) {
        let (fine, coarse) = (fine?, coarse?);
        let height = exact.height(fine.time);
        let fine_gap = fine.momentum.0.1.z - height;
        let coarse_gap = coarse.momentum.0.1.z - height;
        if fine.step.is_multiple_of(20) {
            println!("{:>6.1} {height:>12.8} {fine_gap:>12.2e} {coarse_gap:>12.2e}", fine.time);
        }
        gauss_error = larger(gauss_error, fine_gap.abs());
        midpoint_error = larger(midpoint_error, coarse_gap.abs());
    }
    println!("{:>6} {:>12} {gauss_error:>12.2e} {midpoint_error:>12.2e}", "worst", "");
    if gauss_error < BOUND && midpoint_error > BOUND {
        Ok(())
    } else {
        Err(format!("errors {gauss_error:e} and {midpoint_error:e}, bound {BOUND:e}").into())
    }
}
