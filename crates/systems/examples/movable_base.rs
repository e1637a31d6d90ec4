//! Integrates a heavy top on a base that moves freely, collectively through a Clebsch map to (se(3) ⋉ R³)∗.
//!
//! ```text
//! cargo run --release -p systems-examples --bin movable_base -- [PICTURE]
//! ```
//!
//! The same top of 1 kg starts with the same spin on bases of 0.5, 3 and 10⁹ kg. The last one is a fixed point. Prints the
//! largest deviations up to t = 20 s of the energy h and of the Casimirs |P|², P·Γ and |Γ|². The Gauss method of order 6
//! conserves the Casimirs to round-off, and h does not drift. The program fails if this does not hold, or if the top on
//! the heavy base does not move as that on a fixed point. With a PICTURE (a path ending in .png or .svg), draws the
//! inclination of the axis against time for the three bases.

mod pictures;

use collective_integrators::{Collective, LiftFree, RungeKutta, Start};
use lie_poisson::{
    Covector, Diagonal, Hamiltonian, InfinitesimalAdjoint, LiePoisson, Pair, Se3Dual, larger,
};
use lie_poisson_systems::{Gyrostat, MovableBaseAlgebra, MovableBaseTop};
use momentum_map::{DualQuaternions, Side, clebsch_realisation};
use nalgebra::Vector3;
use pictures::arguments::Arguments;
use pictures::canvas;
use pictures::colours::{BLUE, ORANGE, RED};
use pictures::curves::{Curve, curves};
use std::error::Error;

const STEP: f64 = 0.025;
const STEPS: usize = 800;
/// The bound of round-off over the run, for Casimirs of the size of 1.
const ROUND_OFF: f64 = 1e-11;
const MOMENTS: Vector3<f64> = Vector3::new(1.5, 1.5, 0.5);
const CENTRE: Vector3<f64> = Vector3::new(0.0, 0.0, 0.8);
const GRAVITY: f64 = 9.81;
const BASES: [f64; 3] = [0.5, 3.0, 1e9];

/// Returns Π and Γ at the start: spin about the axis, which is inclined by 0.5 rad.
fn start() -> (Vector3<f64>, Vector3<f64>) {
    let (sin, cos) = 0.5_f64.sin_cos();
    (Vector3::new(0.0, 0.0, 6.0), Vector3::new(sin, 0.0, cos))
}

/// What a run gives: the inclination of the axis (°) against time, and the largest deviations of h in the first and in both
/// halves of the time, of |P|², P·Γ and |Γ|².
struct Run {
    inclination: Vec<(f64, f64)>,
    changes: [f64; 5],
}

fn inclination(gamma: &Vector3<f64>) -> f64 {
    gamma.angle(&Vector3::z()).to_degrees()
}

fn run(base: f64) -> Result<Run, Box<dyn Error>> {
    let top = MovableBaseTop::new(MOMENTS, [1.0, base], GRAVITY, CENTRE)?;
    let (pi, gamma) = start();
    // The light base moves at 0.2 m/s at first; the heavy one is at rest.
    let push =
        if base < 100.0 { Vector3::new(0.2, 0.1, 0.0) * (1.0 + base) } else { Vector3::zeros() };
    let mu = Covector(Pair(Pair(pi, push), gamma));
    let adjoint = InfinitesimalAdjoint(MovableBaseAlgebra::default());
    let map = clebsch_realisation(Diagonal::<_, 2>(adjoint), Side::Right)?;
    let gauss = Collective::new(RungeKutta::gauss(3)?, map, top);
    let values = |mu: &_| {
        let energy = Hamiltonian::<LiePoisson<MovableBaseAlgebra>>::value(&top, mu);
        let [square, level, length] = MovableBaseTop::casimirs(mu);
        [energy, energy, square, level, length]
    };
    let (initial, mut run) = (values(&mu), Run { inclination: Vec::new(), changes: [0.0; 5] });
    for sample in gauss.trajectory(&mu, STEP)?.take(STEPS + 1) {
        let sample = sample?;
        let now = values(&sample.momentum);
        let first = usize::from(sample.time > 0.5 * STEP * STEPS as f64);
        for i in first..5 {
            run.changes[i] = larger(run.changes[i], (now[i] - initial[i]).abs());
        }
        run.inclination.push((sample.time, inclination(&sample.momentum.0.1)));
    }
    Ok(run)
}

/// Returns the inclinations of the top on a fixed point, by the method on se(3)∗ without a lift.
fn fixed() -> Result<Vec<f64>, Box<dyn Error>> {
    let top = Gyrostat::new(MOMENTS, GRAVITY, CENTRE, Vector3::zeros())?;
    let gauss = LiftFree::new(RungeKutta::gauss(3)?, DualQuaternions, top);
    let (pi, gamma) = start();
    let samples = gauss.trajectory(&Se3Dual::new(pi, gamma), STEP)?.take(STEPS + 1);
    samples.map(|sample| Ok(inclination(&sample?.momentum.0.1))).collect()
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::read(0)?;
    println!("largest deviations up to t = 20 s, steps of {STEP} s");
    println!(
        "{:>10} {:>10} {:>18} {:>15} {:>10}",
        "base (kg)", "h (J)", "|P|² (kg²m²/s²)", "P·Γ (kg m/s)", "|Γ|²"
    );
    let mut runs = Vec::new();
    for base in BASES {
        let run = run(base)?;
        let [early, h, square, level, length] = run.changes;
        println!("{base:>10} {h:>10.2e} {square:>18.2e} {level:>15.2e} {length:>10.2e}");
        if !(h <= 2.0 * early && larger(larger(square, level), length) <= ROUND_OFF) {
            return Err(format!("an invariant is not conserved: {:?}", run.changes).into());
        }
        runs.push(run);
    }
    let pairs = runs[2].inclination.iter().zip(fixed()?);
    let apart = pairs.map(|((_, on_base), fixed)| (on_base - fixed).abs()).fold(0.0, larger);
    println!("base of 10⁹ kg and fixed point: inclinations differ by at most {apart:.2e}°");
    if let Some(path) = &arguments.picture {
        let heading = [
            "A heavy top of 1 kg on a base that moves freely",
            "Gauss method of order 6 through a Clebsch map, steps of 0.025 s",
        ];
        let names = ["base of 0.5 kg", "base of 3 kg", "base of 10⁹ kg: fixed point"];
        let named = names.iter().zip([BLUE, ORANGE, RED]).zip(runs);
        let lines: Vec<_> = named
            .map(|((name, colour), run)| Curve {
                name: (*name).into(),
                colour,
                points: run.inclination,
            })
            .collect();
        canvas::save(path, heading, [1100, 480], |area| {
            curves(area, "", ["t (s)", "inclination of the axis (°)"], &lines)?;
            Ok(())
        })?;
    }
    // Two methods of order 6 differ by their errors.
    if apart < 1e-3 { Ok(()) } else { Err("the heavy base does not act as a fixed point".into()) }
}
