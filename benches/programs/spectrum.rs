//! The change of the eigenvalues of W over 10⁴ steps of each method for Zeitlin's model:
//!
//! ```text
//! cargo run --release -p measurements --bin spectrum -- [SIZE [STEPS]]
//! ```
//!
//! The start has harmonics of degree 1 to 8 and a largest eigenvalue near 1 (default: SIZE 32). The numbers are the
//! largest change of an eigenvalue, relative to the largest eigenvalue, and the relative change of the energy. The
//! program fails if a method that conserves the spectrum changes it by more than a rounding error in each hundred steps.

use collective_integrators::{Direct, Integrator, RungeKutta};
use lie_poisson::State;
use lie_poisson_systems::isospectral_flows::{
    CommutatorField, ExponentialMidpoint, GaussMagnus, IsospectralRungeKutta, LargeSkewHermitian,
};
use lie_poisson_systems::num_complex::Complex;
use lie_poisson_systems::{VorticityCoefficients, Zeitlin};
use nalgebra::DMatrix;
use std::error::Error;

const STEP: f64 = 0.1;

/// Returns the eigenvalues of −iW in increasing order.
fn spectrum(w: &LargeSkewHermitian) -> Vec<f64> {
    let entry = |j: usize, k: usize| -Complex::<f64>::I * w.at(j, k);
    let hermitian = DMatrix::from_fn(w.size(), w.size(), entry);
    let mut eigenvalues = hermitian.symmetric_eigenvalues().as_slice().to_vec();
    eigenvalues.sort_by(f64::total_cmp);
    eigenvalues
}

/// Makes the steps, prints the changes and returns that of the spectrum.
fn measure<I: Integrator<State = LargeSkewHermitian>>(
    name: &str,
    method: &I,
    fluid: &Zeitlin,
    start: &LargeSkewHermitian,
    steps: u32,
) -> Result<f64, Box<dyn Error>> {
    let (mut w, mut workspace) = (start.clone(), method.workspace());
    for _ in 0..steps {
        method.step_in_place(&mut w, STEP, &mut workspace)?;
    }
    let (before, after) = (spectrum(start), spectrum(&w));
    let largest = before.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let change = before
        .iter()
        .zip(&after)
        .map(|(a, b)| (a - b).abs() / largest)
        .fold(0.0, lie_poisson::larger);
    let energy = fluid.energy(&w) / fluid.energy(start) - 1.0;
    println!("{name:28} {change:10.1e} {energy:10.1e}");
    Ok(change)
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let size: usize = arguments.first().map_or(Ok(32), |size| size.parse())?;
    let steps: u32 = arguments.get(1).map_or(Ok(10_000), |steps| steps.parse())?;
    let fluid = Zeitlin::new(size)?;
    let omega = VorticityCoefficients::from_fn(size, |l, m| {
        let x = (5 * l + m) as f64;
        let value = Complex::new((3.1 * x).sin(), (5.3 * x).cos());
        if (1..=8).contains(&l) { value } else { Complex::ZERO }
    });
    let mut start = fluid.vorticity(&omega);
    let largest = spectrum(&start).iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    start.scale_in_place(1.0 / largest);
    println!("N = {size}, {steps} steps of {STEP}");
    println!("{:28} {:>10} {:>10}", "method", "spectrum", "energy");
    let run = |name: &str, change: Result<f64, Box<dyn Error>>| -> Result<(), Box<dyn Error>> {
        let allowed = f64::EPSILON * (1.0 + f64::from(steps) / 100.0);
        let change = change?;
        if change <= allowed {
            Ok(())
        } else {
            Err(format!("{name}: {change:e} is above {allowed:e}").into())
        }
    };
    for stages in [1, 2, 3] {
        let method = GaussMagnus::new(stages, &fluid)?.with_tolerance(1e-8);
        let name = format!("Gauss–Magnus of order {}", method.order());
        run(&name, measure(&name, &method, &fluid, &start, steps))?;
    }
    let name = "exponential midpoint";
    run(name, measure(name, &ExponentialMidpoint::new(&fluid), &fluid, &start, steps))?;
    let name = "collective Gauss-4";
    let gauss = IsospectralRungeKutta::new(RungeKutta::gauss(2)?, &fluid);
    run(name, measure(name, &gauss, &fluid, &start, steps))?;
    let direct = Direct::new(RungeKutta::rk4(), CommutatorField::new(&fluid));
    measure("RK4, direct", &direct, &fluid, &start, steps)?;
    Ok(())
}
