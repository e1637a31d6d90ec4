//! Integrates the free rigid body in N dimensions on so(N)∗ by a collective Gauss method.
//!
//! ```text
//! cargo run --release -p systems-examples --bin rigid_body -- [N [END]] [PICTURE]
//! ```
//!
//! The body has the second moments 1, 1.5, 2, … kg m² along its N axes (default 5). Prints the largest deviations up to
//! the END (20 s) of the energy h and of Manakov's integrals tr(M + λJ²)ᵏ, k = 2 … N, for λ = 0 (the spectrum of M) and
//! λ = 1 kg⁻¹ m⁻² s⁻¹, relative to the largest term of each sum; then the same for the classical Runge–Kutta method of
//! order 4. The Gauss method of order 8 conserves the spectrum of M to round-off, and the others to its order. The program
//! fails if this does not hold, or if the control conserves the spectrum. With a PICTURE (a path ending in .png or .svg),
//! draws three components of M and the control's loss against time.

mod pictures;

use collective_integrators::{Direct, Integrator, RungeKutta};
use lie_poisson::larger;
use lie_poisson_systems::GeneralisedRigidBody;
use lie_poisson_systems::isospectral_flows::{
    CommutatorField, IsospectralRungeKutta, LargeSkewHermitian,
};
use nalgebra::DMatrix;
use pictures::arguments::Arguments;
use pictures::canvas;
use pictures::colours::{BLUE, ORANGE, RED};
use pictures::curves::{Curve, curves};
use plotters::style::RGBColor;
use std::error::Error;
use std::path::Path;

const STEP: f64 = 0.05;
/// The bound of the error of order 8 of the integrals, relative to their size, for rates of about 1/s.
const METHOD: f64 = 1e-8;

/// Returns h, tr M², …, tr Mᴺ and tr(M + J²)², …, tr(M + J²)ᴺ, each with the sum of the moduli of its terms.
fn integrals(body: &GeneralisedRigidBody, m: &LargeSkewHermitian) -> Vec<[f64; 2]> {
    let size = body.moments().len();
    let momentum = DMatrix::from_fn(size, size, |j, k| m.at(j, k).re);
    let squares = body.moments().iter().map(|moment| moment * moment);
    let squares = DMatrix::from_diagonal(&nalgebra::DVector::from_iterator(size, squares));
    let mut values = vec![[body.energy(m); 2]];
    for sum in [momentum.clone(), momentum + squares] {
        let (mut power, mut moduli) = (sum.clone(), sum.abs());
        for _ in 2..=size {
            (power, moduli) = (power * &sum, moduli * sum.abs());
            values.push([power.trace(), moduli.trace()]);
        }
    }
    values
}

/// What a run gives: the components M₁₂, M₁₃, M₂₃ and the change of tr M² at each time, and the largest changes of h, of
/// the spectrum of M and of the other integrals.
struct Run {
    components: [Vec<(f64, f64)>; 3],
    square: Vec<(f64, f64)>,
    changes: [f64; 3],
}

fn run<I: Integrator<State = LargeSkewHermitian>>(
    integrator: &I,
    body: &GeneralisedRigidBody,
    steps: usize,
) -> Result<Run, Box<dyn Error>> {
    let mut m = body.momentum(|j, k| 8.0 * ((1 + j + 3 * k) as f64).sin());
    let (start, mut workspace) = (integrals(body, &m), integrator.workspace());
    let spectrum = body.moments().len();
    let mut run = Run { components: Default::default(), square: Vec::new(), changes: [0.0; 3] };
    for n in 0..=steps {
        let (time, now) = (n as f64 * STEP, integrals(body, &m));
        for (curve, (j, k)) in run.components.iter_mut().zip([(0, 1), (0, 2), (1, 2)]) {
            curve.push((time, m.at(j, k).re));
        }
        run.square.push((time, now[1][0] / start[1][0] - 1.0));
        for (i, ([now, _], [start, scale])) in now.iter().zip(&start).enumerate() {
            let kind = if i == 0 {
                0
            } else if i < spectrum {
                1
            } else {
                2
            };
            run.changes[kind] = larger(run.changes[kind], ((now - start) / scale).abs());
        }
        integrator.step_in_place(&mut m, STEP, &mut workspace)?;
    }
    Ok(run)
}

fn draw(path: &Path, size: usize, gauss: &Run, control: &Run) -> Result<(), Box<dyn Error>> {
    let first = format!("A free rigid body in {size} dimensions, J = 1, 1.5, 2, … kg m²");
    let heading = [
        &first,
        "collective Gauss method of order 8 and Runge–Kutta method of order 4, steps of 0.05 s",
    ];
    let curve = |name: &str, colour: RGBColor, points: &[(f64, f64)]| Curve {
        name: name.into(),
        colour,
        points: points.to_vec(),
    };
    canvas::save(path, heading, [1100, 760], |area| {
        let panels = area.split_evenly((2, 1));
        let [a, b, c] = &gauss.components;
        let three = [curve("M₁₂", BLUE, a), curve("M₁₃", RED, b), curve("M₂₃", ORANGE, c)];
        curves(&panels[0], "", ["t (s)", "M (kg m²/s)"], &three)?;
        // Parts per million
        let millions = |points: &[(f64, f64)]| -> Vec<_> {
            points.iter().map(|(time, change)| (*time, change * 1e6)).collect()
        };
        let (kept, lost) = (millions(&gauss.square), millions(&control.square));
        let two = [
            curve("collective Gauss method", BLUE, &kept),
            curve("Runge–Kutta method, direct", RED, &lost),
        ];
        curves(&panels[1], "", ["t (s)", "relative change of tr M² (10⁻⁶)"], &two)?;
        Ok(())
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::read(2)?;
    let size: usize = arguments.number(0, "N", 5)?;
    let end: f64 = arguments.number(1, "END", 20.0)?;
    if size < 3 {
        return Err(format!("N: a body turns in three dimensions or more, not in {size}").into());
    }
    let steps = (end / STEP).ceil() as usize;
    let body = GeneralisedRigidBody::new((0..size).map(|j| 1.0 + 0.5 * j as f64).collect())?;
    let gauss = IsospectralRungeKutta::new(RungeKutta::gauss(4)?, body.clone());
    let gauss = run(&gauss, &body, steps)?;
    let control = Direct::new(RungeKutta::rk4(), CommutatorField::new(body.clone()));
    let control = run(&control, &body, steps)?;
    if let Some(path) = &arguments.picture {
        draw(path, size, &gauss, &control)?;
    }
    // Each step rounds the entries of M, and the trace of a power of degree k is k times as sensitive.
    let rounding = f64::EPSILON * (steps + 1) as f64 * size as f64;
    println!("N = {size}, {steps} steps of {STEP} s, largest relative changes");
    println!("{:>24} {:>10} {:>10} {:>10}", "method", "h", "tr Mᵏ", "tr(M+J²)ᵏ");
    for (name, Run { changes: [h, spectrum, others], .. }) in
        [("Gauss 8, collective", &gauss), ("RK4, direct", &control)]
    {
        println!("{name:>24} {h:>10.2e} {spectrum:>10.2e} {others:>10.2e}");
    }
    let [energy, spectrum, others] = gauss.changes;
    println!("{:>24} {METHOD:>10.2e} {rounding:>10.2e} {METHOD:>10.2e}", "bound for Gauss");
    let conserved = energy <= METHOD && spectrum <= rounding && others <= METHOD;
    if conserved && control.changes[1] > rounding {
        Ok(())
    } else {
        Err("an integral is lost, or the control conserves the spectrum".into())
    }
}
