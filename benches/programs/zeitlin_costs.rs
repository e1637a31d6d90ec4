//! Times and errors of the methods for Zeitlin's model, for `benches/quflow`:
//!
//! ```text
//! cargo run --release -p measurements --bin zeitlin_costs -- SIZE END FOLDER
//! ```
//!
//! The start has coefficients without a pattern of degree 1 to 20 and a root mean square vorticity of 1. The folder receives the
//! matrices at the start and at the end (`start.bin`, `end.bin`: real and imaginary part of each entry, column by
//! column). Each method prints one line: name, steps, seconds, error relative to the largest entry.

use collective_integrators::{Direct, Integrator, RungeKutta};
use lie_poisson::State;
use lie_poisson_systems::isospectral_flows::{
    CommutatorField, ExponentialMidpoint, GaussMagnus, LargeSkewHermitian,
};
use lie_poisson_systems::num_complex::Complex;
use lie_poisson_systems::{VorticityCoefficients, Zeitlin};
use std::error::Error;
use std::fs;
use std::path::Path;
use std::time::Instant;

const DEGREES: usize = 20;

/// Returns the start.
fn start(fluid: &Zeitlin, size: usize) -> LargeSkewHermitian {
    let omega = VorticityCoefficients::from_fn(size, |l, m| {
        let x = (21 * l + m) as f64;
        let value = Complex::new((3.1 * x * x).sin(), (5.3 * x * x).cos());
        if (1..=DEGREES).contains(&l) { value } else { Complex::ZERO }
    });
    let mut w = fluid.vorticity(&omega);
    let mean = (fluid.enstrophy(&w) / (4.0 * std::f64::consts::PI)).sqrt();
    w.scale_in_place(1.0 / mean);
    w
}

/// The seconds of a run and its end, or the reason why it has none.
type Outcome = Result<(f64, LargeSkewHermitian), Box<dyn Error>>;

/// Returns the seconds that a run takes, and its end. The best of several times for short runs.
fn run<I: Integrator<State = LargeSkewHermitian>>(
    integrator: &I,
    start: &LargeSkewHermitian,
    end: f64,
    steps: u32,
) -> Outcome {
    let (mut best, mut w) = (f64::INFINITY, start.clone());
    let begin = Instant::now();
    for _ in 0..5 {
        let mut workspace = integrator.workspace();
        w.assign(start);
        let now = Instant::now();
        for _ in 0..steps {
            integrator.step_in_place(&mut w, end / f64::from(steps), &mut workspace)?;
        }
        best = best.min(now.elapsed().as_secs_f64());
        if begin.elapsed().as_secs_f64() > 3.0 {
            break;
        }
    }
    Ok((best, w))
}

fn error(a: &LargeSkewHermitian, b: &LargeSkewHermitian) -> f64 {
    let largest = |f: &dyn Fn(usize) -> f64| {
        (0..a.dimension()).map(|i| f(i).abs()).fold(0.0, lie_poisson::larger)
    };
    largest(&|i| a.coordinate(i) - b.coordinate(i)) / largest(&|i| b.coordinate(i))
}

fn save(path: &Path, w: &LargeSkewHermitian) -> std::io::Result<()> {
    let parts = w.matrix().real().iter().zip(w.matrix().imaginary());
    fs::write(
        path,
        parts.flat_map(|(re, im)| [re, im]).flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>(),
    )
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [size, end, folder] = arguments.as_slice() else {
        return Err("three arguments are needed: SIZE END FOLDER".into());
    };
    let (size, end, folder): (usize, f64, &Path) = (size.parse()?, end.parse()?, Path::new(folder));
    let fluid = Zeitlin::new(size)?;
    let start = start(&fluid, size);
    let per_unit = |steps: f64| ((steps * end).ceil() as u32).max(1);
    let best = GaussMagnus::new(3, &fluid)?;
    let (_, reference) = run(&best, &start, end, per_unit(if size <= 128 { 256.0 } else { 64.0 }))?;
    fs::create_dir_all(folder)?;
    save(&folder.join("start.bin"), &start)?;
    save(&folder.join("end.bin"), &reference)?;
    let print = |name: &str, steps: u32, outcome: Outcome| match outcome {
        Ok((seconds, w)) => {
            println!("{name}\t{steps}\t{seconds:.6}\t{:.3e}", error(&w, &reference));
        }
        Err(reason) => println!("{name}\t{steps}\t-\t{reason}"),
    };
    // Sweeps for stages converge for steps below the reciprocal of the largest rate of W, which grows with N. Those of
    // the exponential midpoint rule converge for longer steps.
    let (slow, rates) = if size <= 128 {
        ([6.0, 8.0, 12.0], [4.0, 6.0, 9.0])
    } else {
        ([6.0, 8.0, 10.0], [8.0, 12.0, 16.0])
    };
    for rate in slow {
        let midpoint = ExponentialMidpoint::new(&fluid).with_tolerance(1e-6);
        print("exponential midpoint", per_unit(rate), run(&midpoint, &start, end, per_unit(rate)));
    }
    for rate in rates {
        let steps = per_unit(rate);
        for (stages, tolerance) in [(2, 1e-5), (3, 1e-7), (3, 1e-9)] {
            let method = GaussMagnus::new(stages, &fluid)?.with_tolerance(tolerance);
            let name = format!("Gauss–Magnus of order {}", method.order());
            print(&name, steps, run(&method, &start, end, steps));
        }
    }
    for rate in [4.0, 8.0, 16.0, 48.0, 72.0, 104.0] {
        let direct = Direct::new(RungeKutta::rk4(), CommutatorField::new(&fluid));
        print("RK4, direct", per_unit(rate), run(&direct, &start, end, per_unit(rate)));
    }
    Ok(())
}
