//! Measures the error of the kernel of collective Gauss methods, for the paper's top and for a generic one, on every
//! instruction set of the processor:
//!
//! ```text
//! cargo run --release -p measurements --bin collective_gauss
//! ```
//!
//! Errors are 2-norms of the error of μ, at t = 10 against eight stages of step 1/25 without a lift. The bench `one_top`
//! measures times.

use collective_integrators::{LiftFree, RungeKutta, Start};
use heavytop::{Body, CollectiveGauss, HeavyTop};
use lie_poisson::{InstructionSet, Se3Dual, euclidean_norm};
use momentum_map::DualQuaternions;
use nalgebra::Vector3;
use std::error::Error;

/// Returns μ and the mean number of iterations after the given number of steps.
fn run<I>(
    gauss: &I,
    start: &Se3Dual,
    step: f64,
    steps: u32,
) -> Result<(Se3Dual, f64), Box<dyn Error>>
where
    I: Start<Momentum = Se3Dual>,
{
    let (mut last, mut iterations) = (*start, 0);
    for sample in gauss.trajectory(start, step)?.take(steps as usize + 1) {
        let sample = sample?;
        (last, iterations) = (sample.momentum, iterations + sample.iterations);
    }
    Ok((last, iterations as f64 / f64::from(steps)))
}

fn main() -> Result<(), Box<dyn Error>> {
    let generic = Body {
        inertia: Vector3::new(1.5, 2.0, 1.0),
        mass: 1.0,
        gravity: 1.0,
        length: 1.0,
        center_of_mass: Vector3::new(0.6, 0.64, 0.48),
    };
    let tops = [
        ("Kovalevskaya", HeavyTop::kovalevskaya(1.0, 1.0)?),
        ("generic", HeavyTop::new(&generic)?),
    ];
    let start = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.5, 0.0, 0.75_f64.sqrt()));
    for (name, top) in tops {
        let reference = LiftFree::new(RungeKutta::gauss(8)?, DualQuaternions, top).compensated();
        let (exact, _) = run(&reference, &start, 0.04, 250)?;
        for set in InstructionSet::available() {
            for (stages, steps) in [(4, 160), (6, 80), (8, 50), (8, 40), (8, 32)] {
                let gauss = CollectiveGauss::new(stages, top)?.with_instructions(set)?;
                let step = 10.0 / f64::from(steps);
                let (end, iterations) = run(&gauss, &start, step, steps)?;
                let error = euclidean_norm(&(end - exact));
                println!(
                    "{name:12} {set:18} {stages} stages, step {step:.4}: error {error:.1e}, \
                     {iterations:.1} iterations per step"
                );
            }
        }
    }
    Ok(())
}
