//! Follows a heavy top at a temperature, by the collective midpoint rule, and counts the steps that fail.
//!
//! ```text
//! cargo run --release -p heavytop --example langevin -- [STEPS [STEP [TEMPERATURE [BOUND]]]]
//! ```
//!
//! The top has I = (2, 3/2, 1), m g l = 1 and the friction θ = 0.7, in units without names; its slowest time is 1. By
//! default a million steps of 0.05 are made at kT = 0.8, with increments of the noise cut at six standard deviations;
//! the bound `inf` cuts none. Prints the means of the kinetic energy and of the height of the centre of mass beside
//! those of Gibbs's measure, the largest change of the Casimirs, how fast the top turned, and the sweeps of a step. The
//! program fails if a step does, and says at which rate of rotation.

use collective_integrators::{BrownianPaths, Integrator, Noisy, RungeKutta, Start};
use heavytop::{Body, HeavyTop, SpinorRealisation};
use lie_poisson::{
    Autonomous, Covector, DoubleBracket, InnerProduct, IsotropicNoise, LiePoisson, Pair,
    PathNumber, Se3, Time, larger,
};
use nalgebra::Vector3;
use std::error::Error;
use std::time::Instant;

const FRICTION: f64 = 0.7;
/// The means of ½Π·Ω and Γ·c at kT = 0.8 by quadrature.
const GIBBS: [f64; 2] = [0.831_776_45, -0.385_231_66];

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |place: usize, default: f64| {
        arguments.get(place).map_or(Ok(default), |argument| argument.parse::<f64>())
    };
    let (steps, step) = (number(0, 1e6)? as u64, number(1, 0.05)?);
    let (temperature, bound) = (number(2, 0.8)?, number(3, 6.0)?);

    let (inertia, centre) = (Vector3::new(2.0, 1.5, 1.0), Vector3::new(0.6, 0.0, 0.8));
    let body = Body { inertia, mass: 1.0, gravity: 1.0, length: 1.0, center_of_mass: centre };
    let (space, inner_product) = (LiePoisson::minus(Se3::default()), InnerProduct::euclidean());
    let noise = IsotropicNoise::thermal(inner_product.clone(), (FRICTION, temperature))?;
    let top = Autonomous(HeavyTop::new(&body)?);
    let field = DoubleBracket::new(space, top, FRICTION, inner_product)?;
    let paths = BrownianPaths::new(2, step)?.with_bound(bound)?;
    let langevin =
        Noisy::new(RungeKutta::implicit_midpoint(), SpinorRealisation, field, noise, paths);

    // |Γ|² = 1 and Π·Γ = 0.3.
    let start = Covector(Pair(Vector3::new(0.5, 0.2, 0.3), Vector3::z()));
    let clock = Pair(PathNumber(1.0), Time(0.0));
    let mut state = langevin.start(&Pair(start, clock))?;
    let mut workspace = langevin.workspace();
    let (mut sums, mut lost, mut fastest) = ([0.0; 2], [0.0; 2], 0.0);
    let (mut sweeps, mut most) = (0, 0);
    let begin = Instant::now();
    for n in 0..steps {
        let made = match langevin.step(&state, step, &mut workspace) {
            Ok(made) => made,
            Err(error) => {
                let Pair(Covector(Pair(pi, _)), _) = langevin.momentum(&state);
                let turned = pi.component_div(&inertia).norm() * step;
                return Err(format!("step {n}, which turns by {turned:.2} rad: {error}").into());
            }
        };
        state = made.point;
        (sweeps, most) = (sweeps + made.iterations, most.max(made.iterations));
        let Pair(Covector(Pair(pi, gamma)), _) = langevin.momentum(&state);
        let omega = pi.component_div(&inertia);
        sums[0] += 0.5 * pi.dot(&omega);
        sums[1] += gamma.dot(&centre);
        lost[0] = larger(lost[0], (gamma.norm_squared() - 1.0).abs());
        lost[1] = larger(lost[1], (pi.dot(&gamma) - 0.3).abs());
        fastest = larger(fastest, omega.norm());
    }
    let (time, count) = (begin.elapsed().as_secs_f64(), steps as f64);
    println!("{steps} steps of {step} at kT = {temperature} in {time:.1} s");
    println!("sweeps of a step: {:.1}, at most {most}", sweeps as f64 / count);
    println!("fastest turn of a step: {:.2} rad", fastest * step);
    println!("largest change of |Γ|² {:.1e}, of Π·Γ {:.1e}", lost[0], lost[1]);
    println!("⟨½Π·Ω⟩ = {:.5}, ⟨Γ·c⟩ = {:.5}", sums[0] / count, sums[1] / count);
    println!("at kT = 0.8 the measure of Gibbs has {:.5} and {:.5}", GIBBS[0], GIBBS[1]);
    Ok(())
}
